#include "sweeps/advise/discretization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "plastica/model/numbered_place.hpp"
#include "plastica/model/support_kind.hpp"
#include "plastica/run/path_stops.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kLargestTolerance = 1e-6;
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

/// The time step of a motion, whose coarsest is the time between samples, or what sees the
/// histories; with adaptive steps what one may be off, and the longest one.
void add_time_axes(const Setup& setup, std::vector<FinenessAxis>& axes) {
  const FixedSteps steps =
      fixed_steps(path_stops(setup.scene, setup.solver), std::numeric_limits<double>::max());
  double coarsest = std::min(steps.longest, resolving_step(setup));
  if (setup.solver.step_error > 0.0) {
    axes.push_back(axis_of("solver.step_error", kLargestStepError, kSmallestStepError));
    coarsest = std::min(coarsest, setup.solver.time_step);
  }
  axes.push_back(axis_of("solver.time_step", coarsest, coarsest / kMostStepsOfASample));
}

/// A step is the difference of two samples over a count: its last digits are rounding, which a
/// user would find in the written scene. Twelve digits are the same count.
double without_rounding(double step) { return std::stod(fmt::format("{:.12g}", step)); }

/// Refuses what has another meaning with another number of segments.
void refuse_numbered(const Scene& scene, const SolverOptions& solver) {
  if (!scene.beam.segment_fractions.empty()) {
    throw InputError({}, "beam.segment_lengths", "",
                     "fixes the segments, whose number is to be chosen");
  }
  if (!scene.beam.joint_lengths.empty()) {
    throw InputError({}, "beam.joint_lengths", "",
                     "fixes the segments, whose number is to be chosen");
  }
  if (const auto place = numbered_place(scene, solver)) {
    throw InputError({}, *place, "",
                     "is the end of a segment, which moves with their number: give a fraction");
  }
}

}  // namespace

double resolving_step(const Setup& setup) {
  constexpr double kStepsASwing = 4.0;
  double shortest = std::numeric_limits<double>::infinity();
  const auto look = [&](const History& history) {
    if (history.slope.empty()) return;  // a motion stops at each corner of straight segments
    // It goes on a part of its way alone before the first turn and after the last one.
    std::vector<double> turns = history.reversals();
    if (turns.size() < 2) turns = history.corners();
    for (std::size_t i = 1; i < turns.size(); ++i) {
      shortest = std::min(shortest, turns[i] - turns[i - 1]);
    }
  };
  for (const Load& load : setup.scene.loads) look(load.history);
  for (const Support& support : setup.scene.supports) {
    if (support.moves()) look(support.history);
  }
  look(setup.scene.gravity_history);
  return shortest / kStepsASwing;
}

bool has_first_order_errors(const Setup& setup) {
  const auto is_within = [](const Place& at) { return at.fraction > 0.0 && at.fraction < 1.0; };
  const auto is_a_spring = [&](const Support& support) {
    return is_within(support.at) && !support.to && traits_of(support).springs;
  };
  const auto acts_within = [&](const auto& item) { return is_within(item.at); };
  const Scene& scene = setup.scene;
  const bool moves = setup.solver.analysis == Analysis::Dynamics;
  return setup.solver.translation == JointTranslation::Elastic &&
         (std::ranges::any_of(scene.supports, is_a_spring) ||
          std::ranges::any_of(scene.masses, acts_within) ||
          (moves && std::ranges::any_of(scene.loads, acts_within)));
}

double FinenessAxis::size(double value) const {
  return refinement_of(*field) == Refinement::Count ? 1.0 / value : value;
}

double FinenessAxis::scaled(double value, double factor) const {
  const bool counts = refinement_of(*field) == Refinement::Count;
  // 1e-9: what rounding makes of a whole number is that number.
  double wanted = counts ? std::ceil(value / factor - 1e-9) : value * factor;
  if (factor < 1.0 && finer_at_least > 0.0) wanted = std::max(wanted, finer_at_least);
  return std::clamp(wanted, std::min(coarsest, finest), std::max(coarsest, finest));
}

std::vector<FinenessAxis> fineness_axes(const Setup& setup) {
  if (setup.scene.is_coupon()) {
    throw InputError({}, "drive", "",
                     "makes the scene a coupon, which has neither segments nor "
                     "steps to choose");
  }
  refuse_numbered(setup.scene, setup.solver);
  if (setup.solver.tolerance > kLargestTolerance) {
    throw InputError(
        {}, "solver.tolerance", fmt::format("{:g}", setup.solver.tolerance),
        "must be at most 1e-6 for advice: all its runs have it, so that what it leaves "
        "would not be seen");
  }
  std::vector<FinenessAxis> axes{axis_of("beam.segments", kFewestSegments, kMostSegments)};
  const bool moves = setup.solver.analysis == Analysis::Dynamics;
  const bool yields = setup.scene.yield_model != YieldModel::Elastic;
  if (moves) add_time_axes(setup, axes);
  if (setup.scene.yield_model == YieldModel::Fibre) {
    axes.push_back(axis_of("solver.fibres", kFewestFibres, kMostFibres));
    axes.back().finer_at_least = kRichFibres;
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
    // Runs are compared at the samples that both have: multiples share those of the scene's own.
    if (axes[k].field->path == "solver.steps") {
      const double own = axes[k].coarsest;
      const double times = std::ceil(setting[k] / own - 1e-9);
      setting[k] = own * std::min(times, std::floor(axes[k].finest / own + 1e-9));
    }
    if (axes[k].field->path != "solver.time_step") continue;
    const Setup at = setup_at(setup, axes, setting);
    setting[k] = without_rounding(taken_time_step(at.scene, at.solver));
  }
  return setting;
}

Setting own_setting(const Setup& setup, const std::vector<FinenessAxis>& axes) {
  Setting own;
  for (const FinenessAxis& axis : axes) own.push_back(number_of(*axis.field, setup));
  return taken_setting(setup, axes, own);
}

}  // namespace plastica::sweeps
