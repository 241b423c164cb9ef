// Teams of 1 to 4 096 processes, by simulation (`team_simulation.hpp`): how well they are used,
// with the times of fits and of all else as they were measured. First that the simulation gives
// what can be said without it. PLASTICA_STUDY=full prints the table of docs/many-machines.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "tests/studies/team_simulation.hpp"

namespace plastica::testing {
namespace {

constexpr std::array kDealings{Dealing::Guided, Dealing::Single, Dealing::Equal};

TEST(TeamSimulation, OfOneProcessIsTheSum) {
  const std::vector<double> seconds{0.5, 2.0, 0.25, 1.0};
  TeamCosts costs;
  costs.start = 0.1;
  costs.read = 0.2;
  costs.keep = 0.01;
  costs.merge = 0.03;
  for (const Dealing dealing : kDealings) {
    const TeamRun run = simulate_team(seconds, 1, dealing, costs);
    EXPECT_NEAR(run.shared, 3.75 + 4 * 0.01, 1e-12);
    EXPECT_NEAR(run.whole, 0.3 + run.shared + 4 * 0.03, 1e-12);
    EXPECT_EQ(run.asked, 0U);
  }
}

// Alike fits, without other costs: as many rounds as the fullest process has fits.
TEST(TeamSimulation, OfAlikeFitsTakesWholeRounds) {
  const std::vector<double> seconds(100, 2.0);
  for (const std::size_t processes : {1U, 2U, 3U, 7U, 64U, 100U, 200U}) {
    const double rounds = std::ceil(100.0 / static_cast<double>(processes));
    for (const Dealing dealing : {Dealing::Single, Dealing::Equal}) {
      EXPECT_NEAR(simulate_team(seconds, processes, dealing, {}).whole, 2.0 * rounds, 1e-9);
    }
    // Parts that shrink end within one fit of it.
    EXPECT_LE(simulate_team(seconds, processes, Dealing::Guided, {}).whole, 2.0 * (rounds + 1.0));
  }
}

// Where fits take no time, process 0 answers one question after the other.
TEST(TeamSimulation, IsBoundByTheAnswersOfProcessZero) {
  const std::vector<double> seconds(1000, 1e-3);
  TeamCosts costs;
  costs.answer = 1e-3;
  const TeamRun run = simulate_team(seconds, 513, Dealing::Single, costs);
  EXPECT_NEAR(run.shared, static_cast<double>(run.asked) * costs.answer, 0.01 * run.shared);
}

// No order of taking beats the longest fit, nor a full use of all; and taking single fits when free
// is within (2 - 1/P) of the best there is.
// Source: R. L. Graham, "Bounds on multiprocessing timing anomalies", SIAM J. Appl. Math. 17 (2),
// 1969, 416-429.
TEST(TeamSimulation, KeepsTheBoundsOfListScheduling) {
  std::mt19937_64 random(5);
  std::lognormal_distribution<double> draw(0.0, 1.5);
  for (const std::size_t processes : {2U, 5U, 16U, 50U}) {
    std::vector<double> seconds(400);
    for (double& one : seconds) one = draw(random);
    const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    const double least = std::max(*std::max_element(seconds.begin(), seconds.end()),
                                  sum / static_cast<double>(processes));
    for (const Dealing dealing : kDealings) {
      EXPECT_GE(simulate_team(seconds, processes, dealing, {}).whole, least * (1.0 - 1e-12));
    }
    const double single = simulate_team(seconds, processes, Dealing::Single, {}).whole;
    EXPECT_LE(single, least * (2.0 - 1.0 / static_cast<double>(processes)));
  }
}

/// What was measured on two cores, with Open MPI 4.1 (docs/many-machines.md says how).
struct Workload {
  const char* name;
  std::size_t count;   ///< fits or cases
  double median;       ///< of their times [s]
  double spread;       ///< of the logarithm of their times, normally distributed
  double read;         ///< for each process to read all inputs [s]
  double megabytes;    ///< of them
  double keep, merge;  ///< of each [s]
};

constexpr double kGigabit = 125e6;  // [bytes/s]: a file server over a plain network

constexpr std::array<Workload, 3> kWorkloads{{
    {"10 000 curves, one law", 10'000, 9e-4, 0.3, 5.0, 51.0, 3e-5, 4e-4},
    {"10 000 curves, five laws, profiles, 400 resamples", 50'000, 0.6, 1.0, 5.0, 51.0, 5e-5, 6e-4},
    {"1 000 fits through a scene, profiles, 100 resamples", 1'000, 15.0, 0.3, 0.2, 2.0, 2e-4, 2e-3},
}};

std::vector<double> times_of(const Workload& work) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> draw(std::log(work.median), work.spread);
  std::vector<double> seconds(work.count);
  for (double& one : seconds) one = draw(random);
  return seconds;
}

TeamCosts costs_of(const Workload& work) {
  TeamCosts costs;
  costs.start = 1.0;
  costs.read = work.read;
  costs.read_bytes = 1e6 * work.megabytes;
  costs.server_rate = kGigabit;
  costs.per_machine = 32;
  costs.ask = 2.4e-3;
  costs.answer = 25e-6;
  costs.keep = work.keep;
  costs.open = 1e-3;
  costs.merge = work.merge;
  return costs;
}

TEST(TeamStudy, GuidedPartsAreAsGoodAsSingleOnesWithATenthOfTheQuestions) {
  const char* study = std::getenv("PLASTICA_STUDY");
  const bool prints = study != nullptr && std::string(study) == "full";
  for (const Workload& work : kWorkloads) {
    const std::vector<double> seconds = times_of(work);
    const TeamCosts costs = costs_of(work);
    if (prints) std::printf("%s\n", work.name);
    for (const std::size_t processes : {1U, 2U, 4U, 16U, 64U, 256U, 1024U, 4096U}) {
      std::array<TeamRun, 3> runs;
      for (std::size_t k = 0; k < 3; ++k) {
        runs[k] = simulate_team(seconds, processes, kDealings[k], costs);
      }
      const double longest = *std::max_element(seconds.begin(), seconds.end());
      // The longest fit may be the last.
      EXPECT_LE(runs[0].shared, 1.02 * runs[1].shared + longest) << work.name << processes;
      if (processes <= 64 && processes > 1) {
        EXPECT_LT(10 * runs[0].asked, 9 * runs[1].asked + 10 * processes) << work.name << processes;
        if (seconds.size() >= 10'000) {
          EXPECT_LT(10 * runs[0].asked, runs[1].asked) << work.name << processes;
        }
      }
      if (!prints) continue;
      std::printf("| %zu | %.4g s |", processes, runs[0].whole);
      for (const TeamRun& run : runs) {
        std::printf(" %.1f |", 100.0 * efficiency(seconds, processes, run.whole));
      }
      std::printf(" %.1f | %zu, %zu |\n", 100.0 * efficiency(seconds, processes, runs[0].shared),
                  runs[0].asked, runs[1].asked);
    }
  }
}

}  // namespace
}  // namespace plastica::testing
