#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "plastica/chain/inverse.hpp"
#include "plastica/chain/loads.hpp"

/// The recursion along the chain; README.md derives it.
namespace plastica::chain {

/// What a joint transmits from its outer side: the force, and the moment about the joint.
template <class L>
struct Transmitted {
  std::vector<Wrench<L>> outer;  ///< (N)
};

/// A right-hand side: forces on the segments, and how the ground moves at the root.
template <class L>
struct RightSide {
  std::vector<Wrench<L>> wrench;  ///< (N)
  Motion<L> ground{};
  /// What of it acts at the nodes of joint 0 and of joints to the ground; read where moments follow
  /// axial forces (ground joints).
  typename L::Point at_start{};
  std::vector<typename L::Point> at_ground;

  void reset(std::size_t n) {
    wrench.assign(n, {});
    ground = {};
    at_start = {};
    at_ground.assign(at_ground.size(), {});
  }
};

/// The motion that follows from a right-hand side.
template <class L, bool kElastic>
struct Solution {
  using S = typename L::Scalar;
  std::vector<Vec<S, kFreedoms<L, kElastic>>> joint;  ///< spins and shifts of the joints (N)
  typename L::Point root{};                           ///< of the start's free translations
  std::vector<Motion<L>> motion;                      ///< of the segments (N)

  void resize(std::size_t n) {
    joint.resize(n);
    motion.resize(n);
  }
};

/// Factors the tangent of a chain once and solves with it for any number of right-hand sides.
template <class L, bool kElastic>
class Recursion {
 public:
  using S = typename L::Scalar;
  static constexpr std::size_t kT = L::kTranslations;
  static constexpr std::size_t kR = L::kRotations;
  static constexpr std::size_t kJ = kFreedoms<L, kElastic>;
  using JointVector = Vec<S, kJ>;

  void resize(std::size_t n) {
    joints_.resize(n);
    balance_.resize(n);
    starts_.clear();
  }

  /// Goes from the tip to the root: sums what each joint transmits, how far each is out of
  /// balance, and eliminates joint after joint.
  /// @param placement     where the segments are, and move from
  /// @param stage         where the forces act
  void factor(const Chain<L>& chain, const Coordinates<L>& q, const Placement<L>& placement,
              const Stage<L>& stage, const JointForces<L, kElastic>& laws,
              const OuterForces<L>& outer_forces, Transmitted<L>& transmitted);

  /// Sums what each joint transmits and its residual, as `factor` does, and eliminates nothing.
  void sum(const Chain<L>& chain, const Coordinates<L>& q, const Placement<L>& placement,
           const Stage<L>& stage, const JointForces<L, kElastic>& laws,
           const OuterForces<L>& outer_forces, Transmitted<L>& transmitted);

  /// Law minus transmitted moment (and force) of each joint: what Newton makes zero (N).
  const std::vector<JointVector>& balance() const { return balance_; }
  /// Of all eliminated freedoms, the least stiffness there was, relative to what stiffens
  /// constraints; about 0: the beam can move freely.
  const S& min_pivot() const { return min_pivot_; }
  /// Pivots of the factored tangent, inverted: recursion_pivots.hpp.
  template <class Visit>
  void for_each_pivot(const Chain<L>& chain, const Visit& visit) const;
  /// The residual force of the free translations of the root.
  const typename L::Point& root_balance() const { return root_balance_; }
  /// The residual of each fragment: force and moment at its start.
  template <class Visit>
  void for_each_fragment(const Visit& visit) const {
    for (const FragmentStart& start : starts_) visit(start.joint, start.balance);
  }

  /// @param with_balance  whether the right-hand side is minus the imbalance, plus `right`
  void solve(const RightSide<L>& right, bool with_balance, Solution<L, kElastic>& solution);

 private:
  using Spins = Mat<S, kR, kR>;

  /// How a shift of an elastic joint moves the outer segment's point: with the joint's spin, and
  /// along its own axes.
  struct Carrier {
    Mat<S, kT, kR> by_spin;
    Mat<S, kT, kT> along;
  };
  struct Rigid {};

  /// One eliminated joint. Its freedoms are here the spin in world axes, then the shifts in the
  /// joint's, so that a rigid joint's motion is the outer segment's spin against the inner one's.
  struct Joint {
    Mat<S, kT, kJ> u_shift;     ///< A S, rows of the force; A: impedance of all outside of it
    Mat<S, kR, kJ> u_spin;      ///< A S, rows of the moment
    Mat<S, kJ, kJ> inverse;     ///< of D
    Mat<S, kJ, kT> give_shift;  ///< D^-1 V: how it yields to a motion of the inner segment
    Mat<S, kJ, kR> give_spin;
    JointVector residual;        ///< the balance, in these freedoms
    Spins near;                  ///< world axes of the joint's own
    typename L::Point arm;       ///< from the inner neighbour's joint, for motion
    typename L::Point work_arm;  ///< the same for forces
    [[no_unique_address]] std::conditional_t<kElastic, Carrier, Rigid> moves;  ///< S
    [[no_unique_address]] std::conditional_t<kElastic, Carrier, Rigid>
        works;  ///< P; S, but half way
  };
  /// How the moment of a joint that does not stretch follows its axial force:
  /// dm = by (along . df + rotates_inner . d(inner spin) + rotates_joint . d(joint's spin)).
  struct AxialCoupling {
    typename L::Spin by;  ///< world axes
    typename L::Point along;
    typename L::Spin rotates_inner;
    typename L::Spin rotates_joint;
  };
  /// The same of a joint to the ground, whose moment acts on its segment.
  struct GroundCoupling {
    std::size_t segment = 0;
    bool outer = true;
    typename L::Spin by;
    typename L::Point along;
  };
  static constexpr std::size_t kFree = kR + kT;
  /// The start of a fragment: its spin and shift are solved there, and nothing goes further in.
  struct FragmentStart {
    std::size_t joint = 0;
    mask_t<S> open{};
    Mat<S, kFree, kFree> inverse;  ///< of the fragment's impedance, spins first
    Wrench<L> balance;             ///< what acts on the fragment
    Motion<L> motion;              ///< of its first segment, in the solution that is sought
  };

  static Carrier carrier(const Placement<L>& placement, std::size_t i,
                         const typename L::Point& shift);
  void set_joint(const Coordinates<L>& q, const Placement<L>& placement, const Stage<L>& stage,
                 std::size_t i);
  void set_balance(const Chain<L>& chain, const Stage<L>& stage, const JointVector& law,
                   const Wrench<L>& w, std::size_t i);
  /// @tparam kAxial  whether its moment follows the axial force; apart, so that other chains do not
  ///                 pay for it
  template <bool kAxial>
  void eliminate(const Chain<L>& chain, const Stage<L>& stage, const Mat<S, kJ, kJ>& tangent,
                 const Coordinates<L>& q, const Placement<L>& at, const Wrench<L>& w, std::size_t i,
                 Impedance<L>& a);
  static void add_rotation_terms(const Stage<L>& stage, const typename L::Point& shift,
                                 const Placement<L>& at, const Spins& near, const Wrench<L>& w,
                                 std::size_t i, Mat<S, kJ, kR>& v_spin, Mat<S, kJ, kJ>& d);
  static Mat<S, kJ, kJ> inverse_held(const Mat<S, kJ, kJ>& d, const Spins& near,
                                     const Spins& to_joint, const Root<L>& root);
  // recursion_axial.hpp
  void set_couplings(const Chain<L>& chain, const Placement<L>& placement,
                     const JointForces<L, kElastic>& laws, const AxialForces<L>& axial);
  [[gnu::noinline]] void add_with_axial(std::size_t segment, const Impedance<L>& own,
                                        Impedance<L>& a) const;
  [[gnu::noinline]] void eliminate_with_axial(const Chain<L>& chain, const Stage<L>& stage,
                                              const Mat<S, kJ, kJ>& tangent,
                                              const Coordinates<L>& q, const Placement<L>& at,
                                              const Wrench<L>& w, std::size_t i, Impedance<L>& a);
  void couple_ground_joints(std::size_t segment, bool outer_end, Impedance<L>& a) const;
  void couple_ground_joints(std::size_t segment, bool outer_end, const RightSide<L>& right,
                            Wrench<L>& b) const;
  void couple(std::size_t i, const Impedance<L>& a, Mat<S, kJ, kR>& v_spin, Mat<S, kJ, kT>& v_shift,
              Mat<S, kJ, kJ>& d) const;
  [[gnu::noinline]] JointVector rest_with_axial(std::size_t i, const RightSide<L>& right,
                                                Wrench<L>& b) const;

  static JointVector in_freedoms(const Joint& joint, const Wrench<L>& b);
  static void move(const Joint& joint, JointVector& moved, Motion<L>& motion);
  void set_root_balance(const Chain<L>& chain, const Wrench<L>& w);
  /// Of the rotations. The least stiffness of a matrix is about one over the largest entry of its
  /// inverse.
  static S largest_entry(const Mat<S, kJ, kJ>& inverted, S largest) {
    for (std::size_t i = 0; i < kR; ++i) {
      for (std::size_t j = 0; j < kR; ++j) largest = max(abs(inverted(i, j)), largest);
    }
    return largest;
  }
  void factor_root(const Chain<L>& chain, const mask_t<S>& open, const Impedance<L>& outside);

  static void solve_fragment(FragmentStart& start, bool with_balance, Wrench<L>& b);
  void factor_fragment(std::size_t i, const mask_t<S>& open, const Impedance<L>& a, Wrench<L>& w,
                       Impedance<L>& given, Joint& joint);

  std::vector<Joint> joints_;
  std::vector<FragmentStart> starts_;  ///< from the tip to the root
  std::vector<JointVector> balance_;
  typename L::Point root_balance_{};
  Impedance<L> root_impedance_{};  ///< of the whole chain, about the start
  Mat<S, kT, kT> root_inverse_{};
  S min_pivot_{};
  // Where moments follow axial forces:
  bool follows_axial_ = false;
  std::vector<AxialCoupling> couplings_;          ///< of rigid joints (N)
  std::vector<GroundCoupling> ground_couplings_;  ///< (ground joints)
  NodeForce<L> at_start_{};
};

template <class L, bool kElastic>
void Recursion<L, kElastic>::factor(const Chain<L>& chain, const Coordinates<L>& q,
                                    const Placement<L>& placement, const Stage<L>& stage,
                                    const JointForces<L, kElastic>& laws,
                                    const OuterForces<L>& outer_forces,
                                    Transmitted<L>& transmitted) {
  Impedance<L> a{};
  Wrench<L> w{};
  S softest = constant<S>(0);
  starts_.clear();
  const Placement<L>& at = stage.of(placement);
  follows_axial_ = outer_forces.axial.acts();
  if (follows_axial_) set_couplings(chain, placement, laws, outer_forces.axial);
  for (std::size_t i = chain.size(); i-- > 0;) {
    // What is outside of joint i: segment i and all beyond.
    if (follows_axial_) {
      add_with_axial(i, outer_forces.impedance[i], a);
    } else {
      a += outer_forces.impedance[i];
    }
    w = w + outer_forces.wrench[i];
    transmitted.outer[i] = w;
    Joint& joint = joints_[i];
    set_joint(q, placement, stage, i);
    set_balance(chain, stage, laws.force[i], w, i);
    const Impedance<L> whole = a;
    if (follows_axial_) {
      eliminate_with_axial(chain, stage, laws.tangent[i], q, at, w, i, a);
    } else {
      eliminate<false>(chain, stage, laws.tangent[i], q, at, w, i, a);
    }
    softest = largest_entry(joint.inverse, softest);
    if (any(q.open[i])) {
      factor_fragment(i, q.open[i], whole, w, a, joint);
      transmitted.outer[i] = w;
    }
    if (i == 0) break;
    // The same about joint i - 1.
    joint.arm = placement.position[i] - placement.position[i - 1];
    joint.work_arm = at.position[i] - at.position[i - 1];
    carry(joint.arm, joint.work_arm, a);
    a.rr -= stage.fraction() * L::moment_by(joint.arm, w.force);
    w.moment += L::moment(joint.work_arm, w.force);
  }
  const S one = constant<S>(1);
  min_pivot_ = one / max(chain.constraint_rotational_stiffness * softest, one);
  factor_root(chain, q.open[0], a);
  set_root_balance(chain, w);
}

}  // namespace plastica::chain

#include "plastica/chain/recursion_axial.hpp"
#include "plastica/chain/recursion_ends.hpp"
#include "plastica/chain/recursion_joint.hpp"
#include "plastica/chain/recursion_pivots.hpp"

// Compiled once (recursion.cpp). In a plane it is small, and 5 % faster where it is inlined.
namespace plastica::chain {

extern template class Recursion<Spatial<double>, false>;
extern template class Recursion<Spatial<double>, true>;
extern template class Recursion<Spatial<float>, false>;

}  // namespace plastica::chain
