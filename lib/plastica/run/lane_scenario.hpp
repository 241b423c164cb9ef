#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "plastica/run/lane_program.hpp"
#include "plastica/run/lane_shape.hpp"
#include "plastica/run/motion_begin.hpp"
#include "plastica/run/prescribed_joints.hpp"
#include "plastica/solve/motion_step.hpp"

namespace plastica {

/// One scenario of a group: its chain, and what is recorded of it.
/// @tparam Form  of the level, see lane_planar.hpp
template <class Form>
class LaneScenario {
 public:
  using L = typename Form::Level;
  using Body = typename Form::Body;
  using Motions = std::vector<solve::SegmentMotion<L>>;

  /// Back to the virgin beam, at time 0. @return Completed if it can begin
  Status begin(const LaneCase& one) {
    if (!body_ || model_ != one.model) {
      model_ = one.model;
      body_ = std::make_unique<Body>(*one.model, view_of<L>(*one.model));
      laws_.reset();
    }
    case_ = one;
    if (laws_) std::swap(body_->joints, laws_);
    body_->record.shapes_on_demand();
    begin_motion(*one.material, *body_, *one.response);
    set_initial_motion(*body_, motion_);
    const Status status = fit_initial_motion();
    auto given =
        std::make_unique<PrescribedJoints<L>>(body_->joints->joints(), body_->view.section_axes());
    given->reset();
    joints_ = given.get();
    laws_ = std::move(given);
    std::swap(body_->joints, laws_);
    angular_acceleration_.assign(body_->build.chain.size(), {});
    accumulated_.assign(body_->build.chain.size(), {});
    probed_.clear();
    for (const Probe& probe : model_->scene.probes) {
      if (!is_of_point(probe.quantity)) continue;
      const double fraction = fraction_of(probe.at, model_->layout.ends);
      probed_.push_back(chain::segment_point(model_->layout, fraction).segment);
    }
    flows_ = {};
    status_ = status;
    return status;
  }

  std::array<double, Form::Kind::kCount> kind(std::size_t i) const {
    return Form::kind(*body_, *joints_, i);
  }
  std::array<double, Form::State::kCount> state(std::size_t i) const {
    return Form::state(*body_, motion_, i);
  }
  const chain::Chain<L>& chain() const { return body_->build.chain; }
  const ChainModel& model() const { return *model_; }
  Response& response() const { return *case_.response; }
  const Workspace& hooks() const { return *case_.hooks; }

  bool running() const { return status_ == Status::Completed; }
  void stop(Status status) { status_ = status; }

  /// Takes what the kernels' memory says of the time that it has come to: of the whole chain where
  /// the next sample needs that, else of the points that probes are at.
  /// @param loads_work  counted by the kernels; else it is that of loads that do not change
  template <class Memory>
  void arrive(double time, const Memory& memory, std::size_t lane, bool loads_work, bool whole) {
    using Sums = typename Form::Sums;
    auto& work = body_->work;
    work.time = time;
    kinetic_ = memory.sum(Sums::Kinetic, lane);
    flows_.damping = memory.sum(Sums::Damping, lane);
    flows_.numerical_dissipation = memory.sum(Sums::NumericalDissipation, lane);
    const double potential = memory.sum(Sums::Potential, lane);
    if (time == 0.0) potential_ = potential;
    flows_.external = loads_work ? memory.sum(Sums::Loads, lane) : potential - potential_;
    body_->record.prescribe_energies({memory.sum(Sums::Elastic, lane), plastic_work(memory, lane)});
    if (whole || yields() || body_->record.needs_chain(response().samples, response())) {
      read_chain(memory, lane);
    } else {
      for (const std::size_t i : probed_) Form::place(memory.observables(i, lane), i, *body_);
    }
  }

  /// Of all joints so far [J].
  template <class Memory>
  double plastic_work(const Memory& memory, std::size_t lane) const {
    double work = 0.0;
    for (std::size_t i = 0; yields() && i < motion_.size(); ++i) {
      work += Form::plastic_work(memory.state(i, lane), *body_, i);
    }
    return work;
  }

  /// Writes a sample.
  void record() {
    Response& out = response();
    if (out.samples > 0 && body_->record.needs_chain(out.samples, out)) transmit();
    body_->set_trial_strains(true);
    // The kernels have summed in every step what is taken here once a sample.
    if (yields()) {
      std::copy(accumulated_.begin(), accumulated_.end(), body_->trial.accumulated.begin());
    }
    body_->accept_strains();
    if (out.samples == 0) {
      body_->record.begin_motion(body_->work, *body_->joints, motion_, kinetic_);
    } else {
      body_->record.set_motion(motion_, kinetic_, flows_);
    }
    body_->record.write(body_->work, *body_->joints, body_->strains, out.samples, out);
    out.chain.iterations[out.samples] = out.counters.iterations;
    ++out.samples;
  }

  void finish(double seconds) {
    Response& out = response();
    out.status = status_;
    if (!running() && out.samples > 0) {
      // What `arrive` has read for this is the last sample.
      if (out.samples > 1) transmit();
      body_->record.shape_now(body_->work, *body_->joints, body_->strains);
    }
    body_->record.end_motion();
    body_->record.end_frames(out);
    set_energy_balance(model_->scene.beam.length, out);
    judge_balance(out);
    out.permanent_strain = body_->watch.largest_strain(body_->strains);
    out.seconds = seconds;
  }

 private:
  /// The nearest motion that the joints and the support allow.
  Status fit_initial_motion() {
    if (model_->scene.initial_motions.empty()) return Status::Completed;
    const solve::MotionOptions options = motion_options(*body_);
    solve::MotionStep<L, false> step(body_->build.chain, *body_->joints, body_->view.section_axes(),
                                     options, body_->work);
    const bool holds = step.start(motion_);
    motion_ = step.motions();
    return holds ? Status::Completed : Status::HeldTwice;
  }

  bool yields() const { return model_->scene.yield_model != YieldModel::Elastic; }

  template <class Memory>
  void read_chain(const Memory& memory, std::size_t lane) {
    auto& work = body_->work;
    auto& placement = work.placement;
    const std::size_t n = motion_.size();
    typename L::Point velocity{};
    typename L::Frame near = chain().root.ground;
    for (std::size_t i = 0; i < n; ++i) {
      const auto& segment = chain().segments[i];
      const auto state = memory.state(i, lane);
      Form::read(state, i, *body_, *joints_, angular_acceleration_[i]);
      const auto flowed = in_double(body_->view.spin_in_space(Form::accumulated(state)));
      for (std::size_t k = 0; k < 3; ++k) accumulated_[i][k] = std::fabs(flowed[k]);
      const auto observables = memory.observables(i, lane);
      Form::place(observables, i, *body_);
      const auto& frame = placement.frame[i];
      placement.near[i] = near;
      placement.far[i] = L::compose(frame, segment.inner);
      near = L::compose(frame, segment.outer);
      motion_[i].spin = Form::spin(observables);
      const typename L::Spin spin = L::axes(frame) * motion_[i].spin;
      motion_[i].velocity = velocity + L::spun(spin, L::rotate(frame, chain().inertias[i].center));
      velocity += L::spun(spin, L::rotate(frame, segment.arm));
      work.angles[i] = work.q.angle[i];
      typename L::Spin moment;
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        moment[k] = joints_->section_forces()[i][body_->view.section_axes().rotation(k)];
      }
      if constexpr (L::kRotations == 3) {
        // As it works on spins: chain/rotation.hpp.
        const auto& angle = work.q.angle[i];
        const chain::RotationCoefficients<double> by(dot(angle, angle));
        moment = transposed_times(chain::inverse_tangent_map(angle, by), moment);
      }
      for (std::size_t k = 0; k < L::kRotations; ++k) work.joints.force[i][k] = moment[k];
    }
  }

  /// What each joint passes on: loads less what the segments outside of it resist, by the
  /// accelerations of the step before.
  void transmit() {
    auto& work = body_->work;
    const auto& placement = work.placement;
    const std::size_t n = motion_.size();
    center_acceleration_.resize(n);
    typename L::Point at{};
    for (std::size_t i = 0; i < n; ++i) {
      const auto& frame = placement.frame[i];
      const typename L::Spin spin = L::axes(frame) * motion_[i].spin;
      const auto moved = [&](const typename L::Point& local) {
        const typename L::Point arm = L::rotate(frame, local);
        return at + L::spun(angular_acceleration_[i], arm) + L::spun(spin, L::spun(spin, arm));
      };
      center_acceleration_[i] = moved(chain().inertias[i].center);
      at = moved(chain().segments[i].arm);
    }
    auto& outer = work.transmitted.outer;
    for (auto& wrench : outer) wrench = {};
    for (const auto& load : chain().loads) {
      const double factor = chain().histories[load.history].at(work.time);
      const auto unit = chain::unit_wrench(load, placement);
      outer[load.segment].force += factor * unit.force;
      outer[load.segment].moment += factor * unit.moment;
    }
    chain::Wrench<L> sum{};
    for (std::size_t i = n; i-- > 0;) {
      const auto& inertia = chain().inertias[i];
      const auto axes = L::axes(placement.frame[i]);
      const typename L::Spin spin = motion_[i].spin;
      const typename L::Spin momentum = inertia.rotational * spin;
      const typename L::Spin resists =
          axes * (inertia.rotational * transposed_times(axes, angular_acceleration_[i]) +
                  L::spin_derivative(momentum) * -spin);
      const typename L::Point force = -(inertia.mass * center_acceleration_[i]);
      const typename L::Point arm = L::rotate(placement.frame[i], inertia.center);
      sum.force += outer[i].force + force;
      sum.moment += outer[i].moment + L::moment(arm, force) - resists;
      outer[i] = sum;
      if (i > 0) {
        sum.moment += L::moment(placement.position[i] - placement.position[i - 1], sum.force);
      }
    }
  }

  const ChainModel* model_ = nullptr;
  LaneCase case_;
  std::unique_ptr<Body> body_;
  std::unique_ptr<chain::SectionJointsBase<L, false>>
      laws_;  ///< while the body has prescribed joints
  PrescribedJoints<L>* joints_ = nullptr;
  Motions motion_;
  std::vector<JointFlow> accumulated_;  ///< sums of the permanent angles' changes (N)
  std::vector<typename L::Spin>
      angular_acceleration_;  ///< angular accelerations, in world axes (N)
  std::vector<typename L::Point>
      center_acceleration_;          ///< accelerations of the centers of mass (N)
  std::vector<std::size_t> probed_;  ///< segments of points that probes are at
  double kinetic_ = 0.0;             ///< energy [J]
  double potential_ = 0.0;           ///< of the loads at time 0 [J]
  solve::EnergyFlows flows_;
  Status status_ = Status::NotRun;
};

}  // namespace plastica
