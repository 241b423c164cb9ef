#pragma once

#include <cstddef>
#include <optional>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Where a curve broke: `intact` samples carry load, the rest is cut.
struct BreakFound {
  std::size_t intact = 0;
  BreakObservation observation;
};

/// Finds the break by the rule of TargetOptions::trim.
/// @param goes_on  stress was measured beyond the last strain: its end is no break
std::optional<BreakFound> find_break(const Curve& curve, Loading loading, double modulus,
                                     bool goes_on, const TargetOptions& options);

/// A curve that carries load up to and with its sample `last`, which another follows.
/// @param rule  by which that was found
BreakFound broken_after(const Curve& curve, std::size_t last, Loading loading, const char* rule);

}  // namespace plastica::calibrate
