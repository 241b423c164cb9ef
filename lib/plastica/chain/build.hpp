#pragma once

#include <vector>

#include "plastica/chain/chain.hpp"
#include "plastica/chain/joint_plan.hpp"
#include "plastica/chain/layout.hpp"
#include "plastica/chain/view.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::chain {

/// A chain and what its joints are.
template <class L>
struct Build {
  Chain<L> chain;
  std::vector<JointPlan> joints;  ///< (joints)
};

struct BuildOptions {
  RotaryInertia rotary = RotaryInertia::On;
  bool shifts = false;      ///< whether joints stretch and shear
  bool sees_axial = false;  ///< whether joints that do not stretch yield by their axial force, too
};

/// Turns a laid-out scene into the chain of a level. Compiled once for each level (build.cpp).
template <class L>
Build<L> build_chain(const Scene& scene, const Layout& layout, const View<L>& view,
                     const BuildOptions& options = {});

}  // namespace plastica::chain
