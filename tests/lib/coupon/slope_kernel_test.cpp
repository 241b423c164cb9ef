#include "plastica/coupon/slope_kernel.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "plastica/base/instruction_set.hpp"
#include "plastica/coupon/shape.hpp"
#include "plastica/model/material_field.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/scene.hpp"

namespace plastica::coupon {
namespace {

/// Loading, unloading and reverse yielding.
std::vector<double> cycle() {
  std::vector<double> strain;
  for (int i = 1; i <= 40; ++i) strain.push_back(3.01e-4 * i);
  for (int i = 1; i <= 80; ++i) strain.push_back(0.01204 - 2.51e-4 * i);
  return strain;
}

Scene scene_of(HardeningLaw law, BreakMeasure measure) {
  Scene scene = testing::coupon_scene(Deformation::Bending, cycle());
  scene.break_measure = measure;
  scene.material.hardening = {
      law,           2e9,           0.3, 80e6, 12.0, {20e9, 4e9, 0.5e9}, {300.0, 40.0, 5.0},
      {0.002, 0.01}, {330e6, 400e6}};
  return scene;
}

struct Curve {
  std::vector<double> stress, slopes, permanent;  ///< permanent strain and its derivatives

  std::vector<std::uint64_t> bits() const {
    std::vector<std::uint64_t> bits;
    for (const auto* numbers : {&stress, &slopes, &permanent}) {
      for (const double x : *numbers) bits.push_back(std::bit_cast<std::uint64_t>(x));
    }
    return bits;
  }
};

Curve follow(SlopeKernel kernel, const Scene& scene, const std::vector<std::size_t>& fields) {
  const CouponShape shape = coupon_shape(scene);
  const MaterialValues<double> material = material_values(scene.material);
  const std::vector<double>& strain = scene.drive.strain;
  const std::size_t n = fields.size();
  Curve curve;
  curve.stress.resize(strain.size());
  curve.slopes.resize(strain.size() * n);
  curve.permanent.resize(1 + n);
  kernel({.shape = &shape,
          .material = material.data(),
          .fields = fields.data(),
          .n_slopes = n,
          .strain = strain.data(),
          .n_samples = strain.size(),
          .stress = curve.stress.data(),
          .slopes = curve.slopes.data(),
          .stride = n,
          .permanent = curve.permanent.data(),
          .permanent_slopes = curve.permanent.data() + 1});
  return curve;
}

constexpr HardeningLaw kLaws[] = {HardeningLaw::Ideal, HardeningLaw::Linear,
                                  HardeningLaw::VoceChaboche, HardeningLaw::Multilinear};
constexpr BreakMeasure kMeasures[] = {BreakMeasure::Net, BreakMeasure::Accumulated};

std::vector<std::size_t> fields_of(std::size_t n) {
  constexpr MaterialField kFields[] = {
      MaterialField::YoungsModulus,     MaterialField::YieldStress,   MaterialField::TangentModulus,
      MaterialField::SaturationStress,  MaterialField::BackModulus1,  MaterialField::BackRate1,
      MaterialField::KinematicFraction, MaterialField::SaturationRate};
  std::vector<std::size_t> fields;
  for (std::size_t i = 0; i < n; ++i) fields.push_back(static_cast<std::size_t>(kFields[i]));
  return fields;
}

TEST(SlopeKernel, GivesTheSameBitsOnEachInstructionSet) {
  if (!has_instruction_set(InstructionSet::Avx2)) GTEST_SKIP() << "this processor has one set";
  for (const HardeningLaw law : kLaws) {
    for (const BreakMeasure measure : kMeasures) {
      if (testing::kSanitized && measure == BreakMeasure::Net) continue;
      const Scene scene = scene_of(law, measure);
      for (std::size_t n = 1; n <= kMaxSlopes; ++n) {
        const Curve narrow = follow(slope_kernel(InstructionSet::Baseline), scene, fields_of(n));
        EXPECT_EQ(narrow.bits(),
                  follow(slope_kernel(InstructionSet::Avx2), scene, fields_of(n)).bits())
            << n;
        EXPECT_GT(narrow.permanent[0], 1e-3);
      }
    }
  }
}

TEST(SlopeKernel, GivesADerivativeTheSameBitsWhateverGoesAlong) {
  for (const HardeningLaw law : kLaws) {
    const Scene scene = scene_of(law, BreakMeasure::Net);
    const Curve all =
        follow(slope_kernel(resolved(InstructionSet::Auto)), scene, fields_of(kMaxSlopes));
    for (std::size_t n = 1; n < kMaxSlopes; ++n) {
      const Curve some = follow(slope_kernel(resolved(InstructionSet::Auto)), scene, fields_of(n));
      EXPECT_EQ(some.stress, all.stress);
      for (std::size_t s = 0; s < some.stress.size(); ++s) {
        for (std::size_t k = 0; k < n; ++k) {
          EXPECT_EQ(some.slopes[s * n + k], all.slopes[s * kMaxSlopes + k]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace plastica::coupon
