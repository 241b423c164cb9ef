#pragma once

#include <cstddef>
#include <span>

#include "plastica/chain/state.hpp"

namespace plastica::chain {

/// The laws of all joints of a chain, one virtual call for all: the solver does not know which.
///
/// A trial is a set of joint angles reached from the last committed state in one increment; trials
/// leave the committed state alone.
template <class L, bool kElastic>
class JointLaws {
 public:
  using S = typename L::Scalar;
  static constexpr std::size_t kJ = kFreedoms<L, kElastic>;

  virtual ~JointLaws() = default;

  /// Whether moments depend on the axial force of joints that do not stretch: `forces.axial` then
  /// says it.
  bool sees_axial() const { return sees_axial_; }
  /// Whether the last trial had more axial force than a section carries, whatever its moments.
  bool overloaded() const { return overloaded_; }

  /// Forces and tangents of a trial, as they work on spins and shifts.
  /// @param angles  of all joints with a law (joints)
  /// @param shifts  of the joints of segments; empty for rigid joints (N)
  virtual void evaluate(std::span<const typename L::Spin> angles,
                        std::span<const typename L::Point> shifts,
                        JointForces<L, kElastic>& forces) = 0;

  /// Says how long the increments of trials take, to laws that have a rate [s]; of 0 nothing flows.
  virtual void set_time(double /*seconds*/) {}

  /// Makes the state of the last trial the committed one.
  virtual void commit() = 0;

 protected:
  bool sees_axial_ = false;
  bool overloaded_ = false;
};

}  // namespace plastica::chain
