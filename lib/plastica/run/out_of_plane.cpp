#include "plastica/run/out_of_plane.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plastica/chain/joint_model.hpp"
#include "plastica/run/chain_laws.hpp"
#include "plastica/run/growing_histories.hpp"
#include "plastica/solve/buckling_mode.hpp"
#include "plastica/solve/first_roots.hpp"
#include "plastica/solve/newton.hpp"
#include "plastica/solve/pencil.hpp"
#include "plastica/solve/stability_count.hpp"

namespace plastica {
namespace {

using chain::Spatial;

/// Relative stiffness below which supports leave the beam free; as of paths.
constexpr double kFree = 1e-11;

template <bool kElastic>
class SpatialTangent final : public OutOfPlane {
 public:
  using L = Spatial<double>;

  SpatialTangent(const ChainModel& model, const MaterialValues<double>& material)
      : scene_(model.scene), normal_(1 - model.across) {
    scene_.yield_model = YieldModel::Elastic;
    build_ = chain::build_chain<L>(scene_, model.layout, view_,
                                   {model.options.rotary_inertia, kElastic});
    set_joints(model, material);
    work_.resize(build_.chain);
    conservative_ = solve::is_conservative(build_.chain);
    applies_ = is_fixed_everywhere() || holds_at_rest();
    if (!applies_) {
      // A start that is held in the plane alone is taken as held against twist, as by a fork.
      build_.chain.root.clamped[2] = true;
      applies_ = holds_at_rest();
    }
  }

  bool applies() const override { return applies_; }

  int unstable_modes(const PlanarEquilibrium& at) override {
    factor(at);
    return count_unstable_modes();
  }

  double log_determinant(const PlanarEquilibrium& at) override {
    factor(at);
    double sum = 0.0;
    std::size_t visited = 0;
    const std::size_t of_joints = joint_pivots();
    for_each_pivot([&](double pivot) {
      const double size = pivot < 0.0 || pivot > 0.0 ? std::log(std::fabs(pivot)) : 0.0;
      // Those of the joints are pivots of inverses.
      sum += visited++ < of_joints ? -size : size;
    });
    return sum;
  }

  void add_mode(const PlanarEquilibrium& at, std::vector<double>& mode) override {
    factor(at);
    append_mode(mode);
  }

  bool has_potential() const override { return conservative_; }

  void let_forces_grow(const PlanarEquilibrium& at, double reach) override {
    pencil_.reset();
    assemble(at);
    work_.time = solve::just_before(at.time);
    const std::vector<History> kept = build_.chain.histories;
    let_held_grow(work_.time, at.time, reach, build_.chain.histories);
    pencil_.emplace(build_.chain, work_);
    pencil_->let_forces_grow();
    build_.chain.histories = kept;
  }

  int unstable_after(double time) override {
    pencil_->factor(time);
    return count_unstable_modes();
  }

  void add_mode_after(double time, std::vector<double>& mode) override {
    std::vector<double> found;
    solve::look_at_root(time, [&](double x) {
      found.clear();
      pencil_->factor(x);
      append_mode(found);
      return std::ranges::all_of(found, [](double u) { return std::isfinite(u); });
    });
    mode.insert(mode.end(), found.begin(), found.end());
  }

 private:
  static constexpr std::size_t kJ = chain::kFreedoms<L, kElastic>;

  void append_mode(std::vector<double>& mode) {
    // A mode in the plane may have the same load; at a planar state both stand apart.
    const auto displacements = solve::buckling_mode(build_.chain, work_);
    double largest = 0.0;
    for (const auto& displacement : displacements) {
      if (std::fabs(displacement[normal_]) > std::fabs(largest)) largest = displacement[normal_];
    }
    for (const auto& displacement : displacements) {
      for (std::size_t k = 0; k < 3; ++k) {
        mode.push_back(k == normal_ ? displacement[normal_] / largest : 0.0);
      }
    }
  }

  int count_unstable_modes() {
    int count = 0;
    for_each_pivot([&](double pivot) { count += pivot < 0.0 ? 1 : 0; });
    for (std::size_t k = 0; k < build_.chain.constraints.size(); ++k) {
      if (work_.closed[k] && leaves_plane(build_.chain.constraints[k])) --count;
    }
    return conservative_ ? count : std::abs(count) % 2;
  }

  void set_joints(const ChainModel& model, const MaterialValues<double>& material) {
    const auto& regions = model.layout.regions;
    const auto materials = chain::region_materials<double>(model.layout, material);
    joints_ = make_joints<L, kElastic>(
        scene_, regions, materials, chain::joint_numbers(build_.joints, regions, materials, view_),
        view_, model.options.fibres);
    chain::set_constraint_stiffness(joints_->joints(), scene_.beam.length, build_.chain);
  }

  /// Whether the start is held in all ways and every joint resists every rotation: then nothing
  /// gives way without strain, and there is no need to look.
  bool is_fixed_everywhere() const {
    const auto& root = build_.chain.root;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!root.held[k]) return false;
      for (std::size_t i = 0; i < build_.chain.size(); ++i) {
        const bool clamped = i == 0 && root.clamped[k];
        if (!clamped && !build_.joints[i].active[k]) return false;
      }
    }
    return true;
  }

  bool holds_at_rest() {
    work_.time = 0.0;
    solve::detail::assemble(
        build_.chain, *joints_, [](std::size_t /*history*/) { return 0.0; }, work_);
    factor_assembled();
    // What nothing at all resists makes no numbers, which the least pivot leaves out.
    bool finite = true;
    work_.recursion.for_each_pivot(build_.chain,
                                   [&](double pivot) { finite = finite && std::isfinite(pivot); });
    return finite && work_.recursion.min_pivot() > kFree;
  }

  void factor(const PlanarEquilibrium& at) {
    assemble(at);
    factor_assembled();
  }

  void assemble(const PlanarEquilibrium& at) {
    work_.time = at.time;
    for (std::size_t i = 0; i < at.angle.size(); ++i) {
      work_.q.angle[i].at = at.angle[i];
      if (!at.shift.empty()) work_.q.shift[i].at = at.shift[i];
    }
    work_.q.root.at = at.root;
    auto& constraints = build_.chain.constraints;
    for (std::size_t k = 0; k < constraints.size(); ++k) {
      work_.q.multiplier[k] = 0.0;
      for (const PlanarEquilibrium::Held& held : at.held) {
        const bool same = held.support == constraints[k].support &&
                          held.direction == constraints[k].direction.at &&
                          held.axis == constraints[k].axis.at;
        if (!same) continue;
        work_.q.multiplier[k] = held.multiplier;
        work_.q.released_constraint[k] = !held.closed;
      }
      work_.closed[k] = !work_.q.released_constraint[k];
    }
    solve::detail::assemble(build_.chain, *joints_, work_);
    if (!at.elastic.empty()) unload(at);
  }

  /// What has yielded carries the moments of its elastic angles.
  void unload(const PlanarEquilibrium& at) {
    const std::size_t n = build_.chain.size();
    const auto each = [&](const auto& visit) {
      for (std::size_t i = 0; i < n; ++i) visit(i, i);
      for (const auto& joint : build_.chain.ground_joints) {
        for (std::size_t k = 0; k < at.ground_node.size(); ++k) {
          if (at.ground_node[k] == joint.node) visit(joint.joint, n + k);
        }
      }
    };
    each([&](std::size_t joint, std::size_t seen) { work_.angles[joint].at = at.elastic[seen]; });
    joints_->evaluate(work_.angles, work_.q.shift, work_.joints);
    if (!at.aside.empty()) {
      each([&](std::size_t joint, std::size_t seen) { soften(joint, at.aside[seen]); });
    }
    chain::gather_forces(
        build_.chain, work_.q, work_.placement, work_.stage, work_.joints,
        [&](std::size_t history) { return build_.chain.histories[history].at(work_.time); },
        work_.outer_forces);
    solve::detail::set_constraints(build_.chain, work_);
  }

  /// Leaves a joint a fraction of its stiffness for bending out of the plane.
  void soften(std::size_t joint, double fraction) {
    const std::size_t aside = 1 - normal_;
    const auto& numbers = joints_->joints()[joint];
    const double lost = (1.0 - fraction) * numbers.active[aside] * numbers.active[aside] *
                        numbers.stiffness[aside] / numbers.length[aside];
    const auto& angle = work_.angles[joint];
    const chain::RotationCoefficients<double> k(dot(angle, angle));
    const auto to_angle = chain::inverse_tangent_map(angle, k);
    auto& tangent = work_.joints.tangent[joint];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        tangent(i, j) -= lost * to_angle(aside, i) * to_angle(aside, j);
      }
    }
  }

  void factor_assembled() {
    work_.recursion.factor(build_.chain, work_.q, work_.placement, work_.stage, work_.joints,
                           work_.outer_forces, work_.transmitted);
  }

  /// Whether a constraint holds a motion out of the plane.
  bool leaves_plane(const chain::LoopConstraint<L>& constraint) const {
    if (constraint.rotational) return std::fabs(constraint.axis[normal_]) < 0.5;
    return std::fabs(constraint.direction[normal_]) > 0.5;
  }

  /// Joint freedoms and translations of the start out of the plane, all but those that are held.
  std::size_t joint_pivots() const { return build_.chain.size() * (kElastic ? 3 : 2) + 1; }

  /// Visits the pivots of the freedoms out of the plane: in joints, the spins about the axes that
  /// lie in it, and the shift along its normal.
  template <class Visit>
  void for_each_pivot(const Visit& visit) {
    std::size_t index = 0;
    const std::size_t joints = build_.chain.size() * kJ;
    work_.recursion.for_each_pivot(build_.chain, [&](double pivot) {
      const std::size_t k = index < joints ? index % kJ : index - joints;
      const bool spin = index < joints && k < 3;
      const std::size_t axis = spin || index >= joints ? k : k - 3;
      ++index;
      if (spin == (axis != normal_)) visit(pivot);
    });
    std::size_t constraint = 0;
    const solve::PathCondition<L> at_time;
    solve::detail::for_each_constraint_pivot(
        build_.chain, at_time, false, work_, [&](double pivot) {
          if (leaves_plane(build_.chain.constraints[constraint++])) visit(pivot);
        });
  }

  Scene scene_;
  chain::View<L> view_{};
  std::size_t normal_;
  chain::Build<L> build_;
  std::unique_ptr<chain::SectionJointsBase<L, kElastic>> joints_;
  solve::NewtonWork<L, kElastic> work_;
  std::optional<solve::Pencil<L, kElastic>> pencil_;
  bool conservative_ = true;
  bool applies_ = false;
};

}  // namespace

std::unique_ptr<OutOfPlane> make_out_of_plane(const ChainModel& model,
                                              const MaterialValues<double>& material) {
  if (model.options.translation == JointTranslation::Elastic) {
    return std::make_unique<SpatialTangent<true>>(model, material);
  }
  return std::make_unique<SpatialTangent<false>>(model, material);
}

}  // namespace plastica
