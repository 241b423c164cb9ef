#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plastica/base/check.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::model_detail {
namespace {

using Vector = std::array<double, 3>;

bool is_zero(const Vector& vector) { return vector == Vector{}; }

void check_history(const History& history, const std::string& field) {
  if (history.time.empty() || history.time.size() != history.factor.size()) {
    throw InputError({}, field,
                     std::to_string(history.time.size()) + " times, " +
                         std::to_string(history.factor.size()) + " factors",
                     "must be as many of one as of the other, and at least one");
  }
  check_finite(history.time, field + ".time");
  check_finite(history.factor, field + ".factor");
  require(history.time.front() >= 0.0, {}, field + ".time", history.time.front(),
          "must not begin before 0");
  for (std::size_t i = 1; i < history.time.size(); ++i) {
    require(history.time[i] > history.time[i - 1], {}, field + ".time", history.time[i],
            "must rise from one to the next");
  }
  if (!history.slope.empty()) {
    check_finite(history.slope, field + ".slope");
    if (history.slope.size() != history.time.size() || history.time.size() < 2 ||
        history.continues) {
      throw InputError({}, field + ".slope", std::to_string(history.slope.size()) + " slopes",
                       "must be one for each of two times at least, of a history that ends");
    }
  }
  if (history.continues && history.time.size() < 2) {
    throw InputError({}, field, std::to_string(history.time.size()) + " times",
                     "must be at least 2 to go on along a line after the last");
  }
}

/// Numbers that a kind has no use for are as they are by default.
void check_kind(const Support& support, const std::string& name) {
  const Support usual;
  for (const SupportField& field : support_fields()) {
    if (field.belongs_to(support)) continue;
    const auto values = field.values(support);
    if (std::ranges::equal(values, field.values(usual))) continue;
    const double* number = field.number(support);
    throw InputError({}, name + '.' + std::string(field.key), number ? number_text(*number) : "",
                     "belongs to " + kinds_with(field.of));
  }
  const SupportTraits& kind = traits_of(support);
  if (support.hold && !kind.no_hold.empty()) {
    throw InputError({}, name + ".hold", "", kind.no_hold);
  }
  if (support.to && !kind.springs) {
    throw InputError({}, name + ".to", place_text(*support.to),
                     "belongs to " + kinds_with(&SupportTraits::springs));
  }
}

/// "the twist rz" of the first held rotation, "ry".
std::string_view held_rotation(const HeldFreedoms& held) {
  for (std::size_t i = 3; i < 6; ++i) {
    if (held[i]) return freedom_names()[i];
  }
  return {};
}

/// A rotation can be held where a joint is: at a segment's end.
void check_rotation_place(const Support& support, std::span<const double> ends,
                          const std::string& field) {
  const std::string_view rotation = held_rotation(support.held());
  if (rotation.empty() || segment_end_at(support.at, ends)) return;
  const double fraction = fraction_of(support.at, ends);
  const auto after = std::upper_bound(ends.begin(), ends.end(), fraction);
  throw InputError({}, field, place_text(support.at),
                   "a " + std::string(traits_of(support).word) + " that holds rotation (" +
                       std::string(rotation) + ") must be at a segment's end; the nearest are " +
                       number_text(*(after - 1)) + " and " + number_text(*after));
}

bool holds(const Support& support) {
  const HeldFreedoms held = support.held();
  return std::find(held.begin(), held.end(), true) != held.end();
}

/// A bed of springs is elastic and holds no rotation.
void check_bed(const Support& support, const Scene& scene, std::span<const double> ends,
               const std::string& name) {
  if (!support.to) return;
  check_place(*support.to, scene.beam.segments, name + ".to");
  if (fraction_of(support.at, ends) >= fraction_of(*support.to, ends)) {
    throw InputError({}, name + ".to", place_text(*support.to),
                     "must lie beyond at = " + place_text(support.at));
  }
  if (holds(support)) {
    throw InputError({}, name + ".hold", "", "is of a support at one place, without to");
  }
  if (!is_zero(support.rotational_stiffness)) {
    throw InputError({}, name + ".rotational_stiffness", "",
                     "is of a support at one place, without to");
  }
}

void check_holds(const Support& support, const std::string& name) {
  const SupportTraits& kind = traits_of(support);
  const bool springs = !is_zero(support.stiffness) || !is_zero(support.rotational_stiffness);
  if (kind.springs && !springs && !holds(support)) {
    throw InputError(
        {}, name, "",
        "an " + std::string(kind.word) + " support needs stiffness or rotational_stiffness");
  }
  if (!kind.springs && kind.no_hold.empty() && !holds(support)) {
    throw InputError({}, name + ".hold", "[]", "must hold something");
  }
  const HeldFreedoms held = support.held();
  for (std::size_t i = 0; i < 6; ++i) {
    const double stiffness = i < 3 ? support.stiffness[i] : support.rotational_stiffness[i - 3];
    if (held[i] && stiffness > 0.0) {
      throw InputError({}, name + ".hold", freedom_names()[i], "has a spring, too");
    }
  }
}

void check_normal(const Support& support, const std::string& name) {
  if (!support.has_normal()) return;
  const double size = std::hypot(support.normal[0], support.normal[1], support.normal[2]);
  require(std::abs(size - 1.0) <= 1e-9, {}, name + ".normal", size,
          "is the vector's size and must be 1");
}

/// What a support does to each freedom: hold or spring. Those along a normal are compared by that.
HeldFreedoms taken_freedoms(const Scene& scene, const Support& support, Ends ends) {
  HeldFreedoms taken = held_about_world(scene, support, ends);
  for (std::size_t i = 0; i < 3; ++i) {
    taken[i] = taken[i] || support.stiffness[i] > 0.0 ||
               (support.has_normal() && support.normal[i] != 0.0);
    taken[i + 3] = taken[i + 3] || support.rotational_stiffness[i] > 0.0;
  }
  return taken;
}

/// What moves across the normal moves nothing.
void check_translation(const Support& support, const std::string& name) {
  const auto& translation = support.translation;
  const auto& n = support.normal;
  const double size = std::hypot(translation[0], translation[1], translation[2]);
  if (!support.has_normal() || size == 0.0) return;
  const double along = n[0] * translation[0] + n[1] * translation[1] + n[2] * translation[2];
  require(std::abs(along) > 1e-9 * size, {}, name + ".translation", size,
          "goes across the normal, along which alone the support holds");
}

void check_motion(const Scene& scene, const Support& support, Ends ends, const std::string& name) {
  const HeldFreedoms taken = taken_freedoms(scene, support, ends);
  for (std::size_t i = 0; i < 6; ++i) {
    const double motion = i < 3 ? support.translation[i] : support.rotation[i - 3];
    if (motion == 0.0 || taken[i]) continue;
    throw InputError(
        {}, name + (i < 3 ? ".translation" : ".rotation"), number_text(motion),
        "moves " + std::string(freedom_names()[i]) + ", which the support does not hold");
  }
  check_translation(support, name);
  if (support.moves()) check_history(support.history, name + ".history");
}

/// Supports at one place share it as long as each takes freedoms of its own, or their
/// normals have different directions. The chain begins at the start, where one support alone may
/// hold.
void check_neighbours(const Scene& scene, std::size_t index, std::span<const double> ends) {
  const Support& support = scene.supports[index];
  const HeldFreedoms taken = taken_freedoms(scene, support, ends);
  const std::string field = item_name("support", index, ".at");
  for (std::size_t other = 0; other < index; ++other) {
    const Support& before = scene.supports[other];
    // Beds add up, with whatever else is there.
    if (before.to || support.to || fraction_of(before.at, ends) != fraction_of(support.at, ends))
      continue;
    if (fraction_of(support.at, ends) == 0.0 && holds(support) && holds(before)) {
      throw InputError({}, field, place_text(support.at),
                       item_name("support", other) +
                           " holds the start, too: one support takes all that is held there");
    }
    const bool normals = support.has_normal() && before.has_normal();
    if (normals && support.normal != before.normal) continue;
    const HeldFreedoms taken_before = taken_freedoms(scene, before, ends);
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (!taken[i] || !taken_before[i]) continue;
      throw InputError({}, field, place_text(support.at),
                       item_name("support", other) + " holds " + std::string(freedom_names()[i]) +
                           " at the same place");
    }
  }
}

}  // namespace

HeldFreedoms held_about_world(const Scene& scene, const Support& support, Ends ends) {
  HeldFreedoms held = support.held();
  const bool twists = held == traits_of(support).held && held[5] && !held[3] && !held[4];
  if (!twists) return held;
  const double at = fraction_of(support.at, ends);
  const auto from = axis_point(scene.beam, std::max(0.0, at - 1e-6));
  const auto to = axis_point(scene.beam, std::min(1.0, at + 1e-6));
  const double size = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  for (std::size_t k = 0; k < 2; ++k) {
    if (std::abs(to[k] - from[k]) < (1.0 - 1e-9) * size) continue;
    held[5] = false;
    held[3 + k] = true;
  }
  return held;
}

void check_supports(const Scene& scene, Ends ends) {
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& support = scene.supports[i];
    const std::string name = item_name("support", i);
    check_place(support.at, scene.beam.segments, name + ".at");
    check_kind(support, name);
    check_item(support, support_fields(), name);
    check_bed(support, scene, ends, name);
    check_rotation_place(support, ends, name + ".at");
    check_normal(support, name);
    check_holds(support, name);
    check_motion(scene, support, ends, name);
    check_neighbours(scene, i, ends);
  }
}

void check_masses(const Scene& scene) {
  for (std::size_t i = 0; i < scene.masses.size(); ++i) {
    const PointMass& mass = scene.masses[i];
    check_place(mass.at, scene.beam.segments, item_name("mass", i, ".at"));
    check_item(mass, mass_fields(), item_name("mass", i));
    require(mass.mass > 0.0 || mass.has_rotational_inertia(), {}, item_name("mass", i, ".mass"),
            mass.mass, "must be above 0 kg, or have inertia");
  }
}

void check_actions(const Scene& scene, Analysis analysis, Ends ends) {
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const Load& load = scene.loads[i];
    check_place(load.at, scene.beam.segments, item_name("load", i, ".at"));
    if (load.to) check_place(*load.to, scene.beam.segments, item_name("load", i, ".to"));
    if (load.to && fraction_of(load.at, ends) >= fraction_of(*load.to, ends)) {
      throw InputError({}, item_name("load", i, ".to"), place_text(*load.to),
                       "must lie beyond at = " + place_text(load.at));
    }
    check_item(load, load_fields(), item_name("load", i));
    check_history(load.history, item_name("load", i, ".history"));
  }
  check_history(scene.gravity_history, "gravity.history");
  const bool moved = std::any_of(scene.supports.begin(), scene.supports.end(),
                                 [](const Support& support) { return support.moves(); });
  if (!scene.loads.empty() || moved || !is_zero(scene.gravity)) return;
  if (analysis == Analysis::Statics) {
    throw InputError(
        {}, "load", "",
        "is missing: give a [[load]], gravity, or a support's translation or rotation");
  }
  if (scene.initial_motions.empty() && scene.cuts.empty()) {
    throw InputError({}, "load", "",
                     "is missing, and nothing else moves the beam: give a [[load]], an "
                     "[[initial_motion]], gravity, or a support's translation or rotation");
  }
}

}  // namespace plastica::model_detail
