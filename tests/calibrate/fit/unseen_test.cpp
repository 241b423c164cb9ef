#include "calibrate/fit/unseen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// Elastic bars of the given moduli [GPa], with fits that have found them.
struct Bars {
  explicit Bars(const std::vector<double>& moduli) {
    options = fit_of({free_parameter("youngs_modulus")});
    options.setup.scene.material.yield_stress = 1e12;
    options.laws = {Law::Ideal, Law::Linear};
    for (std::size_t i = 0; i < moduli.size(); ++i) {
      const std::vector<double> strain = ramp(20, 0.001);
      Target target = target_of(strain, ideal_curve(strain, 1e9 * moduli[i], 1e12));
      target.name = std::string(1, static_cast<char>('a' + i));
      targets.push_back(std::move(target));
      cases.push_back({i, Law::Ideal});
      FitResult& result = results.emplace_back();
      result.status = FitStatus::Fitted;
      result.parameters.emplace_back().path = "material.youngs_modulus";
      result.parameters.back().value = 1e9 * moduli[i];
    }
  }

  void foretell() { add_unseen(targets, cases, options, 1, results); }

  std::vector<Target> targets;
  std::vector<FitCase> cases;
  FitOptions options;
  std::vector<FitResult> results;
};

/// sum w e^2/sum w over the largest e^2, of 20 samples whose first and last count half.
double mean_square_strain() {
  double sum = 0.0;
  for (int i = 1; i < 19; ++i) sum += i * i / 361.0;
  return (sum + 0.5) / 19.0;
}

TEST(Unseen, IsTheMeanOverTheOthersOfAGroup) {
  Bars bars({200.0, 210.0, 190.0, 300.0});
  bars.targets[3].group = {{"lot", "B"}};
  bars.foretell();
  const double mean = (std::pow(10.0 / 200.0, 2) + std::pow(10.0 / 200.0, 2)) / 2.0;
  ASSERT_TRUE(bars.results[0].unseen);
  EXPECT_NEAR(*bars.results[0].unseen, mean * mean_square_strain(), tolerance(1e-12));
  const double of_b = (std::pow(10.0 / 210.0, 2) + std::pow(20.0 / 210.0, 2)) / 2.0;
  EXPECT_NEAR(*bars.results[1].unseen, of_b * mean_square_strain(), tolerance(1e-12));
  EXPECT_FALSE(bars.results[3].unseen) << "alone in its group";
}

TEST(Unseen, AsksTenOthersAtMost) {
  std::vector<double> moduli(12, 200.0);
  moduli[11] = 400.0;
  Bars bars(moduli);
  bars.foretell();
  EXPECT_EQ(*bars.results[0].unseen, 0.0) << "b … k foretell a, not l";
  EXPECT_NEAR(*bars.results[1].unseen, 0.1 * mean_square_strain(), tolerance(1e-12));
}

TEST(Unseen, NeedsLawsThatAreComparedAndFits) {
  Bars alone({200.0, 210.0});
  alone.options.laws = {Law::Ideal};
  alone.foretell();
  EXPECT_FALSE(alone.results[0].unseen);
  Bars failed({200.0, 210.0});
  failed.results[1].status = FitStatus::Failed;
  failed.foretell();
  EXPECT_FALSE(failed.results[0].unseen);
  EXPECT_FALSE(failed.results[1].unseen);
}

TEST(Unseen, IsPartOfABatch) {
  Bars bars({200.0, 210.0, 190.0});
  bars.options.parameters.push_back(fixed_parameter("yield_stress", 1e12));
  const std::vector<FitResult> results = fit(bars.targets, bars.options);
  ASSERT_EQ(results.size(), 6U);
  ASSERT_TRUE(results[0].unseen);
  EXPECT_NEAR(*results[0].unseen, 0.0025 * mean_square_strain(), tolerance(1e-9));
  EXPECT_EQ(results[0].held_out.size(), 5U);
}

}  // namespace
}  // namespace plastica::calibrate
