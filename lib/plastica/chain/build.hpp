#pragma once

#include <cstddef>
#include <vector>

#include "plastica/chain/chain.hpp"
#include "plastica/chain/joint_plan.hpp"
#include "plastica/chain/layout.hpp"
#include "plastica/chain/state.hpp"
#include "plastica/chain/view.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::chain {

/// A moment that acts where a support holds the rotation: it goes into the support, past the beam.
template <class L>
struct HeldMoment {
  std::size_t support = 0;
  std::size_t history = 0;
  typename L::Spin moment;  ///< world axes, times the history [N m]
};

/// A chain and what its joints are.
template <class L>
struct Build {
  Chain<L> chain;
  std::vector<JointPlan> joints;  ///< (joints)
  std::vector<HeldMoment<L>> held_moments;
  /// Rotations are counted from this: in a plane by how far the beam turns along it, which axes
  /// alone do not tell.
  Placement<L> undeformed;
};

struct BuildOptions {
  RotaryInertia rotary = RotaryInertia::On;
  bool shifts = false;      ///< whether joints stretch and shear
  bool sees_axial = false;  ///< whether joints that do not stretch yield by their axial force, too
  /// Whether a joint may let go of its segment: what stands there is then of both sides. Empty:
  /// none does (N).
  std::vector<bool> may_open{};
};

/// Turns a laid-out scene into the chain of a level. Compiled once for each level (build.cpp).
template <class L>
Build<L> build_chain(const Scene& scene, const Layout& layout, const View<L>& view,
                     const BuildOptions& options = {});

}  // namespace plastica::chain
