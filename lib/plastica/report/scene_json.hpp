#pragma once

#include <string>

#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// The summary of a simulated scene for scripts: one JSON object in SI units with `name`,
/// `status`, `level`, `level_reason`, `samples`, `limit_load`, `break`, `probes`, `peaks`,
/// `reactions`, `energies`, `counters`, `warnings`. What there is not is null, so is every number
/// that is not finite. The order of the keys is fixed.
std::string scene_json(const io::SceneRecord& record);

}  // namespace plastica::report
