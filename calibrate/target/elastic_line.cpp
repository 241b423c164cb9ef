#include "calibrate/target/elastic_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/deming_line.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

using Values = std::span<const double>;

/// Of the largest stress: a proof stress below it is none.
constexpr double kLeastProof = 0.02;

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
/// @param level  of a sample [Pa]
template <typename Level>
Window window_of(std::size_t samples, double low, double high, const Level& level) {
  Window window;
  while (window.end < samples && level(window.end) <= high) ++window.end;
  window.begin = window.end;
  while (window.begin > 0 && level(window.begin - 1) > low) --window.begin;
  return window;
}

/// The line through the samples of a window; empty if there are too few, or they do not rise.
/// @param low, high  of the window [Pa]
std::optional<DemingLine> regression_in(Values strain, Values stress, Window window, double low,
                                        double high, double noise) {
  const std::size_t count = window.end - window.begin;
  if (count < 3) return std::nullopt;
  DemingLine found =
      deming_line(strain.subspan(window.begin, count), stress.subspan(window.begin, count), noise);
  ElasticLine& line = found.line;
  if (!(line.modulus > 0.0) || !std::isfinite(line.modulus)) return std::nullopt;
  line.low = std::max(low, 0.0);
  line.high = high;
  return found;
}

/// The line through the samples whose measured stress lies in a window.
std::optional<DemingLine> measured_line(Values strain, Values stress, double sign, double low,
                                        double high, double noise) {
  const Window window =
      window_of(stress.size(), low, high, [&](std::size_t i) { return sign * stress[i]; });
  return regression_in(strain, stress, window, low, high, noise);
}

std::optional<ElasticLine> line_in(Values strain, Values stress, double sign, double low,
                                   double high, double noise) {
  const auto found = measured_line(strain, stress, sign, low, high, noise);
  return found ? std::optional(found->line) : std::nullopt;
}

/// The line through the samples whose feet on it lie in its window. Measured stresses choose by
/// their noise: above the window's lower end they take the samples that it has lifted, below the
/// upper end those that it has lowered, which makes the slope too small. The noise of a sample's
/// foot is not correlated with that of its distance from the line (Deming's projection), so that
/// choosing by feet has no such bias.
/// @param low  of the window [Pa]; -infinity: has no lower end
std::optional<ElasticLine> unbiased_line(Values strain, Values stress, double sign, double low,
                                         double high, double noise) {
  constexpr int kRounds = 10;  // most lines settle in two
  auto found = measured_line(strain, stress, sign, low, high, noise);
  std::optional<Window> before;
  for (int round = 0; found && round < kRounds; ++round) {
    const DemingLine& now = *found;
    const Window window = window_of(stress.size(), low, high, [&](std::size_t i) {
      const double on_line = now.line.modulus * (strain[i] - now.line.zero_strain);
      return sign * (on_line + now.foot_fraction * (stress[i] - on_line));
    });
    if (before && window.begin == before->begin && window.end == before->end) break;
    before = window;
    const auto next = regression_in(strain, stress, window, low, high, noise);
    if (!next) break;
    found = next;
  }
  return found ? std::optional(found->line) : std::nullopt;
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

/// The window is a fraction of the proof stress, which needs the modulus: a few rounds settle it.
/// @param start  what is taken for the proof stress at first; below the peak, the window has to
///               settle, or there is no line
std::optional<ElasticLine> settled_line(const Curve& curve, Loading loading, Values strain,
                                        Values stress, double sign, double start, double noise,
                                        const TargetOptions& options) {
  const double peak = std::abs(stress.back());
  const bool must_settle = start < peak;
  const double least = (must_settle ? kLeastProof : 0.2) * peak;
  double yield = start;
  bool settled = false;
  auto line = automatic_line(strain, stress, sign, yield, noise, options);
  // After a test the strain may run back to zero, above the offset line without load.
  const auto furthest = std::max_element(curve.strain.begin(), curve.strain.end());
  const auto tested = static_cast<std::size_t>(furthest - curve.strain.begin()) + 1;
  const Values until = Values(curve.strain).first(tested);
  for (int round = 0; line && round < 8; ++round) {
    line->yield_stress = yield;
    if (loading != Loading::Monotonic || !sees_offset(line->modulus, options.offset, noise)) break;
    const auto proof = proof_stress(until, Values(curve.stress).first(tested), line->modulus,
                                    line->zero_strain, options.offset);
    settled = proof && std::abs(*proof - yield) <= 1e-4 * yield;
    if (!proof || !(*proof > least) || settled) break;
    auto next = automatic_line(strain, stress, sign, *proof, noise, options);
    if (!next) break;
    yield = *proof;
    line = next;
    line->yield_stress = yield;
  }
  if (must_settle && !settled) return std::nullopt;
  return line;
}

/// How much steeper the lower half of the line's window is, where that is no chance.
double bend_of(Values strain, Values stress, double sign, const ElasticLine& line, double noise) {
  const double middle = 0.5 * (line.low + line.high);
  const auto lower = line_in(strain, stress, sign, line.low, middle, noise);
  const auto upper = line_in(strain, stress, sign, middle, line.high, noise);
  if (!lower || !upper) return 1.0;
  const double error = std::hypot(lower->modulus_stderr, upper->modulus_stderr);
  if (std::abs(lower->modulus - upper->modulus) <= 5.0 * error) return 1.0;
  return lower->modulus / upper->modulus;
}

/// Whether the curve starts far below the line: then the line is that of what hardens, and the
/// elastic part, which is steeper, has no samples to be seen by. One that starts on the line was
/// zeroed under load; a foot starts above it.
bool is_beyond_knee(Values strain, Values stress, const ElasticLine& line, double noise) {
  constexpr double kFar = 0.18;  // of the yield stress; preloads and sticking sensors stay below
  const double below = line.modulus * (strain[0] - line.zero_strain) - stress[0];
  return below > std::max(kFar * line.yield_stress, 6.0 * noise);
}

/// Clearly: by a tenth and by three standard errors.
bool is_steeper(const ElasticLine& line, const ElasticLine& other) {
  const double error = std::hypot(line.modulus_stderr, other.modulus_stderr);
  return line.modulus_stderr <= 0.03 * line.modulus &&
         line.modulus - other.modulus > std::max(0.1 * other.modulus, 3.0 * error);
}

}  // namespace

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
                    : unbiased_line(strain, stress, sign, low, high, noise);
    if (line) line->yield_stress = peak;
    return line;
  }
  if (options.modulus_method == ModulusMethod::Chord) {
    throw InputError({}, "modulus_window", "", "is required for a modulus by chord");
  }

  auto line = settled_line(curve, loading, strain, stress, sign, peak, noise, options);
  const auto by_feet = [&] {
    if (!line) return line;
    const double low = line->low > 0.0 ? line->low : -std::numeric_limits<double>::infinity();
    auto unbiased = unbiased_line(strain, stress, sign, low, line->high, noise);
    if (!unbiased) return line;
    unbiased->yield_stress = line->yield_stress;
    unbiased->bend = line->bend;
    return unbiased;
  };
  if (loading != Loading::Monotonic) return by_feet();
  // A curve that hardens strongly has a window above its knee, too, that agrees with the proof
  // stress of its own slope. What is elastic is steeper than a foot and than all that is plastic.
  for (double start = 0.5 * peak; start > std::max(kLeastProof * peak, 10.0 * noise);
       start *= 0.5) {
    auto lower = settled_line(curve, loading, strain, stress, sign, start, noise, options);
    if (lower && (!line || is_steeper(*lower, *line))) line = lower;
  }
  // A curve that is nowhere straight is elastic only at its foot, if at all.
  constexpr double kPlastic = 1.4;
  TargetOptions narrower = options;
  for (int i = 0; line; ++i) {
    line->bend = bend_of(strain, stress, sign, *line, noise);
    const bool is_beyond = is_beyond_knee(strain, stress, *line, noise);
    if (!is_beyond && !(line->bend > kPlastic)) return by_feet();
    narrower.modulus_low *= 0.75;
    narrower.modulus_high *= 0.75;
    const double start = std::min(line->yield_stress, 0.999 * peak);
    auto lower = settled_line(curve, loading, strain, stress, sign, start, noise, narrower);
    if (!lower) lower = automatic_line(strain, stress, sign, line->yield_stress, noise, narrower);
    const double error = is_beyond ? 0.1 : 0.03;  // better a poor one than a wrong one
    if (i == 4 || !lower || lower->modulus_stderr > error * lower->modulus) {
      return is_beyond ? std::nullopt : by_feet();
    }
    if (lower->yield_stress == 0.0) lower->yield_stress = line->yield_stress;
    line = lower;
  }
  return line;
}

}  // namespace plastica::calibrate
