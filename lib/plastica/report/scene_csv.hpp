#pragma once

#include <iosfwd>

#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// The probes: a row per sample with its number, time and load factor (a coupon: the driven
/// strain) and a column per probe. SI, units in the header as "tip [m]"; numbers have all their
/// digits.
void write_probes_csv(std::ostream& out, const io::SceneRecord& record);

/// The joints at the last sample: a row per joint with its place, position, moments, forces,
/// angles, plastic angles, plastic strain and stress. @throws InputError for a coupon
void write_joints_csv(std::ostream& out, const io::SceneRecord& record);

}  // namespace plastica::report
