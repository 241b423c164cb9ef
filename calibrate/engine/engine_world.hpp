#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "calibrate/engine/engine_beam.hpp"

namespace plastica::calibrate {

/// What the world of an engine has otherwise than the scene.
struct EngineWorld {
  /// The axis that points up, a word of `up_axes()`; empty: the scene's axes stay. What is up in
  /// the scene is turned there: against its gravity, or y where it has none.
  std::string_view up{};
  std::optional<double> gravity{};  ///< where the scene's points, else down [m/s^2]; empty: that
  std::optional<double> damping_time{};  ///< of the joints [s], >= 0; empty: the scene's
  EngineContacts contacts = EngineContacts::None;
};

/// "x", "y", "z", and "-x", "-y", "-z".
std::span<const std::string_view> up_axes();

/// Puts a beam into a world. Turns are by quarters, so no number is rounded.
/// @throws InputError if a number is negative or not finite, `up` is no word, or if the beam is to
/// be turned but the
///         scene's gravity is not along an axis
void put_into(const EngineWorld& world, EngineBeam& beam);

}  // namespace plastica::calibrate
