#pragma once

#include <cstddef>
#include <vector>

#include "plastica/chain/chain.hpp"

namespace plastica::chain {

/// A motion of a segment: of its inner joint, and its spin.
template <class L>
struct Motion {
  typename L::Point shift;
  typename L::Spin spin;
};

/// A force on a segment and the moment about its inner joint.
template <class L>
struct Wrench {
  typename L::Point force;
  typename L::Spin moment;

  friend Wrench operator+(const Wrench& a, const Wrench& b) {
    return {a.force + b.force, a.moment + b.moment};
  }
};

/// -d(wrench)/d(motion) of a segment, by blocks.
template <class L>
struct Impedance {
  using S = typename L::Scalar;
  static constexpr std::size_t kT = L::kTranslations;
  static constexpr std::size_t kR = L::kRotations;
  Mat<S, kT, kT> tt;
  Mat<S, kT, kR> tr;
  Mat<S, kR, kT> rt;
  Mat<S, kR, kR> rr;
};

/// Number of freedoms of a joint: its rotations, then, with elastic translation, its shifts.
template <class L, bool kElastic>
inline constexpr std::size_t kFreedoms = L::kRotations + (kElastic ? L::kTranslations : 0);

/// What the unknowns of a chain are.
template <class L>
struct Coordinates {
  std::vector<typename L::Spin> angle;   ///< of each joint (N)
  std::vector<typename L::Point> shift;  ///< of each joint, in its axes; rigid joints: empty (N)
  typename L::Point root;                ///< free translation of the start
  std::vector<typename L::Scalar> multiplier;  ///< of each closure
};

/// Where the segments are; follows from the coordinates.
template <class L>
struct Placement {
  std::vector<typename L::Frame> frame;     ///< of each segment (N)
  std::vector<typename L::Point> position;  ///< of each inner joint [m] (N)
  std::vector<typename L::Frame> near;      ///< axes of each joint on its inner side (N)
  std::vector<typename L::Frame> far;       ///< and on its outer side (N)

  void resize(std::size_t n) {
    frame.resize(n);
    position.resize(n);
    near.resize(n);
    far.resize(n);
  }
  typename L::Point point(std::size_t segment, const typename L::Point& arm) const {
    return position[segment] + L::turn(frame[segment], arm);
  }
};

/// What the laws say of each joint: its moments as they work on spins and shifts, and their slope.
template <class L, bool kElastic>
struct JointForces {
  static constexpr std::size_t kJ = kFreedoms<L, kElastic>;
  using S = typename L::Scalar;
  std::vector<Vec<S, kJ>> force;        ///< (joints)
  std::vector<Mat<S, kJ, kJ>> tangent;  ///< (joints)
};

}  // namespace plastica::chain
