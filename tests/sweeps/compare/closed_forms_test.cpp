#include "sweeps/compare/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastica/run/batch.hpp"
#include "sweeps/run/case_result.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"

namespace plastica::sweeps {
namespace {

using plastica::testing::add_probe;
using plastica::testing::cantilever_scene;
using plastica::testing::chain_scene;

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
  const CaseResult result = result_of(row.response, row.level, quantity);
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
    scene.end_rule = EndRule::Half;
    EXPECT_EQ(refusal("lumped_chain", setup_of(scene), of_probe()),
              "is for rules.end_rule half_joint, equal or three_halves");
  }
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
  EXPECT_EQ(refusal("beam", setup_of(two), of_probe()), "is for one load");
}

TEST(ClosedForms, HoldATwistedBar) {
  Scene scene = loaded(cantilever_scene(10), {.moment = {0.0, 0.0, 50.0}});
  scene.end_rule = EndRule::HalfJoint;
  add_probe(scene, ProbeQuantity::Rotation, {10.0 / 10, 10}, Component::Z);
  // The last half segment has no joint.
  EXPECT_NEAR(error_of("torsion", setup_of(scene), of_probe()), -0.05, 1e-9);
  scene.loads[0].force = {0.0, 1.0, 0.0};
  EXPECT_EQ(refusal("torsion", setup_of(scene), of_probe()), "is for a torque at the tip, about z");
}

/// A beam of 0.2 m that yields.
Scene stocky(int segments, YieldModel model) {
  Scene scene = cantilever_scene(segments);
  scene.beam.length = 0.2;
  scene.yield_model = model;
  if (model != YieldModel::Fibre) scene.yield_cap = YieldCap::FullyPlastic;
  return scene;
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
  const CaseResult result = result_of(row.response, row.level, of_probe(Take::Curve));
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
