#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// Everything that a result says, to the last bit.
class Bits {
 public:
  explicit Bits(const FitResult& r) {
    add(static_cast<double>(r.status));
    add(r.reason);
    for (const FittedParameter& p : r.parameters) {
      add(p.name() + p.path);
      for (const double value : {p.value, p.start, p.lower, p.upper, p.standard_error,
                                 p.interval_low, p.interval_high}) {
        add(value);
      }
      for (const bool flag : {p.logarithmic, p.at_lower, p.at_upper, p.identified}) add(flag);
    }
    for (const std::vector<double>* values :
         {&r.correlation, &r.trace.values, &r.trace.costs, &r.fitted.strain, &r.fitted.stress}) {
      for (const double value : *values) add(value);
    }
    for (const double value :
         {r.cost, r.misfit_rms, r.misfit_fraction, r.break_strain_total.value_or(-1)}) {
      add(value);
    }
    add(r.misfit_word);
    words_.push_back(r.seed);
    words_.push_back(r.samples);
    for (const OptimizerStage& stage : r.stages) {
      add(stage.algorithm + stage.outcome);
      add(stage.evaluations);
      add(stage.cost);
    }
    for (const std::string& warning : r.warnings) add(warning);
  }
  bool operator==(const Bits&) const = default;

 private:
  void add(double value) { words_.push_back(std::bit_cast<std::uint64_t>(value)); }
  void add(const std::string& text) { text_ += text + "\n"; }

  std::vector<std::uint64_t> words_;
  std::string text_;
};

/// Twenty-four noisy specimens with break, three of them without any hope; the poor fits among
/// them go through every stage of `auto`.
std::vector<Target> specimens() {
  std::vector<Target> targets;
  for (std::size_t i = 0; i < 24; ++i) {
    const auto k = static_cast<double>(i);
    const std::vector<double> strain = ramp(60 + i, 0.02 + 0.001 * k);
    std::vector<double> stress = ideal_curve(strain, (100 + 5 * k) * 1e9, (200 + 10 * k) * 1e6);
    Noise noise(i);
    for (std::size_t s = 0; s < stress.size(); ++s) {
      stress[s] += noise(2e6) + (i % 3 == 0 ? 12e9 * strain[s] : 0.0);
    }
    Target target = target_of(strain, stress);
    break_at(target, strain.back() + 0.0003, strain.back() - 0.002);
    target.name = "specimen-" + std::to_string(i);
    if (i % 8 == 5) {
      target.status = TargetStatus::Rejected;
      target.reason = "nothing to see";
    }
    targets.push_back(target);
  }
  return targets;
}

FitOptions options_with_break() {
  return fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                 free_parameter("break_strain")});
}

std::vector<Bits> bits_of(const std::vector<FitResult>& results) {
  return {results.begin(), results.end()};
}

TEST(FitBatch, GivesTheSameBitsForEveryNumberOfThreads) {
  const std::vector<Target> targets = specimens();
  std::vector<Bits> alone;
  for (const Target& target : targets) alone.emplace_back(fit_target(target, options_with_break()));
  for (const int threads : {1, 2, 3, 8}) {
    if (testing::kSanitized && threads != 3) continue;
    BatchFitOptions batch;
    batch.threads = threads;
    EXPECT_EQ(bits_of(fit(targets, options_with_break(), batch)), alone) << threads;
  }
}

TEST(FitBatch, GivesTheSameBitsForShuffledTargets) {
  const std::vector<Target> targets = specimens();
  const std::vector<Bits> expected = bits_of(fit(targets, options_with_break()));
  std::vector<std::size_t> order(targets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 random(1);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<Target> shuffled;
  for (const std::size_t i : order) shuffled.push_back(targets[i]);
  BatchFitOptions batch;
  batch.threads = 3;
  const std::vector<Bits> found = bits_of(fit(shuffled, options_with_break(), batch));
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(found[i], expected[order[i]]) << i;
}

TEST(FitBatch, TheSeedIsPartOfTheBits) {
  const std::vector<Target> targets = specimens();
  FitOptions other = options_with_break();
  other.seed = 2;
  EXPECT_NE(Bits(fit_target(targets[0], other)),
            Bits(fit_target(targets[0], options_with_break())));
}

TEST(FitBatch, TargetsOfOneNameAndCurveGiveTheSameBitsAndOthersDiffer) {
  std::vector<Target> targets(3, specimens()[0]);
  targets[2].name = "another";
  const std::vector<Bits> bits = bits_of(fit(targets, options_with_break()));
  EXPECT_EQ(bits[0], bits[1]);
  EXPECT_NE(bits[0], bits[2]);  // by its seed
}

TEST(FitBatch, ARejectedTargetStopsNoOther) {
  const std::vector<FitResult> results = fit(specimens(), options_with_break());
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].status, i % 8 == 5 ? FitStatus::Rejected : FitStatus::Fitted) << i;
  }
  EXPECT_EQ(results[5].reason, "nothing to see");
}

TEST(FitBatch, ReportsEachFitOnceAndOneAtATime) {
  const std::vector<Target> targets = specimens();
  std::vector<int> calls(targets.size(), 0);
  std::atomic<int> inside{0};
  bool alone = true;
  BatchFitOptions batch;
  batch.threads = 4;
  batch.finished = [&](std::size_t index, const FitResult& result) {
    alone = alone && ++inside == 1;
    calls[index] += result.reason == "not run" ? 100 : 1;
    --inside;
  };
  fit(targets, options_with_break(), batch);
  EXPECT_TRUE(alone);
  EXPECT_EQ(calls, std::vector<int>(targets.size(), 1));
}

TEST(FitBatch, StopsBetweenFits) {
  const std::vector<Target> targets = specimens();
  std::atomic<bool> stop{false};
  int finished = 0;
  BatchFitOptions batch;
  batch.threads = 2;
  batch.stop = &stop;
  batch.finished = [&](std::size_t, const FitResult&) {
    if (++finished == 5) stop = true;
  };
  const std::vector<FitResult> results = fit(targets, options_with_break(), batch);
  std::size_t not_run = 0;
  for (const FitResult& result : results) not_run += result.reason == "not run" ? 1 : 0;
  EXPECT_EQ(not_run + static_cast<std::size_t>(finished), targets.size());
  EXPECT_GE(finished, 5);
  EXPECT_LE(finished, 6);  // the other thread's fit was under way
  EXPECT_EQ(results.back().status, FitStatus::Rejected);
}

TEST(FitBatch, RefusesBadOptionsBeforeAnyFit) {
  FitOptions options = options_with_break();
  options.confidence = 0.0;
  int finished = 0;
  BatchFitOptions batch;
  batch.finished = [&](std::size_t, const FitResult&) { ++finished; };
  EXPECT_EQ(message_of([&] { fit(specimens(), options, batch); }),
            "fit.confidence = 0: must be between 0 and 1");
  EXPECT_EQ(finished, 0);
  EXPECT_TRUE(fit({}, options_with_break()).empty());
}

TEST(FitBatch, CarriesAnExceptionOfTheCallerOut) {
  BatchFitOptions batch;
  batch.threads = 2;
  batch.finished = [](std::size_t index, const FitResult&) {
    if (index == 3) throw 17;
  };
  EXPECT_THROW(fit(specimens(), options_with_break(), batch), int);
}

}  // namespace
}  // namespace plastica::calibrate
