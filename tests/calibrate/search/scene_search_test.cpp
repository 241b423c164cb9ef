#include "calibrate/fit/scene_fit.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <map>

#include "plastica/io/storage_error.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"

/// The search from several starts, and what survives an interruption of it or of what follows.

namespace plastica::calibrate {
namespace {

using testing::bend_test;
using testing::measured;
using testing::stiffness_and_yield;
using testing::Truth;

/// A start at which nothing yields, so that the yield stress has no slope.
SceneFitOptions far_off() {
  SceneFitOptions options{.parameters = stiffness_and_yield()};
  options.parameters[1].upper = 10e9;
  options.parameters[1].value = 9e9;
  options.segments_error = false;
  return options;
}

TEST(SceneSearch, LeavesAStartThatKnowsNothingForABetterOne) {
  // The curve of a finer beam, of which 5 segments are 3 % off.
  const plastica::Setup setup = bend_test(5);
  const SceneTarget target = measured(bend_test(20));
  SceneFitOptions options = far_off();
  const SceneFitResult fit = fit_scene(setup, target, options);
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_NEAR(fit.parameters[1].value / Truth{}.yield_stress, 1.0, 0.05);
  ASSERT_EQ(fit.starts.size(), 10U);
  EXPECT_NEAR(fit.starts[0].from[1], 9e9, 1.0);
  // The start's own search ended where nothing yields, and others were better.
  EXPECT_GT(fit.starts[0].to[1], 5e9);
  // So did each other one that knew nothing of the yield stress; the rest found it.
  for (const SceneStart& start : fit.starts) {
    if (start.from[1] > 2e9) {
      EXPECT_GT(start.to[1], 2e9);
    } else {
      EXPECT_NEAR(start.to[1] / fit.parameters[1].value, 1.0, 1e-3) << start.from[1];
    }
  }
  options.starts = 1;
  EXPECT_GT(fit_scene(setup, target, options).targets[0].misfit_fraction, 0.1);
}

TEST(SceneSearch, RescuesAStartWithoutACurve) {
  // A moment that ideal plasticity does not carry, at the scene's own yield stress.
  plastica::Setup setup = bend_test(5);
  Scene& scene = setup.scene;
  scene.material.hardening = {};
  scene.supports.pop_back();
  scene.loads = {{.at = Place::end(), .moment = {1.0, 0.0, 0.0}}};
  scene.probes = {{"turn", ProbeQuantity::Rotation, Place::end(), Component::X}};
  SceneTarget target;
  target.name = "turned";
  target.kind = Abscissa::Load;
  target.ordinate_probe = "turn";
  for (int i = 1; i <= 20; ++i) target.abscissa.push_back(35.0 * i);
  scene.material.yield_stress = Truth{}.yield_stress;
  const SceneModel model(setup, target, {&find_field("material.yield_stress")});
  target.ordinate.assign(20, 0.0);
  const std::vector<double> truth{Truth{}.yield_stress};
  const SceneCurve curve = model.run(truth, 1).front();
  ASSERT_TRUE(curve.usable) << curve.reason;
  target.ordinate = curve.ordinate;
  scene.material.yield_stress = 150e6;
  SceneFitOptions options{.parameters = stiffness_and_yield()};
  options.segments_error = false;
  options.starts = 1;
  const SceneFitResult lost = fit_scene(setup, target, options);
  ASSERT_EQ(lost.status, FitStatus::Failed);
  EXPECT_TRUE(lost.reason.starts_with("the scene gives no curve from the start values: "))
      << lost.reason;
  options.starts = 6;
  const SceneFitResult fit = fit_scene(setup, target, options);
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_TRUE(std::isinf(fit.starts[0].cost));
  EXPECT_EQ(fit.starts[0].outcome, LeastSquaresOutcome::NoStart);
  EXPECT_TRUE(fit.starts[0].to.empty());
  EXPECT_NEAR(fit.parameters[1].value / Truth{}.yield_stress, 1.0, 1e-5);
}

/// What a fit kept, as a journal has it.
using Kept = std::map<std::string, std::vector<std::byte>>;

SceneFitHooks hooks_of(const Kept& found, Kept& kept) {
  SceneFitHooks hooks;
  hooks.find = [&found](const std::string& name) -> const std::vector<std::byte>* {
    const auto place = found.find(name);
    return place == found.end() ? nullptr : &place->second;
  };
  hooks.keep = [&kept](const std::string& name, std::span<const std::byte> bytes) {
    kept[name].assign(bytes.begin(), bytes.end());
  };
  return hooks;
}

void expect_same(const SceneFitResult& a, const SceneFitResult& b) {
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(a.parameters[i].value, b.parameters[i].value);
    EXPECT_EQ(a.parameters[i].standard_error, b.parameters[i].standard_error);
  }
  EXPECT_EQ(a.targets[0].fitted, b.targets[0].fitted);
  EXPECT_EQ(a.runs, b.runs);
  EXPECT_EQ(a.failed_runs, b.failed_runs);
  EXPECT_EQ(a.segment_iterations, b.segment_iterations);
  ASSERT_EQ(a.starts.size(), b.starts.size());
  for (std::size_t i = 0; i < a.starts.size(); ++i) {
    EXPECT_EQ(a.starts[i].cost, b.starts[i].cost);
    EXPECT_EQ(a.starts[i].to, b.starts[i].to);
    EXPECT_EQ(a.starts[i].evaluations, b.starts[i].evaluations);
  }
}

TEST(SceneSearch, GoesOnFromWhatWasFinishedToTheSameBits) {
  const plastica::Setup setup = bend_test(5);
  const SceneTarget target = measured(setup);
  SceneFitOptions options = far_off();
  const SceneFitResult whole = fit_scene(setup, target, options);
  std::atomic<bool> stop{false};
  int runs = 0;
  const Kept nothing;
  Kept kept;
  options.hooks = hooks_of(nothing, kept);
  options.hooks.stop = &stop;
  // Stopped in each of the stages in turn.
  for (const std::string stage : {"screen", "search", "polish"}) {
    Kept more = kept;
    stop = false;
    options.hooks = hooks_of(kept, more);
    options.hooks.stop = &stop;
    options.hooks.progress = [&](const SceneFitProgress& progress) {
      EXPECT_GE(progress.runs, runs);
      runs = progress.runs;
      if (progress.stage == stage && progress.done > 0) stop = true;
    };
    EXPECT_THROW(fit_scene(setup, target, options), FitInterrupted) << stage;
    EXPECT_GT(more.size(), kept.size()) << stage;
    kept = std::move(more);
    runs = 0;
  }
  EXPECT_TRUE(kept.contains("screen"));
  EXPECT_TRUE(kept.contains("search 0"));
  Kept last;
  options.hooks = hooks_of(kept, last);
  const SceneFitResult resumed = fit_scene(setup, target, options);
  EXPECT_FALSE(last.contains("screen"));
  expect_same(resumed, whole);
}

TEST(SceneSearch, GoesOnFromWhatFollowedItToTheSameBits) {
  const plastica::Setup setup = bend_test(4);
  SceneFitOptions options{.parameters = stiffness_and_yield(), .starts = 1};
  options.intervals = {.profile = true, .bootstrap = 24};
  SceneTarget target = measured(setup);
  for (std::size_t i = 0; i < target.ordinate.size(); ++i) {
    target.ordinate[i] += i % 3 == 0 ? 4.0 : -2.0;
  }
  const SceneFitResult whole = fit_scene(setup, target, options);
  std::atomic<bool> stop{false};
  Kept kept;
  for (const std::string stage : {"segments", "profile", "bootstrap"}) {
    Kept more = kept;
    stop = false;
    options.hooks = hooks_of(kept, more);
    options.hooks.stop = &stop;
    int runs = 0;
    options.hooks.progress = [&](const SceneFitProgress& progress) {
      EXPECT_GE(progress.runs, runs);
      runs = progress.runs;
      if (progress.stage == stage && progress.done > 0) stop = true;
    };
    EXPECT_THROW(fit_scene(setup, target, options), FitInterrupted) << stage;
    EXPECT_TRUE(more.contains(stage + " 0"));
    kept = std::move(more);
  }
  EXPECT_EQ(kept.contains("bootstrap 2"), false);
  Kept last;
  options.hooks = hooks_of(kept, last);
  const SceneFitResult resumed = fit_scene(setup, target, options);
  EXPECT_FALSE(last.contains("profile 3"));
  EXPECT_TRUE(last.contains("bootstrap 2"));
  expect_same(resumed, whole);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(resumed.segments->parameters[i].error, whole.segments->parameters[i].error);
    EXPECT_EQ(resumed.intervals.profiles[i].rise, whole.intervals.profiles[i].rise);
    EXPECT_EQ(resumed.intervals.profiles[i].low, whole.intervals.profiles[i].low);
  }
  EXPECT_EQ(resumed.intervals.residuals.values, whole.intervals.residuals.values);
}

TEST(SceneSearch, RefusesToGoOnFromWhatIsNoRecord) {
  const plastica::Setup setup = bend_test(5);
  SceneFitOptions options = far_off();
  const Kept torn{{"screen", std::vector<std::byte>(3)}};
  Kept kept;
  options.hooks = hooks_of(torn, kept);
  EXPECT_THROW(fit_scene(setup, measured(setup), options), io::StorageError);
}

}  // namespace
}  // namespace plastica::calibrate
