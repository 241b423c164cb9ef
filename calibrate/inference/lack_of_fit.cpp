#include "calibrate/inference/lack_of_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "calibrate/inference/material_interval.hpp"
#include "calibrate/inference/verdict.hpp"

namespace plastica::calibrate {
namespace {

/// Misfits, as fractions of the largest value, above which a law may lack something: with residuals
/// in long runs; without a count of runs.
constexpr double kLacking = 0.01;
constexpr double kLackingForSure = 0.05;

}  // namespace

double effective_samples(std::span<const double> weight) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double w : weight) {
    sum += w;
    squares += w * w;
  }
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

double autocorrelation(std::span<const double> residual) {
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    squares += residual[i] * residual[i];
    if (i > 0) products += residual[i] * residual[i - 1];
  }
  return squares > 0.0 ? products / squares : 0.0;
}

double samples_worth(double samples, double autocorrelation) {
  constexpr double kMaxAlike = 0.999;  // more alike would leave no samples
  const double alike = std::clamp(autocorrelation, 0.0, kMaxAlike);
  return samples * (1.0 - alike) / (1.0 + alike);
}

StatedNoise judge_stated_noise(double over, double degrees) {
  constexpr double kQuantile = 3.09;  // of 0.999
  if (!(degrees > 0.5)) return StatedNoise::Fits;
  const double z = over * std::sqrt(2.0 * degrees) - std::sqrt(2.0 * degrees - 1.0);
  if (z > kQuantile) return StatedNoise::TooSmall;
  return z < -kQuantile && over < 0.5 ? StatedNoise::TooLarge : StatedNoise::Fits;
}

bool lacks_fit(double fraction, double runs_test_p) {
  return std::isnan(runs_test_p) ? fraction > kLackingForSure
                                 : runs_test_p < kFewRuns && fraction > kLacking;
}

std::string_view misfit_word(double fraction, double runs_test_p, double autocorrelation) {
  if (lacks_fit(fraction, runs_test_p)) return "poor";
  // Of no samples: for the word neighbours must be alike by much, not only surely.
  const bool is_noise = !std::isnan(runs_test_p) && !are_in_runs(runs_test_p, autocorrelation, 0.0);
  return is_noise || fraction < kLacking ? "close" : "fair";
}

std::string lack_of_fit(std::string_view law, double fraction, double runs_test_p,
                        std::string_view try_next) {
  if (!lacks_fit(fraction, runs_test_p)) return {};
  const bool counted = !std::isnan(runs_test_p);
  std::string text =
      fmt::format("{} does not describe this curve (misfit {:.2g} % of the largest value", law,
                  100.0 * fraction);
  if (counted) text += fmt::format(", runs test p {:.1g}", runs_test_p);
  text += "): errors are widened for it, and rough";
  if (!try_next.empty()) text += fmt::format("; try --laws {}", try_next);
  return text;
}

}  // namespace plastica::calibrate
