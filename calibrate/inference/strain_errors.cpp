#include "calibrate/inference/strain_errors.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "plastica/base/median.hpp"

namespace plastica::calibrate {
namespace {

/// Whether the strain turns back at an inner sample.
bool turns_at(std::span<const double> strain, std::size_t i) {
  return (strain[i] - strain[i - 1]) * (strain[i + 1] - strain[i]) < 0.0;
}

/// How the residuals change with what is added to the strain [Pa] (n_samples).
/// @param add  changes a strain by about as much as `size`
template <typename Add>
std::vector<double> slopes_by(const Target& target, const FitOptions& options,
                              const ParameterSet& parameters, std::span<const double> active,
                              std::span<const double> residual, double size, const Add& add) {
  Target moved = target;
  add(moved.corrected.strain);
  std::vector<double> slopes = Misfit(moved, options, parameters).parts(active).residual;
  for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = (slopes[i] - residual[i]) / size;
  return slopes;
}

}  // namespace

double noise_of_strain(std::span<const double> strain) {
  constexpr std::size_t kFew = 20;
  constexpr double kOfNormal = 0.6745;  // the median of the magnitude of a normal number
  std::vector<double> differences;
  for (std::size_t i = 2; i + 2 < strain.size(); ++i) {
    if (turns_at(strain, i - 1) || turns_at(strain, i) || turns_at(strain, i + 1)) continue;
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
  const auto slopes = [&](double size, const auto& add) {
    return slopes_by(target, options, parameters, active, details.residual, size, add);
  };
  if (const double error = target.shift_error; error > 0.0) {
    details.by_shift = slopes(error, [&](std::vector<double>& strain) {
      for (double& one : strain) one -= error;
    });
  }
  if (target.loading != Loading::Cyclic) return;
  const std::vector<double>& strain = target.corrected.strain;
  Misfit::Details::Turns turns;
  turns.error = noise_of_strain(strain);
  if (!(turns.error > 0.0)) return;
  for (std::size_t i = 1; i + 1 < strain.size(); ++i) {
    if (turns_at(strain, i)) turns.at.push_back(i);
  }
  if (turns.at.empty()) return;
  // What follows a turn hangs on the noise of that one alone, once it flows again.
  turns.slopes = slopes(turns.error, [&](std::vector<double>& moved) {
    for (const std::size_t i : turns.at) moved[i] += turns.error;
  });
  // What its own noise does to a sample is noise like that of any other.
  for (const std::size_t i : turns.at) turns.slopes[i] = 0.0;
  details.turns = std::move(turns);
}

}  // namespace plastica::calibrate
