// Whether the search of a coupon finds back what made a cyclic curve: exact curves of random
// materials, with 4 to 8 free parameters, each from the start that the curve itself gives.
// PLASTICA_STUDY=full runs 40 of each, =sample three.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"

namespace plastica::studies {
namespace {

using namespace calibrate;
using testing::free_parameter;

/// A kind of material and the parameters that are searched.
struct Kind {
  const char* name;
  bool modulus, isotropic;
  int backstresses;
  std::vector<const char*> parameters;
};

const std::vector<Kind> kKinds{
    {"4: E, yield stress, C, gamma", true, false, 1, {"backstress_modulus_1", "backstress_rate_1"}},
    {"5: yield stress, C, gamma, Q, b",
     false,
     true,
     1,
     {"backstress_modulus_1", "backstress_rate_1", "saturation_stress", "saturation_rate"}},
    {"6: E, yield stress, C, gamma, Q, b",
     true,
     true,
     1,
     {"backstress_modulus_1", "backstress_rate_1", "saturation_stress", "saturation_rate"}},
    {"8: and a second C, gamma",
     true,
     true,
     2,
     {"backstress_modulus_1", "backstress_rate_1", "backstress_modulus_2", "backstress_rate_2",
      "saturation_stress", "saturation_rate"}},
};

/// Even in the logarithm.
double between(double low, double high, std::mt19937_64& random) {
  return low * std::pow(high / low, static_cast<double>(random() >> 11U) * 0x1p-53);
}

FitOptions truth_of(const Kind& kind, std::mt19937_64& random) {
  FitOptions options = testing::fit_of({free_parameter("yield_stress")});
  if (kind.modulus) options.parameters.push_back(free_parameter("youngs_modulus"));
  for (const char* name : kind.parameters) options.parameters.push_back(free_parameter(name));
  Material& material = options.setup.scene.material;
  material.youngs_modulus = 190e9;
  material.yield_stress = between(150e6, 450e6, random);
  Hardening& hardening = material.hardening;
  hardening.law = HardeningLaw::VoceChaboche;
  hardening.backstress_modulus[0] = between(10e9, 100e9, random);
  hardening.backstress_rate[0] = between(100.0, 600.0, random);
  if (kind.backstresses > 1) {
    hardening.backstress_modulus[1] = between(2e9, 8e9, random);
    hardening.backstress_rate[1] = between(10.0, 60.0, random);
  }
  if (kind.isotropic) {
    hardening.saturation_stress = between(20e6, 150e6, random);
    hardening.saturation_rate = between(2.0, 50.0, random);
  }
  return options;
}

TEST(Cyclic, FindsBackWhatMadeAnExactCurve) {
  const char* study = std::getenv("PLASTICA_STUDY");
  const bool full = study != nullptr && std::string(study) == "full";
  const int curves = full ? 40 : 3;
  for (const Kind& kind : kKinds) {
    int found = 0;
    double evaluations = 0.0;
    for (int i = 0; i < curves; ++i) {
      std::mt19937_64 random(1000 + static_cast<std::uint64_t>(i));
      const FitOptions options = truth_of(kind, random);
      Target target = testing::target_like(options, Deformation::Tension,
                                           testing::path({0.01, -0.01, 0.01, -0.01}, 25));
      target.loading = Loading::Cyclic;
      const FitResult fit = fit_target(target, options);
      const double yield = options.setup.scene.material.yield_stress;
      // A cost that is nothing but rounding, at the one yield stress that has it.
      const bool back = fit.status == FitStatus::Fitted && fit.misfit_fraction < 1e-7 &&
                        std::fabs(fit.parameter("yield_stress").value / yield - 1.0) < 1e-4;
      found += back ? 1 : 0;
      evaluations += static_cast<double>(fit.evaluations());
    }
    fmt::print("{:36} {} of {} found back, {:.0f} evaluations a fit\n", kind.name, found, curves,
               evaluations / curves);
    std::fflush(stdout);
    EXPECT_EQ(found, curves) << kind.name;
  }
}

}  // namespace
}  // namespace plastica::studies
