#include "calibrate/inference/strain_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "plastica/base/median.hpp"

namespace plastica::calibrate {
namespace {

/// How the residuals change with what is taken off all strains [Pa] (n_samples): by the slope of
/// the model's curve there, which a strain that only rises makes a function of it.
std::vector<double> slopes_of_shift(const Curve& measured, std::span<const double> residual) {
  const std::size_t n = residual.size();
  const std::vector<double>& strain = measured.strain;
  const auto model = [&](std::size_t i) { return residual[i] + measured.stress[i]; };
  std::vector<double> slopes(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const double step = strain[i] - strain[i - 1];
    slopes[i] = step > 0.0 ? (model(i - 1) - model(i)) / step : slopes[i - 1];
  }
  if (n > 1) slopes[0] = slopes[1];
  return slopes;
}

/// The largest noise of the strain that the residuals of elastic branches leave room for [1].
/// @param slopes  by the strain where it turns: of elastic branches Young's modulus [Pa] (n)
double most_noise(std::span<const double> slopes, std::span<const double> residual) {
  double modulus = 0.0;
  for (const double slope : slopes) modulus = std::max(modulus, std::fabs(slope));
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (std::fabs(slopes[i]) < 0.5 * modulus) continue;
    squares += residual[i] * residual[i];
    count += 1.0;
  }
  return modulus > 0.0 ? std::sqrt(squares / count) / modulus : 0.0;
}

}  // namespace

std::vector<std::size_t> turns_of(std::span<const double> strain) {
  std::vector<std::size_t> turns;
  if (strain.empty()) return turns;
  const auto [least, most] = std::ranges::minmax(strain);
  const double back = 0.05 * (most - least);
  int way = 0;                    // up, down, or not known yet
  std::size_t high = 0, low = 0;  // since the last turn
  const auto turn = [&](std::size_t at) {
    if (at > 0) turns.push_back(at);
  };
  for (std::size_t i = 1; i < strain.size(); ++i) {
    if (strain[i] > strain[high]) high = i;
    if (strain[i] < strain[low]) low = i;
    if (way >= 0 && strain[high] - strain[i] > back) {
      turn(high);
      way = -1;
      low = i;
    } else if (way <= 0 && strain[i] - strain[low] > back) {
      turn(low);
      way = 1;
      high = i;
    }
  }
  return turns;
}

double noise_of_strain(std::span<const double> strain, std::span<const std::size_t> turns) {
  constexpr std::size_t kFew = 20;
  constexpr double kOfNormal = 0.6745;  // the median of the magnitude of a normal number
  std::vector<double> differences;
  auto turn = turns.begin();
  for (std::size_t i = 2; i + 2 < strain.size(); ++i) {
    while (turn != turns.end() && *turn + 2 < i) ++turn;
    if (turn != turns.end() && *turn <= i + 2) continue;
    differences.push_back(std::fabs(strain[i - 2] - 4.0 * strain[i - 1] + 6.0 * strain[i] -
                                    4.0 * strain[i + 1] + strain[i + 2]));
  }
  if (differences.size() < kFew) return 0.0;
  return median_of(std::move(differences)) / (kOfNormal * std::sqrt(70.0));
}

void add_strain_errors(const Target& target, const FitOptions& options,
                       const ParameterSet& parameters, std::span<const double> active,
                       Misfit::Details& details) {
  details.by_shift.clear();
  details.turns = {};
  if (target.shift_error > 0.0) {
    details.by_shift = slopes_of_shift(target.corrected, details.residual);
  }
  if (target.loading != Loading::Cyclic) return;
  const std::vector<double>& strain = target.corrected.strain;
  Misfit::Details::Turns turns;
  turns.at = turns_of(strain);
  turns.error = noise_of_strain(strain, turns.at);
  if (turns.at.empty() || !(turns.error > 0.0)) return;
  // What follows a turn hangs on the noise of that one alone, once it flows again.
  Target moved = target;
  std::size_t before = 0;
  for (const std::size_t i : turns.at) {
    // Outwards, where it stays the turn.
    moved.corrected.strain[i] += std::copysign(turns.error, strain[i] - strain[before]);
    before = i;
  }
  turns.slopes = Misfit(moved, options, parameters).parts(active).residual;
  for (std::size_t i = 0; i < turns.slopes.size(); ++i) {
    turns.slopes[i] = (turns.slopes[i] - details.residual[i]) / turns.error;
  }
  // What its own noise does to a sample is noise like that of any other.
  for (const std::size_t i : turns.at) turns.slopes[i] = 0.0;
  turns.error = std::min(turns.error, most_noise(turns.slopes, details.residual));
  details.turns = std::move(turns);
}

}  // namespace plastica::calibrate
