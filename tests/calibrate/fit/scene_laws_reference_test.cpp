#include "calibrate/fit/scene_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calibrate/inference/held_out.hpp"
#include "calibrate/store/journaled_scene_fits.hpp"
#include "calibrate/store/result_bytes.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

constexpr double kForceNoise = 8.0;  // [N], of some 2500 N

/// A bend test of a bar that hardens by some law, with noise.
WeightedTarget bent_by(const Hardening& hardening) {
  WeightedTarget weighted{bend_test(6), {}};
  weighted.setup.scene.material.hardening = hardening;
  weighted.target = measured(weighted.setup, {}, 1.5e-3);
  weighted.target.broke.reset();
  std::mt19937_64 bits(11);
  std::normal_distribution<double> noise(0.0, kForceNoise);
  for (double& force : weighted.target.ordinate) force += noise(bits);
  return weighted;
}

Hardening voce() {
  Hardening hardening;
  hardening.law = HardeningLaw::VoceChaboche;
  hardening.saturation_stress = 150e6;
  hardening.saturation_rate = 60.0;
  return hardening;
}

SceneFitOptions stated() {
  SceneFitOptions options;
  options.parameters = stiffness_and_yield();
  options.parameters[0].lower = 150e9;
  options.parameters[0].upper = 300e9;
  options.parameters[1].lower = 200e6;
  options.parameters[1].upper = 800e6;
  options.screen = 16;
  options.starts = 3;
  options.laws = {Law::Ideal, Law::Linear, Law::Voce};
  return options;
}

struct Fits {
  std::vector<SceneFitRecord> records;
  LawComparison laws;
};

Fits fits_of(const SceneFitCase& one, const SceneFitOptions& options, const std::string& journal) {
  const std::vector<SceneFitCase> cases{one};
  JournaledSceneFits batch(cases, options, {.journal = {.path = journal}, .threads = 1});
  std::vector<SceneFitResult> results = batch.run();
  batch.finish();
  Fits fits;
  std::vector<LawFit> compared;
  for (SceneFitResult& result : results) {
    fits.records.push_back(record_of(one, std::move(result)));
    compared.push_back(law_fit_of(fits.records.back()));
  }
  fits.laws = compare_laws(std::move(compared));
  return fits;
}

Law advised(const Fits& fits) { return fits.laws.laws[fits.laws.advised.value()].fit.law; }

TEST(SceneLawsReference, AdviseTheLawThatMadeTheCurve) {
  const io::ScratchFolder folder;
  const Fits fits = fits_of({"bar", {bent_by(voce())}}, stated(), folder.file("j"));
  ASSERT_EQ(fits.records.size(), 3U);
  EXPECT_EQ(advised(fits), Law::Voce) << fits.laws.advice;
  const SceneFitResult& found = fits.records[2].result;
  EXPECT_EQ(found.law, Law::Voce);
  EXPECT_NEAR(found.parameter("saturation_stress").value, 150e6,
              4.0 * found.parameter("saturation_stress").standard_error);
  EXPECT_NEAR(found.targets[0].noise, kForceNoise, 0.3 * kForceNoise);
  // What is made of a chosen fit is made of the advised law alone.
  EXPECT_TRUE(found.segments);
  EXPECT_FALSE(fits.records[0].result.segments);
  EXPECT_GT(found.runs, found.search_runs);
  // No law ends worse than one that it contains, and those that miss the curve say so.
  EXPECT_LE(found.targets[0].cost, fits.records[0].result.targets[0].cost);
  const std::vector<std::string>& said = fits.records[0].result.warnings;
  EXPECT_TRUE(std::ranges::any_of(said, [](const std::string& text) {
    return text.starts_with("bar: ideal plasticity does not describe this curve");
  }));
}

/// Elastic, the force is E times a shape, so that a fit without a part has a closed form.
TEST(SceneLawsReference, HoldOutPartsOfTheCurveAsTheClosedFormDoes) {
  WeightedTarget bar = bent_by({});
  bar.target = measured(bar.setup, {}, 1e-4, 4e-3);
  bar.target.broke.reset();
  std::mt19937_64 bits(3);
  std::normal_distribution<double> noise(0.0, kForceNoise);
  for (double& force : bar.target.ordinate) force += noise(bits);
  SceneFitOptions options = stated();
  options.parameters.resize(1);
  options.segments_error = false;
  const SceneFitResult result = fit(std::vector<WeightedTarget>{bar}, options);
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  ASSERT_EQ(result.held_out.size(), kParts);
  const std::vector<double>& force = bar.target.ordinate;
  const std::vector<double>& shape = result.targets[0].fitted;  // times one over E
  const std::vector<std::size_t> part = parts_along(bar.target.abscissa, force);
  const double largest = std::ranges::max(force, {}, [](double f) { return std::abs(f); });
  for (std::size_t k = 0; k < kParts; ++k) {
    double both = 0.0, square = 0.0, left = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      if (part[i] == k) continue;
      both += shape[i] * force[i];
      square += shape[i] * shape[i];
    }
    for (std::size_t i = 0; i < force.size(); ++i) {
      if (part[i] == k) left += std::pow((both / square * shape[i] - force[i]) / largest, 2);
    }
    const double expected = 5.0 * left / static_cast<double>(force.size());
    EXPECT_NEAR(result.held_out[k], expected, tolerance(1e-4 * expected)) << k;
  }
}

TEST(SceneLawsReference, AdviseIdealPlasticityWhereThatMadeTheCurve) {
  const io::ScratchFolder folder;
  const Fits fits = fits_of({"bar", {bent_by({})}}, stated(), folder.file("j"));
  EXPECT_EQ(advised(fits), Law::Ideal) << fits.laws.advice;
  for (const SceneFitRecord& record : fits.records) {
    EXPECT_LE(record.result.targets[0].cost,
              fits.records[0].result.targets[0].cost * (1.0 + tolerance(1e-9)));
    for (const std::string& warning : record.result.warnings) {
      EXPECT_EQ(warning.find("larger misfit"), std::string::npos) << warning;
    }
  }
}

TEST(SceneLawsReference, TakeAStatedNoiseForKnown) {
  const io::ScratchFolder folder;
  WeightedTarget weighted = bent_by(voce());
  // So blunt a curve does not contradict ideal plasticity.
  weighted.target.noise = 100.0 * kForceNoise;
  SceneFitOptions options = stated();
  options.segments_error = false;
  const Fits fits = fits_of({"bar", {weighted}}, options, folder.file("j"));
  EXPECT_EQ(advised(fits), Law::Ideal) << fits.laws.advice;
}

TEST(SceneLawsReference, GoOnWhereTheyWereStoppedWithTheSameBits) {
  const io::ScratchFolder folder;
  const std::vector<SceneFitCase> cases{{"bar", {bent_by(voce())}}};
  SceneFitOptions options = stated();
  options.laws = {Law::Ideal, Law::Linear};
  const auto bytes_of_all = [&](const std::vector<SceneFitResult>& results) {
    std::vector<std::vector<std::byte>> all;
    for (const SceneFitResult& result : results) all.push_back(bytes_of(result));
    return all;
  };
  JournaledSceneFits whole(cases, options, {.journal = {.path = folder.file("a")}, .threads = 1});
  const auto expected = bytes_of_all(whole.run());
  ASSERT_TRUE(whole.complete());

  std::atomic<bool> stop = false;
  JournaledOptions how{.journal = {.path = folder.file("b")}, .threads = 1, .stop = &stop};
  // After the first law, within the search of the second.
  std::size_t done = 0;
  how.progress = [&](const BatchProgress& progress) { done = progress.done; };
  {
    JournaledSceneFits first(cases, options, how, [&](const SceneFitProgress& progress) {
      stop = done == 1 && progress.stage == "polish";
    });
    (void)first.run();
    EXPECT_FALSE(first.complete());
  }
  stop = false;
  how.journal.resume = true;
  JournaledSceneFits second(cases, options, how);
  EXPECT_EQ(second.resumed(), 1U);
  EXPECT_GT(second.stages(), 0U);
  EXPECT_EQ(second.stale(), 0U);
  EXPECT_TRUE(bytes_of_all(second.run()) == expected);
  EXPECT_TRUE(second.complete());
  EXPECT_TRUE(std::isnan(second.seconds()[0])) << "resumed from the journal";
  EXPECT_GT(second.seconds()[1], 0.0);
}

}  // namespace
}  // namespace plastica::calibrate
