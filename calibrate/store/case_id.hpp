#pragma once

#include <cstdint>
#include <string>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Digest of all that is told to every fit of a batch, and of what computes it: options, scene and
/// solver fields, version of the library, instruction set.
std::uint64_t digest_of(const FitOptions& options);

/// Who a fit is: the target's name and a digest of all that can change the result's bits.
/// @param options_digest  `digest_of(options)`
/// @return "NAME 0123456789abcdef"
std::string case_id(const Target& target, std::uint64_t options_digest);

}  // namespace plastica::calibrate
