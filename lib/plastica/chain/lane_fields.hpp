#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "plastica/chain/chain.hpp"
#include "plastica/chain/section_joints.hpp"
#include "plastica/chain/state.hpp"
#include "plastica/law/per_axis.hpp"
#include "plastica/law/uniaxial.hpp"

/// Visits what a chain consists of, in one order for every scalar: so the numbers of a lone
/// chain come to a lane of a chain of packs, whichever instruction set that is compiled for.
///
/// A visitor has size(vector), index(integer) and flag(bool), which say the shape that all lanes
/// share, and number(scalar), in which lanes may differ.
namespace plastica::chain {

/// Writes down a chain's shape and numbers.
struct FieldWriter {
  std::vector<std::size_t>& shape;
  std::vector<double>& numbers;

  template <class Values>
  void size(const Values& values) {
    shape.push_back(values.size());
  }
  void index(std::size_t index) { shape.push_back(index); }
  void flag(bool flag) { shape.push_back(flag ? 1 : 0); }
  void number(double number) { numbers.push_back(number); }
};

/// Reads numbers back.
struct FieldReader {
  const double* from;
  void number(double& number) { number = *from++; }
};

/// A factor in lanes. Each has been told its own, for iterations at a time that is given, at which
/// no slope is asked for; or all have one time and one history, which is asked.
template <class S>
struct LaneFactor {
  S now{};
  const History* history = nullptr;
  S at(double time) const { return history == nullptr ? now : constant<S>(history->at(time)); }
  S slope_at(double time) const {
    return constant<S>(history == nullptr ? 0.0 : history->slope_at(time));
  }
  S curvature_at(double time) const {
    return constant<S>(history == nullptr ? 0.0 : history->curvature_at(time));
  }
};

/// A level in lanes.
template <class Level>
struct InLanes : Level {};

template <class Level>
struct HistoryOf<InLanes<Level>> {
  using Type = LaneFactor<typename Level::Scalar>;
};

template <class Level>
struct SectionAxes<InLanes<Level>> : SectionAxes<Level> {};

template <class V, class Numbers>
void visit_numbers(V& visitor, Numbers& numbers) {
  for (auto& number : numbers.at) visitor.number(number);
}

template <class V, class Frame>
void visit_frame(V& visitor, Frame& frame) {
  if constexpr (requires { frame.cosine; }) {
    visitor.number(frame.angle);
    visitor.number(frame.cosine);
    visitor.number(frame.sine);
  } else {
    visit_numbers(visitor, frame.axes);
  }
}

template <class V, class Flags>
void visit_flags(V& visitor, Flags& flags) {
  for (auto& flag : flags) visitor.flag(flag);
}

/// The root and what is attached to segments.
template <class V, class C>
void visit_attached(V& v, C& chain) {
  v.size(chain.loads);
  for (auto& load : chain.loads) {
    v.index(load.segment);
    v.index(load.history);
    v.flag(load.follows);
    visit_numbers(v, load.arm);
    visit_numbers(v, load.force);
    visit_numbers(v, load.moment);
  }
  v.size(chain.constraints);
  for (auto& constraint : chain.constraints) {
    v.index(constraint.segment);
    v.index(constraint.history);
    v.flag(constraint.rotational);
    v.flag(constraint.one_sided);
    v.index(constraint.waits_for);
    visit_numbers(v, constraint.arm);
    visit_numbers(v, constraint.direction);
    visit_numbers(v, constraint.axis);
    visit_frame(v, constraint.frame);
    v.number(constraint.target);
    v.number(constraint.motion);
  }
  v.size(chain.springs);
  for (auto& spring : chain.springs) {
    v.index(spring.segment);
    v.index(spring.history);
    visit_numbers(v, spring.arm);
    visit_numbers(v, spring.stiffness);
    visit_numbers(v, spring.rest);
    visit_numbers(v, spring.motion);
  }
  v.size(chain.ground_joints);
  for (auto& joint : chain.ground_joints) {
    v.index(joint.segment);
    v.index(joint.history);
    v.index(joint.joint);
    v.flag(joint.outer);
    visit_frame(v, joint.local);
    visit_frame(v, joint.ground);
    visit_numbers(v, joint.motion);
  }
  v.index(chain.root.history);
  visit_flags(v, chain.root.held);
  visit_flags(v, chain.root.clamped);
  visit_numbers(v, chain.root.position);
  visit_frame(v, chain.root.ground);
  visit_numbers(v, chain.root.motion);
  visit_numbers(v, chain.root.rotation);
}

/// Of the histories, nothing but how many there are.
template <class V, class C>
void visit_chain(V& v, C& chain) {
  v.size(chain.segments);
  for (auto& segment : chain.segments) {
    visit_numbers(v, segment.arm);
    visit_frame(v, segment.inner);
    visit_frame(v, segment.outer);
  }
  visit_attached(v, chain);
  v.size(chain.histories);
  v.number(chain.length);
  v.number(chain.constraint_stiffness);
  v.number(chain.constraint_rotational_stiffness);
}

/// Vectors or matrices.
template <class V, class Values>
void visit_each(V& v, Values& values) {
  for (auto& value : values) visit_numbers(v, value);
}

/// Of the unknowns, those that are no angles of joints.
template <class V, class Q>
void visit_held(V& v, Q& q) {
  visit_numbers(v, q.root);
  for (auto& multiplier : q.multiplier) v.number(multiplier);
}

/// The unknowns of a chain in one piece.
template <class V, class Q>
void visit_unknowns(V& v, Q& q) {
  visit_each(v, q.angle);
  visit_held(v, q);
}

/// How the segments resist acceleration.
template <class V, class C>
void visit_inertias(V& v, C& chain) {
  v.size(chain.inertias);
  for (auto& inertia : chain.inertias) {
    v.number(inertia.mass);
    visit_numbers(v, inertia.center);
    visit_numbers(v, inertia.rotational);
  }
}

template <class V, class Pose>
void visit_pose(V& v, Pose& pose) {
  visit_numbers(v, pose.position);
  visit_frame(v, pose.frame);
}

template <class V, class Wrenches>
void visit_wrenches(V& v, Wrenches& wrenches) {
  for (auto& wrench : wrenches) {
    visit_numbers(v, wrench.force);
    visit_numbers(v, wrench.moment);
  }
}

template <class V, class Motions>
void visit_velocities(V& v, Motions& motions) {
  for (auto& motion : motions) {
    visit_numbers(v, motion.velocity);
    visit_numbers(v, motion.spin);
  }
}

/// Where the segments are.
template <class V, class P>
void visit_places(V& v, P& placement) {
  for (auto& frame : placement.frame) visit_frame(v, frame);
  for (auto& position : placement.position) visit_numbers(v, position);
}

/// The laws that lanes have, in the order of `solve::LaneLaw`.
template <class S>
using LaneLaws = std::tuple<law::ElasticSection<S>, law::PerAxisSection<S, law::IdealPlastic<S>>,
                            law::PerAxisSection<S, law::LinearHardening<S>>,
                            law::PerAxisSection<S, law::VoceChaboche<S>>,
                            law::PerAxisSection<S, law::Multilinear<S>>>;

/// The numbers of a law of each kind that lanes have, and of its states.
template <class V, class Law>
void visit_law(V& v, Law& law) {
  if constexpr (requires { law.axis; }) {
    for (std::size_t i = 0; i < law::kSectionAxes; ++i) {
      visit_law(v, law.axis[i]);
      v.number(law.lever[i]);
      v.number(law.modulus[i]);
      v.number(law.area[i]);
      v.number(law.softness[i]);
    }
  } else if constexpr (requires { law.compliance; }) {
    v.number(law.stiffness);
    v.number(law.compliance);
    v.number(law.yield);
  } else if constexpr (requires { law.saturation; }) {
    v.number(law.stiffness);
    v.number(law.yield);
    v.number(law.saturation);
    v.number(law.rate);
    for (auto& modulus : law.back_modulus) v.number(modulus);
    for (auto& rate : law.back_rate) v.number(rate);
  } else if constexpr (requires { law.kinematic; }) {
    v.number(law.stiffness);
    v.number(law.yield);
    v.number(law.isotropic);
    v.number(law.kinematic);
    if constexpr (requires { law.steepest; }) {
      v.number(law.steepest);
      for (auto* numbers : {&law.begin, &law.width, &law.slope}) {
        for (auto& number : *numbers) v.number(number);
      }
    }
  } else {
    visit_numbers(v, law.stiffness);  // of a section that never yields
  }
}

template <class V, class State>
void visit_state(V& v, State& state, std::size_t first, std::size_t count) {
  if constexpr (requires { state.axis; }) {
    for (std::size_t i = first; i < first + count; ++i) {
      v.number(state.axis[i].plastic);
      v.number(state.axis[i].accumulated);
      if constexpr (requires { state.axis[i].back_stress; }) {
        for (auto& back : state.axis[i].back_stress) v.number(back);
      }
    }
  }
}

}  // namespace plastica::chain
