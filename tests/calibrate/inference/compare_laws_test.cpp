#include "calibrate/inference/compare_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
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

TEST(CompareLaws, SaysWhichParametersOfTheAdvisedLawAreWeakAndWhatASimplerOneLeaves) {
  LawFit chaboche = fit_of_law(Law::Chaboche, 0.01, 8);
  chaboche.verdicts[6] = chaboche.verdicts[7] = Verdict::Weak;
  LawFit voce = fit_of_law(Law::Voce, 0.015, 4);
  voce.verdicts[3] = Verdict::AtBound;
  const LawFit linear = fit_of_law(Law::Linear, 0.02, 3);
  EXPECT_TRUE(compare_laws({linear, voce, chaboche})
                  .advice.ends_with("; yet 2 of its parameters are weak: none of linear, whose "
                                    "misfit is 2 % for 1 %"));
  EXPECT_TRUE(
      compare_laws({voce, chaboche}).advice.ends_with("; yet 2 of its parameters are weak"));
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

/// A curve whose samples are worth less than ten: neighbours are nearly the same.
LawFit uninformed(Law law, double rms, std::size_t parameters, std::vector<double> parts) {
  LawFit fit = fit_of_law(law, rms, parameters);
  fit.curves[0].autocorrelation = 0.9;
  for (double& part : parts) part *= part;
  fit.parts = std::move(parts);
  return fit;
}

TEST(CompareLaws, RanksByWhatWasHeldOutBelowTenSamples) {
  // By information eight parameters would cost 8 ln 5.3; what they have learnt they do not
  // foretell.
  const LawComparison c =
      compare_laws({uninformed(Law::Chaboche, 0.01, 8, {0.05, 0.05, 0.05, 0.05, 0.05}),
                    uninformed(Law::Linear, 0.03, 3, {0.03, 0.04, 0.03, 0.04, 0.03}),
                    uninformed(Law::Ideal, 0.08, 2, {0.08, 0.09, 0.08, 0.09, 0.08})});
  EXPECT_FALSE(c.is_informed);
  EXPECT_EQ(c.ranked_by, RankedBy::Parts);
  EXPECT_NEAR(c.samples, 100.0 * 0.1 / 1.9, 1e-9);
  EXPECT_EQ(c.laws[0].fit.law, Law::Linear);
  EXPECT_EQ(c.laws[2].fit.law, Law::Ideal);
  EXPECT_NEAR(c.laws[0].held_out, std::sqrt((3 * 9e-4 + 2 * 16e-4) / 5), 1e-12);
  EXPECT_EQ(c.advice,
            "linear: parts of the curve held out are 3.44 % off, by chaboche 5 %; chaboche gains "
            "nothing: parts of the curve held out are 5 % off");
}

TEST(CompareLaws, KeepsToInformationWhereThereIsSome) {
  LawFit ideal = fit_of_law(Law::Ideal, 0.1, 2);
  LawFit linear = fit_of_law(Law::Linear, 0.05, 3);
  ideal.parts = {1e-9};
  linear.parts = {1e-2};
  const LawComparison c = compare_laws({ideal, linear});
  EXPECT_TRUE(c.is_informed);
  EXPECT_EQ(c.ranked_by, RankedBy::Information);
  EXPECT_EQ(c.laws[*c.advised].fit.law, Law::Linear);
}

TEST(CompareLaws, TakesTheSimplerOfLawsThatForetellAlike) {
  const auto advised = [](std::vector<double> of_linear, std::vector<double> of_voce) {
    const LawComparison c = compare_laws({uninformed(Law::Voce, 0.03, 4, std::move(of_voce)),
                                          uninformed(Law::Linear, 0.04, 3, std::move(of_linear))});
    return c.laws[*c.advised].fit.law;
  };
  // 1 % more in each part: nothing, however sure.
  EXPECT_EQ(advised({0.0303, 0.0303, 0.0303}, {0.03, 0.03, 0.03}), Law::Linear);
  // 5 % more: in each part it is a difference, within its error it is none.
  EXPECT_EQ(advised({0.0315, 0.0315, 0.0315}, {0.03, 0.03, 0.03}), Law::Voce);
  EXPECT_EQ(advised({0.0415, 0.0215, 0.0285}, {0.03, 0.03, 0.03}), Law::Linear);
  // One part's alone is as large as its error: but a third more is no equal.
  EXPECT_EQ(advised({0.06, 0.03, 0.03}, {0.03, 0.03, 0.03}), Law::Voce);
}

/// A specimen's fits by two laws: misfits of parts held out, and of the specimen not seen.
std::vector<LawFit> specimen(double ideal, double linear, double by_ideal, double by_linear) {
  LawFit simple = uninformed(Law::Ideal, ideal, 2, {ideal, ideal});
  LawFit other = uninformed(Law::Linear, linear, 3, {linear, linear});
  simple.specimens = {by_ideal * by_ideal};
  other.specimens = {by_linear * by_linear};
  return {simple, other};
}

TEST(CompareLaws, RanksByThreeSpecimensThatWereNotSeen) {
  const std::vector<LawFit> a = specimen(0.1, 0.09, 0.1, 0.2), b = specimen(0.1, 0.09, 0.2, 0.1);
  EXPECT_EQ(compare_laws_over({a, a}).ranked_by, RankedBy::Parts);
  const LawComparison c = compare_laws_over({a, a, b});
  EXPECT_EQ(c.ranked_by, RankedBy::Specimens);
  EXPECT_EQ(c.laws[*c.advised].fit.law, Law::Ideal);
  EXPECT_NEAR(c.laws[0].unseen, std::sqrt(0.06 / 3.0), 1e-12);
  EXPECT_TRUE(c.advice.starts_with("ideal: specimens not seen are 14.1 % off, by linear 17.3 %"))
      << c.advice;
}

/// What specimens differ by, 15 % here, must not hide that a law misses each curve by 2.3 %.
TEST(CompareLaws, DoesNotLetScatterOfSpecimensHideALackOfFit) {
  const auto of = [](double scatter) {
    return specimen(0.023, 0.0037, std::hypot(scatter, 0.023), std::hypot(scatter, 0.0037));
  };
  const LawComparison c = compare_laws_over({of(0.12), of(0.15), of(0.18)});
  EXPECT_EQ(c.ranked_by, RankedBy::Specimens);
  EXPECT_LT(c.laws[1].unseen, 1.02 * c.laws[0].unseen);
  EXPECT_EQ(c.laws[*c.advised].fit.law, Law::Linear);
}

TEST(CompareLaws, SaysWhereSpecimensSpeakAgainstInformation) {
  std::vector<LawFit> informed = specimen(0.1, 0.05, 0.1, 0.2);
  for (LawFit& fit : informed) fit.curves[0].autocorrelation = 0.0;
  const LawComparison c = compare_laws_over({informed, informed, informed});
  EXPECT_EQ(c.ranked_by, RankedBy::Information);
  EXPECT_EQ(c.laws[*c.advised].fit.law, Law::Linear);
  EXPECT_TRUE(c.advice.ends_with("; yet specimens not seen are 20 % off, by ideal 10 %"))
      << c.advice;
}

TEST(CompareLaws, ComparesByTheSpecimensThatAllLawsHave) {
  std::vector<LawFit> lacking = specimen(0.1, 0.09, 0.9, 0.2);
  lacking[1].specimens.clear();
  const std::vector<LawFit> a = specimen(0.1, 0.09, 0.1, 0.2);
  const LawComparison c = compare_laws_over({a, a, a, lacking});
  EXPECT_EQ(c.laws[0].fit.law, Law::Ideal);
  EXPECT_EQ(c.laws[0].fit.specimens.size(), 3U);
  EXPECT_EQ(c.laws[0].fit.parts.size(), 8U);
}

TEST(CompareLaws, DoesNotCompareByPartsOfUnequalNumber) {
  const LawComparison c = compare_laws(
      {uninformed(Law::Ideal, 0.1, 2, {0.1, 0.1, 0.1}), uninformed(Law::Linear, 0.05, 3, {0.01})});
  EXPECT_EQ(c.ranked_by, RankedBy::Information);
  EXPECT_TRUE(c.laws[0].fit.parts.empty());
}

TEST(CompareLaws, CountsWhatALawOwesToThePriorOfItsModulus) {
  LawFit fit = fit_of_law(Law::Ideal, 0.1, 2);
  const double without = compare_laws({fit}).laws[0].bic;
  fit.curves[0].prior = 9.0;
  EXPECT_NEAR(compare_laws({fit}).laws[0].bic - without, 9.0, 1e-9);
}

TEST(CompareLaws, SaysThatNothingRanksLawsOfFewSamples) {
  const LawComparison c =
      compare_laws({uninformed(Law::Ideal, 0.1, 2, {}), uninformed(Law::Linear, 0.05, 3, {})});
  EXPECT_EQ(c.ranked_by, RankedBy::Information);
  EXPECT_TRUE(
      c.advice.ends_with("; yet BIC rests on samples worth 5.3, and nothing was "
                         "cross-validated: not comparable, calibrate again"))
      << c.advice;
}

}  // namespace
}  // namespace plastica::calibrate
