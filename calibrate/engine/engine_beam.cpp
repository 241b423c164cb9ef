#include "calibrate/engine/engine_beam.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/support_kind.hpp"
#include "plastica/run/chain_body.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::calibrate {
namespace {

using Space = chain::Spatial<double>;
using Body = ChainBody<Space, false>;

EngineAxes axes_of(const Mat<double, 3, 3>& frame) {
  EngineAxes axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) axes[axis][k] = frame(k, axis);
  }
  return axes;
}

bool all_of(const std::array<bool, 3>& flags) { return flags[0] && flags[1] && flags[2]; }
bool any_of(const std::array<bool, 3>& flags) { return flags[0] || flags[1] || flags[2]; }

/// Puts the parts together; see `engine_beam`.
class BeamReader {
 public:
  explicit BeamReader(const ChainModel& model) : model_(model), body_(model, {}) {
    body_.reset(material_values(model.scene.material));
  }

  EngineBeam read() {
    const Scene& scene = model_.scene;
    beam_.name = scene.name;
    beam_.formulas = scene.formulas;
    beam_.yield_model = scene.yield_model;
    beam_.yield_cap = scene.yield_cap;
    beam_.carries_masses = !scene.masses.empty();
    beam_.hinge_lengths = body_.watch.hinge_lengths(0);
    beam_.break_length = break_length();
    beam_.breaks = body_.watch.active() && scene.yield_model != YieldModel::Elastic;
    add_regions();
    for (std::size_t i = 0; i < model_.layout.size(); ++i) add_segment(i);
    for (std::size_t i = 0; i < model_.layout.size(); ++i) add_joint(i);
    for (std::size_t s = 0; s < scene.supports.size(); ++s) add_support(s);
    for (const EngineJoint& joint : beam_.joints) check_frame(joint);
    return std::move(beam_);
  }

 private:
  /// What `BreakWatch` does with a joint whose neighbours are straight, in words.
  std::string break_length() const {
    if (beam_.hinge_lengths[0] == 0.0) return "l";
    switch (localization_of(model_.scene)) {
      case Localization::Concentrated: return "L_p";
      case Localization::Saturating: return "L_p where l < L_p, else l";
      case Localization::Distributed: break;
    }
    return "l";
  }

  void add_regions() {
    for (const chain::BeamRegion& form : model_.layout.regions) {
      EngineRegion region{form.material, form.section, form.properties, {}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        region.stiffness_factor[k] = form.form.axis[k].stiffness_factor;
        region.cap_factor[k] = form.form.axis[k].cap_factor;
      }
      beam_.regions.push_back(std::move(region));
    }
  }

  void add_segment(std::size_t i) {
    const chain::Inertia<Space>& inertia = body_.build.chain.inertias[i];
    EngineSegment segment;
    segment.length = model_.layout.segment_length[i];
    segment.mass = inertia.mass;
    for (std::size_t k = 0; k < 3; ++k) segment.inertia[k] = inertia.rotational(k, k);
    segment.start = model_.layout.node[i].at;
    segment.end = model_.layout.node[i + 1].at;
    segment.axes = axes_of(model_.layout.segment_frame[i]);
    segment.region = model_.layout.segment_regions[i].middle;
    if (!model_.scene.masses.empty()) balance_segment(i, segment);
    beam_.segments.push_back(segment);
  }

  /// Point masses move the center of mass along the chord.
  void balance_segment(std::size_t i, EngineSegment& segment) const {
    const chain::Inertia<Space>& inertia = body_.build.chain.inertias[i];
    const auto& arm = body_.build.chain.segments[i].arm;
    segment.balance = dot(inertia.center, arm) / dot(arm, arm);
    const auto& about = inertia.rotational;
    const double products =
        std::fabs(about(0, 1)) + std::fabs(about(0, 2)) + std::fabs(about(1, 2));
    if (products <= 1e-12 * (about(0, 0) + about(1, 1) + about(2, 2))) return;
    throw InputError({}, "mass.inertia", "",
                     "must have principal axes along those of its segment: an export has moments "
                     "of inertia about these alone");
  }

  /// The joint at the inner end of a segment.
  void add_joint(std::size_t i) {
    const chain::Root<Space>& root = body_.build.chain.root;
    EngineJoint joint;
    joint.name = fmt::format("joint_{}", i);
    joint.child = i;
    joint.axes = axes_of(model_.layout.joint_frame[i]);
    set_place(model_.layout.ends[i], model_.layout.node[i].at, joint);
    if (i > 0) {
      joint.parent = i - 1;
      joint.holds = {true, true, true};
    } else {
      joint.holds = root.held;
    }
    set_law(body_.joints->joints()[i], body_.build.joints[i].length[0], i, joint);
    for (std::size_t k = 0; k < 3; ++k) {
      if (i == 0 && root.clamped[k]) joint.rotation[k] = JointHold::Rigid;
    }
    joint.half_joint = i == 0 && joint.length > 0.0;
    const bool acts = any_of(joint.holds) || joint.rotation != std::array<JointHold, 3>{};
    if (acts) beam_.joints.push_back(std::move(joint));
  }

  /// What a support off the start holds rigidly, and its half joints.
  void add_support(std::size_t index) {
    const chain::Chain<Space>& chain = body_.build.chain;
    EngineJoint held;
    held.name = fmt::format("support_{}", index + 1);
    held.off_start = true;
    const double fraction = fraction_of(model_.scene.supports[index].at, model_.layout.ends);
    const chain::SegmentPoint point = chain::segment_point(model_.layout, fraction);
    const auto& frame = model_.layout.segment_frame[point.segment];
    set_place(fraction, (model_.layout.node[point.segment] + frame * point.arm).at, held);
    held.child = point.segment;
    held.axes = axes_of(identity<double, 3>());
    for (const chain::LoopConstraint<Space>& constraint : chain.constraints) {
      if (constraint.support != index || constraint.one_sided) continue;
      if (constraint.rotational) {
        add_weld(constraint, held);
        continue;
      }
      if (is_oblique(constraint.direction)) continue;  // is noted as left out
      for (std::size_t k = 0; k < 3; ++k) {
        held.holds[k] = held.holds[k] || std::fabs(constraint.direction[k]) > 0.5;
      }
    }
    bool is_first = true;
    for (const chain::GroundJoint<Space>& ground : chain.ground_joints) {
      const chain::JointPlan& plan = body_.build.joints[ground.joint];
      if (ground.support != index || !any_of(plan.active)) continue;
      EngineJoint half = held;
      if (!is_first) {
        half.name += "_beyond";
        half.holds = {};
      }
      half.half_joint = true;
      half.child = ground.segment;
      half.axes = axes_of(ground.ground.axes);
      set_law(body_.joints->joints()[ground.joint], plan.length[0], ground.node, half);
      beam_.joints.push_back(std::move(half));
      is_first = false;
    }
    if (is_first && (any_of(held.holds) || held.rotation != std::array<JointHold, 3>{})) {
      beam_.joints.push_back(std::move(held));
    }
  }

  /// A weld holds the segment before the support, and where there is one, that behind it.
  void add_weld(const chain::LoopConstraint<Space>& constraint, EngineJoint& held) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (constraint.axis[k] == 0.0) continue;
      if (constraint.segment == held.child) {
        held.rotation[k] = JointHold::Rigid;
      } else {
        beam_.notes.push_back(fmt::format("{} also welds segment_{} to the ground about {}",
                                          held.name, constraint.segment + 1, "xyz"[k]));
      }
    }
  }

  void set_place(double fraction, const std::array<double, 3>& point, EngineJoint& joint) const {
    joint.at = fraction * model_.scene.beam.length;
    joint.point = point;
  }

  void set_law(const chain::SectionJoint<Space>& law, double length, std::size_t node,
               EngineJoint& joint) const {
    joint.region = law.law;
    const chain::BeamRegion& region = model_.layout.regions[law.law];
    const auto material = material_values(region.material);
    const chain::JointModel model = chain::joint_of_region(model_.scene, region, material);
    for (std::size_t k = 0; k < 3; ++k) {
      if (law.active[k] == 0.0) continue;
      joint.rotation[k] = JointHold::Sprung;
      joint.length = length;
      joint.stiffness[k] = law.rotational_stiffness(k, k);
      if (model_.scene.yield_model == YieldModel::Elastic) continue;
      joint.yield_moment[k] = model.cap[k];
      if (region.material.hardening.law == HardeningLaw::Linear) {
        const auto uniaxial = law::uniaxial_material(region.form.axis[k], material);
        const auto linear = law::LinearHardening<double>::of(uniaxial, material);
        const double modulus = linear.isotropic + linear.kinematic;
        joint.hardened_stiffness[k] = joint.stiffness[k] * modulus / (uniaxial.stiffness + modulus);
      }
      if (beam_.breaks) joint.break_angle[k] = break_angle(model.limit[k], node, k);
    }
  }

  /// The permanent angle of one joint about one axis, all others straight, at which it breaks.
  double break_angle(double limit, std::size_t node, std::size_t axis) const {
    if (!std::isfinite(limit)) return kNever;
    const auto strain = [&](double angle) {
      JointFlow alone{};
      alone[axis] = angle;
      return body_.watch.lone_strain(alone, node);
    };
    // Strains are linear in the angle, but for Wendelius' sine, which goes no further than pi.
    const double straight = limit / strain(1.0);
    if (std::fabs(strain(straight) - limit) < 1e-12 * limit) return straight;
    double low = 0.0;
    double high = 3.14159265358979323846;
    if (strain(high) < limit) return kNever;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (strain(middle) < limit ? low : high) = middle;
    }
    return high;
  }

  /// Translations are held along the world's axes; a joint has one frame for them and its turning.
  void check_frame(const EngineJoint& joint) const {
    if (all_of(joint.holds) || !any_of(joint.holds)) return;
    if (joint.axes == axes_of(identity<double, 3>())) return;
    throw InputError(
        {}, fmt::format("support at {:g} m", joint.at), "",
        "must hold all translations or none where it holds rotation and the beam's axis "
        "does not run along z: an engine's joint has one frame");
  }

  const ChainModel& model_;
  Body body_;
  EngineBeam beam_;
};

/// The beam and what holds it, in space and free to move: what a scene does with its beam, and
/// whether it can be solved, does not matter here, but for where moments act: a joint beside a free
/// end turns by them for the half segment at the end, too.
Model bare_model(const Scene& scene) {
  Scene bare = scene;
  bare.gravity = {};
  bare.initial_motions.clear();
  bare.cuts.clear();
  bare.probes.clear();
  bare.loads = {{.at = Place::end(), .force = {0.0, 1.0, 0.0}}};
  for (const Load& load : scene.loads) {
    if (!load.to) bare.loads.push_back({.at = load.at, .moment = load.moment});
  }
  for (Support& support : bare.supports) support.translation = support.rotation = {};
  return prepare(bare, {.level = Level::Spatial, .analysis = Analysis::Dynamics, .duration = 1.0});
}

}  // namespace

std::array<double, 3> EngineSegment::point(double fraction) const {
  std::array<double, 3> there;
  for (std::size_t k = 0; k < 3; ++k) there[k] = (1.0 - fraction) * start[k] + fraction * end[k];
  return there;
}

EngineBeam engine_beam(const Scene& scene, const SolverOptions& options) {
  if (scene.is_coupon()) {
    throw InputError({}, "drive.strain", "", "a coupon has no joints: an export needs a beam");
  }
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    if (!traits_of(scene.supports[i]).releases) continue;
    throw InputError({}, fmt::format("support[{}]", i + 1), "", "is a hinge, which no export has");
  }
  const Model model = bare_model(scene);
  EngineBeam beam = BeamReader(*model.chain).read();
  beam.gravity = scene.gravity;
  beam.time_step = options.time_step;
  if (options.analysis == Analysis::Dynamics && options.damping != Damping::None) {
    beam.damping_time = options.damping_time;
  }
  add_scene_notes(scene, options, beam);
  return beam;
}

}  // namespace plastica::calibrate
