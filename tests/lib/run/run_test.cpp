#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scene.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica {
namespace {

using testing::coupon_scene;
using testing::kE;
using testing::kYield;
using testing::of;
using testing::tolerance;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Response run_with(const Model& model, const std::vector<double>& values) {
  Response response = make_response(model);
  Workspace workspace = make_workspace(model);
  run(model, values, workspace, response);
  return response;
}

TEST(Probes, RecordEveryQuantityOfATensionTest) {
  const double y = kYield / kE;
  const Response response = simulate(coupon_scene(Deformation::Tension, {3.0 * y, -3.0 * y}));
  const auto expect = [&](ProbeQuantity quantity, double first, double second) {
    const std::vector<double>& values = of(response, quantity);
    ASSERT_EQ(values.size(), 2U);
    EXPECT_NEAR(values[0], first, tolerance(1e-13) * std::fabs(first));
    EXPECT_NEAR(values[1], second, tolerance(1e-13) * std::fabs(second));
  };
  expect(ProbeQuantity::Strain, 3.0 * y, -3.0 * y);
  expect(ProbeQuantity::Stress, kYield, -kYield);
  expect(ProbeQuantity::PlasticStrain, 2.0 * y, -2.0 * y);
  expect(ProbeQuantity::AccumulatedStrain, 2.0 * y, 6.0 * y);
  expect(ProbeQuantity::Load, kYield * 0.006, -kYield * 0.006);
  expect(ProbeQuantity::Dissipation, kYield * 2.0 * y, kYield * 6.0 * y);
}

TEST(Probes, AreFilledInTheOrderOfTheScene) {
  Scene scene = coupon_scene(Deformation::Tension, {0.001});
  scene.probes = {{"a", ProbeQuantity::Load}, {"b", ProbeQuantity::Strain}};
  const Response response = simulate(scene);
  EXPECT_NEAR(response.probes[0][0], 0.001 * kE * 0.006, 1e-6);
  EXPECT_EQ(response.probes[1][0], 0.001);
}

TEST(Probes, MayBeAbsent) {
  Scene scene = coupon_scene(Deformation::Tension, {0.001, 0.01});
  scene.probes.clear();
  const Response response = simulate(scene);
  EXPECT_EQ(response.status, Status::Completed);
  EXPECT_NEAR(response.permanent_strain, 0.01 - kYield / kE, 1e-16);
}

TEST(Dissipation, IsTheWorkPutInLessTheElasticEnergy) {
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear}) {
    Scene scene = coupon_scene(Deformation::Tension, {});
    scene.material.hardening.law = law;
    scene.material.hardening.tangent_modulus = 2e9;
    const int samples = 20000;
    for (int i = 1; i <= samples; ++i) scene.drive.strain.push_back(0.02 * std::sin(5e-4 * i));
    const Response response = simulate(scene);
    const std::vector<double>& strain = of(response, ProbeQuantity::Strain);
    const std::vector<double>& stress = of(response, ProbeQuantity::Stress);
    // Kinematic hardening alone stores energy; here all of it is isotropic.
    double work = 0.5 * stress[0] * strain[0];
    for (std::size_t i = 1; i < strain.size(); ++i) {
      work += 0.5 * (stress[i] + stress[i - 1]) * (strain[i] - strain[i - 1]);
    }
    const double stored = 0.5 * stress.back() * stress.back() / kE;
    const double dissipated = testing::last(response, ProbeQuantity::Dissipation);
    EXPECT_NEAR(dissipated, work - stored, 1e-5 * work);
  }
}

TEST(Run, FillsAStressOnlyResponseWithTheBitsOfAFullOne) {
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear,
                                 HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
    Scene scene = coupon_scene(Deformation::Bending, {0.001, 0.01, 0.005, -0.004, -0.02});
    scene.material.hardening = {
        law,           2e9,           0.3, 80e6, 12.0, {20e9, 1e9, 0.0}, {300.0, 0.0, 0.0},
        {0.002, 0.01}, {330e6, 400e6}};
    const Response full = simulate(scene);
    scene.probes = {{"stress", ProbeQuantity::Stress}};
    const Response lean = simulate(scene);
    EXPECT_EQ(lean.probes[0], of(full, ProbeQuantity::Stress));
    EXPECT_EQ(lean.permanent_strain, full.permanent_strain);
  }
}

TEST(Run, TakesParametersInsteadOfTheScenesValues) {
  Scene scene = coupon_scene(Deformation::Torsion, {0.05});
  scene.material.break_shear_strain = 0.01;
  const std::vector<std::string> parameters{"material.shear_yield_stress", "shear_modulus"};
  const Model model = prepare(scene, {}, parameters);
  const Response given = run_with(model, {100e6, 50e9});
  scene.material.shear_yield_stress = 100e6;
  scene.material.shear_modulus = 50e9;
  const Response set = simulate(scene);
  EXPECT_EQ(given.probes, set.probes);
  EXPECT_EQ(given.event->strain, set.event->strain);
}

TEST(Run, BreaksByAParameterThatTheSceneLeavesUnset) {
  const std::vector<std::string> parameters{"break_strain"};
  const Model model = prepare(coupon_scene(Deformation::Tension, {0.05}), {}, parameters);
  EXPECT_EQ(run_with(model, {0.01}).status, Status::Broken);
  EXPECT_EQ(run_with(model, {0.1}).status, Status::Completed);
}

TEST(Run, ForgetsTheRunBefore) {
  const std::vector<std::string> parameters{"break_strain"};
  const Model model = prepare(coupon_scene(Deformation::Tension, {0.05}), {}, parameters);
  Response response = make_response(model);
  Workspace workspace = make_workspace(model);
  for (const double limit : {0.01, -1.0, 0.1}) {
    const double values[] = {limit};
    run(model, values, workspace, response);
    const Response fresh = run_with(model, {limit});
    EXPECT_EQ(response.status, fresh.status);
    EXPECT_EQ(response.samples, fresh.samples);
    EXPECT_EQ(response.permanent_strain, fresh.permanent_strain);
    EXPECT_EQ(response.event.has_value(), fresh.event.has_value());
  }
}

TEST(Status, IsNotRunBeforeTheFirstRun) {
  const Model model = prepare(coupon_scene(Deformation::Tension, {0.05}));
  EXPECT_EQ(make_response(model).status, Status::NotRun);
  EXPECT_EQ(make_response(model).samples, 0U);
}

TEST(Status, IsCompletedOrBrokenWithAllSamplesValid) {
  Scene scene = coupon_scene(Deformation::Tension, {0.01, 0.02});
  EXPECT_EQ(simulate(scene).status, Status::Completed);
  scene.material.break_strain = 0.01;
  const Response response = simulate(scene);
  EXPECT_EQ(response.status, Status::Broken);
  EXPECT_EQ(response.samples, 2U);
}

TEST(Status, IsInvalidParameterForAValueOutsideOfItsRange) {
  const std::vector<std::string> parameters{"yield_stress"};
  const Model model = prepare(coupon_scene(Deformation::Tension, {0.05}), {}, parameters);
  for (const double value : {0.0, -1.0, kInfinite, std::nan("")}) {
    const Response response = run_with(model, {value});
    EXPECT_EQ(response.status, Status::InvalidParameter) << value;
    EXPECT_EQ(response.samples, 0U);
  }
}

TEST(Status, IsInvalidParameterForATangentModulusNotBelowYoungsModulus) {
  Scene scene = coupon_scene(Deformation::Tension, {0.05});
  scene.material.hardening.law = HardeningLaw::Linear;
  const std::vector<std::string> parameters{"tangent_modulus"};
  const Model model = prepare(scene, {}, parameters);
  EXPECT_EQ(run_with(model, {0.9 * kE}).status, Status::Completed);
  EXPECT_EQ(run_with(model, {kE}).status, Status::InvalidParameter);
  EXPECT_EQ(run_with(model, {2.0 * kE}).status, Status::InvalidParameter);
}

TEST(Status, IsInvalidParameterForASofteningToNothing) {
  Scene scene = coupon_scene(Deformation::Tension, {0.05});
  scene.material.hardening.law = HardeningLaw::VoceChaboche;
  scene.material.hardening.saturation_rate = 10.0;
  const std::vector<std::string> parameters{"saturation_stress"};
  const Model model = prepare(scene, {}, parameters);
  EXPECT_EQ(run_with(model, {-0.9 * kYield}).status, Status::Completed);
  EXPECT_EQ(run_with(model, {-kYield}).status, Status::InvalidParameter);
}

TEST(Status, IsNonFiniteWhereANumberOverflows) {
  for (const bool lean : {false, true}) {
    Scene scene = coupon_scene(Deformation::Tension, {0.01, 1e300, 0.01});
    if (lean) scene.probes = {{"stress", ProbeQuantity::Stress}};
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 2e9;
    const Response response = simulate(scene);
    EXPECT_EQ(response.status, Status::NonFinite);
    EXPECT_EQ(response.samples, 1U);
  }
}

TEST(Status, IsNonFiniteWhereTheModulusHasNoInverse) {
  Scene scene = coupon_scene(Deformation::Tension, {0.01});
  scene.material.youngs_modulus = 1e-320;
  EXPECT_EQ(simulate(scene).status, Status::NonFinite);
}

std::string error_of(const std::vector<std::string>& parameters) {
  try {
    prepare(coupon_scene(Deformation::Tension, {0.05}), {}, parameters);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Prepare, RefusesParametersThatACouponCannotMove) {
  EXPECT_EQ(error_of({"beam.length"}), "beam.length: cannot be a parameter of a coupon");
  EXPECT_EQ(error_of({"stiffness"}), "stiffness: is not a field; `plastica fields` lists them");
  EXPECT_EQ(error_of({"yield_stress", "material.yield_stress"}),
            "material.yield_stress: is a parameter twice");
  EXPECT_EQ(error_of({"yield_stress"}), "");
}

TEST(Prepare, RefusesParametersThatAChainWouldIgnore) {
  const auto error = [](const std::string& path, const std::function<void(Scene&)>& set = {}) {
    Scene scene = testing::cantilever_scene(4);
    scene.loads.push_back({.force = {0.0, -1.0, 0.0}});
    if (set) set(scene);
    return testing::message_of([&] { prepare(scene, {}, std::vector{path}); });
  };
  const std::string unset = ": must be set in the scene to be a parameter of a chain";
  const std::string limit =
      ": cannot be a parameter of a chain, whose break limits are those of its scene";
  for (const std::string path : {"material.break_strain", "material.break_shear_strain"}) {
    EXPECT_EQ(error(path), path + limit);
    EXPECT_EQ(error(path, [](Scene& s) { s.material.break_strain = 0.1; }), path + limit);
  }
  EXPECT_EQ(error("material.shear_modulus"), "material.shear_modulus" + unset);
  EXPECT_EQ(error("material.shear_modulus", [](Scene& s) { s.material.shear_modulus = 77e9; }),
            "no error");
  EXPECT_EQ(error("material.shear_yield_stress"), "material.shear_yield_stress" + unset);
  EXPECT_EQ(
      error("material.shear_yield_stress", [](Scene& s) { s.material.shear_yield_stress = 1e8; }),
      "no error");
  EXPECT_EQ(error("material.youngs_modulus"), "no error");
  EXPECT_EQ(error("beam.length"), "beam.length: cannot be a parameter of a chain");
}

/// A parameter that is taken does something: a shaft turns by T (L - l/2)/(G J) with either G.
TEST(Prepare, TakesTheShearModulusThatAChainsSceneSets) {
  Scene scene = testing::cantilever_scene(4);
  scene.material.shear_modulus = 77e9;
  scene.loads.push_back({.moment = {0.0, 0.0, 1.0}});
  testing::add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
  const Model model = prepare(scene, {}, std::vector<std::string>{"material.shear_modulus"});
  const double twist = testing::last_of(run_with(model, {77e9}), 0);
  EXPECT_NEAR(testing::last_of(run_with(model, {38.5e9}), 0) / twist, 2.0, tolerance(1e-9));
}

TEST(Prepare, RefusesRulesOfChainsInACoupon) {
  const auto error = [](const std::function<void(Scene&)>& set) {
    Scene scene = coupon_scene(Deformation::Tension, {0.05});
    set(scene);
    return testing::message_of([&] { prepare(scene); });
  };
  EXPECT_EQ(error([](Scene& s) { s.yield_model = YieldModel::Elastic; }),
            "rules.yield_model = elastic: is of chains: a coupon has one stress component");
  EXPECT_EQ(error([](Scene& s) { s.break_limit_x = 0.25; }),
            "rules.break_limit_x = 0.25: is of chains: a coupon breaks at material.break_strain or "
            "material.break_shear_strain");
  EXPECT_EQ(error([](Scene& s) { s.hinge_length = 0.0; }),
            "rules.hinge_length = 0: is of chains: a coupon has no hinge");
}

TEST(Prepare, SaysWhyItChoseTheLevel) {
  const Scene scene = coupon_scene(Deformation::Tension, {0.05});
  EXPECT_EQ(prepare(scene).level, Level::Coupon);
  EXPECT_NE(prepare(scene).level_reason, prepare(scene, {Level::Coupon}).level_reason);
}

}  // namespace
}  // namespace plastica
