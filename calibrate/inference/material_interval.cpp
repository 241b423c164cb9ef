#include "calibrate/inference/material_interval.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/verdict.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {

bool are_in_runs(double runs_test_p, double autocorrelation, double samples) {
  constexpr double kVeryAlike = 0.5;  // however few they are
  constexpr double kQuantile = 3.3;   // normal, of 1 in 2000
  return runs_test_p < kFewRuns || autocorrelation > kVeryAlike ||
         autocorrelation * std::sqrt(samples) > kQuantile;
}

double variance_inflation(double autocorrelation, double samples, int parameters) {
  const double most = std::max(1.0, samples / (parameters + 1.0));
  return std::min(samples / samples_worth(samples, autocorrelation), most);
}

void set_material_interval(double confidence, std::span<const double> halves,
                           const SegmentsError& segments, FittedParameter& p) {
  if (std::isnan(p.noise_error)) return;
  const double scale = p.model_error();
  std::vector<double> all(halves.begin(), halves.end());
  double centre = p.value;
  double off = 0.0;
  if (segments.trend != SegmentsTrend::Unknown) {
    centre = segments.extrapolated;
    all.push_back(segments.extrapolated_error);
    off = segments.error / std::sqrt(3.0);
  }
  p.standard_error = std::hypot(scale, p.sampling_error, off);
  const double reach = theory::half_interval(confidence, scale, p.degrees_of_freedom, all);
  p.interval_low = centre - reach;
  p.interval_high = centre + reach;
  // What segments leave open holds all that was searched: nothing is known of the material's.
  const double half = segments.extrapolated_error;
  if (p.upper > p.lower && centre - half <= p.lower && centre + half >= p.upper) {
    p.standard_error = p.interval_low = p.interval_high = FittedParameter::kNone;
  }
}

bool is_of_material(const FittedParameter& p, const SegmentsError& segments) {
  const double centre = 0.5 * (p.interval_low + p.interval_high);
  return std::abs(centre - segments.extrapolated) <= std::abs(centre - p.value);
}

}  // namespace plastica::calibrate
