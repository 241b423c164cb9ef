#pragma once

#include <array>
#include <cstddef>
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

/// A right-hand side: forces on the segments, what the joints are out of balance by, and how the
/// ground moves at the root.
template <class L, bool kElastic>
struct RightSide {
  using S = typename L::Scalar;
  std::vector<Wrench<L>> wrench;                      ///< (N)
  std::vector<Vec<S, kFreedoms<L, kElastic>>> joint;  ///< (N)
  Motion<L> ground{};

  void reset(std::size_t n) {
    wrench.assign(n, {});
    joint.assign(n, {});
    ground = {};
  }
};

/// The motion that a right-hand side gives.
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

  /// Sums what each joint transmits and lacks, as `factor` does, and eliminates nothing.
  void sum(const Chain<L>& chain, const Coordinates<L>& q, const Placement<L>& placement,
           const Stage<L>& stage, const JointForces<L, kElastic>& laws,
           const OuterForces<L>& outer_forces, Transmitted<L>& transmitted);

  /// Law minus transmitted moment (and force) of each joint: what Newton makes zero (N).
  const std::vector<JointVector>& balance() const { return balance_; }
  /// Of all eliminated freedoms, the least stiffness there was, relative to what stiffens closures;
  /// about 0: the beam can move freely.
  const S& least_pivot() const { return least_pivot_; }
  /// The force that the free translations of the root lack.
  const typename L::Point& root_balance() const { return root_balance_; }
  /// What the pieces lack: force and moment at the start of each.
  template <class Visit>
  void for_each_piece(const Visit& visit) const {
    for (const PieceStart& start : starts_) visit(start.joint, start.balance);
  }

  /// @param with_balance  whether the right-hand side is minus the imbalance, plus `right`
  void solve(const RightSide<L, kElastic>& right, bool with_balance,
             Solution<L, kElastic>& solution);

 private:
  /// One eliminated joint. `impedance` there is that of all that is outside of it.
  struct Joint {
    Mat<S, kT, kJ> u_shift;  ///< A S, rows of the force
    Mat<S, kR, kJ> u_spin;   ///< A S, rows of the moment
    Mat<S, kJ, kT> v_shift;  ///< P A and the turning of the joint's axes
    Mat<S, kJ, kR> v_spin;
    Mat<S, kJ, kJ> inverse;     ///< of D
    Mat<S, kT, kJ> axes_shift;  ///< S: freedoms to motion of the outer segment
    Mat<S, kR, kJ> axes_spin;
    Mat<S, kJ, kT> work_shift;  ///< P: force and moment to those of the freedoms; S^T, but half way
    Mat<S, kJ, kR> work_spin;
    Mat<S, kT, kR> by;       ///< spun_by of the arm from the inner neighbour's joint, for motion
    Mat<S, kT, kR> work_by;  ///< the same for forces
  };
  static constexpr std::size_t kFree = kR + kT;
  /// The start of a piece: its spin and shift are solved there, and nothing goes further in.
  struct PieceStart {
    std::size_t joint = 0;
    mask_t<S> open{};
    Mat<S, kFree, kFree> inverse;  ///< of the piece's impedance, spins first
    Wrench<L> balance;             ///< what acts on the piece
    Motion<L> motion;              ///< of its first segment, in the solution that is sought
  };

  void set_axes(const typename L::Frame& near, const typename L::Frame& far,
                const typename L::Point& shift, Joint& joint) const;
  void set_work(const Stage<L>& stage, std::size_t i, Joint& joint) const;
  void add_turning(const S& share, const typename L::Frame& near, const typename L::Frame& far,
                   const typename L::Point& shift, const Wrench<L>& w, Joint& joint,
                   Mat<S, kJ, kJ>& d) const;
  void weld(const std::array<bool, 3>& welded, Mat<S, kJ, kJ>& d) const;
  /// The least stiffness of a matrix is about one over the largest entry of its inverse.
  template <std::size_t N>
  void note_pivot(const Mat<S, N, N>& inverted, const S& scale) {
    const std::size_t rotations = N == kJ ? kR : N;
    for (std::size_t i = 0; i < rotations; ++i) {
      for (std::size_t j = 0; j < rotations; ++j) {
        least_pivot_ = min(constant<S>(1) / (scale * abs(inverted(i, j))), least_pivot_);
      }
    }
  }
  void factor_root(const Chain<L>& chain, const mask_t<S>& open, const Impedance<L>& outside);

  static void solve_piece(PieceStart& start, bool with_balance, Wrench<L>& b);
  void factor_piece(std::size_t i, const mask_t<S>& open, const Impedance<L>& a, Wrench<L>& w,
                    Impedance<L>& given, Joint& joint);

  std::vector<Joint> joints_;
  std::vector<PieceStart> starts_;  ///< from the tip to the root
  std::vector<JointVector> balance_;
  typename L::Point root_balance_{};
  Impedance<L> root_impedance_{};  ///< of the whole chain, about the start
  Mat<S, kT, kT> root_inverse_{};
  S least_pivot_{};
};

template <class L, bool kElastic>
void Recursion<L, kElastic>::set_axes(const typename L::Frame& near, const typename L::Frame& far,
                                      const typename L::Point& shift, Joint& joint) const {
  const Mat<S, kR, kR> spin_axes = L::axes(near);
  for (std::size_t i = 0; i < kR; ++i) {
    for (std::size_t j = 0; j < kR; ++j) joint.axes_spin(i, j) = spin_axes(i, j);
  }
  if constexpr (kElastic) {
    const S half = constant<S>(0.5);
    const Mat<S, kT, kR> carried = L::spun_by(half * L::turn(far, shift)) * spin_axes;
    const Mat<S, kT, kT> along = half * (L::turn_matrix(near) + L::turn_matrix(far));
    for (std::size_t i = 0; i < kT; ++i) {
      for (std::size_t j = 0; j < kR; ++j) joint.axes_shift(i, j) = carried(i, j);
      for (std::size_t j = 0; j < kT; ++j) joint.axes_shift(i, kR + j) = along(i, j);
    }
  }
}

/// The projection P of forces. Where forces act at the end it is S^T.
template <class L, bool kElastic>
void Recursion<L, kElastic>::set_work(const Stage<L>& stage, std::size_t i, Joint& joint) const {
  if (!stage.half_way) {
    joint.work_spin = transpose(joint.axes_spin);
    if constexpr (kElastic) joint.work_shift = transpose(joint.axes_shift);
    return;
  }
  const Mat<S, kR, kR>& to_joint = stage.to_joint[i];
  for (std::size_t k = 0; k < kR; ++k) {
    for (std::size_t j = 0; j < kR; ++j) joint.work_spin(k, j) = to_joint(k, j);
  }
  if constexpr (kElastic) {
    const S half = constant<S>(0.5);
    const typename L::Frame& near = stage.placement.near[i];
    const typename L::Frame& far = stage.placement.far[i];
    const Mat<S, kT, kT> along = half * (L::turn_matrix(near) + L::turn_matrix(far));
    const Mat<S, kR, kT> carried =
        to_joint * transpose(L::spun_by(half * L::turn(far, stage.shift[i])));
    for (std::size_t j = 0; j < kT; ++j) {
      for (std::size_t k = 0; k < kR; ++k) joint.work_shift(k, j) = carried(k, j);
      for (std::size_t k = 0; k < kT; ++k) joint.work_shift(kR + k, j) = along(j, k);
    }
  }
}

/// The part of the slope of S^T w that comes from S turning, at constant w. With p = far shift,
/// G = moment + p/2 x force: rows of spins are near^T G, rows of shifts (near + far)^T force/2.
/// @param share  of the step's motion that the axes follow
template <class L, bool kElastic>
void Recursion<L, kElastic>::add_turning(const S& share, const typename L::Frame& near,
                                         const typename L::Frame& far,
                                         const typename L::Point& shift, const Wrench<L>& w,
                                         Joint& joint, Mat<S, kJ, kJ>& d) const {
  const Mat<S, kR, kR> near_axes = L::axes(near);
  if constexpr (!kElastic) {
    joint.v_spin += share * (transpose(near_axes) * L::turned_by(w.moment));
  } else {
    const S half = constant<S>(0.5);
    const typename L::Point p = L::turn(far, shift);
    const Mat<S, kR, kR> back = share * transpose(near_axes);
    const typename L::Spin g = w.moment + L::moment(half * p, w.force);
    const Mat<S, kR, kR> by_p = half * L::moment_by(p, w.force);
    const Mat<S, kT, kR> by_force = L::spun_by(w.force);
    const Mat<S, kT, kT> near_back = share * transpose(L::turn_matrix(near));
    const Mat<S, kT, kT> far_back = share * transpose(L::turn_matrix(far));
    const Mat<S, kR, kR> v_rr = back * (L::turned_by(g) - by_p);
    const Mat<S, kT, kR> v_tr = half * ((near_back + far_back) * by_force);
    const Mat<S, kR, kR> d_rr = back * by_p * near_axes;
    const Mat<S, kT, kR> d_tr = half * (far_back * by_force * near_axes);
    for (std::size_t i = 0; i < kR; ++i) {
      for (std::size_t j = 0; j < kR; ++j) {
        joint.v_spin(i, j) += v_rr(i, j);
        d(i, j) -= d_rr(i, j);
      }
    }
    for (std::size_t i = 0; i < kT; ++i) {
      for (std::size_t j = 0; j < kR; ++j) {
        joint.v_spin(kR + i, j) += v_tr(i, j);
        // d(S^T w) is symmetric in spins and shifts: p/2 x force changes with the shift alike.
        d(kR + i, j) += d_tr(i, j);
        d(j, kR + i) += d_tr(i, j);
      }
    }
  }
}

/// A welded freedom does not move: its row and column are those of the identity.
template <class L, bool kElastic>
void Recursion<L, kElastic>::weld(const std::array<bool, 3>& welded, Mat<S, kJ, kJ>& d) const {
  for (std::size_t k = 0; k < kR; ++k) {
    if (!welded[k]) continue;
    for (std::size_t i = 0; i < kJ; ++i) {
      d(k, i) = constant<S>(0);
      d(i, k) = constant<S>(0);
    }
    d(k, k) = constant<S>(1);
  }
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::factor(const Chain<L>& chain, const Coordinates<L>& q,
                                    const Placement<L>& placement, const Stage<L>& stage,
                                    const JointForces<L, kElastic>& laws,
                                    const OuterForces<L>& outer_forces,
                                    Transmitted<L>& transmitted) {
  Impedance<L> a{};
  Wrench<L> w{};
  least_pivot_ = constant<S>(1);
  starts_.clear();
  const Placement<L>& at = stage.of(placement);
  const S share = stage.share();
  for (std::size_t i = chain.size(); i-- > 0;) {
    // What is outside of joint i: segment i and all beyond.
    a.tt += outer_forces.impedance[i].tt;
    a.tr += outer_forces.impedance[i].tr;
    a.rt += outer_forces.impedance[i].rt;
    a.rr += outer_forces.impedance[i].rr;
    w = w + outer_forces.wrench[i];
    transmitted.outer[i] = w;
    if (any(q.open[i])) {
      transmitted.outer[i] = {select(q.open[i], {}, w.force), select(q.open[i], {}, w.moment)};
    }

    Joint& joint = joints_[i];
    const typename L::Point shift = kElastic ? q.shift[i] : typename L::Point{};
    set_axes(placement.near[i], placement.far[i], shift, joint);
    set_work(stage, i, joint);
    joint.u_spin = a.rr * joint.axes_spin;
    joint.u_shift = a.tr * joint.axes_spin;
    joint.v_spin = joint.work_spin * a.rr;
    joint.v_shift = joint.work_spin * a.rt;
    Vec<S, kJ> carried = joint.work_spin * w.moment;
    if constexpr (kElastic) {
      joint.u_spin += a.rt * joint.axes_shift;
      joint.u_shift += a.tt * joint.axes_shift;
      joint.v_spin += joint.work_shift * a.tr;
      joint.v_shift += joint.work_shift * a.tt;
      carried += joint.work_shift * w.force;
    }
    balance_[i] = laws.force[i] - carried;
    Mat<S, kJ, kJ> d = laws.tangent[i] + joint.work_spin * joint.u_spin;
    if constexpr (kElastic) d += joint.work_shift * joint.u_shift;
    add_turning(share, at.near[i], at.far[i], shift, w, joint, d);
    if constexpr (kElastic) {
      // The force acts on segment i - 1 where the shift has taken it.
      joint.u_spin += share * (transpose(L::spun_by(w.force)) * joint.axes_shift);
    }
    if (i == 0) weld(chain.root.welded, d);
    joint.inverse = inverse(d);
    if (i == 0) {
      for (std::size_t k = 0; k < kR; ++k) {
        if (!chain.root.welded[k]) continue;
        joint.inverse(k, k) = constant<S>(0);
        balance_[0][k] = constant<S>(0);
      }
    }
    note_pivot(joint.inverse, chain.closure_turning_stiffness);

    // What is outside of segment i - 1, about joint i: joint i gives way.
    const Impedance<L> impedance = a;
    const Mat<S, kJ, kR> give_spin = joint.inverse * joint.v_spin;
    const Mat<S, kJ, kT> give_shift = joint.inverse * joint.v_shift;
    a.tt -= joint.u_shift * give_shift;
    a.tr -= joint.u_shift * give_spin;
    a.rt -= joint.u_spin * give_shift;
    a.rr -= joint.u_spin * give_spin;
    if (any(q.open[i])) factor_piece(i, q.open[i], impedance, w, a, joint);
    if (i == 0) break;

    // The same about joint i - 1.
    const typename L::Point arm = placement.position[i] - placement.position[i - 1];
    const typename L::Point work_arm = at.position[i] - at.position[i - 1];
    joint.by = L::spun_by(arm);
    joint.work_by = L::spun_by(work_arm);
    const Mat<S, kT, kR> tr = a.tt * joint.by + a.tr;
    a.rr += a.rt * joint.by + transpose(joint.work_by) * tr - share * L::moment_by(arm, w.force);
    a.rt += transpose(joint.work_by) * a.tt;
    a.tr = tr;
    w.moment += L::moment(work_arm, w.force);
  }
  factor_root(chain, q.open[0], a);
  for (std::size_t k = 0; k < kT; ++k) {
    root_balance_[k] = chain.root.held[k] ? constant<S>(0) : w.force[k];
  }
}

}  // namespace plastica::chain

#include "plastica/chain/recursion_ends.hpp"
