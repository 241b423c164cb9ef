#include "sweeps/advise/discretization.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>

#include "plastica/run/path_stops.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kFewestSegments = 4.0;
constexpr double kMostSegments = 20'000.0;
constexpr double kFewestFibres = 4.0;
constexpr double kMostFibres = 5'000.0;
constexpr double kMostSteps = 100'000.0;
constexpr double kLargestStepError = 1e-2;
constexpr double kSmallestStepError = 1e-10;
/// Of the time from one sample to the next.
constexpr double kMostStepsOfASample = 100'000.0;

double number_of(const Field& field, const Setup& setup) {
  const FieldValue value = field.get(setup);
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
}

FinenessAxis axis_of(std::string_view path, double coarsest, double finest) {
  return {&find_field(path), coarsest, finest};
}

/// The time step of a motion, whose coarsest is the time between samples; of adaptive steps what
/// one may be off.
FinenessAxis time_axis(const Setup& setup) {
  if (setup.solver.step_error > 0.0) {
    return axis_of("solver.step_error", kLargestStepError, kSmallestStepError);
  }
  const FixedSteps steps =
      fixed_steps(path_stops(setup.scene, setup.solver), std::numeric_limits<double>::max());
  return axis_of("solver.time_step", steps.longest, steps.longest / kMostStepsOfASample);
}

}  // namespace

double FinenessAxis::size(double value) const {
  return refinement_of(*field) == Refinement::Count ? 1.0 / value : value;
}

double FinenessAxis::scaled(double value, double factor) const {
  const bool counts = refinement_of(*field) == Refinement::Count;
  // 1e-9: what rounding makes of a whole number is that number.
  const double wanted = counts ? std::ceil(value / factor - 1e-9) : value * factor;
  return std::clamp(wanted, std::min(coarsest, finest), std::max(coarsest, finest));
}

std::vector<FinenessAxis> fineness_axes(const Setup& setup) {
  if (setup.scene.is_coupon()) {
    throw InputError({}, "drive", "",
                     "makes the scene a coupon, which has neither segments nor "
                     "steps to choose");
  }
  std::vector<FinenessAxis> axes{axis_of("beam.segments", kFewestSegments, kMostSegments)};
  const bool moves = setup.solver.analysis == Analysis::Dynamics;
  const bool yields = setup.scene.yield_model != YieldModel::Elastic;
  if (moves) axes.push_back(time_axis(setup));
  if (setup.scene.yield_model == YieldModel::Fibre) {
    axes.push_back(axis_of("solver.fibres", kFewestFibres, kMostFibres));
  }
  if (!moves && yields) {
    const double own = number_of(find_field("solver.steps"), setup);
    axes.push_back(axis_of("solver.steps", own, std::max(4.0 * own, kMostSteps)));
  }
  return axes;
}

Setup setup_at(const Setup& setup, const std::vector<FinenessAxis>& axes, const Setting& setting) {
  Setup at = setup;
  for (std::size_t k = 0; k < axes.size(); ++k) set_field(at, *axes[k].field, setting[k]);
  return at;
}

Setting taken_setting(const Setup& setup, const std::vector<FinenessAxis>& axes, Setting setting) {
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (axes[k].field->path != "solver.time_step") continue;
    const Setup at = setup_at(setup, axes, setting);
    setting[k] = taken_time_step(at.scene, at.solver);
  }
  return setting;
}

Setting own_setting(const Setup& setup, const std::vector<FinenessAxis>& axes) {
  Setting own;
  for (const FinenessAxis& axis : axes) own.push_back(number_of(*axis.field, setup));
  return taken_setting(setup, axes, own);
}

}  // namespace plastica::sweeps
