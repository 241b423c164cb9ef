#include "plastica/run/small_motion.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace plastica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What counts as nothing of a closure's motion by unit joint motions [1].
constexpr double kNothing = 1e-10;
/// Of the softest freedom's omega^2: below, a motion is one that nothing resists. Rounding leaves
/// about 1e-13 of it.
constexpr double kUnresisted = 1e-10;
/// Of the largest stiffness: below, it is the rounding of lever arms that should be zero, squared.
constexpr double kNoStiffness = 1e-24;

/// Least omega^2 of a single coordinate that something resists: no less than that of the chain
/// before it is held off the start, by Rayleigh's principle, and of its size. Infinite where
/// nothing is resisted.
double softest(const MatrixXd& mass, const MatrixXd& stiffness) {
  double least = std::numeric_limits<double>::infinity();
  const double nothing = kNoStiffness * stiffness.diagonal().maxCoeff();
  for (Index i = 0; i < mass.rows(); ++i) {
    if (stiffness(i, i) > nothing) least = std::min(least, stiffness(i, i) / mass(i, i));
  }
  return least;
}

/// The indices at which a flag is not set.
std::vector<Index> unset(const std::vector<bool>& flags) {
  std::vector<Index> indices;
  for (std::size_t k = 0; k < flags.size(); ++k) {
    if (!flags[k]) indices.push_back(static_cast<Index>(k));
  }
  return indices;
}

/// Lets a chain move a little from its undeformed shape. Coordinates are unit motions of the joints
/// from the root outwards: spins [rad], and shifts and translations over the beam's length [1], so
/// that all of a mass matrix is in kg m^2, of a stiffness in N m.
class Motions {
 public:
  explicit Motions(const ChainAtRest& chain)
      : chain_(chain),
        translations_(static_cast<Index>(chain.held.size())),
        rotations_(static_cast<Index>(chain.welded.size())),
        all_(translations_ + rotations_) {
    for (std::size_t i = 0; i < chain.segments.size(); ++i) add_joint(i);
  }

  SmallMotion free_motion() const {
    MatrixXd mass = spread([&](const SegmentAtRest& segment) { return mass_of(segment); });
    MatrixXd stiffness = spread([](const SegmentAtRest& segment) { return segment.ground; });
    for (const Joint& joint : joints_) {
      const Index n = joint.axes.cols();
      stiffness.block(joint.first, joint.first, n, n) += joint.stiffness;
    }
    const double least = softest(mass, stiffness);
    const Eigen::ColPivHouseholderQR<MatrixXd> held = held_motions();
    const Index count = freedoms(held);
    for (MatrixXd* matrix : {&mass, &stiffness}) {
      // In an orthonormal basis whose first members are held: what is left of it is free.
      matrix->applyOnTheLeft(held.householderQ().adjoint());
      matrix->applyOnTheRight(held.householderQ());
      *matrix = MatrixXd(matrix->bottomRightCorner(count, count));
    }
    return {mass, stiffness, least};
  }

  Index freedoms() const { return freedoms(held_motions()); }

 private:
  /// A joint's unit motions.
  struct Joint {
    Index first = 0;     ///< its first coordinate
    MatrixXd carry;      ///< its motion by that of the joint before, when locked
    MatrixXd axes;       ///< what they are of the outer segment's motion (T + R x its coordinates)
    MatrixXd stiffness;  ///< that its law has against them
  };

  void add_joint(std::size_t i) {
    const SegmentAtRest& segment = chain_.segments[i];
    const Index n = rotations_ + (chain_.elastic ? translations_ : 0);
    MatrixXd axes = MatrixXd::Zero(all_, n);
    axes.bottomLeftCorner(rotations_, rotations_) = segment.joint_axes;
    MatrixXd stiffness = segment.tangent;
    if (chain_.elastic) {
      axes.topRightCorner(translations_, translations_) = chain_.length * segment.joint_shifts;
      stiffness.rightCols(translations_) *= chain_.length;
      stiffness.bottomRows(translations_) *= chain_.length;
    }
    if (i == 0) free_root(axes, stiffness);
    MatrixXd carry = MatrixXd::Identity(all_, all_);
    if (i > 0) carry.topRightCorner(translations_, rotations_) = segment.arm;
    joints_.push_back({coordinates_, carry, axes, stiffness});
    coordinates_ += axes.cols();
  }

  /// Joint 0 gives what the ground does not hold.
  void free_root(MatrixXd& axes, MatrixXd& stiffness) const {
    std::vector<Index> kept = unset(chain_.welded);
    for (Index k = rotations_; chain_.start_shifts && k < axes.cols(); ++k) kept.push_back(k);
    axes = MatrixXd(axes(Eigen::all, kept));
    stiffness = MatrixXd(stiffness(kept, kept));
    const std::vector<Index> free = unset(chain_.held);
    if (free.empty()) return;
    const MatrixXd identity = MatrixXd::Identity(all_, all_);
    const MatrixXd translations = chain_.length * identity(Eigen::all, free);
    const Index rotations = axes.cols();
    const Index all = rotations + translations.cols();
    axes.conservativeResize(Eigen::NoChange, all);
    axes.rightCols(translations.cols()) = translations;
    stiffness.conservativeResizeLike(MatrixXd::Zero(all, all));
  }

  /// Mass about the inner joint: P^T m P + R J R^T, P the motion of the center of mass.
  MatrixXd mass_of(const SegmentAtRest& segment) const {
    MatrixXd center = MatrixXd::Identity(translations_, all_);
    center.rightCols(rotations_) = segment.center;
    MatrixXd mass = center.transpose() * center;
    mass *= segment.mass;
    const MatrixXd turned = segment.axes * segment.turning;
    mass.bottomRightCorner(rotations_, rotations_) += turned * segment.axes.transpose();
    return mass;
  }

  /// sum J_i^T B_i J_i, J_i the motion of segment i by the coordinates, B_i = block_of(segment i).
  /// What is beyond a joint moves with it as one body (Walker & Orin, J. Dyn. Syst. Meas. Control
  /// 104, 1982, 205: their third method), so this costs the square of the number of freedoms.
  template <class BlockOf>
  MatrixXd spread(const BlockOf& block_of) const {
    MatrixXd whole = MatrixXd::Zero(coordinates_, coordinates_);
    MatrixXd beyond = MatrixXd::Zero(all_, all_);
    for (std::size_t i = joints_.size(); i-- > 0;) {
      beyond += block_of(chain_.segments[i]);
      MatrixXd column(coordinates_, joints_[i].axes.cols());
      work_of(i, beyond * joints_[i].axes, column);
      const Index rows = joints_[i].first + column.cols();
      whole.block(0, joints_[i].first, rows, column.cols()) = column.topRows(rows);
      whole.block(joints_[i].first, 0, column.cols(), rows) = column.topRows(rows).transpose();
      const MatrixXd carried = beyond * joints_[i].carry;
      beyond.noalias() = joints_[i].carry.transpose() * carried;
    }
    return whole;
  }

  /// Work of wrenches on a segment with the unit motions of all joints up to its own.
  void work_of(std::size_t segment, MatrixXd wrench, MatrixXd& work) const {
    for (std::size_t j = segment + 1; j-- > 0;) {
      work.middleRows(joints_[j].first, joints_[j].axes.cols()) =
          joints_[j].axes.transpose() * wrench;
      wrench = MatrixXd(joints_[j].carry.transpose() * wrench);
    }
  }

  /// What the supports off the start hold: the work of a unit force of each with all coordinates,
  /// in orthonormal form.
  Eigen::ColPivHouseholderQR<MatrixXd> held_motions() const {
    std::vector<VectorXd> held;
    for (const HeldDirection& direction : chain_.directions) {
      MatrixXd wrench = direction.wrench;
      if (!direction.turning) wrench /= chain_.length;
      MatrixXd motion = MatrixXd::Zero(coordinates_, 1);
      work_of(direction.segment, wrench, motion);
      // A straight chain's end does not move along it: holding it there holds nothing.
      if (motion.norm() > kNothing) held.emplace_back(motion);
    }
    if (held.empty()) held.emplace_back(VectorXd::Zero(coordinates_));  // of rank 0
    MatrixXd columns(coordinates_, static_cast<Index>(held.size()));
    for (std::size_t k = 0; k < held.size(); ++k) columns.col(static_cast<Index>(k)) = held[k];
    Eigen::ColPivHouseholderQR<MatrixXd> orthonormal(columns);
    orthonormal.setThreshold(kNothing);
    return orthonormal;
  }

  /// Two supports may hold the same.
  Index freedoms(const Eigen::ColPivHouseholderQR<MatrixXd>& held) const {
    return coordinates_ - held.rank();
  }

  const ChainAtRest& chain_;
  Index translations_;
  Index rotations_;
  Index all_;                  ///< freedoms of a segment: its inner joint's motion, spin
  std::vector<Joint> joints_;  ///< (N)
  Index coordinates_ = 0;
};

}  // namespace

SmallMotion small_motion(const ChainAtRest& chain) { return Motions(chain).free_motion(); }

int freedoms(const ChainAtRest& chain) { return static_cast<int>(Motions(chain).freedoms()); }

std::vector<double> frequencies(const SmallMotion& motion, int count) {
  const Index n = motion.mass.rows();
  assert(1 <= count && count <= n);
  std::vector<double> frequencies(static_cast<std::size_t>(count), 0.0);
  const double shift = motion.softest;
  if (std::isinf(shift)) return frequencies;
  // M x = mu (K + shift M) x: its largest mu belong to the lowest frequencies and have all digits;
  // those of K x = omega^2 M x would lack as many as there are between the lowest and the highest.
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(
      motion.mass, motion.stiffness + shift * motion.mass, Eigen::EigenvaluesOnly);
  assert(eigen.info() == Eigen::Success);
  for (int k = 0; k < count; ++k) {
    const double square = 1.0 / eigen.eigenvalues()(n - 1 - k) - shift;
    if (square > kUnresisted * shift) {
      frequencies[static_cast<std::size_t>(k)] = std::sqrt(square) / (2.0 * std::numbers::pi);
    }
  }
  return frequencies;
}

}  // namespace plastica
