#include "sweeps/compare/unrefined.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/motion_warnings.hpp"
#include "plastica/model/support_holds.hpp"

namespace plastica::sweeps {
namespace {

using model_detail::figure;

constexpr double kSamePlace = 1e-9;  ///< of the length

bool refines_segments(const Axis& axis) {
  return axis.field->path == "beam.segments" || axis.field->path == "beam.segment_depth";
}

/// "load[1].at", or which end of the beam it is.
std::string name_of_place(const Scene& scene, double fraction) {
  for (const NodePlace& place : node_places(scene)) {
    if (std::fabs(place.fraction - fraction) > kSamePlace) continue;
    return model_detail::item_name(place.list, place.index, place.key);
  }
  return fraction < 0.5 ? "the start" : "the end";
}

bool is_held(const Scene& scene, double fraction) {
  return std::any_of(scene.supports.begin(), scene.supports.end(), [&](const Support& support) {
    return holds_bending(support, true, true) && !support.at.segment &&
           std::fabs(support.at.fraction - fraction) <= kSamePlace;
  });
}

/// Whether all that acts on a beam at rest acts within a stretch, so that the rest does not bend.
bool bends_alone(const Setup& setup, double from, double to) {
  const Scene& scene = setup.scene;
  const auto places = node_places(scene);
  return setup.solver.analysis == Analysis::Statics && scene.gravity == std::array<double, 3>{} &&
         std::all_of(places.begin(), places.end(), [&](const NodePlace& place) {
           const std::string_view list = place.list;
           return (list != "support" && list != "load") ||
                  (place.fraction >= from - kSamePlace && place.fraction <= to + kSamePlace);
         });
}

std::ptrdiff_t segments_within(const std::vector<double>& ends, double from, double to) {
  return std::count_if(ends.begin(), ends.end(), [&](double end) {
    return end > from + kSamePlace && end < to + kSamePlace;
  });
}

/// A stretch of one segment does not bend. That matters where supports hold both of its ends, and
/// where no other stretch bends.
std::string rigid_stretch(const Scene& coarsest, const Setup& setup) {
  const Scene& finest = setup.scene;
  const auto divides_itself = [](const Scene& scene) {
    return scene.beam.segment_fractions.empty() && scene.beam.joint_lengths.empty();
  };
  if (finest.is_coupon() || !divides_itself(finest) || !divides_itself(coarsest)) return {};
  const std::vector<double> places = needed_ends(finest);
  if (places != needed_ends(coarsest)) return {};  // another scene
  const std::vector<double> ends = segment_ends(finest);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double from = places[i];
    const double to = places[i + 1];
    if (segments_within(ends, from, to) > 1) continue;
    const bool locked = is_held(finest, from) && is_held(finest, to);
    if (!locked && !bends_alone(setup, from, to)) continue;
    return fmt::format("between {} and {} is 1 segment in all cases", name_of_place(finest, from),
                       name_of_place(finest, to));
  }
  return {};
}

std::string probe_beside_its_place(const Quantity& quantity, const Scene& next,
                                   const Scene& finest) {
  if (quantity.kind != QuantityKind::Probe || finest.is_coupon()) return {};
  const Probe& probe = finest.probes[quantity.probe];
  if (!is_of_joint(probe.quantity) || probe.at.segment) return {};
  const auto joint_of = [&](const Scene& scene) {
    const std::vector<double> ends = segment_ends(scene);
    return ends[static_cast<std::size_t>(nearest_segment_end(probe.at, ends))];
  };
  const double read = joint_of(finest);
  const double place = probe.at.fraction;
  if (std::fabs(read - place) <= kSamePlace || read == 1.0) return {};
  if (std::fabs(joint_of(next) - read) > kSamePlace) return {};
  return fmt::format("{} at {:.6g} is of the joint at {:.6g} in the finest cases", probe.name,
                     place, read);
}

/// Of a hinge, or where one forms, the angle stays as it is.
std::string falls_with_its_joint(const Quantity& quantity, const Scene& scene,
                                 const CaseResult& next, const CaseResult& finest) {
  constexpr double kAlike = 0.1;
  if (quantity.kind != QuantityKind::Probe || scene.is_coupon()) return {};
  const Probe& probe = scene.probes[quantity.probe];
  if (!is_angle_of_joint(probe.quantity) || !next.value || !finest.value) return {};
  const double shorter = static_cast<double>(next.segments) / static_cast<double>(finest.segments);
  const double fallen = *finest.value / *next.value;
  if (!(shorter < 1.0) || !(std::fabs(fallen / shorter - 1.0) < kAlike * (1.0 - shorter))) {
    return {};
  }
  return fmt::format(
      "{} is the angle of one joint, which falls with the joint's length; a rotation, or "
      "local_plastic_strain, does not",
      probe.name);
}

std::string missed_periods(const Setup& setup, double step) {
  constexpr double kFewest = 4.0;
  if (setup.solver.step_error > 0.0) return {};  // which chooses its steps
  const auto history = model_detail::shortest_history(setup.scene);
  if (!history || history->period >= kFewest * step) return {};
  return fmt::format("the finest steps of {} s are {} in a period of {}", figure(step),
                     figure(history->period / step), history->name);
}

}  // namespace

std::string what_stays_coarse(const Sweep& sweep, const CaseTable& cases, const ReferenceSets& sets,
                              const ReferenceSet& set, const std::vector<CaseResult>& results) {
  for (const std::size_t axis : set.numbers) {
    const auto line = line_of_finest(sweep, sets, set, axis, results);
    if (line.size() < 2) continue;
    const Setup finest = cases.setup(line.front());
    std::string found;
    if (refines_segments(sweep.axes[axis])) {
      found = rigid_stretch(cases.setup(line.back()).scene, finest);
      if (found.empty()) {
        found = probe_beside_its_place(sweep.quantity, cases.setup(line[1]).scene, finest.scene);
      }
      if (found.empty()) {
        found = falls_with_its_joint(sweep.quantity, finest.scene, results[line[1]],
                                     results[line.front()]);
      }
    } else if (sweep.axes[axis].field->path == "solver.time_step") {
      found = missed_periods(finest, sets.size_at(line.front(), axis));
    }
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace plastica::sweeps
