#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "plastica/model/history.hpp"
#include "plastica/model/place.hpp"

namespace plastica {

/// Ways to hold a point of the beam; each is a set of held freedoms in world axes, in which the
/// beam starts along z. `Support::hold` changes the set.
enum class SupportKind {
  Clamp,           ///< all six
  Pin,             ///< the three translations, and the twist about the beam's axis (a fork)
  Roller,          ///< the translations across the beam, x and y
  Guide,           ///< the three rotations
  Elastic,         ///< none rigidly; springs in each direction whose stiffness is above zero
  Pillar,          ///< one-sided: pushes along `normal`, never pulls; frictionless
  InclinedRoller,  ///< the translation along `normal`, both ways
  /// None: the beam itself has a hinge here. No moment about the section's axes x and y goes
  /// through it; forces and torque do.
  Hinge,
};

/// The words of files for the kinds of support, in the order of SupportKind.
std::span<const std::string_view> support_kinds();

/// What a freedom of the support does: x, y, z, then the rotations about x, y, z.
using HeldFreedoms = std::array<bool, 6>;

/// The words of files for the freedoms: x, y, z, rx, ry, rz.
std::span<const std::string_view> freedom_names();

/// A support at a point of the beam. A rotation that is held at a segment's end is held by a half
/// joint (Scene::end_rule); it turns with `rotation`.
struct Support {
  Place at{};
  SupportKind kind = SupportKind::Clamp;
  std::optional<HeldFreedoms> hold{};            ///< empty: those of the kind
  std::array<double, 3> stiffness{};             ///< Elastic: along x, y, z [N/m], >= 0
  std::array<double, 3> rotational_stiffness{};  ///< Elastic: about x, y, z [N m/rad], >= 0
  /// Pillar: unit vector of its push; InclinedRoller: of what it holds.
  std::array<double, 3> normal{0.0, 1.0, 0.0};
  double gap = 0.0;  ///< Pillar: distance to the undeformed beam [m], >= 0
  /// Pillar, dynamics: speed after an impact over that before [1], 0 … 1.
  double restitution = 0.0;
  /// Prescribed motion, times `history`: of what holds, springs or pushes, in translation [m] and
  /// in rotation [rad], as a rotation vector.
  std::array<double, 3> translation{};
  std::array<double, 3> rotation{};
  History history = History::ramp();
  /// Elastic: if set, a bed of springs from `at` to here (Winkler's foundation), which holds no
  /// rotation of its own; `stiffness` is then per length [N/m^2].
  std::optional<Place> to{};

  HeldFreedoms held() const;  ///< `hold`, or what the kind holds
  bool moves() const;         ///< whether any motion is prescribed
  bool has_normal() const;    ///< whether it acts along `normal`
};

}  // namespace plastica
