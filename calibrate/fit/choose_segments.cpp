#include "calibrate/fit/choose_segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "calibrate/problem/scene_parameters.hpp"
#include "calibrate/trial/remesh.hpp"
#include "plastica/base/check.hpp"
#include "plastica/model/numbered_place.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::calibrate {
namespace {

constexpr int kFewest = 8;  // halved, there are still as many as a fit can be repeated with
constexpr int kMost = 1024;
/// Numbers of segments are multiples of this: they and their halves can be halved.
constexpr int kMultiple = 4;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool is_beam(const WeightedTarget& weighted) { return !weighted.setup.scene.is_coupon(); }

/// Whether the scenes can have so many: at least one for each stretch between two places.
bool can_have(int segments, std::vector<WeightedTarget> targets) {
  try {
    set_segments(segments, targets);
    for (const WeightedTarget& each : targets) (void)prepare(each.setup.scene, each.setup.solver);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

double order_of(std::span<const WeightedTarget> targets) {
  double order = kInfinite;
  for (const WeightedTarget& each : targets) {
    if (is_beam(each)) order = std::min(order, order_of_joints(each.setup.scene));
  }
  return order;
}

/// How many segments a beam has more than whole ones: one where its end ones are half as long.
int halves_of(std::span<const WeightedTarget> targets) {
  std::optional<int> halves;
  for (const WeightedTarget& each : targets) {
    if (!is_beam(each)) continue;
    const int own = each.setup.scene.end_rule == EndRule::Half ? 1 : 0;
    if (halves && *halves != own) {
      throw InputError({}, "fit.segments", "auto",
                       "is not for beams of which some end with half segments and some do not");
    }
    halves = own;
  }
  return halves.value_or(0);
}

/// @return whole segments
int next_number(int whole, const SegmentsTrial& trial, double within, double order) {
  constexpr double kMore = 1.05;  // than the estimate asks for
  const double factor =
      std::isfinite(trial.moved)
          ? std::clamp(kMore * std::pow(trial.moved / within, 1.0 / order), 1.25, 4.0)
          : 2.0;
  const double parts = std::ceil(factor * whole / kMultiple);
  return kMultiple * static_cast<int>(parts);
}

/// Free parameters begin where a fit ended.
void start_at(const SceneFitResult& result, std::vector<Parameter>& parameters) {
  for (Parameter& parameter : parameters) {
    if (parameter.role != ParameterRole::Free || is_break(parameter)) continue;
    const FittedParameter* found = result.find_parameter(parameter.field->path);
    if (found != nullptr && std::isfinite(found->value)) parameter.value = found->value;
  }
}

}  // namespace

void set_segments(int segments, std::vector<WeightedTarget>& targets) {
  for (WeightedTarget& each : targets) {
    if (!is_beam(each)) continue;
    const Beam& beam = each.setup.scene.beam;
    if (!beam.segment_fractions.empty() || !beam.joint_lengths.empty()) {
      throw InputError({}, "fit.segments", std::to_string(segments),
                       "is not for a scene that gives the lengths of its segments or joints (" +
                           each.target.name + ")");
    }
    const std::string why = why_not_segments(each.setup.scene, each.setup.solver, segments);
    if (!why.empty()) {
      throw InputError({}, "fit.segments", std::to_string(segments),
                       why + " (" + each.target.name + ")");
    }
    each.setup.scene.beam.segments = segments;
  }
}

std::vector<SegmentsTrial> choose_segments(std::span<const WeightedTarget> targets,
                                           const SceneFitOptions& options, double within) {
  if (!std::ranges::any_of(targets, is_beam)) {
    throw InputError({}, "fit.segments", "auto", "needs a target that was measured on a beam");
  }
  std::vector<WeightedTarget> tried(targets.begin(), targets.end());
  const int halves = halves_of(targets);
  set_segments(kFewest + halves, tried);  // refuses what has no number to choose
  SceneFitOptions how = options;
  how.laws.clear();
  how.intervals = {};
  how.segments_error = true;
  // A number of segments is a fit of its own: what another keeps is not its.
  how.hooks.find = nullptr;
  how.hooks.keep = nullptr;
  const double order = order_of(targets);
  std::vector<SegmentsTrial> trials;
  for (int whole = kFewest; whole <= kMost;) {
    if (!can_have(whole + halves, tried)) {
      whole += kMultiple;
      continue;
    }
    set_segments(whole + halves, tried);
    const SceneFitResult result = fit(tried, how);
    SegmentsTrial trial = moved_by_segments(result);
    trial.segments = whole + halves;
    trials.push_back(trial);
    if (trial.moved <= within) break;
    if (result.is_fitted()) {
      start_at(result, how.parameters);
      how.starts = 1;
    }
    whole = next_number(whole, trial, within, order);
  }
  return trials;
}

}  // namespace plastica::calibrate
