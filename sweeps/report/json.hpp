#pragma once

#include <string>

#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// The summary of a sweep for scripts: one JSON object in SI units with `name`, `scene`,
/// `quantity`, `against`, `refined`, `axes`, the counts by `statuses`, `groups` with order and grid
/// convergence index, and `cases`, an object each. What there is not is null, so is every number
/// that is not finite. The order of the keys is fixed.
std::string sweep_json(const SweepRecord& record);

}  // namespace plastica::sweeps
