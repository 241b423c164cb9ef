#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "plastica/law/fibre_grid.hpp"
#include "plastica/law/per_axis.hpp"
#include "plastica/law/rated.hpp"
#include "plastica/run/chain_laws.hpp"
#include "plastica/run/surface_law.hpp"

/// Defines `make_joints`; for the files that instantiate it.
namespace plastica {
namespace detail {

template <class L, bool kElastic>
struct JointsMaker {
  using S = typename L::Scalar;
  using Made = std::unique_ptr<chain::SectionJointsBase<L, kElastic>>;

  const Scene& scene;
  const std::vector<chain::BeamRegion>& regions;
  std::vector<MaterialValues<S>> materials;
  std::vector<chain::SectionJoint<L>> joints;
  const chain::View<L>& view;
  int fibres;

  /// @param kept  see SectionJoints
  template <class Law, class... Kept>
  Made make(std::vector<Law> laws, Kept&&... kept) {
    return std::make_unique<chain::SectionJoints<L, kElastic, Law>>(
        view.section_axes(), std::move(laws), std::move(joints), std::forward<Kept>(kept)...);
  }

  Made elastic() {
    std::vector<law::ElasticSection<S>> laws;
    for (std::size_t p = 0; p < regions.size(); ++p) {
      laws.push_back(law::elastic_section(regions[p].form, materials[p]));
    }
    return make(std::move(laws));
  }

  template <class Uniaxial>
  Made per_axis() {
    std::vector<law::PerAxisSection<S, Uniaxial>> laws;
    for (std::size_t p = 0; p < regions.size(); ++p) {
      laws.push_back(law::per_axis_section<Uniaxial>(regions[p].form, materials[p]));
    }
    return make(std::move(laws));
  }

  template <class Uniaxial>
  Made interaction() {
    std::optional<std::size_t> bending;
    if constexpr (L::kRotations == 1) bending = view.section_axes().rotation(0);
    std::vector<SurfaceLaw<S>> laws;
    for (std::size_t p = 0; p < regions.size(); ++p) {
      laws.push_back(
          {make_yield_surface<Uniaxial>(regions[p].gauge, regions[p].form, materials[p], bending)});
    }
    return make(std::move(laws));
  }

  /// What a fibre section sees at the level.
  law::FibrePlane fibre_plane() const {
    if constexpr (L::kRotations == 3) {
      return law::FibrePlane::Both;
    } else if constexpr (std::is_same_v<L, chain::Twist<S>>) {
      return law::FibrePlane::Torsion;
    } else {
      const bool about_y = view.section_axes().rotation(0) == law::kBendingY;
      return about_y ? law::FibrePlane::AboutY : law::FibrePlane::AboutX;
    }
  }

  template <class Uniaxial>
  Made fibre() {
    auto layouts = std::make_shared<std::vector<law::FibreLayout>>();
    for (const chain::BeamRegion& region : regions) {
      layouts->push_back(
          law::fibre_layout(region.section, region.properties, fibre_plane(), fibres));
    }
    const auto all = [&](const auto& make_law) {
      std::vector<std::remove_cvref_t<decltype(make_law(std::size_t{}))>> laws;
      for (std::size_t p = 0; p < regions.size(); ++p) laws.push_back(make_law(p));
      return make(std::move(laws), layouts);
    };
    if constexpr (L::kRotations == 3) {
      return all([&](std::size_t p) {
        return law::fibre_grid<Uniaxial>((*layouts)[p], regions[p].form, materials[p]);
      });
    } else {
      return all([&](std::size_t p) {
        return law::fibre_section<Uniaxial>((*layouts)[p], regions[p].form, materials[p]);
      });
    }
  }

  /// Each point has a rate of its own: laws with a rate, and material numbers as they take them.
  template <class Use>
  void with_rated_law(const Use& use) {
    HardeningLaw law = HardeningLaw::Ideal;
    for (MaterialValues<S>& values : materials) {
      law = law::as_table(scene.material.hardening.law, values);
    }
    [&]<class... Law>(std::type_identity<std::tuple<Law...>>) {
      ((law == Law::kLaw ? use(std::type_identity<Law>{}) : void()), ...);
    }(std::type_identity<law::RatedLaws<S>>{});
  }

  /// Float has ideal plasticity alone (`check_precision`): each other law would be compiled again
  /// with each level and yield model.
  template <class Use>
  void with_law(Use&& use) {
    if constexpr (std::is_same_v<S, float>) {
      use(std::type_identity<law::IdealPlastic<S>>{});
    } else if (has_own_rates(scene.material)) {
      with_rated_law(use);
    } else {
      law::with_law_type<S>(scene.material.hardening.law, use);
    }
  }

  Made make() {
    if (scene.yield_model == YieldModel::Elastic) return elastic();
    Made made;
    with_law([&](auto tag) {
      using Uniaxial = typename decltype(tag)::type;
      if (scene.yield_model == YieldModel::Fibre) {
        made = fibre<Uniaxial>();
        return;
      }
      if constexpr (!kOneForce<L, kElastic>) {
        if (scene.yield_model != YieldModel::PerAxis) {
          made = interaction<Uniaxial>();
          return;
        }
      }
      made = per_axis<Uniaxial>();
    });
    return made;
  }
};

}  // namespace detail

template <class L, bool kElastic>
std::unique_ptr<chain::SectionJointsBase<L, kElastic>> make_joints(
    const Scene& scene, const std::vector<chain::BeamRegion>& regions,
    const std::vector<MaterialValues<typename L::Scalar>>& materials,
    std::vector<chain::SectionJoint<L>> joints, const chain::View<L>& view, int fibres) {
  return detail::JointsMaker<L, kElastic>{scene, regions, materials, std::move(joints),
                                          view,  fibres}
      .make();
}

/// Instantiates it for a level.
#define PLASTICA_MAKE_JOINTS(L, kElastic)                                                          \
  template std::unique_ptr<chain::SectionJointsBase<L, kElastic>> make_joints<L, kElastic>(        \
      const Scene&, const std::vector<chain::BeamRegion>&,                                         \
      const std::vector<MaterialValues<typename L::Scalar>>&, std::vector<chain::SectionJoint<L>>, \
      const chain::View<L>&, int)

}  // namespace plastica
