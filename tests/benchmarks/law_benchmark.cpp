#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/law/fibre_grid.hpp"
#include "plastica/law/interaction.hpp"
#include "plastica/law/per_axis.hpp"

/// Nanoseconds of one respond() of each section law.
namespace plastica::law {
namespace {

/// What the strains of a path are.
enum Path { kElastic, kBending, kBiaxial, kTwisting, kAll };

Material steel(HardeningLaw law) {
  Material material;
  material.hardening.law = law;
  material.hardening.tangent_modulus = 2e9;
  material.hardening.kinematic_fraction = 0.5;
  material.hardening.saturation_stress = 80e6;
  material.hardening.saturation_rate = 12.0;
  material.hardening.backstress_modulus = {20e9, 4e9, 0.5e9};
  material.hardening.backstress_rate = {300.0, 40.0, 0.0};
  return material;
}

Section section_of(SectionShape shape) {
  Section section;
  section.shape = shape;
  section.width = 0.06;
  return section;
}

/// A to-and-fro path up to three yield strains of each component that takes part.
std::vector<SectionStrain<double>> path_of(Path path, const SectionForm& form,
                                           const Material& material) {
  const std::array<std::array<double, 4>, 5> parts{{{0.1, 0.1, 0.1, 0.1},
                                                    {1.0, 0.0, 0.0, 0.0},
                                                    {1.0, 0.7, 0.0, 0.0},
                                                    {1.0, 0.0, 0.6, 0.0},
                                                    {1.0, 0.7, -0.6, 0.3}}};
  std::vector<SectionStrain<double>> strains;
  unsigned random = 12345;
  for (int i = 0; i < 256; ++i) {
    SectionStrain<double> strain;
    for (std::size_t k = 0; k < 4; ++k) {
      random = random * 1664525U + 1013904223U;
      const auto m = uniaxial_material(form.axis[k], material_values(material));
      const double shake = static_cast<double>(random >> 8U) / 8388608.0 - 1.0;
      strain[k] = 3.0 * shake * parts[path][k] * m.yield / m.stiffness / form.lever[k];
    }
    strains.push_back(strain);
  }
  return strains;
}

template <class Respond>
void run(benchmark::State& state, const std::vector<SectionStrain<double>>& path,
         const Respond& respond_to) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(respond_to(path[i]));
    i = (i + 1) % path.size();
  }
}

void elastic(benchmark::State& state) {
  const Material material = steel(HardeningLaw::Ideal);
  const Section section = section_of(SectionShape::Rectangle);
  const SectionForm form = section_form(section, section_properties(section, 0.3), material,
                                        YieldCap::FirstYield, Formulas::Mechanics);
  const auto law = elastic_section(form, material_values(material));
  ElasticSection<double>::State joint;
  run(state, path_of(kAll, form, material),
      [&](const auto& strain) { return respond(law, joint, joint, strain); });
}

void per_axis(benchmark::State& state, HardeningLaw hardening, Path path) {
  const Material material = steel(hardening);
  const Section section = section_of(SectionShape::Rectangle);
  const SectionForm form = section_form(section, section_properties(section, 0.3), material,
                                        YieldCap::FirstYield, Formulas::Mechanics);
  with_law_type<double>(hardening, [&]<class Law>(std::type_identity<Law>) {
    const auto law = per_axis_section<Law>(form, material_values(material));
    typename PerAxisSection<double, Law>::State joint;
    run(state, path_of(path, form, material),
        [&](const auto& strain) { return respond(law, joint, joint, strain); });
  });
}

void interaction(benchmark::State& state, SectionShape shape, YieldCap cap, HardeningLaw hardening,
                 Path path) {
  const Material material = steel(hardening);
  const Section section = section_of(shape);
  const SectionForm form =
      section_form(section, section_properties(section, 0.3), material, cap, Formulas::Mechanics);
  const GaugeForm surface = gauge_form(section, YieldModel::Interaction, cap, Formulas::Mechanics);
  with_gauge<double>(surface, [&](const auto& gauge) {
    with_law_type<double>(hardening, [&]<class Law>(std::type_identity<Law>) {
      const auto law = interaction_section<Law>(form, gauge, material_values(material));
      typename std::remove_cvref_t<decltype(law)>::State joint;
      run(state, path_of(path, form, material),
          [&](const auto& strain) { return respond(law, joint, joint, strain); });
    });
  });
}

void fibre(benchmark::State& state, FibrePlane plane, HardeningLaw hardening, Path path,
           int fibres = 40) {
  const Material material = steel(hardening);
  const Section section = section_of(SectionShape::Rectangle);
  const SectionForm form = section_form(section, section_properties(section, 0.3), material,
                                        YieldCap::FirstYield, Formulas::Mechanics);
  const FibreLayout layout = fibre_layout(section, section_properties(section, 0.3), plane, fibres);
  const auto bend = [&](const auto& law) {
    std::vector<typename std::remove_cvref_t<decltype(law)>::State> before(layout.states());
    auto after = before;
    run(state, path_of(path, form, material), [&](const auto& strain) {
      const auto now = respond(law, before.data(), after.data(), strain);
      std::swap(before, after);
      return now;
    });
  };
  with_law_type<double>(hardening, [&]<class Law>(std::type_identity<Law>) {
    if (plane == FibrePlane::Both) {
      bend(fibre_grid<Law>(layout, form, material_values(material)));
    } else {
      bend(fibre_section<Law>(layout, form, material_values(material)));
    }
  });
}

constexpr auto kIdeal = HardeningLaw::Ideal;
constexpr auto kLinear = HardeningLaw::Linear;
constexpr auto kVoce = HardeningLaw::VoceChaboche;
constexpr auto kBlock = SectionShape::Rectangle;
constexpr auto kRound = SectionShape::Circle;
constexpr auto kFirst = YieldCap::FirstYield;
constexpr auto kPlastic = YieldCap::FullyPlastic;

BENCHMARK(elastic);
BENCHMARK_CAPTURE(per_axis, ideal_elastic, kIdeal, kElastic);
BENCHMARK_CAPTURE(per_axis, ideal, kIdeal, kAll);
BENCHMARK_CAPTURE(per_axis, linear, kLinear, kAll);
BENCHMARK_CAPTURE(per_axis, voce, kVoce, kAll);
BENCHMARK_CAPTURE(interaction, rectangle_elastic, kBlock, kFirst, kIdeal, kElastic);
BENCHMARK_CAPTURE(interaction, rectangle_bending, kBlock, kFirst, kIdeal, kBending);
BENCHMARK_CAPTURE(interaction, rectangle_biaxial, kBlock, kFirst, kIdeal, kBiaxial);
BENCHMARK_CAPTURE(interaction, rectangle_twisting, kBlock, kFirst, kIdeal, kTwisting);
BENCHMARK_CAPTURE(interaction, rectangle_all, kBlock, kFirst, kIdeal, kAll);
BENCHMARK_CAPTURE(interaction, rectangle_bending_linear, kBlock, kFirst, kLinear, kBending);
BENCHMARK_CAPTURE(interaction, rectangle_biaxial_linear, kBlock, kFirst, kLinear, kBiaxial);
BENCHMARK_CAPTURE(interaction, rectangle_bending_voce, kBlock, kFirst, kVoce, kBending);
BENCHMARK_CAPTURE(interaction, rectangle_biaxial_voce, kBlock, kFirst, kVoce, kBiaxial);
BENCHMARK_CAPTURE(interaction, circle_all, kRound, kFirst, kIdeal, kAll);
BENCHMARK_CAPTURE(interaction, circle_all_linear, kRound, kFirst, kLinear, kAll);
BENCHMARK_CAPTURE(interaction, plastic_rectangle_biaxial, kBlock, kPlastic, kIdeal, kBiaxial);
BENCHMARK_CAPTURE(interaction, plastic_rectangle_twisting, kBlock, kPlastic, kIdeal, kTwisting);
BENCHMARK_CAPTURE(interaction, plastic_rectangle_all, kBlock, kPlastic, kIdeal, kAll);
BENCHMARK_CAPTURE(fibre, layers_ideal_20, FibrePlane::AboutX, kIdeal, kBending, 20);
BENCHMARK_CAPTURE(fibre, layers_ideal, FibrePlane::AboutX, kIdeal, kBending);
BENCHMARK_CAPTURE(fibre, layers_linear, FibrePlane::AboutX, kLinear, kBending);
BENCHMARK_CAPTURE(fibre, layers_voce, FibrePlane::AboutX, kVoce, kBending);
BENCHMARK_CAPTURE(fibre, grid_ideal, FibrePlane::Both, kIdeal, kAll);

}  // namespace
}  // namespace plastica::law
