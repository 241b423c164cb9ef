#include "plastica/run/natural_frequencies.hpp"

#include <string>

#include "plastica/base/check.hpp"
#include "plastica/chain/build.hpp"
#include "plastica/chain/loads.hpp"
#include "plastica/run/chain_laws.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/simulate.hpp"
#include "plastica/run/small_motion.hpp"
#include "plastica/solve/newton_work.hpp"

namespace plastica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Copies a matrix to a place of a larger one.
template <std::size_t R, std::size_t C>
void put(const Mat<double, R, C>& m, Index row, Index column, MatrixXd& into) {
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) {
      into(row + static_cast<Index>(i), column + static_cast<Index>(j)) = m(i, j);
    }
  }
}

template <std::size_t R, std::size_t C>
MatrixXd dense(const Mat<double, R, C>& m) {
  MatrixXd copy(R, C);
  put(m, 0, 0, copy);
  return copy;
}

/// Builds a chain of a level and lets its laws tell their tangents at rest.
template <class L, bool kElastic>
class Rest {
 public:
  static constexpr Index kT = L::kTranslations;
  static constexpr Index kR = L::kRotations;

  Rest(const ChainModel& model, const chain::View<L>& view)
      : build_(chain::Builder<L>(model.scene, model.layout, view, model.options.rotary_inertia,
                                 kElastic)
                   .build()),
        length_(model.scene.beam.length) {
    for (History& history : build_.chain.histories) history = {{0.0}, {0.0}};
    rest_.resize(build_.chain);
    chain::place<kElastic>(build_.chain, rest_.q, 0.0, rest_.placement);
    evaluate_joints(model, view);
  }

  ChainAtRest in_numbers() const {
    const chain::Root<L>& root = build_.chain.root;
    ChainAtRest chain;
    chain.length = length_;
    chain.elastic = kElastic;
    chain.start_shifts = kElastic && root.shifts;
    chain.held.assign(root.held.begin(), root.held.begin() + kT);
    chain.welded.assign(root.welded.begin(), root.welded.begin() + kR);
    for (std::size_t i = 0; i < build_.chain.size(); ++i) chain.segments.push_back(segment(i));
    for (const chain::Closure<L>& closure : build_.chain.closures) {
      if (!closure.one_sided) chain.directions.push_back(direction(closure));
    }
    return chain;
  }

 private:
  void evaluate_joints(const ChainModel& model, const chain::View<L>& view) {
    const auto parts =
        chain::part_forms(model.scene, !kOneForce<L, kElastic>, chain::gauge_plane<L>(view));
    std::vector<MaterialValues<double>> materials;
    materials.reserve(parts.size());
    for (const auto& part : parts) materials.push_back(material_values(*part.material));
    const auto laws = make_joints<L, kElastic>(
        model.scene, parts, materials,
        chain::joint_numbers(model.part_of_segment, build_.joints, parts, materials, view), view,
        model.options.fibres);
    laws->evaluate(rest_.angles, rest_.q.shift, rest_.joints);
    chain::gather_forces(
        build_.chain, rest_.q, rest_.placement, rest_.stage, rest_.joints,
        [](std::size_t /*history*/) { return 0.0; }, rest_.outer_forces);
  }

  SegmentAtRest segment(std::size_t i) const {
    const auto& position = rest_.placement.position;
    const auto& near = rest_.placement.near[i];
    const auto& frame = rest_.placement.frame[i];
    const chain::Inertia<L>& inertia = build_.chain.inertias[i];
    const chain::Impedance<L>& impedance = rest_.outer_forces.impedance[i];
    SegmentAtRest segment;
    if (i > 0) segment.arm = dense(L::spun_by(position[i] - position[i - 1]));
    segment.joint_axes = dense(L::axes(near));
    if constexpr (kElastic) segment.joint_shifts = dense(L::turn_matrix(near));
    segment.tangent = dense(rest_.joints.tangent[i]);
    segment.mass = inertia.mass;
    segment.center = dense(L::spun_by(L::turn(frame, inertia.center)));
    segment.axes = dense(L::axes(frame));
    segment.turning = dense(inertia.turning);
    segment.ground.resize(kT + kR, kT + kR);
    put(impedance.tt, 0, 0, segment.ground);
    put(impedance.tr, 0, kT, segment.ground);
    put(impedance.rt, kT, 0, segment.ground);
    put(impedance.rr, kT, kT, segment.ground);
    return segment;
  }

  HeldDirection direction(const chain::Closure<L>& closure) const {
    const chain::Wrench<L> unit = chain::unit_wrench(closure, rest_.placement);
    Eigen::VectorXd wrench(kT + kR);
    for (Index k = 0; k < kT; ++k) wrench(k) = unit.force[static_cast<std::size_t>(k)];
    for (Index k = 0; k < kR; ++k) wrench(kT + k) = unit.moment[static_cast<std::size_t>(k)];
    return {closure.segment, wrench, closure.turning};
  }

  chain::Build<L> build_;
  solve::NewtonWork<L, kElastic> rest_;
  double length_;
};

ChainAtRest at_rest(const ChainModel& model) {
  using chain::Planar;
  using chain::Spatial;
  using chain::Twist;
  const bool elastic = model.options.translation == JointTranslation::Elastic;
  switch (model.level) {
    case Level::Twist: return Rest<Twist<double>, false>(model, {}).in_numbers();
    case Level::Planar: {
      const chain::View<Planar<double>> view{model.across};
      if (elastic) return Rest<Planar<double>, true>(model, view).in_numbers();
      return Rest<Planar<double>, false>(model, view).in_numbers();
    }
    default:
      if (elastic) return Rest<Spatial<double>, true>(model, {}).in_numbers();
      return Rest<Spatial<double>, false>(model, {}).in_numbers();
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

int chain_freedoms(const Model& model) { return freedoms(at_rest(chain_of(model))); }

std::vector<double> natural_frequencies(const Model& model, int count) {
  const SmallMotion motion = small_motion(at_rest(chain_of(model)));
  const Index n = motion.mass.rows();
  if (count < 1 || count > n) {
    throw InputError({}, "count", std::to_string(count),
                     "must be 1 … " + std::to_string(n) + ", the ways in which the chain can move");
  }
  return frequencies(motion, count);
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
