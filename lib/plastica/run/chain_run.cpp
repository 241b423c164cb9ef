#include "plastica/run/chain_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "plastica/run/chain_laws.hpp"
#include "plastica/run/chain_runner.hpp"

namespace plastica {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

WatchedJoint watched_joint(const Scene& scene, const chain::Layout& layout,
                           const chain::PartForm& part, std::size_t node) {
  const std::size_t n = layout.size();
  WatchedJoint joint;
  joint.share = layout.ends[node];
  const double at = layout.ends[node] * scene.beam.length;
  joint.begin = node == 0 ? at : at - 0.5 * layout.segment_length[node - 1];
  joint.end = node == n ? at : at + 0.5 * layout.segment_length[node];
  joint.length = layout.joint_length[node];
  joint.round = detail::is_round(*part.section);
  joint.width = 2.0 * part.properties.outer_distance_y;
  joint.height = 2.0 * part.properties.outer_distance_x;
  joint.shear_lever = part.properties.torsion_constant / part.properties.torsion_modulus;
  const double bending = part.material->break_strain.value_or(kNoLimit);
  const bool report = scene.formulas == Formulas::Report;
  const double shear = report ? part.material->break_shear_strain.value_or(bending)
                              : resolved_break_shear_strain(*part.material).value_or(kNoLimit);
  joint.limit = {scene.break_limit_x.value_or(bending), scene.break_limit_y.value_or(bending),
                 scene.break_limit_z.value_or(shear), kNoLimit};
  if (!report && !scene.break_limit_x && !scene.break_limit_y) joint.limit[3] = bending;
  return joint;
}

}  // namespace

template <class L, bool kElastic>
ChainRunner<L, kElastic>::ChainRunner(const ChainModel& model, const chain::View<L>& view)
    : model_(model), view_(view), parts_(chain::part_forms(model.scene, !kOneForce<L, kElastic>)) {
  build_ = chain::Builder<L>(model.scene, model.layout, view).build();
  set_path_options();
  work_.resize(build_.chain);
  committed_ = work_.q;
  previous_ = work_.q;
  record_.prepare(model, view, build_, parts_);
  const std::size_t nodes = model.layout.size() + 1;
  std::vector<WatchedJoint> watched;
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::size_t segment = std::min(i, nodes - 2);
    watched.push_back(
        watched_joint(model.scene, model.layout, parts_[model.part_of_segment[segment]], i));
  }
  watch_ = BreakWatch(model.scene, std::move(watched));
  strains_.reset(nodes);
  trial_.reset(nodes);
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::set_path_options() {
  const SolverOptions& solver = model_.options;
  options_.newton.most_iterations = std::min(solver.most_iterations, solve::kMostIterations);
  options_.newton.tolerance = solver.tolerance;
  options_.stops = model_.stops;
  options_.recorded = model_.recorded;
  options_.control = solver.control;
  options_.finds_control = !solver.control_at && solver.control != PathControl::Displacement;
  options_.steps = solver.steps;
  options_.largest_turn = solver.largest_turn;
  options_.smallest_step = solver.smallest_step;
  options_.control_motion = solver.control_motion;
  const Scene& scene = model_.scene;
  Place at = Place::end();
  if (!scene.loads.empty()) at = scene.loads.front().at;
  if (solver.control_at) at = *solver.control_at;
  const chain::SegmentPoint point =
      chain::segment_point(model_.layout, share_of(at, model_.layout.ends));
  control_.segment = point.segment;
  control_.arm = view_.point(point.arm);
  if constexpr (L::kTranslations > 0) {
    // The level's own axes.
    const auto motion = view_.point(
        {{solver.control_motion[0], solver.control_motion[1], solver.control_motion[2]}});
    for (std::size_t k = 0; k < L::kTranslations; ++k) options_.control_motion[k] = motion[k];
  } else {
    options_.control_motion[0] = solver.control_motion[2];
  }
}

/// A hundred times the stiffness of the beam's tip, of its largest section.
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::set_closure_stiffness() {
  double bending = 0.0;
  for (const auto& joint : joints_->joints()) {
    for (std::size_t k = 0; k < 3; ++k) bending = std::max(bending, joint.stiffness[k]);
  }
  const double length = model_.scene.beam.length;
  build_.chain.closure_stiffness = 100.0 * bending / (length * length * length);
  build_.chain.closure_turning_stiffness = 100.0 * bending / length;
}

/// Lays out the joints' laws; the same numbers as in the run before only need the virgin state.
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::set_material(const MaterialValues<double>& material) {
  if (joints_ && material == material_) {
    joints_->reset();
    return;
  }
  std::vector<MaterialValues<double>> materials;
  for (const auto& part : parts_) materials.push_back(material_values(*part.material));
  materials.front() = material;
  joints_ = make_joints<L, kElastic>(model_.scene, parts_, materials,
                                     chain::joint_numbers(model_.layout, model_.part_of_segment,
                                                          build_.joints, parts_, materials, view_),
                                     view_, model_.options.fibres);
  material_ = material;
  set_closure_stiffness();
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::run(const MaterialValues<double>& material, Response& response) {
  const auto began = std::chrono::steady_clock::now();
  set_material(material);
  work_.resize(build_.chain);
  committed_ = work_.q;
  previous_ = work_.q;
  record_.reset();
  strains_.reset(strains_.strain.size());
  response_ = &response;
  response.samples = 0;
  response.chain.events.clear();

  solve::PathWalker<L, kElastic> walker(build_.chain, *joints_, options_, control_, work_,
                                        committed_, previous_, *this);
  walker_ = &walker;
  response.status = walker.walk();
  response.counters = walker.counters();
  response.limit = walker.limit();
  if (response.limit) {
    response.limit->below = record_.factor_at(response.limit->below);
    response.limit->above = record_.factor_at(response.limit->above);
  }
  response.permanent_strain = *std::max_element(strains_.strain.begin(), strains_.strain.end());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  response.seconds = took.count();
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::set_trial_strains(const Work& w) {
  for (std::size_t i = 0; i < trial_.strain.size(); ++i) {
    const std::size_t joint = record_.joint_of_node(i);
    if (joint == ChainRecord<L, kElastic>::kNone) continue;
    trial_.permanent[i] = record_.permanent_angle(*joints_, w, joint);
    for (std::size_t k = 0; k < 3; ++k) {
      trial_.accumulated[i][k] =
          strains_.accumulated[i][k] + std::fabs(trial_.permanent[i][k] - strains_.permanent[i][k]);
    }
  }
}

template <class L, bool kElastic>
const std::vector<JointAngles>& ChainRunner<L, kElastic>::measured(const NodeStrains& s) const {
  return model_.scene.break_measure == BreakMeasure::Net ? s.permanent : s.accumulated;
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::yields() const {
  const auto& work = joints_->work_increment();
  return std::any_of(work.begin(), work.end(), [](double w) { return w > 0.0; });
}

template <class L, bool kElastic>
solve::Verdict ChainRunner<L, kElastic>::judge(const Work& w, bool shortest) {
  set_trial_strains(w);
  if (!watch_.active()) return solve::Verdict::Accept;
  const double excess = watch_.excess(measured(trial_));
  if (excess <= 0.0 || model_.scene.on_break == BreakPolicy::RecordOnly) {
    return solve::Verdict::Accept;
  }
  return excess > kBreakTolerance && !shortest ? solve::Verdict::TooFar : solve::Verdict::End;
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::accept(const Work& w) {
  std::swap(strains_.permanent, trial_.permanent);
  std::swap(strains_.accumulated, trial_.accumulated);
  for (std::size_t i = 0; i < strains_.strain.size(); ++i) {
    strains_.strain[i] = watch_.strain(measured(strains_), i);
  }
  record_.add_work(w);
  if (response_->chain.events.empty() && watch_.active() &&
      watch_.excess(measured(strains_)) > 0.0) {
    note_break(w);
  }
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::note_break(const Work& w) {
  ChainBreak event;
  event.time = w.time;
  event.factor = record_.factor_at(w.time);
  event.joints = watch_.broken(measured(strains_));
  for (BrokenJoint& broken : event.joints) {
    const std::size_t joint = record_.joint_of_node(static_cast<std::size_t>(broken.joint));
    broken.moment = record_.moment(*joints_, w, static_cast<std::size_t>(broken.joint)).at;
    broken.angle = strains_.permanent[static_cast<std::size_t>(broken.joint)];
    broken.dissipation = joints_->plastic_work()[joint];
  }
  response_->chain.events.push_back(std::move(event));
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::record(const Work& w) {
  if (response_->samples == model_.samples) return false;
  record_.write(w, *joints_, strains_, response_->samples, *response_);
  response_->chain.iterations[response_->samples] = walker_->counters().iterations;
  ++response_->samples;
  return response_->samples < model_.samples;
}

std::unique_ptr<ChainProgram> make_chain_program(const ChainModel& model) {
  const bool elastic = model.options.translation == JointTranslation::Elastic;
  using chain::Planar;
  using chain::Spatial;
  using chain::Twist;
  using chain::View;
  switch (model.level) {
    case Level::Twist:
      return std::make_unique<ChainRunner<Twist<double>, false>>(model, View<Twist<double>>{});
    case Level::Planar: {
      const View<Planar<double>> view{model.across};
      if (elastic) return std::make_unique<ChainRunner<Planar<double>, true>>(model, view);
      return std::make_unique<ChainRunner<Planar<double>, false>>(model, view);
    }
    default: {
      const View<Spatial<double>> view{};
      if (elastic) return std::make_unique<ChainRunner<Spatial<double>, true>>(model, view);
      return std::make_unique<ChainRunner<Spatial<double>, false>>(model, view);
    }
  }
}

}  // namespace plastica
