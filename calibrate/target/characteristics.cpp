#include "calibrate/target/characteristics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

using Values = std::span<const double>;

/// First loading: samples up to the largest stress (monotonic) or the first turn (cyclic).
std::size_t end_of_loading(const Curve& curve, Loading loading, double& sign) {
  const auto& stress = curve.stress;
  sign = 1.0;
  if (loading == Loading::Monotonic) {
    const auto peak = std::max_element(stress.begin(), stress.end());
    return static_cast<std::size_t>(peak - stress.begin()) + 1;
  }
  double largest = 0.0;
  for (const double value : stress) largest = std::max(largest, std::abs(value));
  std::size_t peak = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    if (std::abs(stress[i]) > std::abs(stress[peak])) peak = i;
    const bool reversed = stress[i] * stress[peak] < 0.5 * stress[peak] * stress[peak];
    if (reversed && std::abs(stress[peak]) >= 0.5 * largest) break;
  }
  if (stress[peak] < 0.0) sign = -1.0;
  return peak + 1;
}

struct Window {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Samples from the last at or below `low` to the first above `high`, both left out.
Window window_of(Values stress, double sign, double low, double high) {
  Window window;
  while (window.end < stress.size() && sign * stress[window.end] <= high) ++window.end;
  window.begin = window.end;
  while (window.begin > 0 && sign * stress[window.begin - 1] > low) --window.begin;
  return window;
}

ElasticLine regress(Values strain, Values stress, double noise) {
  const double n = static_cast<double>(strain.size());
  double mean_strain = 0.0;
  double mean_stress = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    mean_strain += strain[i];
    mean_stress += stress[i];
  }
  mean_strain /= n;
  mean_stress /= n;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const double x = strain[i] - mean_strain;
    sxx += x * x;
    sxy += x * (stress[i] - mean_stress);
  }
  ElasticLine line;
  line.samples = strain.size();
  if (!(sxx > 0.0)) return line;
  line.modulus = sxy / sxx;
  line.zero_strain = mean_strain - mean_stress / line.modulus;
  double squares = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const double r = stress[i] - mean_stress - line.modulus * (strain[i] - mean_strain);
    squares += r * r;
  }
  const double scatter = std::max(noise, std::sqrt(squares / (n - 2.0)));
  line.modulus_stderr = scatter / std::sqrt(sxx);
  const double arm = mean_strain - line.zero_strain;
  line.zero_strain_stderr = scatter / line.modulus * std::sqrt(1.0 / n + arm * arm / sxx);
  return line;
}

std::optional<ElasticLine> line_in(Values strain, Values stress, double sign, double low,
                                   double high, double noise) {
  const Window window = window_of(stress, sign, low, high);
  const std::size_t count = window.end - window.begin;
  if (count < 3) return std::nullopt;
  ElasticLine line =
      regress(strain.subspan(window.begin, count), stress.subspan(window.begin, count), noise);
  if (!(line.modulus > 0.0) || !std::isfinite(line.modulus)) return std::nullopt;
  line.low = std::max(low, 0.0);
  line.high = high;
  return line;
}

std::optional<ElasticLine> automatic_line(Values strain, Values stress, double sign, double yield,
                                          double noise, const TargetOptions& options) {
  double low = options.modulus_low;
  double high = options.modulus_high;
  for (int widening = 0; widening < 20; ++widening) {
    // At the widest the noise around the first sample must not cut it off.
    const double floor = low <= 0.0 ? -std::numeric_limits<double>::infinity() : low * yield;
    auto line = line_in(strain, stress, sign, floor, high * yield, noise);
    // Upwards only if there is no other way: the yield may be there.
    const bool enough = line.has_value();
    const bool exact = enough && line->modulus_stderr <= 0.03 * line->modulus;
    if (exact || (low <= 0.0 && (enough || high >= 0.8))) return line;
    low = std::max(0.0, low - 0.1);
    if (!enough) high = std::max(high, std::min(0.8, high + 0.1));
  }
  return std::nullopt;
}

/// Stress on the curve at a given level, for a chord: strain by linear interpolation.
std::optional<double> strain_at(Values strain, Values stress, double sign, double level) {
  for (std::size_t i = 1; i < stress.size(); ++i) {
    const double a = sign * stress[i - 1];
    const double b = sign * stress[i];
    if (a <= level && level <= b && b > a) {
      return strain[i - 1] + (level - a) / (b - a) * (strain[i] - strain[i - 1]);
    }
  }
  return std::nullopt;
}

std::optional<ElasticLine> chord(Values strain, Values stress, double sign, double low,
                                 double high) {
  const auto a = strain_at(strain, stress, sign, low);
  const auto b = strain_at(strain, stress, sign, high);
  if (!a || !b || !(sign * (*b - *a) > 0.0)) return std::nullopt;
  ElasticLine line;
  line.modulus = sign * (high - low) / (*b - *a);
  line.zero_strain = *a - sign * low / line.modulus;
  line.low = low;
  line.high = high;
  line.samples = 2;
  return line;
}

}  // namespace

bool sees_offset(double modulus, double offset, double noise) {
  return 6.0 * noise < modulus * offset;
}

double noise_of(std::span<const double> strain, std::span<const double> stress) {
  if (stress.size() < 5) return 0.0;
  // Enough for a median, and a curve of many thousand samples costs no more than a short one.
  const std::size_t stride = std::max<std::size_t>(1, stress.size() / 2000);
  std::vector<double> bends;
  bends.reserve(stress.size() / stride + 1);
  for (std::size_t i = 1; i + 1 < stress.size(); i += stride) {
    const double gap = strain[i + 1] - strain[i - 1];
    const double fraction = gap != 0.0 ? (strain[i] - strain[i - 1]) / gap : 0.5;
    const double a = std::clamp(fraction, 0.0, 1.0);
    const double bend = stress[i] - (1.0 - a) * stress[i - 1] - a * stress[i + 1];
    bends.push_back(std::abs(bend) / std::sqrt(1.0 + a * a + (1.0 - a) * (1.0 - a)));
  }
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  std::nth_element(bends.begin(), middle, bends.end());
  return *middle / 0.6745;
}

std::optional<ElasticLine> find_elastic_line(const Curve& curve, Loading loading, double noise,
                                             const TargetOptions& options) {
  double sign = 1.0;
  const std::size_t end = end_of_loading(curve, loading, sign);
  const Values strain = Values(curve.strain).first(end);
  const Values stress = Values(curve.stress).first(end);
  const double peak = std::abs(stress.back());

  if (options.youngs_modulus) {
    ElasticLine line;
    line.modulus = *options.youngs_modulus;
    line.yield_stress = peak;
    return line;
  }
  if (options.modulus_window) {
    const auto [low, high] = *options.modulus_window;
    if (!(low >= 0.0 && low < high)) {
      throw InputError({}, "modulus_window", std::to_string(low) + " … " + std::to_string(high),
                       "must rise from a stress of zero or more");
    }
    auto line = options.modulus_method == ModulusMethod::Chord
                    ? chord(strain, stress, sign, low, high)
                    : line_in(strain, stress, sign, low, high, noise);
    if (line) line->yield_stress = peak;
    return line;
  }
  if (options.modulus_method == ModulusMethod::Chord) {
    throw InputError({}, "modulus_window", "", "is required for a modulus by chord");
  }

  // The window is a fraction of the proof stress, which needs the modulus: a few rounds settle it.
  double yield = peak;
  auto line = automatic_line(strain, stress, sign, yield, noise, options);
  const bool monotonic = loading == Loading::Monotonic;
  for (int round = 0; line && round < 8; ++round) {
    line->yield_stress = yield;
    if (!monotonic || !sees_offset(line->modulus, options.offset, noise)) break;
    const auto proof =
        proof_stress(curve.strain, curve.stress, line->modulus, line->zero_strain, options.offset);
    if (!proof || !(*proof > 0.2 * peak) || std::abs(*proof - yield) <= 1e-4 * yield) break;
    auto next = automatic_line(strain, stress, sign, *proof, noise, options);
    if (!next) break;
    yield = *proof;
    line = next;
    line->yield_stress = yield;
  }
  return line;
}

std::optional<double> proof_stress(std::span<const double> strain, std::span<const double> stress,
                                   double modulus, double zero_strain, double offset) {
  const auto above = [&](std::size_t i) {
    return stress[i] - modulus * (strain[i] - zero_strain - offset);
  };
  if (stress.empty() || above(stress.size() - 1) > 0.0) return std::nullopt;
  for (std::size_t i = stress.size() - 1; i > 0; --i) {
    const double before = above(i - 1);
    if (before <= 0.0) continue;
    const double fraction = before / (before - above(i));
    return stress[i - 1] + fraction * (stress[i] - stress[i - 1]);
  }
  return std::nullopt;
}

std::optional<YieldPoint> find_yield_point(std::span<const double> stress, double noise,
                                           double yield_drop) {
  if (stress.empty()) return std::nullopt;
  const double largest = *std::max_element(stress.begin(), stress.end());
  YieldPoint point{stress[0], stress[0]};
  bool dropped = false;
  for (const double value : stress) {
    if (value > point.upper) {
      if (dropped) return point;
      point = {value, value};
    }
    point.lower = std::min(point.lower, value);
    // A stumble at the foot is no yield point.
    dropped =
        dropped || (point.upper > 0.3 * largest &&
                    point.upper - point.lower > std::max(yield_drop * point.upper, 8.0 * noise));
  }
  return std::nullopt;
}

}  // namespace plastica::calibrate
