#include "calibrate/inference/lack_of_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "calibrate/inference/not_a_number.hpp"

namespace plastica::calibrate {
namespace {

TEST(LackOfFit, CountsSamplesByTheirWeights) {
  EXPECT_NEAR(effective_samples(std::vector<double>{2.0, 2.0, 2.0}), 3.0, 1e-12);
  EXPECT_NEAR(effective_samples(std::vector<double>{3.0, 1.0}), 1.6, 1e-12);
  EXPECT_EQ(effective_samples({}), 0.0);
  EXPECT_NEAR(autocorrelation(std::vector<double>{1.0, -1.0, 1.0, -1.0}), -0.75, 1e-12);
  EXPECT_EQ(autocorrelation(std::vector<double>{0.0, 0.0}), 0.0);
}

/// chi^2 of 600 degrees of freedom is above 712.8 once in a thousand times, of 10 above 29.59, and
/// of 1 above 10.83 (tables; Fisher's approximation is off by some percent for the fewest).
TEST(StatedNoise, IsJudgedByTheSquaresOfTheResiduals) {
  using enum StatedNoise;
  EXPECT_EQ(judge_stated_noise(std::sqrt(705.0 / 600.0), 600.0), Fits);
  EXPECT_EQ(judge_stated_noise(std::sqrt(720.0 / 600.0), 600.0), TooSmall);
  EXPECT_EQ(judge_stated_noise(std::sqrt(27.0 / 10.0), 10.0), Fits);
  EXPECT_EQ(judge_stated_noise(std::sqrt(31.0 / 10.0), 10.0), TooSmall);
  EXPECT_EQ(judge_stated_noise(2.0, 1.0), Fits);
  EXPECT_EQ(judge_stated_noise(100.0, 0.0), Fits) << "nothing is left to judge by";
  EXPECT_EQ(judge_stated_noise(0.6, 600.0), Fits) << "a careful statement";
  EXPECT_EQ(judge_stated_noise(0.4, 600.0), TooLarge);
  EXPECT_EQ(judge_stated_noise(0.4, 3.0), Fits) << "by chance";
}

TEST(LackOfFit, NeedsRunsAndAFraction) {
  EXPECT_EQ(
      lack_of_fit("ideal plasticity", 0.044, 1e-30, "ideal,linear,voce"),
      "ideal plasticity does not describe this curve (misfit 4.4 % of the largest value, runs "
      "test p 1e-30): errors are widened for it, and rough; try --laws ideal,linear,voce");
  EXPECT_EQ(lack_of_fit("ideal plasticity", 0.2, 0.3, "voce"), "") << "noise, however large";
  EXPECT_EQ(lack_of_fit("ideal plasticity", 0.005, 1e-30, "voce"), "") << "hardly any misfit";
  EXPECT_EQ(lack_of_fit("Voce hardening", 0.06, kNan, ""),
            "Voce hardening does not describe this curve (misfit 6 % of the largest value): "
            "errors are widened for it, and rough");
  EXPECT_EQ(lack_of_fit("Voce hardening", 0.04, kNan, ""), "");
}

/// One scale: what lacks a fit is poor, what is left of noise is close, and nothing is both.
TEST(MisfitWord, DoesNotContradictTheLackOfFit) {
  for (const double fraction : {1e-4, 0.005, 0.0101, 0.015, 0.03, 0.08, 0.4}) {
    for (const double p : {kNan, 1e-30, 1e-4, 2e-3, 0.5}) {
      for (const double alike : {0.0, 0.4, 0.9}) {
        const std::string_view word = misfit_word(fraction, p, alike);
        EXPECT_EQ(word == "poor", lacks_fit(fraction, p)) << fraction << ' ' << p;
        if (fraction < 0.01) {
          EXPECT_EQ(word, "close") << fraction << ' ' << p;
        }
      }
    }
  }
  EXPECT_EQ(misfit_word(0.08, 0.5, 0.1), "close") << "noise";
  EXPECT_EQ(misfit_word(0.03, 0.5, 0.8), "fair") << "neighbours are alike";
  EXPECT_EQ(misfit_word(0.03, kNan, 0.0), "fair") << "too short to tell";
  EXPECT_EQ(misfit_word(0.02, 1e-5, 0.0), "poor");
}

}  // namespace
}  // namespace plastica::calibrate
