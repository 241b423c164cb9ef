#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace plastica::calibrate {

/// The sample at which another specimen begins, one under the other in a file: in one step, far
/// longer than the others, the deformation jumps back to its start, nothing of the load is left,
/// and both go up again. An unloading takes its steps, and keeps what is permanent. Signs and units
/// do not matter.
/// @param deformation, load  (n) each
/// @return the first such sample; empty if there is none
std::optional<std::size_t> find_next_specimen(std::span<const double> deformation,
                                              std::span<const double> load);

}  // namespace plastica::calibrate
