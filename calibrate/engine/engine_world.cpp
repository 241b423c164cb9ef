#include "calibrate/engine/engine_world.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

using Vector = std::array<double, 3>;

Vector axis_of(std::string_view word) {
  Vector axis{};
  axis[static_cast<std::size_t>(word.back() - 'x')] = word.front() == '-' ? -1.0 : 1.0;
  return axis;
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Opposite to gravity; y where there is none.
Vector up_of(const EngineBeam& beam) {
  const auto largest = std::ranges::max_element(
      beam.gravity, {}, [](double component) { return std::fabs(component); });
  if (*largest == 0.0) return {0.0, 1.0, 0.0};
  const auto along = static_cast<std::size_t>(largest - beam.gravity.begin());
  if (std::ranges::count(beam.gravity, 0.0) < 2) {
    throw InputError({}, "--up", "",
                     "needs a scene whose gravity is along x, y or z: what is up in this one is no "
                     "axis");
  }
  Vector up{};
  up[along] = *largest > 0.0 ? -1.0 : 1.0;
  return up;
}

/// The turn by quarters that takes one axis to another: where it takes x, y and z.
EngineAxes turn_between(const Vector& from, const Vector& to) {
  Vector about{};
  for (std::size_t k = 0; k < 3; ++k) {
    about[k] = from[(k + 1) % 3] * to[(k + 2) % 3] - from[(k + 2) % 3] * to[(k + 1) % 3];
  }
  EngineAxes turn;
  const bool opposite = dot(from, to) < 0.0;
  // Half a turn is about z, the beam's axis, or about x where that is what is turned.
  if (opposite) about = from[2] == 0.0 ? Vector{0.0, 0.0, 1.0} : Vector{1.0, 0.0, 0.0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector unit{};
    unit[axis] = 1.0;
    const double kept = dot(unit, about);
    // An axis is along `about`, along `from`, or (quarter turns) along `to`.
    for (std::size_t k = 0; k < 3; ++k) {
      const double moved = opposite ? -(unit[k] - kept * about[k])
                                    : dot(unit, from) * to[k] - dot(unit, to) * from[k];
      turn[axis][k] = kept * about[k] + moved;
    }
  }
  return turn;
}

void turn_vector(const EngineAxes& turn, Vector& vector) {
  Vector turned{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) turned[k] += vector[axis] * turn[axis][k];
  }
  // No -0.
  for (std::size_t k = 0; k < 3; ++k) vector[k] = turned[k] + 0.0;
}

void turn_axes(const EngineAxes& turn, EngineAxes& axes) {
  for (Vector& axis : axes) turn_vector(turn, axis);
}

void turn_up(const Vector& up, EngineBeam& beam) {
  const Vector now = up_of(beam);
  if (now == up) return;
  const EngineAxes turn = turn_between(now, up);
  turn_axes(turn, beam.scene_axes);
  turn_vector(turn, beam.gravity);
  for (EngineSegment& segment : beam.segments) {
    turn_vector(turn, segment.start);
    turn_vector(turn, segment.end);
    turn_axes(turn, segment.axes);
  }
  for (EngineJoint& joint : beam.joints) {
    turn_vector(turn, joint.point);
    turn_axes(turn, joint.axes);
  }
}

void check_not_negative(std::string_view field, const std::optional<double>& value) {
  if (!value || (std::isfinite(*value) && *value >= 0.0)) return;
  throw InputError({}, field, fmt::format("{}", *value), "must not be negative");
}

}  // namespace

std::span<const std::string_view> up_axes() {
  static constexpr std::array<std::string_view, 6> kWords{"x", "y", "z", "-x", "-y", "-z"};
  return kWords;
}

void put_into(const EngineWorld& world, EngineBeam& beam) {
  if (!world.up.empty() && std::ranges::find(up_axes(), world.up) == up_axes().end()) {
    throw InputError({}, "--up", world.up, "must be x, y, z, -x, -y or -z");
  }
  check_not_negative("--gravity", world.gravity);
  check_not_negative("--damping", world.damping_time);
  if (!world.up.empty()) turn_up(axis_of(world.up), beam);
  if (world.gravity) {
    const double now = std::sqrt(dot(beam.gravity, beam.gravity));
    const Vector up = world.up.empty() ? Vector{0.0, 1.0, 0.0} : axis_of(world.up);
    for (std::size_t k = 0; k < 3; ++k) {
      beam.gravity[k] = (now > 0.0 ? beam.gravity[k] / now : -up[k]) * *world.gravity + 0.0;
    }
  }
  if (world.damping_time) beam.damping_time = world.damping_time;
  beam.contacts = world.contacts;
}

}  // namespace plastica::calibrate
