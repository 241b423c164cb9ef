#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/chain_scene.hpp"

// One yield surface that grows as the material hardens. What increments do not change, and what
// bending alone is, whatever else is nearly nothing.

namespace plastica {
namespace {

constexpr double kSlope = 5e9;
constexpr double kShortBar = 0.01;  // short and stiff: rotations stay small

/// A short bar that hardens isotropically, with a force and a moment at its free end.
Scene bar(const Section& section, YieldModel model, const std::array<double, 3>& moment,
          double pull = 0.0) {
  Scene scene = testing::cantilever_scene(1);
  scene.beam.length = kShortBar;
  scene.section = section;
  scene.material = Material{};
  scene.material.yield_stress = 355e6;
  scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = kSlope};
  scene.yield_model = model;
  scene.loads.push_back({.force = {0.0, 0.0, pull}, .moment = moment});
  scene.probes = {{.name = "x", .quantity = ProbeQuantity::Angle, .component = Component::X},
                  {.name = "z", .quantity = ProbeQuantity::Angle, .component = Component::Z}};
  return scene;
}

/// Angle of the bar's joint under the whole load.
double angle(const Scene& scene, int steps, std::size_t probe = 0) {
  const Response response = simulate(scene, {.level = Level::Spatial, .steps = steps});
  EXPECT_EQ(response.status, Status::Completed) << name_of(response.status);
  return response.probes[probe].back();
}

// The axial force is given, so that flow along the beam turns the trial force far out of bending.
// A pull of a newton must not change how the section hardens.
TEST(HardeningSurface, BendsAsAFibreDoesWhateverTheStepsAndHoweverItIsPulled) {
  const Section sections[] = {{.width = 0.03, .height = 0.02},
                              {.shape = SectionShape::Circle, .radius = 0.012}};
  for (const Section& section : sections) {
    const SectionProperties p = testing::properties_of(bar(section, YieldModel::PerAxis, {}));
    const std::array<double, 3> moment{1.24 * 355e6 * p.section_modulus_x, 0.0, 0.0};
    const double alone = angle(bar(section, YieldModel::PerAxis, moment), 20);
    for (const double pull : {0.0, 1.0, -1.0}) {
      for (const int steps : {5, 20, 320}) {
        const Scene scene = bar(section, YieldModel::Interaction, moment, pull);
        // Of a hundred thousandth of the axial cap: what it takes from bending at yield.
        const double share = pull == 0.0 ? 1e-9 : 2e-5;
        EXPECT_NEAR(angle(scene, steps), alone, share * alone) << pull << " N, " << steps;
      }
    }
  }
}

// Forces that grow together: lambda = A_p p with A_p = A_x m^2 + A_z t^2 in their direction, A of
// one component that of its uniaxial law, and the flow along the surface's normal.
TEST(HardeningSurface, FlowsByTheWorkOfItsForceWhereBendingAndTorsionGrowTogether) {
  const Section round{.shape = SectionShape::Circle, .radius = 0.012};
  const Scene empty = bar(round, YieldModel::PerAxis, {});
  const SectionProperties section = testing::properties_of(empty);
  const double cap_x = 355e6 * section.section_modulus_x;
  const double cap_z = resolved_shear_yield_stress(empty.material) * section.torsion_modulus;
  constexpr double kSize = 1.25, kBending = 0.6, kTorsion = 0.8;  // of the surface's radius
  const auto flow_of = [&](YieldModel model, double bending, double torsion, std::size_t probe,
                           int steps) {
    const auto at = [&](double size, int count) {
      return angle(bar(round, model, {size * bending * cap_x, 0.0, size * torsion * cap_z}), count,
                   probe);
    };
    return at(kSize, steps) - kSize / 0.5 * at(0.5, 1);  // less the elastic angle
  };
  const double p = (kSize - 1.0) * 355e6 * (1.0 / kSlope - 1.0 / empty.material.youngs_modulus);
  const double area_x = cap_x * flow_of(YieldModel::PerAxis, 1.0, 0.0, 0, 20) / p;
  const double area_z = cap_z * flow_of(YieldModel::PerAxis, 0.0, 1.0, 1, 20) / p;
  const double area = area_x * kBending * kBending + area_z * kTorsion * kTorsion;
  for (const int steps : {4, 20, 400}) {
    EXPECT_NEAR(flow_of(YieldModel::Interaction, kBending, kTorsion, 0, steps),
                area * p * kBending / cap_x, 1e-5 * area * p * kBending / cap_x)
        << steps;
    EXPECT_NEAR(flow_of(YieldModel::Interaction, kBending, kTorsion, 1, steps),
                area * p * kTorsion / cap_z, 1e-5 * area * p * kTorsion / cap_z)
        << steps;
  }
}

// A long cantilever, whose axial force is the load's share along the turned beam.
TEST(HardeningSurface, OfABeamThatTurnsFarDoesNotDependOnTheSteps) {
  const auto tip = [](YieldModel model, int steps) {
    Scene scene = testing::cantilever_scene(8);
    scene.beam.length = 1.0;
    scene.section = {.width = 0.03, .height = 0.02};
    scene.material = Material{};
    scene.material.yield_stress = 355e6;
    scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = kSlope};
    scene.yield_model = model;
    scene.loads.push_back({.force = {0.0, 900.0, 0.0}});
    scene.probes = {
        {.name = "tip", .quantity = ProbeQuantity::Displacement, .component = Component::Y}};
    const Response response = simulate(scene, {.steps = steps});
    EXPECT_EQ(response.status, Status::Completed) << name_of(response.status);
    return response.probes[0].back();
  };
  const double bent = tip(YieldModel::PerAxis, 20);
  for (const int steps : {10, 20, 80, 320}) {
    // Its axial force, up to 0.1 % of its cap, leaves a little less to bending.
    EXPECT_NEAR(tip(YieldModel::Interaction, steps), bent, 3e-3 * bent) << steps;
    EXPECT_NEAR(tip(YieldModel::Interaction, steps), tip(YieldModel::Interaction, 40), 2e-4 * bent)
        << steps;
  }
}

// A pull far below yield: no work is plastic, and what is stored is N^2 L/2 E A, however stiff a
// spring holds the rotation on the way.
TEST(SpringWithinABeam, TakesNoPartInTheWorkOfAPull) {
  for (const double stiffness : {1e3, 1e6, 1e8}) {
    Scene scene = testing::cantilever_scene(20);
    scene.section = {.width = 0.03, .height = 0.025};
    scene.material = Material{};
    scene.material.yield_stress = 355e6;
    scene.supports.push_back({.at = {0.2, {}},
                              .kind = SupportKind::Elastic,
                              .rotational_stiffness = {stiffness, 0.0, 0.0}});
    scene.loads.push_back({.force = {0.0, 0.0, 1e3}});
    const double stored =
        1e6 * scene.beam.length / (2.0 * scene.material.youngs_modulus * 0.03 * 0.025);
    for (const Level level : {Level::Planar, Level::Spatial}) {
      SolverOptions options{.level = level, .steps = 4};
      options.translation = JointTranslation::Elastic;
      for (const YieldModel model :
           {YieldModel::PerAxis, YieldModel::Interaction, YieldModel::Fibre}) {
        scene.yield_model = model;
        const Response response = simulate(scene, options);
        ASSERT_EQ(response.status, Status::Completed) << name_of(response.status);
        const Energies& last = response.chain.energy.back();
        EXPECT_NEAR(last.plastic, 0.0, 1e-12 * stored)
            << stiffness << ", model " << static_cast<int>(model);
        EXPECT_NEAR(last.elastic, stored, 1e-6 * stored)
            << stiffness << ", model " << static_cast<int>(model);
        EXPECT_NEAR(last.external, stored, 1e-6 * stored)
            << stiffness << ", model " << static_cast<int>(model);
      }
    }
  }
}

}  // namespace
}  // namespace plastica
