#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_figure.hpp"

/// The pictures of a simulated scene that are curves; not installed.
namespace plastica::report {

/// Bending moments and torque along the beam at a time, a panel each that is not zero.
/// @param time  the frame next to it is drawn; empty: the last one
Figure moment_figure(std::span<const io::SceneRecord> records, std::optional<double> time);

/// Stress of the extreme fibre over its strain, in all frames.
/// @throws InputError for a joint that there is not
Figure joint_figure(std::span<const io::SceneRecord> records, std::optional<int> joint);

/// Load factor over a probe. @throws InputError for a probe that there is not
Figure load_figure(std::span<const io::SceneRecord> records, const std::string& probe);

/// What tells records in one picture apart: their names, or their segments.
std::vector<std::string> labels_of(std::span<const io::SceneRecord> records);
/// The names of all records, each once.
std::string title_of(std::span<const io::SceneRecord> records);

/// The stresses of a coupon, null if it has no probe of them.
const std::vector<double>* coupon_stress(const io::SceneRecord& record);

}  // namespace plastica::report
