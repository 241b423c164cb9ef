#include "calibrate/report/scene_population.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace plastica::calibrate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::optional<std::size_t> index_of(const SceneFitResult& result, const std::string& path) {
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    if (result.parameters[i].path == path) return i;
  }
  return std::nullopt;
}

bool is_determined(const SceneParameter& p) {
  return !p.at_bound && std::isfinite(p.value) && std::isfinite(p.standard_error);
}

/// Moments of a pair of parameters over the fits that determine both; of a parameter with itself
/// its variance.
struct Moments {
  double observed = kNan;
  double noise = kNan;
};

struct Sample {
  double a = 0.0, b = 0.0;
  double noise = 0.0;  ///< rho s_a s_b
};

std::vector<Sample> samples_of(std::span<const SceneFitRecord> records, const std::string& a,
                               const std::string& b) {
  std::vector<Sample> samples;
  for (const SceneFitRecord& record : records) {
    const SceneFitResult& result = record.result;
    if (result.status != FitStatus::Fitted) continue;
    const auto i = index_of(result, a);
    const auto j = index_of(result, b);
    if (!i || !j) continue;
    const SceneParameter& p = result.parameters[*i];
    const SceneParameter& q = result.parameters[*j];
    const std::size_t n = result.parameters.size();
    double rho = 1.0;
    if (*i != *j) rho = result.correlation.size() == n * n ? result.correlation[*i * n + *j] : kNan;
    if (!is_determined(p) || !is_determined(q) || !std::isfinite(rho)) continue;
    samples.push_back({p.value, q.value, rho * p.standard_error * q.standard_error});
  }
  return samples;
}

Moments moments_of(const std::vector<Sample>& samples) {
  const auto n = static_cast<double>(samples.size());
  if (samples.size() < 2) return {};
  double mean_a = 0.0, mean_b = 0.0;
  for (const Sample& s : samples) {
    mean_a += s.a / n;
    mean_b += s.b / n;
  }
  Moments moments{0.0, 0.0};
  for (const Sample& s : samples) {
    moments.observed += (s.a - mean_a) * (s.b - mean_b) / (n - 1.0);
    moments.noise += s.noise / n;
  }
  return moments;
}

PopulationParameter parameter_of(std::span<const SceneFitRecord> records,
                                 const SceneParameter& like) {
  PopulationParameter all;
  all.path = like.path;
  all.dimension = like.dimension;
  const std::vector<Sample> samples = samples_of(records, like.path, like.path);
  all.n = samples.size();
  for (const SceneFitRecord& record : records) {
    if (record.result.status != FitStatus::Fitted) continue;
    if (index_of(record.result, like.path)) ++all.left_out;
  }
  all.left_out -= all.n;
  double squares = 0.0;
  for (const Sample& s : samples) {
    all.mean += s.a / static_cast<double>(all.n);
    squares += s.noise / static_cast<double>(all.n);
  }
  if (all.n == 0) all.mean = kNan;
  all.rms_error = all.n == 0 ? kNan : std::sqrt(squares);
  const Moments moments = moments_of(samples);
  all.standard_deviation = std::sqrt(moments.observed);
  const double left = moments.observed - moments.noise;
  all.specimen_deviation = left < 0.0 ? 0.0 : std::sqrt(left);
  return all;
}

}  // namespace

double ScenePopulation::correlation(std::size_t a, std::size_t b) const {
  const double size = parameters[a].specimen_deviation * parameters[b].specimen_deviation;
  return size > 0.0 ? specimen_covariance[a * parameters.size() + b] / size : kNan;
}

ScenePopulation scene_population(std::span<const SceneFitRecord> records) {
  ScenePopulation population;
  const auto first = std::ranges::find(records, FitStatus::Fitted,
                                       [](const SceneFitRecord& r) { return r.result.status; });
  if (first == records.end()) return population;
  for (const SceneParameter& like : first->result.parameters) {
    population.parameters.push_back(parameter_of(records, like));
  }
  const auto& all = population.parameters;
  for (const PopulationParameter& a : all) {
    for (const PopulationParameter& b : all) {
      const Moments moments = moments_of(samples_of(records, a.path, b.path));
      const double most = a.specimen_deviation * b.specimen_deviation;
      const double left = moments.observed - moments.noise;
      population.covariance.push_back(moments.observed);
      population.specimen_covariance.push_back(
          std::isnan(left) || std::isnan(most) ? kNan : std::clamp(left, -most, most));
    }
  }
  return population;
}

}  // namespace plastica::calibrate
