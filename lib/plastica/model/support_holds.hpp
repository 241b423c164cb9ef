#pragma once

#include "plastica/model/support_kind.hpp"

namespace plastica {

/// Whether a support at a place holds the beam rigidly against bending: across it, or its turning.
/// @param about_x, about_y  in which bending it counts
inline bool holds_bending(const Support& support, bool about_x, bool about_y) {
  const HeldFreedoms held = support.held();
  return !support.to && !traits_of(support).releases &&
         ((about_x && (held[1] || held[3])) || (about_y && (held[0] || held[4])));
}

}  // namespace plastica
