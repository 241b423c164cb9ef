#pragma once

#include <cstdint>
#include <optional>

#include "plastica/run/response.hpp"

namespace plastica::sweeps {

/// Where and when a chain broke first.
struct FirstBreak {
  double time = 0.0;       ///< [s]
  double factor = 0.0;     ///< as `ChainBreak::factor` [1]
  std::int64_t joint = 0;  ///< its number, 0 at the beam's start
  double place = 0.0;      ///< of the joint, joints over segments: 0 … 1
};

/// The first break of a run; what the scene cuts is none.
std::optional<FirstBreak> first_break(const ChainHistory& chain);

/// Whether two runs of one scene break alike: neither does, or both at one place, within a segment
/// of the coarser. What breaks at a point breaks the joint nearest to it, which is at most half a
/// segment of its own run off.
/// @param place     of the first break, 0 … 1; empty: nothing breaks
/// @param segments  of that run, >= 1
bool break_alike(std::optional<double> place, std::int64_t segments,
                 std::optional<double> other_place, std::int64_t other_segments);

}  // namespace plastica::sweeps
