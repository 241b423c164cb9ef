#include "calibrate/inference/compare_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::calibrate {
namespace {

/// A law's fit of one curve of 100 independent samples, whose largest value is 1.
LawFit fit_of_law(Law law, double rms, std::size_t parameters) {
  LawFit fit;
  fit.law = law;
  fit.fitted = true;
  fit.curves = {{.mean_square = rms * rms,
                 .largest = 1.0,
                 .samples = 100.0,
                 .autocorrelation = 0.0,
                 .noise = {}}};
  for (std::size_t i = 0; i < parameters; ++i) fit.parameters.emplace_back("p");
  fit.verdicts.assign(parameters, Verdict::Identified);
  fit.misfit_fraction = rms;
  return fit;
}

TEST(CompareLaws, HasTheCriteriaOfTheBooks) {
  const LawComparison c =
      compare_laws({fit_of_law(Law::Ideal, 0.1, 2), fit_of_law(Law::Linear, 0.05, 3)});
  ASSERT_EQ(c.laws.size(), 2U);
  EXPECT_EQ(c.laws[0].fit.law, Law::Linear);
  // 100 ln 0.0025 + 2 x 4, K = 3 and the noise; N - K - 1 = 95.
  EXPECT_NEAR(c.laws[0].aic, 100.0 * std::log(0.0025) + 8.0, 1e-9);
  EXPECT_NEAR(c.laws[0].aicc - c.laws[0].aic, 2.0 * 4.0 * 5.0 / 95.0, 1e-9);
  EXPECT_NEAR(c.laws[0].bic, 100.0 * std::log(0.0025) + 4.0 * std::log(100.0), 1e-9);
  EXPECT_EQ(c.advised, 0U);
  EXPECT_EQ(c.advice, "linear: BIC lower by 134 than ideal");
}

TEST(CompareLaws, CountsAKnownNoiseAsNoParameter) {
  LawFit fit = fit_of_law(Law::Ideal, 0.1, 2);
  fit.curves[0].noise = 0.1;
  EXPECT_NEAR(compare_laws({fit}).laws[0].aic, 100.0 + 4.0, 1e-9);
}

TEST(CompareLaws, HasNothingAgainstASimplerLawWithinAKnownNoise) {
  // Half the misfit would be worth 100 ln 4 of an unknown noise.
  LawFit ideal = fit_of_law(Law::Ideal, 0.1, 2);
  LawFit linear = fit_of_law(Law::Linear, 0.05, 3);
  ideal.curves[0].noise = linear.curves[0].noise = 1.0;
  const LawComparison c = compare_laws({ideal, linear});
  EXPECT_EQ(c.laws[*c.advised].fit.law, Law::Ideal);
  EXPECT_NEAR(c.laws[1].bic - c.laws[0].bic, std::log(100.0) - 100.0 * (0.01 - 0.0025), 1e-9);
}

TEST(CompareLaws, TakesNeighboursAlikeForFewerSamples) {
  LawFit ideal = fit_of_law(Law::Ideal, 0.1, 2);
  LawFit linear = fit_of_law(Law::Linear, 0.05, 3);
  ideal.curves[0].autocorrelation = 0.99;  // of the shape that it lacks
  linear.curves[0].autocorrelation = 0.6;
  const LawComparison c = compare_laws({ideal, linear});
  EXPECT_NEAR(c.samples, 100.0 * 0.4 / 1.6, 1e-9);
  EXPECT_NEAR(c.laws[1].bic - c.laws[0].bic, 25.0 * std::log(4.0) - std::log(25.0), 1e-9);
}

TEST(CompareLaws, AdvisesTheSimplerOfTwoAlikeAndSaysWhy) {
  LawFit chaboche = fit_of_law(Law::Chaboche, 0.0400, 8);
  chaboche.verdicts[6] = chaboche.verdicts[7] = Verdict::Weak;
  // The fall of the misfit is just worth one parameter more: 100 ln(rms^2) falls by ln 100 + 1.
  const double rms = 0.0401 * std::exp(-0.005 * (std::log(100.0) + 1.0));
  const LawComparison c =
      compare_laws({fit_of_law(Law::Linear, 0.0401, 3), fit_of_law(Law::Voce, rms, 4), chaboche});
  ASSERT_TRUE(c.advised);
  EXPECT_EQ(c.laws[0].fit.law, Law::Voce);
  EXPECT_EQ(c.laws[*c.advised].fit.law, Law::Linear);
  EXPECT_EQ(c.advice,
            "linear: simpler than voce, whose BIC is lower by 1 only; voce gains nothing: its "
            "misfit is 3.9 %, that of linear 4 %; chaboche gains nothing: 2 of its parameters are "
            "weak");
}

TEST(CompareLaws, AddsUpTheTargetsThatEveryLawWasFittedTo) {
  LawFit failed;
  failed.law = Law::Linear;
  LawFit timed = fit_of_law(Law::Ideal, 0.1, 2);
  timed.seconds = 2.0;
  timed.runs = 7;
  timed.evaluations = 5;
  const LawComparison c = compare_laws_over({{timed, fit_of_law(Law::Linear, 0.05, 3)},
                                             {fit_of_law(Law::Ideal, 1e-4, 2), failed},
                                             {timed, fit_of_law(Law::Linear, 0.05, 3)}});
  ASSERT_EQ(c.laws.size(), 2U);
  EXPECT_EQ(c.laws[0].fit.law, Law::Linear);
  EXPECT_EQ(c.laws[1].fit.curves.size(), 2U);
  EXPECT_EQ(c.laws[1].fit.parameters.size(), 4U);
  EXPECT_EQ(c.laws[1].fit.seconds, 4.0);
  EXPECT_EQ(c.laws[1].fit.runs, 14U);
  EXPECT_EQ(c.laws[1].fit.evaluations, 10U);
}

TEST(CompareLaws, TakesExactFitsAsEqual) {
  const LawComparison c =
      compare_laws({fit_of_law(Law::Linear, 1e-9, 3), fit_of_law(Law::Voce, 1e-12, 4)});
  EXPECT_EQ(c.laws[0].fit.law, Law::Linear);
}

TEST(CompareLaws, PutsLawsWithoutAFitLast) {
  LawFit none;
  none.law = Law::Ideal;
  const LawComparison c = compare_laws({none, fit_of_law(Law::Linear, 0.1, 3)});
  EXPECT_EQ(c.laws[1].fit.law, Law::Ideal);
  EXPECT_EQ(c.advice, "linear");
  EXPECT_FALSE(compare_laws({none}).advised);
  EXPECT_FALSE(compare_laws(std::vector<LawFit>{}).advised);
}

TEST(CompareLaws, CountsSamplesByTheirWeights) {
  EXPECT_NEAR(effective_samples(std::vector<double>{2.0, 2.0, 2.0}), 3.0, 1e-12);
  EXPECT_NEAR(effective_samples(std::vector<double>{3.0, 1.0}), 1.6, 1e-12);
  EXPECT_EQ(effective_samples({}), 0.0);
  EXPECT_NEAR(autocorrelation(std::vector<double>{1.0, -1.0, 1.0, -1.0}), -0.75, 1e-12);
  EXPECT_EQ(autocorrelation(std::vector<double>{0.0, 0.0}), 0.0);
}

TEST(LackOfFit, NeedsRunsAndAFraction) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
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
  constexpr double kUncounted = std::numeric_limits<double>::quiet_NaN();
  for (const double fraction : {1e-4, 0.005, 0.0101, 0.015, 0.03, 0.08, 0.4}) {
    for (const double p : {kUncounted, 1e-30, 1e-4, 2e-3, 0.5}) {
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
  EXPECT_EQ(misfit_word(0.03, kUncounted, 0.0), "fair") << "too short to tell";
  EXPECT_EQ(misfit_word(0.02, 1e-5, 0.0), "poor");
}

}  // namespace
}  // namespace plastica::calibrate
