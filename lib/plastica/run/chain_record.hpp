#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/run/break_watch.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/chain_shape.hpp"
#include "plastica/run/growing_histories.hpp"
#include "plastica/run/response.hpp"
#include "plastica/run/spread_joint.hpp"
#include "plastica/solve/motion_options.hpp"
#include "plastica/solve/newton.hpp"
#include "plastica/solve/pencil.hpp"
#include "plastica/solve/segment_motion.hpp"

namespace plastica {

/// Energies at a sample that kernels have summed [J].
struct PrescribedEnergies {
  double elastic = 0.0;
  double plastic = 0.0;
};

/// What a chain's unknowns mean in space, and what the loads have done: fills the response.
template <class L, bool kElastic>
class ChainRecord {
 public:
  using Work = solve::NewtonWork<L, kElastic>;
  using Joints = chain::SectionJointsBase<L, kElastic>;
  using S = typename L::Scalar;
  using Space = Vec<double, 3>;

  void prepare(const ChainModel& model, const chain::View<L>& view, const chain::Build<L>& build,
               const std::vector<chain::JointModel>& joints, BreakWatch& watch);

  /// Forgets the path so far.
  void reset();
  /// The joint of the law at a node: that of the chain, or to the ground at the end; or none.
  std::size_t joint_of_node(std::size_t node) const { return (*joints_)[node].joint; }
  static constexpr std::size_t kNone = chain::JointModel::kNone;

  /// Permanent deformation of the joint at a node that has one: what is left of its angles about x,
  /// y, z and of its elongation without its forces. A joint that does not stretch has that of its
  /// section, where the law sees the axial force.
  JointFlow permanent_flow(const Joints& joints, const Work& w, std::size_t node) const;

  /// Statics: adds the work of loads and moving supports since the last call; at the first one what
  /// the state at time 0 took.
  void add_work(const Work& w, const Joints& joints);

  // Dynamics: what moves, and what has flowed, at the samples that are written from now on.
  void begin_motion(const Work& w, const Joints& joints,
                    const std::vector<solve::SegmentMotion<L>>& motion, double kinetic);
  void set_motion(const std::vector<solve::SegmentMotion<L>>& motion, double kinetic,
                  const solve::EnergyFlows& flows);
  void end_motion() { motion_ = nullptr; }
  Energies energies(const Work& w, const Joints& joints) const;

  /// Writes one sample, and its shape if it is to be kept.
  void write(const Work& w, const Joints& joints, NodeStrains& strains, std::size_t sample,
             Response& response);

  /// Before the first sample: which samples keep their shape.
  void begin_frames(Response& response) const {
    response.chain.frame_sample = model_->frame_sample;
  }
  /// After the last one: keeps its shape, too, where the run has ended early.
  void end_frames(Response& response) const;
  /// From now on shapes are worked out where a frame or a probe needs them, or for every sample; a
  /// run that ends early calls `shape_now` before `end_frames`, or runs again with those of all.
  void shapes_on_demand(bool on_demand = true) { on_demand_ = on_demand; }
  /// Whether the last sample of a run that has ended has no shape, but was to have one.
  bool lacks_last_shape(const Response& response) const {
    return on_demand_ && !probes_read_shape_ && response.samples > 0 &&
           !is_kept(response.samples - 1, response.chain);
  }
  /// Whether a sample, written on demand, needs the whole chain; else the points of probes and the
  /// energies will do.
  bool needs_chain(std::size_t sample, const Response& response) const {
    return !on_demand_ || probes_read_chain_ || is_kept(sample, response.chain);
  }
  /// Dynamics: energies of the next sample that are known already.
  void prescribe_energies(const PrescribedEnergies& energies) { prescribed_ = energies; }
  void shape_now(const Work& w, const Joints& joints, NodeStrains& strains) {
    set_shape(w, joints, strains);
    set_velocities(w);
  }

  /// Moment of a node's joint about its x, y, z [N m]: of its section and of a spring beside it.
  Space moment(const Joints& joints, const Work& w, std::size_t node) const;
  /// The factor that responses show: of the first load, motion or gravity that changes in time.
  double factor_at(double time) const { return shown_history().at(time); }
  const History& shown_history() const;
  /// That of what ends a path at a time, or breaks the beam: of the first that grows there; where
  /// none does, the one above.
  double growing_factor_at(double time) const { return growing_history(time).at(time); }
  const History& growing_history(double time) const;

  /// Force and moment of a support on the beam, and on what acts on the support itself.
  std::array<double, 6> reaction(const Work& w, std::size_t support) const;

 private:
  /// Of these, that of the beam alone.
  std::array<double, 6> support_force(const Work& w, std::size_t support) const;
  /// Of what its springs push, about where it begins; of a support that is no bed 0.
  Space moment_of_bed(const Work& w, std::size_t support) const;
  typename L::Point spring_force(const chain::Spring<L>& spring, const Work& w) const;
  /// That the joint at a node transmits, in its axes.
  Space force_at(const Work& w, std::size_t node) const;
  static bool is_kept(std::size_t sample, const ChainHistory& history) {
    return std::binary_search(history.frame_sample.begin(), history.frame_sample.end(), sample);
  }
  Space joint_spin(const typename L::Spin& w) const { return in_double(view_.spin_in_space(w)); }
  Space in_space(const typename L::Point& p) const { return in_double(view_.point_in_space(p)); }
  double load_work(const chain::SegmentLoad<L>& load, const Work& w) const;
  double spring_energy(const Work& w) const;
  std::array<double, 6> world_axes(const Space& force, const Space& moment) const {
    return {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
  }
  double probe_value(const Probe& probe, const Work& w, NodeStrains& strains,
                     const Response& response, std::size_t sample) const;
  double joint_value(const Probe& probe, const NodeStrains& strains) const;
  /// In the break measure. @param angles  net or accumulated (nodes)
  double hinge_strain(const Probe& probe, const std::vector<JointFlow>& angles) const;
  void set_shape(const Work& w, const Joints& joints, NodeStrains& strains);
  /// Dynamics: the rest of the shape.
  void set_velocities(const Work& w);
  void keep_shape(std::size_t frame, ChainHistory& history) const;
  Space point_value(const Probe& probe, const Work& w) const;
  /// Where the node of a joint is that has stretched and sheared, between both of its segments.
  typename L::Point sheared_node(std::size_t node, const Work& w) const;
  Space rotation_value(const Probe& probe, const Work& w) const;
  SpreadJoint spread_joint_at(const Probe& probe, const Work& w) const;
  typename L::Spin moment_at_node(std::size_t node, const Work& w) const;
  Space motion_value(const Probe& probe, const Work& w) const;
  // Dynamics, of a segment in world axes:
  typename L::Spin spin_of(std::size_t segment, const Work& w) const;
  /// @param place  of one of its points, in its axes
  typename L::Point velocity_of(std::size_t segment, const typename L::Point& place,
                                const Work& w) const;
  double stored_energy(const Work& w, const Joints& joints) const;
  /// Of a segment from the undeformed beam, as a rotation vector in world axes.
  Space rotation(const Work& w, std::size_t segment) const;
  std::size_t node_at(const Place& place) const;
  /// The same of a probe of angles: a clamp that lets nothing turn has a moment, but no angle, and
  /// the joint beside it has both.
  std::size_t turning_node_at(const Probe& probe) const;
  bool is_cut(const Work& w, std::size_t node) const {
    if (node < build_->chain.size()) return w.q.open[node];
    for (std::size_t g = 0; g < build_->chain.ground_joints.size(); ++g) {
      if (build_->chain.ground_joints[g].joint == joint_of_node(node)) {
        return w.q.released_ground_joint[g];
      }
    }
    return false;
  }
  /// Whether the level moves points along a world axis.
  bool moves_along(std::size_t axis) const {
    typename L::Point one;
    for (std::size_t k = 0; k < L::kTranslations; ++k) one[k] = constant<S>(1);
    return in_space(one)[axis] != 0.0;
  }
  /// A clamped start has no law: its joint's moment is what it transmits.
  void clamp_moment(const Work& w, typename L::Spin& moment) const {
    const auto in_joint =
        transposed_times(L::axes(w.placement.near[0]), w.transmitted.outer[0].moment);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      if (build_->chain.root.clamped[k]) moment[k] = in_joint[k];
    }
  }

  const ChainModel* model_ = nullptr;
  chain::View<L> view_{};
  const chain::Build<L>* build_ = nullptr;
  BreakWatch* watch_ = nullptr;                             ///< the measure of permanent strains
  const std::vector<chain::JointModel>* joints_ = nullptr;  ///< at the nodes
  // Where the work was last summed:
  chain::Placement<L> placement_;
  std::vector<std::array<double, 6>> support_force_;
  ChainHistory shape_;  ///< of the sample that is being written, as one frame
  bool on_demand_ = false;
  bool probes_read_shape_ = false;
  bool probes_read_chain_ = false;  ///< more than where some points are
  std::optional<PrescribedEnergies> prescribed_{};
  bool begun_ = false;
  double time_ = 0.0;
  double external_ = 0.0;
  const std::vector<solve::SegmentMotion<L>>* motion_ = nullptr;  ///< in dynamics
  double kinetic_ = 0.0;
  double energy_at_start_ = 0.0;
  solve::EnergyFlows flows_{};
};

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::prepare(const ChainModel& model, const chain::View<L>& view,
                                       const chain::Build<L>& build,
                                       const std::vector<chain::JointModel>& joints,
                                       BreakWatch& watch) {
  model_ = &model;
  watch_ = &watch;
  view_ = view;
  build_ = &build;
  joints_ = &joints;
  placement_.resize(build.chain.size());
  support_force_.resize(model.scene.supports.size());
  size_shape(response_size(model), 1, shape_);
  probes_read_shape_ = std::any_of(model.scene.probes.begin(), model.scene.probes.end(),
                                   [](const Probe& probe) { return is_of_joint(probe.quantity); });
  probes_read_chain_ =
      std::any_of(model.scene.probes.begin(), model.scene.probes.end(), [](const Probe& probe) {
        return !is_of_point(probe.quantity) && !is_of_all(probe.quantity);
      });
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::reset() {
  begun_ = false;
  external_ = 0.0;
}

/// The first history that something acts on a scene by and that is as asked, in the order in which
/// factors are shown of them: loads, motions of supports, gravity; else null.
template <class Is>
const History* first_history(const Scene& scene, const Is& is) {
  for (const Load& load : scene.loads) {
    if (is(load.history)) return &load.history;
  }
  bool any = !scene.loads.empty();
  for (const Support& support : scene.supports) {
    any = any || support.moves();
    if (support.moves() && is(support.history)) return &support.history;
  }
  const bool weighs = !any || scene.gravity != std::array<double, 3>{};
  return weighs && is(scene.gravity_history) ? &scene.gravity_history : nullptr;
}

template <class L, bool kElastic>
const History& ChainRecord<L, kElastic>::shown_history() const {
  // Beside a dead weight that stays, a factor tells nothing of what grows.
  const Scene& scene = model_->scene;
  const auto* changing = first_history(scene, [](const History& h) { return h.factor.size() > 1; });
  if (changing != nullptr) return *changing;
  return *first_history(scene, [](const History& /*any*/) { return true; });
}

template <class L, bool kElastic>
const History& ChainRecord<L, kElastic>::growing_history(double time) const {
  const double before = solve::just_before(time);
  const auto* growing = first_history(model_->scene, [&](const History& history) {
    return history.factor.size() > 1 && grows(history, before);
  });
  return growing != nullptr ? *growing : shown_history();
}

template <class L, bool kElastic>
std::size_t ChainRecord<L, kElastic>::node_at(const Place& place) const {
  const auto nearest = static_cast<std::size_t>(nearest_segment_end(place, model_->layout.ends));
  // A free end has no joint; the last one is before it.
  return joint_of_node(nearest) == kNone && nearest > 0 ? nearest - 1 : nearest;
}

template <class L, bool kElastic>
std::size_t ChainRecord<L, kElastic>::turning_node_at(const Probe& probe) const {
  const std::size_t node = node_at(probe.at);
  if (node != 0 || joint_of_node(1) == kNone) return node;
  const auto axes = view_.section_axes();
  const auto asked = static_cast<std::size_t>(probe.component);
  bool any = false;
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    const std::size_t axis = axes.rotation(k);
    const bool counts = probe.component == Component::Size ? axis < 2 : axis == asked;
    if (!counts) continue;
    any = true;
    if (!build_->chain.root.clamped[k]) return node;
  }
  return any ? 1 : node;
}

template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::moment(const Joints& joints,
                                                                          const Work& w,
                                                                          std::size_t node) const {
  const std::size_t joint = joint_of_node(node);
  if (is_cut(w, node)) return {};
  const chain::SectionJoint<L>& numbers = joints.joints()[joint];
  const auto axes = view_.section_axes();
  typename L::Spin m;
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    m[k] = numbers.active[k] * joints.section_forces()[joint][axes.rotation(k)] +
           numbers.spring[k] * w.angles[joint][k];
  }
  if (node == 0) clamp_moment(w, m);
  return joint_spin(m);
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::set_shape(const Work& w, const Joints& joints,
                                         NodeStrains& strains) {
  const std::size_t n = build_->chain.size();
  const std::vector<double>& strain = watch_->strains(strains);
  const auto put = [](std::vector<double>& to, std::size_t index, const Space& v) {
    for (std::size_t k = 0; k < 3; ++k) to[index + k] = v[k];
  };
  for (std::size_t i = 0; i <= n; ++i) {
    const typename L::Point point =
        i < n ? w.placement.position[i]
              : w.placement.point(n - 1, build_->chain.segments[n - 1].arm);
    Space where = in_space(point);
    if constexpr (L::kTranslations < 3) {
      // What a level does not move stays where it was.
      for (std::size_t k = 0; k < 3; ++k) {
        if (!moves_along(k)) where[k] = model_->layout.node[i][k];
      }
    }
    put(shape_.position, 3 * i, where);
    const std::size_t joint = joint_of_node(i);
    if (joint == kNone) continue;
    put(shape_.moment, 3 * i, moment(joints, w, i));
    put(shape_.angle, 3 * i, joint_spin(w.angles[joint]));
    for (std::size_t k = 0; k < 3; ++k) shape_.plastic_angle[3 * i + k] = strains.permanent[i][k];
    put(shape_.force, 3 * i, force_at(w, i));
    shape_.plastic_strain[i] = strain[i];
    const chain::JointModel& numbers = (*joints_)[i];
    shape_.stress[i] = numbers.bending_together(numbers.stress(0, shape_.moment[3 * i]),
                                                numbers.stress(1, shape_.moment[3 * i + 1]));
  }
  for (std::size_t i = 0; i < n; ++i) put(shape_.rotation, 3 * i, rotation(w, i));
  for (std::size_t s = 0; s < shape_.supports; ++s) {
    const auto force = reaction(w, s);
    std::copy(force.begin(), force.end(),
              shape_.reaction.begin() + static_cast<std::ptrdiff_t>(6 * s));
  }
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::keep_shape(std::size_t frame, ChainHistory& history) const {
  for (const ShapeValue& value : kShapeValues) {
    const std::vector<double>& from = shape_.*value.values;
    std::copy(from.begin(), from.end(),
              (history.*value.values).begin() + static_cast<std::ptrdiff_t>(frame * from.size()));
  }
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::end_frames(Response& response) const {
  auto& frames = response.chain.frame_sample;
  if (response.samples == 0) return;
  const std::size_t last = response.samples - 1;
  const auto next = std::lower_bound(frames.begin(), frames.end(), last);
  if (next == frames.end() || *next == last) return;
  *next = last;
  keep_shape(static_cast<std::size_t>(next - frames.begin()), response.chain);
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::write(const Work& w, const Joints& joints, NodeStrains& strains,
                                     std::size_t sample, Response& response) {
  ChainHistory& out = response.chain;
  out.time[sample] = w.time;
  out.factor[sample] = factor_at(w.time);
  out.energy[sample] = energies(w, joints);
  const bool kept = is_kept(sample, out);
  if (kept || probes_read_shape_ || !on_demand_) set_shape(w, joints, strains);
  if (kept || !on_demand_) set_velocities(w);
  if (kept) {
    const auto& frames = out.frame_sample;
    const auto frame = std::lower_bound(frames.begin(), frames.end(), sample);
    keep_shape(static_cast<std::size_t>(frame - frames.begin()), out);
  }
  const auto& probes = model_->scene.probes;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    response.probes[p][sample] = probe_value(probes[p], w, strains, response, sample);
  }
}

}  // namespace plastica

#include "plastica/run/chain_flow.hpp"
#include "plastica/run/chain_probe.hpp"
#include "plastica/run/chain_work.hpp"
