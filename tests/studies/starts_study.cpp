// Whether the search finds the best fit from wherever it starts: 100 fits of each problem, each
// from a start of its own, anywhere within bounds of a factor of 30 both ways, and with a seed of
// its own. PLASTICA_STUDY=full runs all, =sample three of each cheap one.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/studies/starts_scenes.hpp"

namespace plastica::studies {
namespace {

using calibrate::FitStatus;
using calibrate::Parameter;
using calibrate::SceneFitOptions;
using calibrate::SceneFitResult;

/// A cost within this fraction of the least that is known is the best.
constexpr double kSame = 1e-6;

/// Starts that are uniform in the logarithm of each parameter.
std::vector<Parameter> far_off(std::vector<Parameter> parameters, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (Parameter& p : parameters) {
    const double fraction = static_cast<double>(random() >> 11U) * 0x1p-53;
    p.value = *p.lower * std::pow(*p.upper / *p.lower, fraction);
  }
  return parameters;
}

/// The fits of one problem from many starts.
struct Tally {
  std::vector<double> costs;
  double best = std::numeric_limits<double>::infinity();
  double runs = 0.0;

  void add(const SceneFitResult& fit) {
    costs.push_back(fit.status == FitStatus::Fitted ? fit.targets[0].cost
                                                    : std::numeric_limits<double>::infinity());
    best = std::min(best, costs.back());
    runs += fit.runs;
  }
  auto reached() const {
    return std::ranges::count_if(costs, [&](double cost) { return cost <= best * (1.0 + kSame); });
  }
};

/// @param starts  of each search; 1: from the given start alone
Tally fit_from(const StartsProblem& problem, int fits, int starts, double best) {
  Tally tally;
  tally.best = best;
  for (int i = 0; i < fits; ++i) {
    SceneFitOptions options;
    options.seed = 1000 + static_cast<std::uint64_t>(i);
    options.parameters = far_off(problem.parameters, options.seed);
    if (starts > 0) options.starts = starts;
    options.segments_error = false;
    tally.add(fit(std::vector{problem.weighted}, options));
  }
  return tally;
}

TEST(Starts, ReachTheBestFitFromWhereverTheyAre) {
  const char* study = std::getenv("PLASTICA_STUDY");
  const bool full = study != nullptr && std::string(study) == "full";
  const int fits = full ? 100 : 3;
  for (const StartsProblem& problem : starts_problems()) {
    if (!full && !problem.cheap) continue;
    SceneFitOptions at_truth{
        .parameters = problem.parameters, .starts = 1, .segments_error = false};
    Tally truth;
    truth.add(fit(std::vector{problem.weighted}, at_truth));
    const Tally found = fit_from(problem, fits, 0, truth.best);
    fmt::print("{:16} {} of {} reach the best cost, {:.0f} runs a fit", problem.name,
               found.reached(), fits, found.runs / fits);
    if (full) {
      const Tally alone = fit_from(problem, fits, 1, found.best);
      fmt::print("; a search alone {}, {:.0f} runs", alone.reached(), alone.runs / fits);
    }
    fmt::print("; from the truth {:.0f} runs, cost over the best - 1 = {:.1g}\n", truth.runs,
               truth.best / found.best - 1.0);
    std::fflush(stdout);
    EXPECT_GE(found.reached(), full ? 95 : fits) << problem.name;
  }
}

}  // namespace
}  // namespace plastica::studies
