#include "plastica/run/natural_frequencies.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/chain/build.hpp"
#include "plastica/chain/loads.hpp"
#include "plastica/run/chain_laws.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/simulate.hpp"
#include "plastica/solve/newton_work.hpp"

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

template <std::size_t R, std::size_t C>
MatrixXd dense(const Mat<double, R, C>& m) {
  MatrixXd copy(R, C);
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) {
      copy(static_cast<Index>(i), static_cast<Index>(j)) = m(i, j);
    }
  }
  return copy;
}

/// Mass and stiffness of a chain for small motions from its undeformed shape.
struct SmallMotion {
  MatrixXd mass;       ///< (n x n)
  MatrixXd stiffness;  ///< (n x n)
  double softest;      ///< least omega^2 of a single coordinate that anything resists [1/s^2]
};

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

/// Lets a chain move a little from its undeformed shape. Coordinates are unit motions of the joints
/// from the root outwards: spins [rad], and shifts and translations over the beam's length [1], so
/// that all of a mass matrix is in kg m^2, of a stiffness in N m.
template <class L, bool kElastic>
class ChainMotions {
 public:
  static constexpr Index kT = L::kTranslations;
  static constexpr Index kR = L::kRotations;
  static constexpr Index kD = kT + kR;  ///< freedoms of a segment: its inner joint's motion, spin
  static constexpr Index kJ = static_cast<Index>(chain::kFreedoms<L, kElastic>);
  using Block = Eigen::Matrix<double, kD, kD>;

  ChainMotions(const ChainModel& model, const chain::View<L>& view)
      : length_(model.scene.beam.length),
        build_(chain::Builder<L>(model.scene, model.layout, view, model.options.rotary_inertia)
                   .build()) {
    for (History& history : build_.chain.histories) history = {{0.0}, {0.0}};
    rest_.resize(build_.chain);
    chain::place<kElastic>(build_.chain, rest_.q, 0.0, rest_.placement);
    evaluate_joints(model, view);
    set_joints();
  }

  /// Mass and stiffness of all that the supports off the start let move.
  SmallMotion free_motion() const {
    MatrixXd mass = spread(segment_masses());
    MatrixXd stiffness = spread(segment_stiffnesses());
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
    Block carry;         ///< its motion by that of the joint before, when locked
    MatrixXd axes;       ///< what they are of the outer segment's motion (kD x its coordinates)
    MatrixXd stiffness;  ///< that its law has against them
  };

  void evaluate_joints(const ChainModel& model, const chain::View<L>& view) {
    const auto parts = chain::part_forms(model.scene, !kOneForce<L, kElastic>);
    std::vector<MaterialValues<double>> materials;
    materials.reserve(parts.size());
    for (const auto& part : parts) materials.push_back(material_values(*part.material));
    const auto laws =
        make_joints<L, kElastic>(model.scene, parts, materials,
                                 chain::joint_numbers(model.layout, model.part_of_segment,
                                                      build_.joints, parts, materials, view),
                                 view, model.options.fibres);
    laws->evaluate(rest_.angles, rest_.q.shift, rest_.joints);
    chain::gather_forces(
        build_.chain, rest_.q, rest_.placement, rest_.stage, rest_.joints,
        [](std::size_t /*history*/) { return 0.0; }, rest_.outer_forces);
  }

  void set_joints() {
    for (std::size_t i = 0; i < build_.chain.size(); ++i) {
      const auto& near = rest_.placement.near[i];
      MatrixXd axes = MatrixXd::Zero(kD, kJ);
      axes.bottomLeftCorner(kR, kR) = dense(L::axes(near));
      MatrixXd stiffness = dense(rest_.joints.tangent[i]);
      if constexpr (kElastic) {
        axes.topRightCorner(kT, kT) = length_ * dense(L::turn_matrix(near));
        stiffness.rightCols(kT) *= length_;
        stiffness.bottomRows(kT) *= length_;
      }
      if (i == 0) free_root(axes, stiffness);
      joints_.push_back({coordinates_, carry(i), axes, stiffness});
      coordinates_ += axes.cols();
    }
  }

  /// The motion of a joint by that of the joint before, locked.
  Block carry(std::size_t i) const {
    Block block = Block::Identity();
    if (i == 0) return block;
    const auto& position = rest_.placement.position;
    block.template topRightCorner<kT, kR>() = dense(L::spun_by(position[i] - position[i - 1]));
    return block;
  }

  /// Joint 0 gives what the ground does not hold. Translations of the start that are free have no
  /// mass of their own: beside an elastic shift they make it so much softer.
  void free_root(MatrixXd& axes, MatrixXd& stiffness) const {
    const chain::Root<L>& root = build_.chain.root;
    std::vector<Index> kept;
    for (Index k = 0; k < kJ; ++k) {
      if (k >= kR || !root.welded[static_cast<std::size_t>(k)]) kept.push_back(k);
    }
    axes = MatrixXd(axes(Eigen::all, kept));
    stiffness = MatrixXd(stiffness(kept, kept));
    std::vector<Index> free;
    for (Index k = 0; k < kT; ++k) {
      if (!root.held[static_cast<std::size_t>(k)]) free.push_back(k);
    }
    if (free.empty()) return;
    const MatrixXd translations = length_ * MatrixXd(Block::Identity())(Eigen::all, free);
    if constexpr (kElastic) {
      // In the joint's coordinates; its axes are orthogonal.
      const MatrixXd slack = axes.transpose() * translations / (length_ * length_);
      const MatrixXd against = stiffness * slack;
      const VectorXd before = stiffness.diagonal();
      stiffness -= against * (slack.transpose() * against).ldlt().solve(against.transpose());
      for (Index k = 0; k < stiffness.rows(); ++k) {
        if (stiffness(k, k) > kNothing * before(k)) continue;  // else it is rounding
        stiffness.row(k).setZero();
        stiffness.col(k).setZero();
      }
    } else {
      const Index rotations = axes.cols();
      const Index all = rotations + translations.cols();
      axes.conservativeResize(Eigen::NoChange, all);
      axes.rightCols(translations.cols()) = translations;
      stiffness.conservativeResizeLike(MatrixXd::Zero(all, all));
    }
  }

  /// Masses about the inner joints: P^T m P + R J R^T, P the motion of the center of mass.
  std::vector<Block> segment_masses() const {
    std::vector<Block> masses;
    for (std::size_t i = 0; i < build_.chain.size(); ++i) {
      const chain::Inertia<L>& inertia = build_.chain.inertias[i];
      const auto& frame = rest_.placement.frame[i];
      Eigen::Matrix<double, kT, kD> center = Eigen::Matrix<double, kT, kD>::Identity();
      center.template rightCols<kR>() = dense(L::spun_by(L::turn(frame, inertia.center)));
      Block mass = inertia.mass * (center.transpose() * center);
      const MatrixXd turned = dense(L::axes(frame));
      mass.template bottomRightCorner<kR, kR>() +=
          turned * dense(inertia.turning) * turned.transpose();
      masses.push_back(mass);
    }
    return masses;
  }

  /// Springs and joints to the ground.
  std::vector<Block> segment_stiffnesses() const {
    std::vector<Block> stiffnesses;
    for (const chain::Impedance<L>& impedance : rest_.outer_forces.impedance) {
      Block block;
      block.template topLeftCorner<kT, kT>() = dense(impedance.tt);
      block.template topRightCorner<kT, kR>() = dense(impedance.tr);
      block.template bottomLeftCorner<kR, kT>() = dense(impedance.rt);
      block.template bottomRightCorner<kR, kR>() = dense(impedance.rr);
      stiffnesses.push_back(block);
    }
    return stiffnesses;
  }

  /// sum J_i^T B_i J_i, J_i the motion of segment i by the coordinates. What is beyond a joint
  /// moves with it as one body (Walker & Orin, J. Dyn. Syst. Meas. Control 104, 1982, 205: their
  /// third method), so this costs the square of the number of freedoms.
  MatrixXd spread(const std::vector<Block>& blocks) const {
    MatrixXd whole = MatrixXd::Zero(coordinates_, coordinates_);
    Block beyond = Block::Zero();
    for (std::size_t i = blocks.size(); i-- > 0;) {
      beyond += blocks[i];
      MatrixXd column(coordinates_, joints_[i].axes.cols());
      work_of(i, beyond * joints_[i].axes, column);
      const Index rows = joints_[i].first + column.cols();
      whole.block(0, joints_[i].first, rows, column.cols()) = column.topRows(rows);
      whole.block(joints_[i].first, 0, column.cols(), rows) = column.topRows(rows).transpose();
      beyond = Block(joints_[i].carry.transpose() * beyond * joints_[i].carry);
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
    for (const chain::Closure<L>& closure : build_.chain.closures) {
      if (closure.one_sided) continue;
      const chain::Wrench<L> unit = chain::unit_wrench(closure, rest_.placement);
      MatrixXd wrench(kD, 1);
      for (Index k = 0; k < kT; ++k) wrench(k) = unit.force[static_cast<std::size_t>(k)];
      for (Index k = 0; k < kR; ++k) wrench(kT + k) = unit.moment[static_cast<std::size_t>(k)];
      if (!closure.turning) wrench /= length_;
      MatrixXd motion = MatrixXd::Zero(coordinates_, 1);
      work_of(closure.segment, wrench, motion);
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

  double length_;
  chain::Build<L> build_;
  solve::NewtonWork<L, kElastic> rest_;
  std::vector<Joint> joints_;  ///< (N)
  Index coordinates_ = 0;
};

/// Calls `work` with the motions of a model's chain.
template <class Work>
auto with_motions(const ChainModel& model, const Work& work) {
  using chain::Planar;
  using chain::Spatial;
  using chain::Twist;
  using chain::View;
  const bool elastic = model.options.translation == JointTranslation::Elastic;
  switch (model.level) {
    case Level::Twist: return work(ChainMotions<Twist<double>, false>(model, {}));
    case Level::Planar: {
      const View<Planar<double>> view{model.across};
      if (elastic) return work(ChainMotions<Planar<double>, true>(model, view));
      return work(ChainMotions<Planar<double>, false>(model, view));
    }
    default:
      if (elastic) return work(ChainMotions<Spatial<double>, true>(model, {}));
      return work(ChainMotions<Spatial<double>, false>(model, {}));
  }
}

[[noreturn]] void refuse_coupon() {
  throw InputError({}, "drive.strain", "", "a coupon has no natural frequencies: a beam has");
}

const ChainModel& chain_of(const Model& model) {
  if (!model.chain) refuse_coupon();
  return *model.chain;
}

}  // namespace

int chain_freedoms(const Model& model) {
  return with_motions(chain_of(model),
                      [](const auto& motions) { return static_cast<int>(motions.freedoms()); });
}

std::vector<double> natural_frequencies(const Model& model, int count) {
  const SmallMotion motion =
      with_motions(chain_of(model), [](const auto& motions) { return motions.free_motion(); });
  const Index n = motion.mass.rows();
  if (count < 1 || count > n) {
    throw InputError({}, "count", std::to_string(count),
                     "must be 1 … " + std::to_string(n) + ", the ways in which the chain can move");
  }
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

std::vector<double> natural_frequencies(const Scene& scene, const SolverOptions& options,
                                        int count) {
  if (scene.is_coupon()) refuse_coupon();
  SolverOptions in_motion;
  in_motion.duration = 1.0;  // of which nothing is run
  in_motion.analysis = Analysis::Dynamics;
  in_motion.level = options.level;
  in_motion.translation = options.translation;
  in_motion.fibres = options.fibres;
  in_motion.rotary_inertia = options.rotary_inertia;
  return natural_frequencies(prepare(scene, in_motion), count);
}

}  // namespace plastica
