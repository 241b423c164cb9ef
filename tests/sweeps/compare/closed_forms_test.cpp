#include "sweeps/compare/closed_forms.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "plastica/run/batch.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "sweeps/run/case_result.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"

namespace plastica::sweeps {
namespace {

using plastica::testing::add_probe;
using plastica::testing::cantilever_scene;
using plastica::testing::chain_scene;
using plastica::testing::properties_of;

plastica::Setup setup_of(Scene scene) {
  plastica::Setup setup;
  setup.scene = std::move(scene);
  setup.solver.steps = 1;
  return setup;
}

Quantity of_probe(Take take = Take::End) {
  Quantity quantity;
  quantity.take = take;
  return quantity;
}

/// (value - form)/|form| of a run.
double error_of(std::string_view form, const plastica::Setup& setup, const Quantity& quantity) {
  BatchCase one{"a", setup.scene, setup.solver};
  const BatchRow row = run_case(one);
  EXPECT_TRUE(usable(row.response.status)) << name_of(row.response.status) << row.reason;
  const CaseResult result = result_of_run(row, quantity);
  const double expected = find_closed_form(form).values(setup, quantity, result.time).front();
  EXPECT_TRUE(result.value.has_value()) << result.reason;
  return (result.value.value_or(0.0) - expected) / std::abs(expected);
}

std::string refusal(std::string_view form, const plastica::Setup& setup, const Quantity& quantity) {
  return plastica::testing::message_of(
      [&] { find_closed_form(form).values(setup, quantity, std::vector<double>{0.0}); });
}

Scene loaded(Scene scene, const Load& load) {
  scene.loads.push_back(load);
  return scene;
}

TEST(ClosedForms, HoldARolledUpBeam) {
  for (const double moment : {2000.0, -2000.0}) {
    Scene scene = loaded(cantilever_scene(200), {.moment = {moment, 0.0, 0.0}});
    for (const Component component : {Component::Y, Component::Z}) {
      scene.probes.clear();
      add_probe(scene, ProbeQuantity::Displacement, Place::end(), component);
      plastica::Setup setup = setup_of(scene);
      setup.solver.steps = 4;
      EXPECT_LT(std::abs(error_of("elastica_moment", setup, of_probe())), 1e-4);
    }
  }
  Scene forced = loaded(cantilever_scene(4), {.force = {0.0, 1.0, 0.0}});
  add_probe(forced, ProbeQuantity::Displacement, Place::end(), Component::Y);
  EXPECT_EQ(refusal("elastica_moment", setup_of(forced), of_probe()),
            "is for a tip moment about x");
}

TEST(ClosedForms, HoldTheChainItself) {
  for (const EndRule rule : {EndRule::HalfJoint, EndRule::Equal, EndRule::ThreeHalves}) {
    Scene scene = loaded(cantilever_scene(7), {.force = {0.0, -1e-3, 0.0}});
    scene.end_rule = rule;
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    EXPECT_LT(std::abs(error_of("lumped_chain", setup_of(scene), of_probe())), 1e-8);
  }
}

TEST(ClosedForms, HoldTheChainUnderEveryLoadAtItsTipAndAlongIt) {
  for (const EndRule rule :
       {EndRule::HalfJoint, EndRule::Equal, EndRule::Half, EndRule::ThreeHalves}) {
    const Load spread{.at = Place::start(), .to = Place::end(), .force = {0.0, -1e-3, 0.0}};
    for (const Load& load :
         {Load{.force = {0.0, -1e-3, 0.0}}, Load{.moment = {1e-3, 0.0, 0.0}}, spread}) {
      Scene scene = loaded(cantilever_scene(7), load);
      scene.end_rule = rule;
      add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
      EXPECT_LT(std::abs(error_of("lumped_chain", setup_of(scene), of_probe())), 1e-8)
          << static_cast<int>(rule) << (load.to ? " spread" : "");
    }
  }
}

TEST(ClosedForms, HoldTheChainUnderItsWeight) {
  Scene scene = cantilever_scene(7);
  scene.gravity = {0.0, -1e-5, 0.0};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  EXPECT_LT(std::abs(error_of("lumped_chain", setup_of(scene), of_probe())), 1e-8);
  EXPECT_LT(std::abs(error_of("beam", setup_of(scene), of_probe())), 0.03) << "1 + 1/49";
}

TEST(ClosedForms, RefuseOtherChains) {
  Scene scene = loaded(cantilever_scene(2), {.force = {0.0, -1e-3, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const auto refused = [&](const Scene& other) {
    return refusal("lumped_chain", setup_of(other), of_probe());
  };
  Scene other = scene;
  other.end_rule = EndRule::Half;
  EXPECT_EQ(refused(other), "is for more segments");
  other = scene;
  other.beam.segment_fractions = {0.3, 0.7};
  EXPECT_EQ(refused(other),
            "is for rules.formulas = \"mechanics\" and segments that the rule divides");
  other = scene;
  other.loads[0].at = {0.5, {}};
  EXPECT_EQ(refused(other), "is for a load at the tip, or an even one");
  other = scene;
  other.loads[0].force[2] = 1.0;
  EXPECT_EQ(refused(other), "is for a force along y or a moment about x that keeps its direction");
  other = scene;
  other.gravity = {0.0, -1.0, 0.0};
  EXPECT_EQ(refused(other), "is for one load, or gravity alone");
}

TEST(ClosedForms, HoldElementaryBeams) {
  struct Held {
    SupportKind start;
    SupportKind end;
  };
  for (const Held held : {Held{SupportKind::Clamp, SupportKind::Roller},
                          Held{SupportKind::Pin, SupportKind::Roller}}) {
    for (const bool spread : {false, true}) {
      Scene scene = chain_scene(200);
      scene.supports.push_back({.at = Place::start(), .kind = held.start});
      scene.supports.push_back({.at = Place::end(), .kind = held.end});
      Load load{.at = {0.25, {}}, .force = {0.0, -1.0, 0.0}};
      if (spread) {
        load.at = Place::start();
        load.to = Place::end();
      }
      scene.loads.push_back(load);
      const auto expect = [&](ProbeQuantity quantity, Place at, Component component, Take take,
                              double most = 1e-3) {
        scene.probes.clear();
        add_probe(scene, quantity, at, component);
        EXPECT_LT(std::abs(error_of("beam", setup_of(scene), of_probe(take))), most)
            << static_cast<int>(quantity);
      };
      expect(ProbeQuantity::Displacement, {0.5, {}}, Component::Y, Take::End);
      // A segment turns as its middle does, half of its length before.
      expect(ProbeQuantity::Rotation, {0.9, {}}, Component::X, Take::End, 0.5 / 100);
      expect(ProbeQuantity::Reaction, Place::end(), Component::Y, Take::End);
      expect(ProbeQuantity::Moment, {0.5, {}}, Component::X, Take::Size);
    }
  }
  Scene two = chain_scene(4);
  EXPECT_EQ(refusal("beam", setup_of(two), of_probe()), "is for one load, or gravity alone");
}

TEST(ClosedForms, AreOfTheEndAtRestAndOfASizeWhereTheLoadIsLargest) {
  Scene scene = loaded(cantilever_scene(100), {.force = {0.0, -1e-3, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  plastica::Setup setup = setup_of(scene);
  EXPECT_LT(std::abs(error_of("beam", setup, of_probe(Take::Size))), 1e-3);
  for (const Take take : {Take::Mean, Take::Min, Take::Max, Take::Frequency}) {
    EXPECT_EQ(refusal("beam", setup, of_probe(take)),
              "is for a probe at the end of the run, or its size where the load is largest there");
  }
  setup.scene.loads[0].history = History::turning_points({1.0, 0.5});
  setup.solver.duration = 2.0;
  EXPECT_NE(refusal("beam", setup, of_probe(Take::Size)), "");
  EXPECT_LT(std::abs(error_of("beam", setup, of_probe())), 1e-3);
  setup.solver.analysis = Analysis::Dynamics;
  for (const char* form : {"beam", "elastica", "lumped_chain", "elastoplastic_cantilever"}) {
    EXPECT_EQ(refusal(form, setup, of_probe()), "is for a beam at rest");
  }
}

// A load at the end of segment 1, which is 0.6 of the beam, is one at 0.6.
TEST(ClosedForms, FindPlacesAmongUnevenSegments) {
  std::array<double, 2> expected{};
  for (const bool by_segment : {false, true}) {
    const Place at = by_segment ? Place{0.0, 1} : Place{0.6, {}};
    Scene scene = loaded(cantilever_scene(3), {.at = at, .force = {0.0, -1e-3, 0.0}});
    scene.beam.segment_fractions = {0.6, 0.2, 0.2};
    add_probe(scene, ProbeQuantity::Displacement, at, Component::Y);
    expected[by_segment ? 1 : 0] =
        find_closed_form("beam").values(setup_of(scene), of_probe(), {}).front();
  }
  EXPECT_EQ(expected[0], expected[1]);
}

// About the other axis, another section; in space the modes of both planes are counted together.
TEST(ClosedForms, HoldTheFrequenciesOfTheAxisThatIsBent) {
  Quantity quantity;
  quantity.kind = QuantityKind::NaturalFrequency;
  Scene scene = loaded(cantilever_scene(100), {.force = {1.0, 0.0, 0.0}});
  scene.section.width = 2.0 * scene.section.height;
  plastica::Setup setup = setup_of(scene);
  for (int mode = 1; mode <= 2; ++mode) {
    quantity.mode = mode;
    const double expected =
        find_closed_form("cantilever_frequency").values(setup, quantity, {}).front();
    const auto found = unloaded_frequencies(scene, setup.solver, mode);
    EXPECT_NEAR(found.back() / expected, 1.0, 1e-3);
  }
  setup.solver.level = Level::Spatial;
  EXPECT_EQ(refusal("cantilever_frequency", setup, quantity),
            "is for a beam that bends in a plane, solver.level = \"planar\"");
}

TEST(ClosedForms, HoldATwistedBar) {
  Scene scene = loaded(cantilever_scene(10), {.moment = {0.0, 0.0, 50.0}});
  scene.end_rule = EndRule::HalfJoint;
  add_probe(scene, ProbeQuantity::Rotation, {10.0 / 10, 10}, Component::Z);
  EXPECT_NEAR(error_of("torsion", setup_of(scene), of_probe()), 0.0, 1e-9);
  scene.loads[0].force = {0.0, 1.0, 0.0};
  EXPECT_EQ(refusal("torsion", setup_of(scene), of_probe()), "is for a torque at the tip, about z");
}

TEST(ClosedForms, HoldATwistedCircleBeyondFirstYield) {
  Scene scene = cantilever_scene(200);
  scene.end_rule = EndRule::HalfJoint;
  scene.section.shape = SectionShape::Circle;
  scene.section.radius = 0.01;
  scene.yield_model = YieldModel::Fibre;
  const double first_yield =
      resolved_shear_yield_stress(scene.material) * properties_of(scene).torsion_modulus;
  scene.loads.push_back({.moment = {0.0, 0.0, 1.25 * first_yield}});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
  plastica::Setup setup = setup_of(scene);
  // At T = 5/4 T_y the twist is that of first yield times 4^(1/3).
  const double yield_twist =
      resolved_shear_yield_stress(scene.material) / resolved_shear_modulus(scene.material) / 0.01;
  EXPECT_NEAR(find_closed_form("torsion").values(setup, of_probe(), {}).front(),
              std::cbrt(4.0) * yield_twist, 1e-12);
  setup.scene.loads[0].history = History::turning_points({1.0, 0.5});
  const std::string rule =
      "is for torques up to first yield; of a solid circle with ideal plasticity for rising ones "
      "up to 4/3 of it";
  EXPECT_EQ(refusal("torsion", setup, of_probe()), rule);
  setup.scene.loads[0].history = History::ramp();
  setup.scene.section.shape = SectionShape::Rectangle;
  setup.scene.loads[0].moment[2] *= 4.0;
  EXPECT_EQ(refusal("torsion", setup, of_probe()), rule);
}

TEST(ClosedForms, HoldTheFrequenciesOfATwistedBar) {
  Scene scene = loaded(cantilever_scene(100), {.moment = {0.0, 0.0, 1.0}});
  scene.end_rule = EndRule::HalfJoint;
  plastica::Setup setup = setup_of(scene);
  setup.solver.level = Level::Twist;
  Quantity quantity;
  quantity.kind = QuantityKind::NaturalFrequency;
  quantity.mode = 2;
  const double expected = find_closed_form("torsion_frequency").values(setup, quantity, {}).front();
  EXPECT_NEAR(unloaded_frequencies(scene, setup.solver, 2)[1] / expected, 1.0, 1e-3);
  setup.solver.level = Level::Spatial;
  EXPECT_EQ(refusal("torsion_frequency", setup, quantity),
            "is for a beam that is only twisted, solver.level = \"twist\"");
}

/// A beam of 0.2 m that yields.
Scene stocky(int segments, YieldModel model) {
  Scene scene = cantilever_scene(segments);
  scene.beam.length = 0.2;
  scene.yield_model = model;
  if (model != YieldModel::Fibre) scene.yield_cap = YieldCap::FullyPlastic;
  return scene;
}

TEST(ClosedForms, OfElasticBeamsAreNotOfThoseThatYield) {
  // M_y = 250 MPa x 20^3/6 mm^3 = 333.3 N m at the clamp of 0.2 m, and 1.5 M_y fully plastic.
  const std::string rule = "is for a beam that stays elastic: this one yields at a moment of ";
  for (const char* form : {"beam", "elastica", "lumped_chain"}) {
    Scene scene = loaded(stocky(20, YieldModel::Fibre), {.force = {0.0, -1660.0, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    EXPECT_EQ(refusal(form, setup_of(scene), of_probe()), "no error");
    scene.loads[0].history = History::turning_points({1.2, form[0] == 'e' ? 1.0 : 0.0});
    EXPECT_EQ(refusal(form, setup_of(scene), of_probe()).substr(0, 72), rule + "333 N m");
    scene.yield_model = YieldModel::PerAxis;
    scene.yield_cap = YieldCap::FullyPlastic;
    EXPECT_EQ(refusal(form, setup_of(scene), of_probe()), "no error") << "M_p";
    scene.loads[0].history = History::turning_points({1.6, 1.0});
    EXPECT_EQ(refusal(form, setup_of(scene), of_probe()).substr(0, 72), rule + "500 N m");
  }
}

TEST(ClosedForms, HoldLimitLoads) {
  Scene scene = loaded(stocky(20, YieldModel::Interaction), {.force = {0.0, -4000.0, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  Quantity quantity;
  quantity.kind = QuantityKind::LimitLoad;
  plastica::Setup setup = setup_of(scene);
  setup.solver.steps = 10;
  EXPECT_LT(std::abs(error_of("limit_load", setup, quantity)), 1e-3);
  EXPECT_EQ(refusal("limit_load", setup, of_probe()), "is for quantity = \"limit_load\"");
}

TEST(ClosedForms, HoldAnElastoplasticCantilever) {
  // 1.2 P_y, P_y = 250 MPa x 20^3/6 mm^3/0.2 m.
  const double force = 1.2 * 250e6 * 8e-6 / 6.0 / 0.2;
  Scene scene = loaded(stocky(160, YieldModel::Fibre), {.force = {0.0, -force, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  plastica::Setup setup = setup_of(scene);
  setup.solver.steps = 8;
  setup.solver.fibres = 80;
  EXPECT_LT(std::abs(error_of("elastoplastic_cantilever", setup, of_probe())), 1e-3);
  setup.scene.loads[0].history = History::turning_points({1.0, 0.0});
  EXPECT_LT(std::abs(error_of("elastoplastic_cantilever", setup, of_probe())), 1e-2);
  setup.scene.loads[0].force[1] *= 2.0;
  EXPECT_EQ(refusal("elastoplastic_cantilever", setup, of_probe()),
            "is for loads up to 1.5 times that of first yield");
}

TEST(ClosedForms, HoldABreakingHinge) {
  Scene scene = stocky(8, YieldModel::Interaction);
  scene.material.break_strain = 0.02;
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Roller,
                            .hold = HeldFreedoms{false, true},
                            .translation = {0.0, -0.02, 0.0}});
  add_probe(scene, ProbeQuantity::PlasticAngle, Place::start(), Component::X);
  plastica::Setup setup = setup_of(scene);
  setup.solver.steps = 20;
  EXPECT_LT(std::abs(error_of("hinge_break", setup, of_probe(Take::Size))), 1e-3);
  setup.scene.hinge_length = 0.0;
  EXPECT_EQ(refusal("hinge_break", setup, of_probe(Take::Size)), "is for a hinge length above 0");
}

TEST(ClosedForms, HoldACoupon) {
  plastica::Setup setup;
  setup.scene.drive.strain = {0.0, 0.001, 0.01};
  setup.scene.material.hardening.law = HardeningLaw::Linear;
  setup.scene.material.hardening.tangent_modulus = 2e9;
  EXPECT_LT(std::abs(error_of("uniaxial", setup, of_probe())), 1e-12);
  setup.scene.drive.strain.push_back(0.0);
  EXPECT_EQ(refusal("uniaxial", setup, of_probe()), "is for a coupon in rising tension");
}

TEST(ClosedForms, HoldTheBreakOfACoupon) {
  plastica::Setup setup;
  for (int i = 0; i <= 400; ++i) setup.scene.drive.strain.push_back(1e-4 * i);
  setup.scene.material.break_strain = 0.02;
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear}) {
    setup.scene.material.hardening.law = law;
    setup.scene.material.hardening.tangent_modulus = law == HardeningLaw::Linear ? 2e9 : 0.0;
    Quantity quantity;
    quantity.kind = QuantityKind::BreakStrain;
    EXPECT_LT(std::abs(error_of("uniaxial", setup, quantity)), 1e-9);
    quantity.kind = QuantityKind::BreakLoad;
    EXPECT_LT(std::abs(error_of("uniaxial", setup, quantity)), 1e-9);
    setup.scene.material.hardening = {};
  }
  Quantity quantity;
  quantity.kind = QuantityKind::BreakStrain;
  setup.scene.material.break_strain.reset();
  EXPECT_EQ(refusal("uniaxial", setup, quantity), "is for a material with a break strain");
}

TEST(ClosedForms, RefuseATipMomentOnAnElastoplasticCantilever) {
  Scene scene = loaded(stocky(8, YieldModel::Fibre), {.moment = {10.0, 0.0, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  EXPECT_EQ(refusal("elastoplastic_cantilever", setup_of(scene), of_probe()),
            "is for a tip force along y");
}

TEST(ClosedForms, HoldAReleasedCantilever) {
  Scene scene = cantilever_scene(64);
  scene.gravity = {0.0, -1.0, 0.0};
  scene.gravity_history = History::constant();
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  plastica::Setup setup = setup_of(scene);
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.rotary_inertia = RotaryInertia::Off;
  setup.solver.scheme = Scheme::LinearlyImplicitMidpoint;
  setup.solver.duration = 0.05;
  setup.solver.steps = 50;
  setup.solver.time_step = 1e-4;
  const BatchRow row = run_case({"a", setup.scene, setup.solver});
  const CaseResult result = result_of_run(row, of_probe(Take::Curve));
  const auto expected =
      find_closed_form("released_cantilever").values(setup, of_probe(Take::Curve), result.time);
  double largest = 0.0;
  double off = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest = std::max(largest, std::abs(expected[i]));
    off = std::max(off, std::abs(result.curve[i] - expected[i]));
  }
  EXPECT_LT(off, 2e-3 * largest);
  EXPECT_EQ(refusal("released_cantilever", setup, of_probe()), "is for take = \"curve\"");
}

}  // namespace
}  // namespace plastica::sweeps
