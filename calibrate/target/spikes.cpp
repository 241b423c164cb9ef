#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/samples.hpp"
#include "plastica/base/median.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::size_t kLongest = 5;
constexpr double kSpikeLeast = 0.2;  // of the largest, or of what all but a few are below

/// The value below which a share of the sizes of some numbers are.
double quantile_of_sizes(std::span<const double> values, double share) {
  std::vector<double> sizes;
  sizes.reserve(values.size());
  for (const double value : values) sizes.push_back(std::abs(value));
  return value_of_rank(sizes,
                       static_cast<std::size_t>(share * static_cast<double>(sizes.size() - 1)));
}

/// A noise that most curves are not asked for.
class LazyNoise {
 public:
  LazyNoise(std::span<const double> x, std::span<const double> y) : x_(x), y_(y) {}
  double operator()() {
    if (!noise_) noise_ = noise_of(x_, y_);
    return *noise_;
  }

 private:
  std::span<const double> x_, y_;
  std::optional<double> noise_;
};

/// The noise about a sample: where the strain has noise it is more on an elastic part.
double noise_about(std::span<const double> x, std::span<const double> y, std::size_t sample) {
  constexpr std::size_t kReach = 20;
  const std::size_t begin = sample > kReach ? sample - kReach : 0;
  const std::size_t count = std::min(x.size(), sample + kReach + 1) - begin;
  return noise_of(x.subspan(begin, count), y.subspan(begin, count));
}

/// Whether a sample is by itself off the straight line through its four nearest, which lie on one.
/// @param threshold  less is none
bool is_off_the_line(std::span<const double> x, std::span<const double> y, std::size_t i,
                     double threshold) {
  constexpr double kTimes = 4.0;  // what the four are off their line
  const std::array<std::size_t, 4> near{i - 2, i - 1, i + 1, i + 2};
  double mean_x = 0.0, mean_y = 0.0, sxx = 0.0, sxy = 0.0;
  for (const std::size_t k : near) {
    mean_x += 0.25 * x[k];
    mean_y += 0.25 * y[k];
  }
  for (const std::size_t k : near) {
    sxx += (x[k] - mean_x) * (x[k] - mean_x);
    sxy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  if (!(sxx > 0.0)) return false;
  const auto off = [&](std::size_t k) {
    return std::abs(y[k] - mean_y - sxy / sxx * (x[k] - mean_x));
  };
  const double own = off(i);
  return own > threshold &&
         std::ranges::all_of(near, [&](std::size_t k) { return own > kTimes * off(k); });
}

/// A dropout or a spike on a rise, where it may be between its neighbours' values or far below the
/// largest one: off both the curve and the record, whose strain may have noise. Neither the corner
/// at a yield stress nor an upper yield point is.
bool is_off_a_rise(std::span<const double> x, std::span<const double> y, std::size_t i,
                   double least, LazyNoise& noise) {
  constexpr std::array<double, 5> kRows{-2.0, -1.0, 0.0, 1.0, 2.0};
  if (i < 2 || i + 2 >= y.size() || !is_off_the_line(x, y, i, least)) return false;
  const double threshold = std::max(least, kNoises * noise());
  return is_off_the_line(x, y, i, threshold) &&
         is_off_the_line(kRows, y.subspan(i - 2, kRows.size()), 2,
                         std::max(threshold, kNoises * noise_about(x, y, i)));
}

/// Whether any value is further than that from the one before, as all that is marked is.
bool jumps(std::span<const double> v, double by) {
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    if (std::abs(v[i] - v[i - 1]) > by) return true;
  }
  return false;
}

/// Marks runs of `shortest` to 5 values whose sizes are above those before and behind, which are
/// near to each other. What falls for some samples is kept: a dropout, or a loop.
void mark_runs(std::span<const double> v, double threshold, std::size_t shortest,
               std::vector<bool>& keep) {
  for (std::size_t length = shortest; length <= kLongest; ++length) {
    for (std::size_t i = 1; i + length < v.size(); ++i) {
      const double before = v[i - 1];
      const double behind = v[i + length];
      double least = std::abs(v[i] - before);
      if (least <= threshold) continue;
      bool is_one_side = true;
      for (std::size_t k = i; k < i + length; ++k) {
        const double a = v[k] - before;
        const double b = v[k] - behind;
        is_one_side = is_one_side && a * v[k] > 0.0 && b * v[k] > 0.0;
        least = std::min({least, std::abs(a), std::abs(b)});
      }
      // On level ground, unlike an upper yield point on the elastic rise.
      const double level = 0.25 * least;
      const bool is_level =
          std::abs(before - behind) < level && (i < 2 || std::abs(v[i - 2] - before) < level) &&
          (i + length + 1 >= v.size() || std::abs(v[i + length + 1] - behind) < level);
      if (!is_one_side || least <= threshold || !is_level) continue;
      for (std::size_t k = i; k < i + length; ++k) keep[k] = false;
    }
  }
}

/// Marks up to 5 values at the end that leave all before them by a fifth in one step.
void mark_end(std::span<const double> v, std::vector<bool>& keep) {
  constexpr std::size_t kFewest = 30;
  const std::size_t n = v.size();
  if (n < kFewest) return;
  double largest = 0.0;  // of all but the last
  for (std::size_t i = 0; i + kLongest < n; ++i) largest = std::max(largest, std::abs(v[i]));
  for (std::size_t i = n - kLongest; i < n; ++i) {
    const double step = std::abs(v[i] - v[i - 1]);
    const bool is_sudden = step > 5.0 * std::abs(v[i - 1] - v[i - 2]);  // rubber gets steep slowly
    if (step > 0.2 * largest && is_sudden && std::abs(v[i]) > 1.2 * largest) {
      for (std::size_t k = i; k < n; ++k) {
        if (std::abs(v[k]) > 1.2 * largest) keep[k] = false;
      }
      return;
    }
    largest = std::max(largest, std::abs(v[i]));
  }
}

}  // namespace

void drop_outliers(const Samples& samples) {
  const std::vector<double> y = samples.ordinate;
  const std::size_t n = y.size();
  if (n < 3) return;
  const std::vector<double> medians = medians_of_three(y);
  const double largest = largest_magnitude(std::span(medians).subspan(1, n - 2));
  if (!(largest > 0.0)) return;
  constexpr double kSmall = 0.03;  // of the largest: less is no matter, or a step of the sensor
  const std::vector<double> x = samples.abscissa;
  LazyNoise noise(x, y);
  const std::size_t dropped = filter(samples, [&](std::size_t i) {
    if (i == 0 || i + 1 == n) return true;
    if (is_off_a_rise(x, y, i, kSmall * largest, noise)) return false;
    const double a = y[i] - y[i - 1];
    const double b = y[i] - y[i + 1];
    const double least = std::min(std::abs(a), std::abs(b));
    return a * b <= 0.0 || least <= kSpikeLeast * largest || std::abs(a - b) >= 0.25 * least ||
           least <= kNoises * noise();
  });
  note_repair(samples.repairs, "outliers", dropped, "lone samples far off both neighbours dropped");
}

void drop_spikes(const Samples& samples) {
  constexpr double kMost = 0.95;  // of all: a few spikes do not count
  const std::size_t n = samples.size();
  if (n < 3) return;
  const std::vector<double>& y = samples.ordinate;
  const std::vector<double>& x = samples.abscissa;
  const double usual = quantile_of_sizes(y, kMost);
  if (!(usual > 0.0)) return;
  std::vector<bool> keep(n, true);
  if (jumps(y, kSpikeLeast * usual)) {
    mark_runs(y, std::max(kSpikeLeast * usual, kNoises * noise_of(x, y)), 2, keep);
  }
  double step = 0.0;
  for (std::size_t i = 1; i < n; ++i) {
    step += std::abs(x[i] - x[i - 1]) / static_cast<double>(n - 1);
  }
  const double long_step = 20.0 * step;
  if (jumps(x, long_step)) {
    mark_runs(
        x, std::max({long_step, 0.01 * quantile_of_sizes(x, kMost), kNoises * noise_over_rows(x)}),
        1, keep);
  }
  mark_end(y, keep);
  const std::size_t dropped = filter(samples, [&](std::size_t i) { return keep[i]; });
  note_repair(samples.repairs, "spikes", dropped, "samples far off their neighbours dropped");
}

}  // namespace plastica::calibrate
