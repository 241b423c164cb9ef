#include "calibrate/inference/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/inference/not_a_number.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

}  // namespace

Draws::Draws(std::uint64_t seed, std::uint64_t index)
    : state_(mixed(mixed(seed + kGolden) + (index + 1) * kGolden)) {}

std::uint64_t Draws::bits() { return mixed(state_ += kGolden); }

double Draws::uniform() { return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52; }

double Draws::normal() { return theory::normal_quantile(uniform()); }

std::size_t Draws::below(std::size_t count) {
  const auto drawn = static_cast<std::size_t>(uniform() * static_cast<double>(count));
  return std::min(drawn, count - 1);
}

std::vector<double> drawn_residuals(std::span<const double> residual, double inflation,
                                    std::size_t block, Draws& draws) {
  const std::size_t m = residual.size();
  double mean = 0.0;
  for (const double r : residual) mean += r / static_cast<double>(m);
  std::vector<double> drawn(m);
  std::size_t from = 0;
  for (std::size_t i = 0; i < m; ++i, ++from) {
    if (i % block == 0) from = draws.below(m);
    drawn[i] = inflation * (residual[from % m] - mean);
  }
  return drawn;
}

LeastSquaresProblem changed(const LeastSquaresProblem& problem, std::vector<double> factor,
                            std::vector<double> shift) {
  LeastSquaresProblem other = problem;
  other.evaluate = [&problem, factor = std::move(factor), shift = std::move(shift)](
                       std::span<const double> points, std::span<double> residuals,
                       std::span<bool> found) {
    problem.evaluate(points, residuals, found);
    const std::size_t m = factor.size();
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      residuals[i] = factor[i % m] * (residuals[i] + shift[i % m]);
    }
  };
  return other;
}

BootstrapInterval bootstrap_interval(std::vector<double> values, double confidence) {
  if (values.size() < 2) return {kNan, kNan, kNan};
  std::ranges::sort(values);
  const auto count = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (const double v : values) mean += v / count;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const auto percentile = [&](double fraction) {
    const double number = std::clamp((count + 1.0) * fraction - 1.0, 0.0, count - 1.0);
    const auto below = std::min(static_cast<std::size_t>(number), values.size() - 2);
    const double part = number - static_cast<double>(below);
    return values[below] + part * (values[below + 1] - values[below]);
  };
  return {std::sqrt(squares / (count - 1.0)), percentile(0.5 - 0.5 * confidence),
          percentile(0.5 + 0.5 * confidence)};
}

}  // namespace plastica::calibrate
