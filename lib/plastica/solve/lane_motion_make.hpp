#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "plastica/chain/axial.hpp"
#include "plastica/solve/lane_motion.hpp"
#include "plastica/solve/lane_newton_make.hpp"
#include "plastica/solve/motion_step.hpp"

/// Defines the motions in lanes for the instruction set that a file is compiled for.
namespace plastica::solve {
PLASTICA_KERNELS_BEGIN

/// Writes a mask as numbers.
template <class Mask>
void store_mask(const Mask& mask, double* to) {
  select(mask, constant<LaneScalar>(1), constant<LaneScalar>(0)).store(to);
}

template <template <class> class Level, class Law>
class LaneMotionOf final : public LaneMotion {
 public:
  using L = chain::InLanes<Level<LaneScalar>>;

  void take_shape(const std::size_t* shape) override {
    ShapeReader reader{shape};
    step_.reset();
    chain::visit_chain(reader, chain_);
    joints_.visit(reader, VisitLaw<Law>{});
    chain::visit_inertias(reader, chain_);
    work_.resize(chain_);
    velocity_.assign(chain_.size(), {});
  }

  void take_chain(int lane, const double* numbers) override {
    LaneWriter writer{lane, numbers};
    chain::visit_chain(writer, chain_);
    joints_.visit(writer, VisitLaw<Law>{});
    chain::visit_inertias(writer, chain_);
    joints_.visit_stiffness(writer);
  }

  void take_velocities(int lane, const double* velocities) override {
    LaneWriter writer{lane, velocities};
    chain::visit_velocities(writer, velocity_);
  }

  void start(const MotionOptions& options, const History* const* histories, bool free,
             double* holds) override {
    for (std::size_t k = 0; k < chain_.histories.size(); ++k) {
      chain_.histories[k].history = histories[k];
    }
    if (free) {
      chain::place<false>(chain_, work_.q, 0.0, work_.placement);
      work_.q.open[0] = in_all_lanes<LaneScalar>(true);
      work_.q.pose[0] = {work_.placement.position[0], work_.placement.frame[0]};
    }
    step_.emplace(chain_, joints_, joints_.axes(), options, work_);
    step_->stop_by(options.newton.stop);
    store_mask(step_->start(velocity_), holds);
  }

  void attempt(double h, const double* rides, double* solved, double* solves,
               double* flows) override {
    const LaneScalar none = constant<LaneScalar>(0);
    store_mask(step_->attempt(h, LaneScalar::load(rides) > none), solved);
    step_->solves().store(solves);
    mask_t<LaneScalar> any_flows = none < none;
    if constexpr (!std::is_empty_v<typename Law::State>) {
      for (const LaneScalar& work : joints_.work_increment()) {
        any_flows = any_flows | (work < none) | (work > none);
      }
    }
    store_mask(any_flows, flows);
  }

  bool accept() override {
    step_->accept();
    has_axial_ = false;
    return step_->has_restarted();
  }

  void read_joints(int lane, double* found) override {
    LaneReader reader{lane, found};
    chain::visit_each(reader, work_.angles);
    joints_.visit_found(reader, joints_.axes());
  }

  void read_axial(int lane, double* axial) override {
    if (!has_axial_) {
      chain::find_axial_forces(
          chain_, work_.q, work_.placement, work_.closed, work_.time,
          [&](std::size_t history) { return chain_.histories[history].at(work_.time); },
          work_.outer_forces.wrench, axial_forces_, axial_);
      has_axial_ = true;
    }
    LaneReader reader{lane, axial};
    for (const LaneScalar& force : axial_) reader.number(force);
  }

  void read_motion(int lane, double* found) override {
    LaneReader reader{lane, found};
    chain::visit_held(reader, work_.q);
    chain::visit_pose(reader, work_.q.pose[0]);
    chain::visit_wrenches(reader, work_.transmitted.outer);
    chain::visit_each(reader, work_.joints.force);
    chain::visit_velocities(reader, step_->motions());
    const EnergyFlowsOf<LaneScalar>& flows = step_->flows();
    reader.number(step_->kinetic());
    reader.number(flows.external);
    reader.number(flows.damping);
    reader.number(flows.numerical_dissipation);
    reader.number(step_->momentum_error());
  }

 private:
  chain::Chain<L> chain_;
  chain::SectionJoints<L, false, Law> joints_{{}, {}, {}};
  NewtonWork<L, false> work_;
  std::vector<SegmentMotion<L>> velocity_;  ///< at time 0 (N)
  std::optional<MotionStep<L, false>> step_;
  chain::AxialForces<L> axial_forces_;
  std::vector<LaneScalar> axial_;  ///< [N] (joints)
  bool has_axial_ = false;         ///< of the step that was taken
};

constexpr LaneMotionTable motion_table() {
  return lane_table<LaneMotionTable, LaneMotion, LaneMotionOf>();
}

PLASTICA_KERNELS_END
}  // namespace plastica::solve
