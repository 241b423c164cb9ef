#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "plastica/chain/build.hpp"
#include "plastica/chain/joint_numbers.hpp"
#include "plastica/chain/section_joints.hpp"
#include "plastica/law/per_axis.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/solve/newton.hpp"

namespace plastica::testing {

/// A scene as a chain of a level and scalar, with the joints of a section law, ready to be solved.
///
/// @tparam Law  a section law; ElasticSection<S> and PerAxisSection<S, …> need no maker
template <class L, bool kElastic, class Law>
struct SolvedChain {
  using S = typename L::Scalar;

  chain::Layout layout;
  chain::Build<L> build;
  std::unique_ptr<chain::SectionJoints<L, kElastic, Law>> joints;
  solve::NewtonWork<L, kElastic> work;

  /// @param material  numbers of the scene's material; lanes and derivatives go in here
  SolvedChain(const Scene& scene, const MaterialValues<S>& material,
              const chain::View<L>& view = {})
      : SolvedChain(scene, material, view,
                    [&](const law::SectionForm& form) { return make_law(form, material); }) {}

  /// @param law_of  makes the law of a section's form
  /// @param spring  beside each joint, as a fraction of its own stiffness [1]
  template <class LawOf>
  SolvedChain(const Scene& scene, const MaterialValues<S>& material, const chain::View<L>& view,
              const LawOf& law_of, double spring = 0.0)
      : layout(chain::make_layout(scene, segment_ends(scene))) {
    build = chain::build_chain<L>(scene, layout, view, {.sees_axial = law::kSeesAxial<Law>});
    const std::vector<MaterialValues<S>> materials{material};
    auto numbers = chain::joint_numbers(build.joints, layout.regions, materials, view);
    const S stiffness = numbers[0].stiffness[0];
    const S length = constant<S>(scene.beam.length);
    build.chain.constraint_stiffness = constant<S>(100) * stiffness / (length * length * length);
    build.chain.constraint_rotational_stiffness = constant<S>(100) * stiffness / length;
    for (auto& joint : numbers) {
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        const std::size_t axis = view.section_axes().rotation(k);
        joint.spring[k] = constant<S>(spring) * joint.stiffness[axis] / joint.length[axis];
      }
    }
    joints = std::make_unique<chain::SectionJoints<L, kElastic, Law>>(
        view.section_axes(), std::vector<Law>{law_of(layout.regions[0].form)}, std::move(numbers));
    work.resize(build.chain);
  }

  /// Goes to a time in even steps. @return the last outcome
  solve::NewtonOutcome<S> go_to(double time, int steps, const solve::NewtonOptions& options = {}) {
    solve::NewtonOutcome<S> outcome;
    const double from = work.time;
    for (int k = 1; k <= steps; ++k) {
      work.time = from + (time - from) * k / steps;
      outcome = solve::equilibrate(build.chain, *joints, options, work);
      joints->commit();
    }
    return outcome;
  }

  typename L::Point tip() const {
    return work.placement.point(layout.size() - 1, build.chain.segments.back().arm);
  }

 private:
  static Law make_law(const law::SectionForm& form, const MaterialValues<S>& material) {
    if constexpr (std::is_same_v<Law, law::ElasticSection<S>>) {
      return law::elastic_section(form, material);
    } else {
      using Uniaxial = std::remove_cvref_t<decltype(Law{}.axis[0])>;
      return law::per_axis_section<Uniaxial>(form, material);
    }
  }
};

/// A steel cantilever of 1 m, 20 mm x 20 mm, with a force at its end, ramped.
inline Scene cantilever(int segments, std::array<double, 3> force) {
  Scene scene;
  scene.material.youngs_modulus = 200e9;
  scene.material.yield_stress = 250e6;
  scene.section.width = 0.02;
  scene.section.height = 0.02;
  scene.beam.length = 1.0;
  scene.beam.segments = segments;
  scene.supports.push_back({});
  Load load;
  load.force = force;
  scene.loads.push_back(load);
  scene.probes = {{"tip", ProbeQuantity::Displacement}};
  return scene;
}

}  // namespace plastica::testing
