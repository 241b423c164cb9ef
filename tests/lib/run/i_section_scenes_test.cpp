#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/model/profile_table.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/chain_scene.hpp"

// Beams of I-sections, against beam theory with published numbers, and sections that are given by
// their numbers.

namespace plastica {
namespace {

using testing::add_probe;
using testing::cantilever_scene;
using testing::last_of;

/// Published: I_y = 1943 cm^4, I_z = 142.4 cm^4, W_pl,y = 220.6 cm^3, W_pl,z = 44.61 cm^3.
Scene ipe_200(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.section = named_profile("IPE 200");
  scene.beam.length = 2.0;
  return scene;
}

TEST(ISectionBeam, BendsAsItsPublishedSecondMomentsSay) {
  for (const bool about_x : {true, false}) {
    Scene scene = ipe_200(64);
    const double force = 10.0;
    scene.loads.push_back({.force = {about_x ? 0.0 : force, about_x ? force : 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(),
              about_x ? Component::Y : Component::X);
    const Response response = testing::completed(scene, {.steps = 1});
    const double inertia = about_x ? 1943e-8 : 142.4e-8;
    const double exact = force * 8.0 / (3.0 * 200e9 * inertia);
    // 1/(8 N^2) of the lumped chain, and the digits of the table.
    EXPECT_NEAR(last_of(response, 0) / exact, 1.0, 4e-4) << about_x;
  }
}

/// The tip force over W_pl sigma_y/L at which a cantilever carries no more. Stiffened a
/// thousandfold, so that its shape stays.
double limit_of(Scene scene, bool about_x, double modulus) {
  scene.material.youngs_modulus *= 1e3;
  const double force = modulus * scene.material.yield_stress / scene.beam.length;
  const double twice = 2.0 * force;
  scene.loads.push_back({.force = {about_x ? 0.0 : twice, about_x ? twice : 0.0, 0.0}});
  const Response response = simulate(scene, {.steps = 20});
  EXPECT_EQ(response.status, Status::LimitLoad);
  if (!response.limit) return 0.0;
  EXPECT_LT(response.limit->above - response.limit->below, 1e-3);
  return response.limit->below + response.limit->above;
}

TEST(ISectionBeam, CarriesItsPublishedPlasticMoments) {
  Scene scene = ipe_200(8);
  scene.yield_model = YieldModel::Interaction;
  scene.yield_cap = YieldCap::FullyPlastic;
  EXPECT_NEAR(limit_of(scene, true, 220.6e-6), 1.0, 1e-3);
  EXPECT_NEAR(limit_of(scene, false, 44.61e-6), 1.0, 1e-3);
  scene.yield_model = YieldModel::Fibre;
  scene.yield_cap = YieldCap::FirstYield;
  EXPECT_NEAR(limit_of(scene, true, 220.6e-6), 1.0, 3e-3);
  EXPECT_NEAR(limit_of(scene, false, 44.61e-6), 1.0, 3e-3);
}

/// The same section, of which only numbers are known.
Section by_numbers(const Section& section) {
  const SectionProperties p = section_properties(section, 0.3);
  Section s;
  s.shape = SectionShape::Numbers;
  s.numbers = {.area = p.area,
               .second_moment_x = p.second_moment_x,
               .second_moment_y = p.second_moment_y,
               .section_modulus_x = p.section_modulus_x,
               .section_modulus_y = p.section_modulus_y,
               .plastic_section_modulus_x = p.plastic_section_modulus_x,
               .plastic_section_modulus_y = p.plastic_section_modulus_y,
               .torsion_constant = p.torsion_constant,
               .torsion_modulus = p.torsion_modulus,
               .plastic_torsion_modulus = p.plastic_torsion_modulus};
  return s;
}

TEST(SectionByItsNumbers, BendsTwistsAndYieldsAsTheSection) {
  Scene scene = ipe_200(8);
  scene.yield_model = YieldModel::Interaction;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 10e9;
  scene.loads.push_back({.force = {450.0, 27000.0, 0.0}, .moment = {0.0, 0.0, 400.0}});
  for (const Component axis : {Component::X, Component::Y, Component::Z}) {
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), axis);
  }
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
  const SolverOptions options{.level = Level::Spatial, .steps = 10};
  const Response section = simulate(scene, options);
  scene.section = by_numbers(scene.section);
  const Response numbers = simulate(scene, options);
  ASSERT_EQ(section.status, numbers.status);
  EXPECT_GT(section.permanent_strain, 1e-4);
  for (std::size_t probe = 0; probe < 4; ++probe) {
    EXPECT_NEAR(last_of(numbers, probe), last_of(section, probe),
                1e-9 * std::fabs(last_of(section, probe)));
  }
}

std::string refusal_of(const Scene& scene, const SolverOptions& options) {
  try {
    check_scene(scene, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(SectionByItsNumbers, IsRefusedWhereItIsNotEnough) {
  Scene scene = ipe_200(8);
  scene.section = by_numbers(scene.section);
  scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
  EXPECT_EQ(refusal_of(scene, {}), "");
  EXPECT_NE(refusal_of(scene, {.translation = JointTranslation::Elastic}).find("shear_coefficient"),
            std::string::npos);
  scene.section.shear_coefficient = 0.4;
  EXPECT_EQ(refusal_of(scene, {.translation = JointTranslation::Elastic}), "");
  scene.yield_model = YieldModel::Fibre;
  EXPECT_NE(refusal_of(scene, {}).find("needs the places of the fibres"), std::string::npos);
}

bool warns(const Scene& scene, const std::string& text) {
  for (const std::string& warning : scene_warnings(prepare(scene, {}))) {
    if (warning.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(ISectionBeam, WarnsOfWarpingWhereItTwistsAndOfThinFlanges) {
  Scene scene = ipe_200(8);
  scene.yield_model = YieldModel::Interaction;
  scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
  EXPECT_FALSE(warns(scene, "Saint-Venant's alone"));
  scene.loads.back().moment[2] = 1.0;
  EXPECT_TRUE(warns(scene, "its section is open: torsion is Saint-Venant's alone"));
  // S355: e = 0.81, flanges of class 1 up to c/t = 7.3. HEA 260: 8.2, class 3 beyond 8.1.
  EXPECT_FALSE(warns(scene, "EN 1993-1-1"));
  scene.material.yield_stress = 355e6;
  scene.material.youngs_modulus = 210e9;
  scene.section = named_profile("HEA 260");
  scene.yield_cap = YieldCap::FullyPlastic;
  EXPECT_TRUE(warns(scene, "class 3 of EN 1993-1-1"));
}

/// Numbers do not say whether a section is open.
TEST(SectionByItsNumbers, IsNotCalledOpenWhereItTwists) {
  Scene scene = ipe_200(8);
  scene.section = by_numbers(scene.section);
  scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
  EXPECT_FALSE(warns(scene, "Saint-Venant's alone"));
  scene.loads.back().moment[2] = 1.0;
  EXPECT_TRUE(warns(scene, "of its section only the numbers are known: torsion is Saint-Venant's"));
  EXPECT_FALSE(warns(scene, "its section is open"));
  // A stretch of the beam whose section is known to be open is.
  scene.regions = {{Place::start(), {0.5, {}}, named_profile("IPE 200"), scene.material}};
  EXPECT_TRUE(warns(scene, "its section is open"));
}

}  // namespace
}  // namespace plastica
