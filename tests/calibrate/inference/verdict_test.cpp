#include "calibrate/inference/verdict.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "calibrate/inference/not_a_number.hpp"

namespace plastica::calibrate {
namespace {

/// A parameter of 100 within 10 and 400 with an error of 1.
Evidence valid() {
  return {.value = 100.0, .lower = 10.0, .upper = 400.0, .noise_error = 1.0, .standard_error = 1.0};
}

TEST(Verdict, HasTheNumberBehindItsWord) {
  const Judgement identified = judge(valid());
  EXPECT_EQ(identified.verdict, Verdict::Identified);
  EXPECT_DOUBLE_EQ(identified.number, 0.01);

  Evidence evidence = valid();
  evidence.standard_error = evidence.noise_error = 10.1;
  EXPECT_EQ(judge(evidence).verdict, Verdict::Weak);
  EXPECT_DOUBLE_EQ(judge(evidence).number, 0.101);

  evidence = valid();
  evidence.noise_error = kNan;
  EXPECT_EQ(judge(evidence).verdict, Verdict::NotIdentified);

  evidence = valid();
  evidence.at_bound = true;
  EXPECT_EQ(judge(evidence).verdict, Verdict::AtBound);
  EXPECT_EQ(judge(evidence).number, 10.0);
  evidence.value = 399.0;
  EXPECT_EQ(judge(evidence).number, 400.0);
}

TEST(Verdict, OfABreakIsSamplingWhereItMattersMoreThanNoise) {
  Evidence evidence = valid();
  evidence.half = 1.7;  // its variance is a third of its square
  EXPECT_EQ(judge(evidence).verdict, Verdict::Identified);
  evidence.half = 1.8;
  EXPECT_EQ(judge(evidence).verdict, Verdict::LimitedBySampling);
  EXPECT_DOUBLE_EQ(judge(evidence).number, 0.018);
}

TEST(Verdict, IsSegmentsWhereTheyMatterMoreThanNoiseAndSampling) {
  Evidence evidence = valid();
  evidence.segments = 1.7;
  EXPECT_EQ(judge(evidence).verdict, Verdict::Identified);
  evidence.segments = 1.8;
  EXPECT_EQ(judge(evidence).verdict, Verdict::LimitedBySegments);
  EXPECT_DOUBLE_EQ(judge(evidence).number, 0.018);
  evidence.half = 2.0;
  EXPECT_EQ(judge(evidence).verdict, Verdict::LimitedBySampling);
  evidence.segments = 2.1;
  EXPECT_EQ(judge(evidence).verdict, Verdict::LimitedBySegments);
  evidence.noise_error = kNan;
  EXPECT_EQ(judge(evidence).verdict, Verdict::NotIdentified);
}

TEST(Verdict, CountsRunsAsWaldAndWolfowitz) {
  // 20 of each sign in two blocks: 2 of the 40!/(20! 20!) orders.
  std::vector<double> blocks(40, 1.0);
  for (std::size_t i = 20; i < 40; ++i) blocks[i] = -1.0;
  EXPECT_NEAR(runs_test_p(blocks) / (2.0 / 137846528820.0), 1.0, 1e-9);
  std::vector<double> to_and_fro(40, 1.0);
  for (std::size_t i = 0; i < 40; i += 2) to_and_fro[i] = -1.0;
  EXPECT_NEAR(runs_test_p(to_and_fro), 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(runs_test_p(std::vector<double>(19, 1.0))));
}

/// Wald and Wolfowitz's limit for many: a normal distribution, here with a correction for that runs
/// are whole numbers; what is left of it is skewness, 1e-3 at 2 000. Among the lengths those about
/// which logarithms are kept.
TEST(Verdict, CountsTheRunsOfManyAsTheirNormalLimit) {
  std::mt19937 random(3);
  for (const int length : {2000, 4095, 4096, 4097, 9000}) {
    std::vector<double> signs;
    double above = 0.0, below = 0.0, runs = 1.0;
    for (int i = 0; i < length; ++i) {
      signs.push_back(random() % 3 == 0 ? -1.0 : 1.0);
      ++(signs.back() > 0.0 ? above : below);
      if (i > 0 && signs[static_cast<std::size_t>(i) - 1] != signs.back()) ++runs;
    }
    const double mean = 1.0 + 2.0 * above * below / (above + below);
    const double deviation = std::sqrt((mean - 1.0) * (mean - 2.0) / (above + below - 1.0));
    const double limit = 0.5 * std::erfc(-(runs + 0.5 - mean) / deviation / std::sqrt(2.0));
    EXPECT_NEAR(runs_test_p(signs), limit, 2e-3) << length;
  }
}

TEST(Verdict, CountsRunsAsAllOrdersDo) {
  // 10 and 11 of the signs, with 6 runs: counted over all orders.
  std::vector<double> residual(21, -1.0);
  for (const std::size_t i : {0U, 1U, 2U, 6U, 7U, 8U, 12U, 13U, 14U, 15U}) residual[i] = 1.0;
  int fewer = 0, all = 0;
  for (unsigned signs = 0; signs < 1U << 21U; ++signs) {
    if (std::popcount(signs) != 10) continue;
    ++all;
    fewer += std::popcount((signs ^ (signs >> 1U)) & 0xfffffU) + 1 <= 6 ? 1 : 0;
  }
  EXPECT_NEAR(runs_test_p(residual), static_cast<double>(fewer) / all, 1e-9);
}

TEST(Verdict, CountsFewOfOneSignAndTheirRuns) {
  // None of the other sign: twice what 2 of 2^40 orders are.
  EXPECT_NEAR(runs_test_p(std::vector<double>(40, 1.0)) / std::ldexp(4.0, -40), 1.0, 1e-9);
  // Nine of 29 in one block: 21 of C(29, 9) orders have so few runs, of which 2 have two.
  std::vector<double> block(29, 1.0);
  for (std::size_t i = 10; i < 19; ++i) block[i] = -1.0;
  const double orders = 10015005.0;
  EXPECT_NEAR(runs_test_p(block) / (2.0 * (2.0 + 19.0 + 8.0) / orders), 1.0, 1e-9);
}

TEST(Verdict, IsThePriorsWhereThatSaysMoreThanTheCurves) {
  Evidence evidence{.value = 1.0, .lower = 0.1, .upper = 10.0, .noise_error = 0.02};
  evidence.standard_error = 0.02;
  evidence.prior = 0.4;
  EXPECT_EQ(judge(evidence).verdict, Verdict::Identified);
  evidence.prior = 0.6;
  EXPECT_EQ(judge(evidence).verdict, Verdict::FromPrior);
  EXPECT_EQ(judge(evidence).number, 0.6);
  EXPECT_EQ(name_of(Verdict::FromPrior), "from its prior");
}

}  // namespace
}  // namespace plastica::calibrate
