#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/scene.hpp"

namespace plastica {
namespace {

using testing::coupon_scene;

/// A path that loads, unloads and yields in reverse, in 60 samples. Few of its samples lie near a
/// yield point, where a difference would straddle the kink.
std::vector<double> cycle() {
  std::vector<double> strain;
  for (int i = 1; i <= 20; ++i) strain.push_back(6.01e-4 * i);
  for (int i = 1; i <= 40; ++i) strain.push_back(0.01202 - 5.01e-4 * i);
  return strain;
}

Scene scene_of(HardeningLaw law, Deformation deformation) {
  Scene scene = coupon_scene(deformation, cycle());
  scene.probes = {{"stress", ProbeQuantity::Stress}};
  scene.material.hardening = {
      law,           2e9,           0.3, 80e6, 12.0, {20e9, 4e9, 0.5e9}, {300.0, 40.0, 5.0},
      {0.002, 0.01}, {330e6, 400e6}};
  return scene;
}

struct Parameter {
  std::string path;
  double value;
};

const std::vector<Parameter> kIdeal{{"youngs_modulus", 200e9}, {"yield_stress", 300e6}};
const std::vector<Parameter> kShear{{"shear_modulus", 75e9}, {"shear_yield_stress", 170e6}};
const std::vector<Parameter> kLinear{{"tangent_modulus", 2e9}, {"kinematic_fraction", 0.3}};
const std::vector<Parameter> kVoce{{"saturation_stress", 80e6},     {"saturation_rate", 12.0},
                                   {"backstress_modulus_1", 20e9},  {"backstress_modulus_2", 4e9},
                                   {"backstress_modulus_3", 0.5e9}, {"backstress_rate_1", 300.0},
                                   {"backstress_rate_2", 40.0},     {"backstress_rate_3", 5.0}};

struct Differentiated {
  Response response;
  Sensitivity sensitivity;
};

Differentiated differentiate(const Scene& scene, const std::vector<Parameter>& parameters) {
  std::vector<std::string> paths;
  std::vector<double> values;
  for (const Parameter& p : parameters) {
    paths.push_back(p.path);
    values.push_back(p.value);
  }
  const Model model = prepare(scene, {}, paths);
  Differentiated d{make_response(model), make_sensitivity(model)};
  Workspace workspace = make_workspace(model);
  run_sensitivity(model, values, workspace, d.response, d.sensitivity);
  return d;
}

Response respond_to(const Scene& scene, const std::vector<Parameter>& parameters, std::size_t moved,
                    double by) {
  std::vector<std::string> paths;
  std::vector<double> values;
  for (const Parameter& p : parameters) {
    paths.push_back(p.path);
    values.push_back(p.value);
  }
  values[moved] += by;
  const Model model = prepare(scene, {}, paths);
  Response response = make_response(model);
  Workspace workspace = make_workspace(model);
  run(model, values, workspace, response);
  return response;
}

/// Central differences with relative steps over three decades: the error must fall as the square
/// of the step until rounding takes over. A sample at a kink may be off, at most two may.
void expect_derivatives(const Scene& scene, const std::vector<Parameter>& parameters) {
  const Differentiated d = differentiate(scene, parameters);
  const std::size_t n = parameters.size();
  for (std::size_t j = 0; j < n; ++j) {
    double largest = 0.0;
    for (std::size_t s = 0; s < scene.drive.strain.size(); ++s) {
      largest = std::max(largest, std::fabs(d.sensitivity.stress[s * n + j]));
    }
    EXPECT_GT(largest * parameters[j].value, 1e3) << parameters[j].path << " does not matter";
    for (const double relative : {1e-3, 1e-4, 1e-5}) {
      const double h = relative * parameters[j].value;
      const Response up = respond_to(scene, parameters, j, h);
      const Response down = respond_to(scene, parameters, j, -h);
      const double allowed = (30.0 * relative * relative + 1e-12 / relative) * largest +
                             1e-7 / relative / parameters[j].value;
      int off = 0;
      for (std::size_t s = 0; s < scene.drive.strain.size(); ++s) {
        const double difference = (up.probes[0][s] - down.probes[0][s]) / (2.0 * h);
        if (std::fabs(d.sensitivity.stress[s * n + j] - difference) > allowed) ++off;
      }
      EXPECT_LE(off, 2) << parameters[j].path << " with a step of " << relative;
      const double permanent = (up.permanent_strain - down.permanent_strain) / (2.0 * h);
      EXPECT_NEAR(d.sensitivity.permanent_strain[j] * parameters[j].value,
                  permanent * parameters[j].value, 30.0 * relative * relative + 1e-15 / relative)
          << parameters[j].path;
    }
  }
}

std::vector<Parameter> joined(std::vector<Parameter> a, const std::vector<Parameter>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

constexpr Deformation kDeformations[] = {Deformation::Tension, Deformation::Bending,
                                         Deformation::Torsion};

TEST(Sensitivity, OfIdealPlasticityAgreesWithDifferencesOverDecades) {
  for (const Deformation deformation : kDeformations) {
    expect_derivatives(scene_of(HardeningLaw::Ideal, deformation), kIdeal);
  }
}

TEST(Sensitivity, OfLinearHardeningAgreesWithDifferencesOverDecades) {
  for (const Deformation deformation : kDeformations) {
    expect_derivatives(scene_of(HardeningLaw::Linear, deformation), joined(kIdeal, kLinear));
  }
}

TEST(Sensitivity, OfVoceAndChabocheAgreesWithDifferencesOverDecades) {
  for (const Deformation deformation : kDeformations) {
    expect_derivatives(scene_of(HardeningLaw::VoceChaboche, deformation), joined(kIdeal, kVoce));
  }
}

TEST(Sensitivity, OfATableAgreesWithDifferencesOverDecades) {
  const std::vector<Parameter> table{{"flow_stress_1", 330e6},
                                     {"flow_stress_2", 400e6},
                                     {"plastic_strain_1", 0.002},
                                     {"kinematic_fraction", 0.3}};
  for (const Deformation deformation : kDeformations) {
    expect_derivatives(scene_of(HardeningLaw::Multilinear, deformation), joined(kIdeal, table));
  }
}

/// A rate that all has multiplies the yield stress and its growth by a factor of its parameters.
TEST(Sensitivity, OfARateLawAgreesWithDifferencesOverDecades) {
  const std::vector<Parameter> cowper_symonds{{"reference_rate", 40.4}, {"exponent", 5.0}};
  const std::vector<Parameter> johnson_cook{{"reference_rate", 0.01}, {"coefficient", 0.03}};
  for (const Deformation deformation : kDeformations) {
    for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear,
                                   HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
      Scene scene = scene_of(law, deformation);
      scene.material.rate = {RateLaw::CowperSymonds, 40.4, 5.0, {}, 7.0};
      expect_derivatives(scene, joined(kIdeal, cowper_symonds));
      scene.material.rate = {RateLaw::JohnsonCook, 0.01, {}, 0.03, 7.0};
      expect_derivatives(scene, joined(kIdeal, johnson_cook));
    }
  }
}

/// Below its reference rate Johnson and Cook's factor is 1: nothing depends on its parameters.
TEST(Sensitivity, OfJohnsonAndCookBelowTheReferenceRateIsZero) {
  Scene scene = scene_of(HardeningLaw::Linear, Deformation::Tension);
  scene.material.rate = {RateLaw::JohnsonCook, 10.0, {}, 0.03, 7.0};
  const Differentiated d = differentiate(scene, {{"reference_rate", 10.0}, {"coefficient", 0.03}});
  for (const double slope : d.sensitivity.stress) EXPECT_EQ(slope, 0.0);
}

TEST(Sensitivity, OfShearParametersAgreesWithDifferencesInTorsion) {
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear,
                                 HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
    expect_derivatives(scene_of(law, Deformation::Torsion), kShear);
  }
  expect_derivatives(scene_of(HardeningLaw::Ideal, Deformation::Torsion),
                     {{"poisson_ratio", 0.3}, {"yield_stress", 300e6}});
}

TEST(Sensitivity, OfReportFormulasAndFullyPlasticCapsAgreesToo) {
  Scene scene = scene_of(HardeningLaw::Linear, Deformation::Torsion);
  scene.formulas = Formulas::Report;
  expect_derivatives(scene, kIdeal);
  scene = scene_of(HardeningLaw::VoceChaboche, Deformation::Bending);
  scene.yield_cap = YieldCap::FullyPlastic;
  expect_derivatives(scene, kIdeal);
}

TEST(Sensitivity, LeavesTheBitsOfTheResponse) {
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear,
                                 HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
    const Scene scene = scene_of(law, Deformation::Torsion);
    const Response plain = respond_to(scene, kIdeal, 0, 0.0);
    const Response response = differentiate(scene, kIdeal).response;
    EXPECT_EQ(response.probes, plain.probes);
    EXPECT_EQ(response.permanent_strain, plain.permanent_strain);
    EXPECT_EQ(response.status, Status::Completed);
  }
}

TEST(Sensitivity, DoesNotDependOnWhichParametersGoAlong) {
  const Scene scene = scene_of(HardeningLaw::VoceChaboche, Deformation::Tension);
  const std::vector<Parameter> all = joined(kIdeal, kVoce);
  const Differentiated together = differentiate(scene, all);
  for (std::size_t count = 1; count < all.size(); ++count) {
    const std::vector<Parameter> some(all.begin(), all.begin() + static_cast<int>(count));
    const Differentiated d = differentiate(scene, some);
    for (std::size_t s = 0; s < scene.drive.strain.size(); ++s) {
      for (std::size_t j = 0; j < count; ++j) {
        EXPECT_EQ(d.sensitivity.stress[s * count + j],
                  together.sensitivity.stress[s * all.size() + j]);
      }
    }
  }
}

TEST(Sensitivity, WithoutParametersIsARun) {
  const Scene scene = scene_of(HardeningLaw::Ideal, Deformation::Tension);
  const Differentiated d = differentiate(scene, {});
  EXPECT_EQ(d.response.probes, simulate(scene).probes);
  EXPECT_TRUE(d.sensitivity.stress.empty());
}

TEST(Sensitivity, HasTheStatusOfARun) {
  const Scene scene = scene_of(HardeningLaw::Linear, Deformation::Tension);
  EXPECT_EQ(differentiate(scene, {{"yield_stress", -1.0}}).response.status,
            Status::InvalidParameter);
  EXPECT_EQ(differentiate(scene, {{"tangent_modulus", 300e9}}).response.status,
            Status::InvalidParameter);
  Scene huge = scene;
  huge.drive.strain = {0.01, 1e300, 0.01};
  const Response response = differentiate(huge, kIdeal).response;
  EXPECT_EQ(response.status, Status::NonFinite);
  EXPECT_EQ(response.samples, 1U);
}

}  // namespace
}  // namespace plastica
