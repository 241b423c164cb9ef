#include "calibrate/report/scene_population.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "calibrate/inference/bootstrap.hpp"
#include "calibrate/inference/material_interval.hpp"
#include "calibrate/inference/mean_interval.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::optional<std::size_t> index_of(const SceneFitResult& result, const std::string& path) {
  for (std::size_t i = 0; i < result.free_count(); ++i) {  // they stand first
    if (result.parameters[i].path == path) return i;
  }
  return std::nullopt;
}

bool is_determined(const FittedParameter& p) {
  return !p.at_bound() && std::isfinite(p.value) && std::isfinite(p.scatter_error()) &&
         std::isfinite(p.standard_error);
}

/// The fits of a population: each parameter's value and error, each pair's correlation.
class Fits {
 public:
  Fits(std::span<const SceneFitRecord> records, const std::vector<FittedParameter>& parameters)
      : n_(parameters.size()) {
    for (const SceneFitRecord& record : records) {
      if (is_usable(record.result)) add(record.result, parameters);
    }
    for (std::size_t a = 0; a < n_; ++a) take_material(a);
  }

  bool is_of_material(std::size_t a) const { return is_of_material_[a]; }
  double segments_error(std::size_t a) const { return segments_error_[a]; }

  std::size_t size() const { return there_.size() / n_; }
  bool has(std::size_t fit, std::size_t a) const { return there_[fit * n_ + a]; }
  double value(std::size_t fit, std::size_t a) const { return value_[fit * n_ + a]; }
  /// Half the interval between the samples that a break lies between; 0 of others.
  double half(std::size_t fit, std::size_t a) const { return sampling_[fit * n_ + a]; }
  /// rho s_a s_b; NaN where not both are determined.
  double noise(std::size_t fit, std::size_t a, std::size_t b) const {
    return noise_[(fit * n_ + a) * n_ + b];
  }

 private:
  void add(const SceneFitResult& result, const std::vector<FittedParameter>& parameters) {
    std::vector<std::optional<std::size_t>> at;
    for (const FittedParameter& like : parameters) {
      at.push_back(index_of(result, like.path));
      there_.push_back(at.back().has_value());
      value_.push_back(at.back() ? result.parameters[*at.back()].value : kNan);
      sampling_.push_back(at.back() ? std::sqrt(3.0) * result.parameters[*at.back()].sampling_error
                                    : 0.0);
      const auto material = at.back() ? material_value(result, *at.back()) : std::nullopt;
      material_.push_back(material.value_or(kNan));
      half_.push_back(material ? result.segments->parameters[*at.back()].extrapolated_error : 0.0);
    }
    const std::size_t n = result.free_count();
    const bool correlated = result.correlation.size() == n * n;
    for (const auto& i : at) {
      for (const auto& j : at) {
        noise_.push_back(kNan);
        if (!i || !j) continue;
        const FittedParameter& p = result.parameters[*i];
        const FittedParameter& q = result.parameters[*j];
        if (!is_determined(p) || !is_determined(q)) continue;
        const double rho = i == j ? 1.0 : correlated ? result.correlation[*i * n + *j] : kNan;
        noise_.back() = rho * p.scatter_error() * q.scatter_error();
      }
    }
  }

  /// Values of the material and of beams do not mix: all that are determined, or none.
  void take_material(std::size_t a) {
    double halves = 0.0;
    std::size_t found = 0;
    bool all = true;
    for (std::size_t fit = 0; fit < size(); ++fit) {
      if (!std::isfinite(noise(fit, a, a))) continue;
      all = all && std::isfinite(material_[fit * n_ + a]);
      halves += half_[fit * n_ + a];
      ++found;
    }
    is_of_material_.push_back(all && found > 0);
    segments_error_.push_back(is_of_material_.back() ? halves / static_cast<double>(found) : 0.0);
    if (!is_of_material_.back()) return;
    for (std::size_t fit = 0; fit < size(); ++fit) value_[fit * n_ + a] = material_[fit * n_ + a];
  }

  std::size_t n_;
  std::vector<bool> there_;
  std::vector<double> value_, noise_, material_, half_, sampling_;
  std::vector<bool> is_of_material_;
  std::vector<double> segments_error_;
};

/// Moments of a pair of parameters over the fits that determine both; of a parameter with itself
/// its variance.
struct Moments {
  std::size_t n = 0;
  double mean = kNan;      ///< of the first
  double noise = kNan;     ///< mean of rho s_a s_b
  double observed = kNan;  ///< with n - 1; NaN for n < 2
};

Moments moments_of(const Fits& fits, std::span<const std::size_t> drawn, std::size_t a,
                   std::size_t b) {
  Moments moments;
  double sum_a = 0.0, sum_b = 0.0, noise = 0.0;
  for (const std::size_t fit : drawn) {
    const double its_noise = fits.noise(fit, a, b);
    if (!std::isfinite(its_noise)) continue;
    ++moments.n;
    sum_a += fits.value(fit, a);
    sum_b += fits.value(fit, b);
    noise += its_noise;
  }
  const auto n = static_cast<double>(moments.n);
  if (moments.n == 0) return moments;
  moments.mean = sum_a / n;
  moments.noise = noise / n;
  if (moments.n < 2) return moments;
  moments.observed = 0.0;
  for (const std::size_t fit : drawn) {
    if (!std::isfinite(fits.noise(fit, a, b))) continue;
    moments.observed += (fits.value(fit, a) - moments.mean) * (fits.value(fit, b) - sum_b / n);
  }
  moments.observed /= n - 1.0;
  return moments;
}

/// sqrt(max(0, variance)); NaN of NaN.
double deviation_of(const Moments& moments) {
  const double left = moments.observed - moments.noise;
  return left < 0.0 ? 0.0 : std::sqrt(left);
}

double specimen_covariance_of(const Moments& moments, double most) {
  const double left = moments.observed - moments.noise;
  return std::isnan(left) || std::isnan(most) ? kNan : std::clamp(left, -most, most);
}

/// What one resample of the fits says.
struct Resample {
  std::vector<double> deviation;   ///< (n_parameters)
  std::vector<double> covariance;  ///< of the specimens (n_parameters x same)
};

Resample resample_of(const Fits& fits, std::span<const std::size_t> drawn, std::size_t n) {
  Resample resample;
  for (std::size_t a = 0; a < n; ++a) {
    resample.deviation.push_back(deviation_of(moments_of(fits, drawn, a, a)));
  }
  resample.covariance.resize(n * n);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a; b < n; ++b) {
      const double most = resample.deviation[a] * resample.deviation[b];
      resample.covariance[a * n + b] = resample.covariance[b * n + a] =
          specimen_covariance_of(moments_of(fits, drawn, a, b), most);
    }
  }
  return resample;
}

/// Of the specimens' deviation: chi-squared of the values' variance, less the noise.
void set_deviation_interval(const Moments& moments, double confidence, PopulationParameter& p) {
  if (moments.n < 2) return;
  const double degrees = static_cast<double>(moments.n - 1);
  const auto bound = [&](double probability) {
    const double variance =
        degrees * moments.observed / theory::chi_squared_quantile(probability, degrees);
    return std::sqrt(std::max(0.0, variance - moments.noise));
  };
  p.deviation_low = bound(0.5 + 0.5 * confidence);
  p.deviation_high = bound(0.5 - 0.5 * confidence);
}

/// Of the means by mean_interval.hpp, of pairs percentiles over resamples of the fits.
void add_intervals(const Fits& fits, double confidence, ScenePopulation& population) {
  std::vector<PopulationParameter>& parameters = population.parameters;
  const std::size_t n = parameters.size();
  population.covariance_low.assign(n * n, kNan);
  population.covariance_high.assign(n * n, kNan);
  for (PopulationParameter& p : parameters) {
    p.mean_low = p.mean_high = p.deviation_low = p.deviation_high = kNan;
  }
  for (std::size_t a = 0; a < n; ++a) {
    std::vector<double> values;
    double squares = 0.0;
    for (std::size_t fit = 0; fit < fits.size(); ++fit) {
      if (!std::isfinite(fits.noise(fit, a, a))) continue;
      values.push_back(fits.value(fit, a));
      squares += fits.half(fit, a) * fits.half(fit, a);
    }
    if (values.size() < 2) continue;
    const double half = std::sqrt(squares / static_cast<double>(values.size()));
    const MeanInterval mean =
        mean_interval(std::move(values), {kPopulationResamples, 1, confidence}, half);
    parameters[a].sampling_error = mean.sampling_error;
    parameters[a].mean_low = mean.low;
    parameters[a].mean_high = mean.high;
  }
  std::vector<std::size_t> drawn(fits.size());
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  for (std::size_t a = 0; a < n; ++a) {
    PopulationParameter& p = parameters[a];
    set_deviation_interval(moments_of(fits, drawn, a, a), confidence, p);
    population.covariance_low[a * n + a] = p.deviation_low * p.deviation_low;
    population.covariance_high[a * n + a] = p.deviation_high * p.deviation_high;
  }
  if (fits.size() < kMinSpecimens) return;
  std::vector<Resample> resamples;
  for (int b = 0; b < kPopulationResamples; ++b) {
    Draws draws(1, static_cast<std::uint64_t>(b));
    for (std::size_t& fit : drawn) fit = draws.below(fits.size());
    resamples.push_back(resample_of(fits, drawn, n));
  }
  const auto interval = [&](auto number) {
    std::vector<double> values;
    for (const Resample& resample : resamples) {
      if (std::isfinite(number(resample))) values.push_back(number(resample));
    }
    return bootstrap_interval(std::move(values), confidence);
  };
  for (std::size_t a = 0; a < n; ++a) {
    if (parameters[a].n < kMinSpecimens) continue;
    for (std::size_t b = 0; b < n; ++b) {
      if (b == a || parameters[b].n < kMinSpecimens) continue;
      const auto both = interval([&](const Resample& r) { return r.covariance[a * n + b]; });
      population.covariance_low[a * n + b] = both.low;
      population.covariance_high[a * n + b] = both.high;
    }
  }
}

}  // namespace

std::optional<double> material_value(const SceneFitResult& result, std::size_t parameter) {
  if (!result.segments || parameter >= result.segments->parameters.size()) return std::nullopt;
  const SegmentsError& segments = result.segments->parameters[parameter];
  if (!std::isfinite(segments.extrapolated) || !std::isfinite(segments.extrapolated_error) ||
      !is_of_material(result.parameters[parameter], segments)) {
    return std::nullopt;
  }
  return segments.extrapolated;
}

double ScenePopulation::correlation(std::size_t a, std::size_t b) const {
  const double size = parameters[a].specimen_deviation * parameters[b].specimen_deviation;
  return size > 0.0 ? specimen_covariance[a * parameters.size() + b] / size : kNan;
}

ScenePopulation scene_population(std::span<const SceneFitRecord> records, double confidence) {
  ScenePopulation population;
  const auto first = std::ranges::find(records, FitStatus::Fitted,
                                       [](const SceneFitRecord& r) { return r.result.status; });
  if (first == records.end()) return population;
  std::vector<FittedParameter> free = first->result.parameters;
  free.resize(first->result.free_count());  // they stand first
  const Fits fits(records, free);
  std::vector<std::size_t> all(fits.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::size_t n = free.size();
  const Resample whole = resample_of(fits, all, n);
  for (std::size_t a = 0; a < n; ++a) {
    const Moments moments = moments_of(fits, all, a, a);
    PopulationParameter p;
    p.path = free[a].path;
    p.dimension = free[a].dimension;
    p.n = moments.n;
    const auto there =
        std::ranges::count_if(all, [&](std::size_t fit) { return fits.has(fit, a); });
    p.left_out = static_cast<std::size_t>(there) - p.n;
    p.is_of_material = fits.is_of_material(a);
    p.segments_error = fits.segments_error(a);
    p.mean = moments.mean;
    p.standard_deviation = std::sqrt(moments.observed);
    p.rms_error = std::sqrt(moments.noise);
    p.specimen_deviation = whole.deviation[a];
    population.parameters.push_back(std::move(p));
    for (std::size_t b = 0; b < n; ++b) {
      population.covariance.push_back(moments_of(fits, all, a, b).observed);
    }
  }
  population.specimen_covariance = whole.covariance;
  add_intervals(fits, confidence, population);
  return population;
}

}  // namespace plastica::calibrate
