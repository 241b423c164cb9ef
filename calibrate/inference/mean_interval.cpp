#include "calibrate/inference/mean_interval.hpp"

#include <algorithm>
#include <cmath>

#include "calibrate/inference/bootstrap.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

struct MeanAndError {
  double mean = 0.0;
  double error = 0.0;     ///< of it
  double variance = 0.0;  ///< of the values, with n
};

MeanAndError mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  MeanAndError found;
  for (const double value : values) found.mean += value / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - found.mean) * (value - found.mean);
  found.error = std::sqrt(squares / (n - 1.0) / n);
  found.variance = squares / n;
  return found;
}

}  // namespace

MeanInterval mean_interval(std::vector<double> values, const SpecimenDraws& how, double half) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const MeanAndError all = mean_of(values);
  const double degrees = static_cast<double>(n) - 1.0;
  const double t = theory::student_t_quantile(0.5 * (1.0 + how.confidence), degrees);
  const double common = std::sqrt(std::max(0.0, half * half - all.variance));
  // Of a t that reaches so far, with what all breaks share.
  const auto reach = [&](double reached) {
    return common > 0.0 ? theory::half_interval(how.confidence, reached / t, degrees, {&common, 1})
                        : reached;
  };
  MeanInterval interval;
  interval.sampling_error = common / std::sqrt(3.0);
  interval.standard_error = std::hypot(all.error, interval.sampling_error);
  interval.low = all.mean - reach(t * all.error);
  interval.high = all.mean + reach(t * all.error);
  if (how.resamples == 0 || n < kFewestToDraw || !(all.error > 0.0)) return interval;
  std::vector<double> pivots;
  std::vector<double> drawn(n);
  for (int b = 0; b < how.resamples; ++b) {
    // Other draws than those of the residuals.
    Draws draws(~how.seed, static_cast<std::uint64_t>(b));
    for (double& value : drawn) value = values[draws.below(n)];
    const MeanAndError one = mean_of(drawn);
    if (one.error > 0.0) pivots.push_back((one.mean - all.mean) / one.error);
  }
  const BootstrapInterval quantiles = bootstrap_interval(std::move(pivots), how.confidence);
  interval.low = all.mean - reach(quantiles.high * all.error);
  interval.high = all.mean + reach(-quantiles.low * all.error);
  return interval;
}

}  // namespace plastica::calibrate
