#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_figure.hpp"

/// The pictures of a simulated scene that are curves; not installed.
namespace plastica::report {

/// Bending moments and torque along the beam at the last sample, a panel each that is not zero.
Figure moment_figure(std::span<const io::SceneRecord> records);

/// Stress of the extreme fibre over its strain, on the whole path.
/// @throws InputError for a joint that there is not
Figure joint_figure(std::span<const io::SceneRecord> records, std::optional<int> joint);

/// Load factor over a probe. @throws InputError for a probe that there is not
Figure load_figure(std::span<const io::SceneRecord> records, const std::string& probe);

Figure energy_figure(const io::SceneRecord& record);

/// The stresses of a coupon, null if it has no probe of them.
const std::vector<double>* coupon_stress(const io::SceneRecord& record);

}  // namespace plastica::report
