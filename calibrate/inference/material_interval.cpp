#include "calibrate/inference/material_interval.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibrate/inference/verdict.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {

bool are_in_runs(double runs_test_p, double autocorrelation) {
  constexpr double kAlike = 0.5;  // neighbours of noise are not
  return runs_test_p < kFewRuns || autocorrelation > kAlike;
}

double misfit_error(double noise_error, double autocorrelation, double samples, int parameters) {
  const double most = std::max(1.0, samples / (parameters + 1.0));
  const double rho = std::clamp(autocorrelation, 0.0, 1.0);
  const double times = rho < 1.0 ? std::min((1.0 + rho) / (1.0 - rho), most) : most;
  return noise_error * std::sqrt(times - 1.0);
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
}

}  // namespace plastica::calibrate
