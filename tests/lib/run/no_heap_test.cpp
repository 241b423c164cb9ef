#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "plastica/law/fibre_grid.hpp"
#include "plastica/law/interaction.hpp"
#include "plastica/law/per_axis.hpp"
#include "tests/lib/law/gauge_of.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/scene.hpp"

/// A program of its own: it counts what the global operator new hands out.
namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// Not inlined: the compiler would see malloc behind new, and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) { return counted(size); }
[[gnu::noinline]] void* operator new[](std::size_t size) { return counted(size); }
/// Of std::stable_sort's buffer.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace plastica {
namespace {

using testing::coupon_scene;

constexpr HardeningLaw kLaws[] = {HardeningLaw::Ideal, HardeningLaw::Linear,
                                  HardeningLaw::VoceChaboche, HardeningLaw::Multilinear};

Hardening hardening_of(HardeningLaw law) {
  return {.law = law, .plastic_strain = {0.01}, .flow_stress = {400e6}};
}

TEST(Heap, IsCountedByThisProgram) {
  const std::size_t before = allocations;
  const std::vector<double> some(1000, 1.0);
  EXPECT_GT(allocations, before);
  EXPECT_EQ(some[999], 1.0);
}

TEST(Heap, IsNotUsedByRun) {
  const std::vector<std::string> parameters{"yield_stress", "break_strain"};
  for (const HardeningLaw law : kLaws) {
    for (const bool report : {false, true}) {
      Scene scene = coupon_scene(Deformation::Bending, {0.001, 0.02, -0.03, 0.05});
      scene.material.hardening = hardening_of(law);
      if (report) scene.formulas = Formulas::Report;
      const Model model = prepare(scene, {}, parameters);
      Response response = make_response(model);
      Workspace workspace = make_workspace(model);
      // Two that run, one of which breaks, and one that is refused.
      for (const double limit : {1.0, 0.01, -1.0}) {
        const double values[] = {300e6, limit};
        const std::size_t before = allocations;
        run(model, values, workspace, response);
        EXPECT_EQ(allocations, before);
      }
      EXPECT_EQ(response.status, Status::InvalidParameter);
    }
  }
}

TEST(Heap, IsNotUsedByRunWithTheStressAlone) {
  for (const HardeningLaw law : kLaws) {
    Scene scene = coupon_scene(Deformation::Torsion, {0.001, 0.02, -0.03, 0.05});
    scene.material.hardening = hardening_of(law);
    scene.probes = {{"stress", ProbeQuantity::Stress}};
    const Model model = prepare(scene);
    Response response = make_response(model);
    Workspace workspace = make_workspace(model);
    const std::size_t before = allocations;
    run(model, {}, workspace, response);
    EXPECT_EQ(allocations, before);
    EXPECT_EQ(response.status, Status::Completed);
  }
}

TEST(Heap, IsNotUsedByRunSensitivity) {
  const std::vector<std::string> all{"yield_stress", "youngs_modulus", "kinematic_fraction"};
  for (const HardeningLaw law : kLaws) {
    const std::size_t own = law == HardeningLaw::Linear ? all.size() : 2;  // has all of them
    for (std::size_t count = 1; count <= own; ++count) {
      Scene scene = coupon_scene(Deformation::Tension, {0.001, 0.02, -0.03, 0.05});
      scene.material.hardening = hardening_of(law);
      scene.probes = {{"stress", ProbeQuantity::Stress}};
      const Model model = prepare(scene, {}, std::span(all).first(count));
      Response response = make_response(model);
      Sensitivity sensitivity = make_sensitivity(model);
      Workspace workspace = make_workspace(model);
      const double values[] = {300e6, 200e9, 0.5};
      const std::size_t before = allocations;
      run_sensitivity(model, std::span(values).first(count), workspace, response, sensitivity);
      EXPECT_EQ(allocations, before);
      EXPECT_EQ(response.status, Status::Completed);
    }
  }
}

/// Runs a chain twice in one workspace; the second time nothing is allocated.
void expect_no_allocation_again(const Scene& scene, const SolverOptions& options) {
  const Model model = prepare(scene, options);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  run(model, {}, workspace, response);
  ASSERT_EQ(response.status, Status::Completed);
  const std::size_t before = allocations;
  run(model, {}, workspace, response);
  EXPECT_EQ(allocations, before);
}

/// A path with yielding joints, a pillar and unloading: no step, iteration or sample allocates.
TEST(Heap, IsNotUsedAlongAPath) {
  for (const Level level : {Level::Planar, Level::Spatial}) {
    Scene scene = testing::cantilever(12, {0.0, -450.0, 0.0});
    scene.loads[0].history = History::turning_points({1.0, 0.0});
    scene.supports.push_back({{0.75, {}}, SupportKind::Pillar});
    SolverOptions options;
    options.level = level;
    expect_no_allocation_again(scene, options);
  }
}

/// A struck beam that yields, falls on a pillar and bounces.
TEST(Heap, IsNotUsedAlongAMotion) {
  for (const Level level : {Level::Planar, Level::Spatial}) {
    for (int scheme = 0; scheme < 4; ++scheme) {
      Scene scene = testing::cantilever(8, {0.0, -450.0, 0.0});
      Support pillar{.at = Place::end(), .kind = SupportKind::Pillar};
      pillar.gap = 0.01;
      pillar.restitution = 0.5;
      scene.supports.push_back(pillar);
      SolverOptions options;
      options.level = level;
      options.analysis = Analysis::Dynamics;
      options.scheme = static_cast<Scheme>(scheme);
      options.duration = 0.1;
      expect_no_allocation_again(scene, options);
    }
  }
}

TEST(Heap, IsNotUsedBySectionLaws) {
  const Material material = law::testing::steel(HardeningLaw::VoceChaboche);
  const auto values = material_values(material);
  using Law = law::VoceChaboche<double>;
  for (const auto& surface : law::testing::surface_cases()) {
    const auto form = law::testing::form_of(surface.section, material, surface.cap);
    const auto yield = law::testing::yield_strain(form, material);
    const law::SectionStrain<double> strain{
        {2.0 * yield[0], -yield[1], 1.5 * yield[2], 0.3 * yield[3]}};
    const auto layout = law::fibre_layout(surface.section, section_properties(surface.section, 0.3),
                                          law::FibrePlane::Both, 8);
    const auto fibres = law::fibre_grid<Law>(layout, form, values);
    using Fibres = law::FibreGrid<double, Law>;
    const std::vector<Fibres::State> virgin(layout.states());
    std::vector<Fibres::State> states(layout.states());
    const auto per_axis = law::per_axis_section<Law>(form, values);
    law::PerAxisSection<double, Law>::State on_axis;
    law::with_gauge<double>(law::testing::gauge_form_of(surface), [&](const auto& gauge) {
      const auto interaction = law::interaction_section<Law>(form, gauge, values);
      typename std::remove_cvref_t<decltype(interaction)>::State together;
      const std::size_t before = allocations;
      double work = respond(fibres, virgin.data(), states.data(), strain).plastic_work;
      work += respond(per_axis, on_axis, on_axis, strain).plastic_work;
      work += respond(interaction, together, together, strain).plastic_work;
      EXPECT_EQ(allocations, before);
      EXPECT_GT(work, 0.0);
    });
  }
}

}  // namespace
}  // namespace plastica
