#include "plastica/run/chain_body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plastica/chain/axial.hpp"
#include "plastica/law/gauge_form.hpp"
#include "plastica/run/chain_laws.hpp"

namespace plastica {
namespace {

/// Whether joints of a path yield by their axial force, too; in motion they do not.
bool sees_axial(const ChainModel& model) {
  const YieldModel yields = model.scene.yield_model;
  return model.options.analysis == Analysis::Statics && yields != YieldModel::Elastic &&
         yields != YieldModel::PerAxis;
}

/// At rest a break ends the path.
std::vector<bool> joints_that_may_open(const ChainModel& model) {
  const bool moves = model.options.analysis == Analysis::Dynamics;
  std::vector<bool> may_open(model.layout.size(), moves && has_break_limits(model.scene));
  for (const JointCut& cut : model.cuts) {
    if (cut.node < may_open.size()) may_open[cut.node] = true;
  }
  return may_open;
}

/// Of the plastic work of a joint in a step.
template <class S>
bool is_flow(const S& work) {
  return work < constant<S>(0) || work > constant<S>(0);
}

/// Whether a change of a joint's permanent elongation is one, and not rounding.
bool is_stretch(double change, const chain::JointModel& joint) {
  constexpr double kRounding = 1e-12;
  return std::fabs(change) > kRounding * joint.own_length();
}

}  // namespace

template <class L, bool kElastic>
ChainBody<L, kElastic>::ChainBody(const ChainModel& of, const chain::View<L>& seen)
    : model(of), view(seen) {
  build = chain::build_chain<L>(
      model.scene, model.layout, view,
      {model.options.rotary_inertia, kElastic, sees_axial(model), joints_that_may_open(model)});
  record.prepare(model, view, build, joint_models, watch);
  const std::size_t nodes = model.layout.size() + 1;
  strains.reset(nodes);
  trial.reset(nodes);
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::reset(const MaterialValues<double>& material) {
  set_material(material);
  work.resize(build.chain);
  record.reset();
  strains.reset(strains.permanent.size());
}

/// Lays out the joints' laws; the same numbers as in the run before only need the virgin state.
template <class L, bool kElastic>
void ChainBody<L, kElastic>::set_material(const MaterialValues<double>& material) {
  if (joints && material == material_) {
    joints->reset();
    return;
  }
  auto made = chain::joint_set(model.scene, model.layout, build, material, view);
  joints = make_joints<L, kElastic>(model.scene, model.layout.regions, made.materials,
                                    std::move(made.numbers), view, model.options.fibres);
  material_ = material;
  joint_models = std::move(made.at_nodes);
  // Which region owns a joint between two follows from the material.
  if (watch.size() == 0 || model.layout.regions.size() > 1)
    watch = BreakWatch(model.scene, joint_models);
  set_neutral_axes();
  chain::set_constraint_stiffness(joints->joints(), model.scene.beam.length, build.chain);
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::set_neutral_axes() {
  // Of all regions: which owns a joint between two is another with another material. That has no
  // part in the axes themselves, since all caps of a section grow with its yield stress.
  if (!neutral_axes_.empty() || !has_one_surface(model.scene.yield_model)) return;
  for (const chain::BeamRegion& region : model.layout.regions) {
    const auto cap =
        chain::joint_of_region(model.scene, region, material_values(region.material)).cap;
    const auto about = [&](law::GaugePlane plane, std::size_t axis) {
      return law::neutral_axis(region.section, region.properties, region.gauge, plane,
                               cap[axis] / cap[law::kAxial]);
    };
    neutral_axes_.push_back({about(law::GaugePlane::AboutX, law::kBendingX),
                             about(law::GaugePlane::AboutY, law::kBendingY)});
  }
}

template <class L, bool kElastic>
bool ChainBody<L, kElastic>::flows() const {
  if (model.scene.yield_model == YieldModel::Elastic) return false;
  const auto& works = joints->work_increment();
  if (std::any_of(works.begin(), works.end(), is_flow<S>)) return true;
  if (joints->axial_states().empty()) return false;
  // Joints that do not stretch may flow along the beam alone, which does no work that they know.
  for (std::size_t i = 0; i < strains.permanent.size(); ++i) {
    if (record.joint_of_node(i) == chain::JointModel::kNone) continue;
    const double stretch = record.permanent_flow(*joints, work, i)[kStretch];
    if (is_stretch(stretch - strains.elongation[i], joint_models[i])) return true;
  }
  return false;
}

template <class L, bool kElastic>
double ChainBody<L, kElastic>::counted_stretch(std::size_t node, double stretch) const {
  const chain::JointModel& at = joint_models[node];
  if (stretch == 0.0 || neutral_axes_.empty()) return stretch;
  law::SectionForce<double> over_caps;
  for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
    over_caps[k] = static_cast<double>(joints->section_forces()[at.joint][k]) / at.cap[k];
  }
  // As in `permanent_flow`: of a joint that stretches its own.
  const bool stretches = kElastic && joints->joints()[at.joint].stretches;
  if (!stretches && !joints->axial_states().empty()) {
    const auto force = static_cast<double>(joints->axial_states()[at.joint].force);
    over_caps[law::kAxial] = force / at.cap[law::kAxial];
  }
  const law::GaugeForm& gauge = model.layout.regions[at.owner].gauge;
  const double n = law::axial_share(gauge, over_caps);
  const double by_x = std::fabs(over_caps[law::kBendingX]);
  const double by_y = std::fabs(over_caps[law::kBendingY]);
  const auto& [about_x, about_y] = neutral_axes_[at.owner];
  if (!(by_x + by_y > 0.0)) return stretch;
  return stretch * (by_x * about_x.fraction(n) + by_y * about_y.fraction(n)) / (by_x + by_y);
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::set_trial_strains(bool of_all) {
  if (model.scene.yield_model == YieldModel::Elastic) return;
  const auto& works = joints->work_increment();
  for (std::size_t i = 0; i < trial.permanent.size(); ++i) {
    const std::size_t joint = record.joint_of_node(i);
    if (joint == chain::JointModel::kNone) continue;
    const bool turns = of_all || is_flow(works[joint]);
    if (!turns && joints->axial_states().empty()) {
      trial.permanent[i] = strains.permanent[i];
      trial.accumulated[i] = strains.accumulated[i];
      trial.elongation[i] = strains.elongation[i];
      continue;
    }
    trial.permanent[i] = record.permanent_flow(*joints, work, i);
    if (!turns) std::copy_n(strains.permanent[i].begin(), kStretch, trial.permanent[i].begin());
    double& elongation = trial.elongation[i];
    elongation = trial.permanent[i][kStretch];
    const double before = strains.elongation[i];
    if (!is_stretch(elongation - before, joint_models[i])) elongation = before;  // rounding
    trial.permanent[i][kStretch] =
        strains.permanent[i][kStretch] + counted_stretch(i, elongation - before);
    for (std::size_t k = 0; k < trial.permanent[i].size(); ++k) {
      trial.permanent[i][k] += 0.0;  // no -0, which tables would show
      trial.accumulated[i][k] =
          strains.accumulated[i][k] + std::fabs(trial.permanent[i][k] - strains.permanent[i][k]);
    }
  }
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::accept_strains() {
  if (model.scene.yield_model == YieldModel::Elastic) return;
  strains.take(trial);
}

/// At rest lanes know neither the forces of a step nor the joints' axes.
template <class L, bool kElastic>
void ChainBody<L, kElastic>::find_axial_forces(bool in_motion) {
  const auto factor_at = [&](std::size_t history) {
    return build.chain.histories[history].at(work.time);
  };
  const auto find = [&](const chain::Placement<L>& placement,
                        const std::vector<chain::Wrench<L>>& wrench) {
    chain::find_axial_forces(build.chain, work.q, placement, work.closed, work.time, factor_at,
                             wrench, axial_forces_, axial_);
  };
  if (in_motion) {
    find(work.placement, work.outer_forces.wrench);
    return;
  }
  axial_placement_.resize(build.chain.size());
  chain::place<kElastic>(build.chain, work.q, work.time, axial_placement_);
  chain::gather_loads(build.chain, axial_placement_, chain::Stage<L>{}, factor_at, axial_outside_);
  chain::add_constraints(build.chain, axial_placement_, chain::Stage<L>{}, work.q, work.closed,
                         axial_outside_);
  find(axial_placement_, axial_outside_.wrench);
}

template <class L, bool kElastic>
double ChainBody<L, kElastic>::missing_elongation(std::size_t j) const {
  const chain::JointPlan& plan = build.joints[j];
  const auto& works = joints->work_increment();
  const std::size_t n = build.chain.size();
  // The joint whose length makes up for it: where that yields, too, nothing is missing.
  const std::size_t beside = plan.node == 0 ? 1 : plan.node == n ? n - 1 : plan.node - 1;
  if (beside > 0 && beside < n && works[beside] > constant<S>(0)) return 0.0;
  if (!joints->joints()[j].stretches) return 1.0;
  const double bends = *std::max_element(plan.length.begin(), plan.length.begin() + 2);
  const double missing = 1.0 - plan.length[3] / bends;
  return missing > 0.25 ? missing : 0.0;  // less is how lengths are dealt out beside regions
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::note_axial(bool in_motion, Response& response,
                                        const std::vector<S>* given) {
  if (L::kTranslations == 0 || model.scene.yield_model == YieldModel::Elastic) return;
  const bool per_axis = model.scene.yield_model == YieldModel::PerAxis;
  const auto& works = joints->work_increment();
  const auto yields = [&](std::size_t j) { return works[j] > constant<S>(0); };
  const bool left_out = per_axis || in_motion;
  const bool any =
      std::any_of(works.begin(), works.end(), [](const S& flow) { return flow > constant<S>(0); });
  // A section of which N is left out would yield by N alone, too: that shows in no flow.
  if (!any && !(per_axis && !in_motion && carries_axial_yield())) return;
  if (left_out && given == nullptr) find_axial_forces(in_motion);
  const std::vector<S>& axial = given != nullptr ? *given : left_out ? axial_ : work.joints.axial;
  // Ideal plasticity does not let N grow; fibres know how they bend under it.
  const bool takes_thrust = !left_out && model.scene.yield_model != YieldModel::Fibre &&
                            model.scene.material.hardening.law != HardeningLaw::Ideal;
  constexpr double kLengthens = 0.05;  // of N_p: below it a hinge hardly lengthens
  for (std::size_t j = 0; j < axial.size(); ++j) {
    const bool stretches = kElastic && joints->joints()[j].stretches;
    const auto& joint = joints->joints()[j];
    const double force = stretches ? joints->section_forces()[j][law::kAxial] : axial[j];
    const double ratio = std::fabs(force) / static_cast<double>(joint.axial_yield);
    const bool seen = stretches && !per_axis;
    const double missing = kElastic && !left_out ? missing_elongation(j) : 0.0;
    // In a motion, nothing is left out of a joint that stretches; its neighbours that do not, at
    // the ends, may have more than N_p from the hardening of those that do.
    if (in_motion && seen) continue;
    const bool is_beside = kElastic && in_motion && !per_axis;
    if (!yields(j) && !(left_out && !is_beside && ratio > 1.0)) continue;
    const bool grows = takes_thrust && force < 0.0 && ratio > 1.0;
    const double least = missing > 0.0 ? kLengthens
                         : grows       ? 1.0
                         : seen        ? chain::JointModel::kNever
                         : left_out    ? 1e-3
                                       : 1.0;
    if (ratio < std::max(least, response.axial ? response.axial->ratio : 0.0)) continue;
    const chain::JointPlan& plan = build.joints[j];
    const double thrust = response.axial ? response.axial->thrust : 0.0;
    response.axial = AxialNote{ratio, model.layout.ends[plan.node], 1.0,
                               grows ? std::max(thrust, ratio) : thrust, missing};
    axial_part_ = joint.law;
  }
}

template <class L, bool kElastic>
bool ChainBody<L, kElastic>::carries_axial_yield() const {
  const auto& outer = work.transmitted.outer;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const S most = joints->joints()[i].axial_yield;
    if (dot(outer[i].force, outer[i].force) > most * most) return true;
  }
  return false;
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::finish_axial(Response& response) const {
  if (!response.axial) return;
  response.axial->left =
      law::moment_left(model.layout.regions[axial_part_].section, model.scene.yield_cap,
                       model.scene.formulas, response.axial->ratio);
}

template <class L, bool kElastic>
void ChainBody<L, kElastic>::describe(BrokenJoint& broken) const {
  const auto node = static_cast<std::size_t>(broken.joint);
  const std::size_t joint = record.joint_of_node(node);
  broken.moment = record.moment(*joints, work, node).at;
  std::copy_n(strains.permanent[node].begin(), broken.angle.size(), broken.angle.begin());
  broken.dissipation = joints->plastic_work()[joint];
}

template <class L, bool kElastic>
std::vector<BrokenJoint> ChainBody<L, kElastic>::broken() {
  std::vector<BrokenJoint> all = watch.broken(watch.measured(strains));
  for (BrokenJoint& joint : all) describe(joint);
  return all;
}

template class ChainBody<chain::Twist<double>, false>;
template class ChainBody<chain::Planar<double>, false>;
template class ChainBody<chain::Planar<double>, true>;
template class ChainBody<chain::Spatial<double>, false>;
template class ChainBody<chain::Spatial<double>, true>;
template class ChainBody<chain::Twist<float>, false>;
template class ChainBody<chain::Planar<float>, false>;
template class ChainBody<chain::Spatial<float>, false>;

}  // namespace plastica
