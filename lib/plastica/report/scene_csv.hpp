#pragma once

#include <iosfwd>
#include <optional>

#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// The probes: a row per sample with its number, time and load factor (a coupon: the driven
/// strain) and a column per probe. SI, units in the header as "tip [m]"; numbers have all their
/// digits.
void write_probes_csv(std::ostream& out, const io::SceneRecord& record);

/// The joints at a time: a row per joint with its place, position, moments, forces, angles, plastic
/// angles, plastic strain and stress.
/// @param time  the frame next to it is taken; empty: the last one
/// @throws InputError for a coupon
void write_joints_csv(std::ostream& out, const io::SceneRecord& record,
                      std::optional<double> time = {});

/// The energy balance: a row per sample and a column per entry. @throws InputError for a coupon
void write_energies_csv(std::ostream& out, const io::SceneRecord& record);

/// A row per joint that broke or was cut, with the number and time of its event.
/// @throws InputError for a coupon
void write_events_csv(std::ostream& out, const io::SceneRecord& record);

/// A row per fragment after each event, with the number and time of it. @throws InputError for a
/// coupon
void write_fragments_csv(std::ostream& out, const io::SceneRecord& record);

/// The spectra of all probes: a row per frequency, a column per probe.
/// @throws InputError for what has none: paths, coupons, too few or uneven samples
void write_spectrum_csv(std::ostream& out, const io::SceneRecord& record);

}  // namespace plastica::report
