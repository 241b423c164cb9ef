#pragma once

#include <cstddef>

#include "plastica/base/instruction_set.hpp"
#include "plastica/coupon/shape.hpp"

/// Curves with derivatives, by dual numbers whose derivatives fill registers. The same templates
/// are compiled for two instruction sets (slopes_*.cpp). Neither fuses or reorders anything, so
/// that both give the same bits and the choice shows in time alone.
namespace plastica::coupon {

/// Derivatives that go along in one pass.
inline constexpr std::size_t kMaxSlopes = 8;

/// A curve to be followed, and where its derivatives by some material numbers go.
struct SlopesRun {
  const CouponShape* shape;
  const double* material;     ///< SI (kMaterialFields)
  const std::size_t* fields;  ///< index of each number to differentiate by (n_slopes)
  std::size_t n_slopes;       ///< 1 … kMaxSlopes
  const double* strain;       ///< (n_samples)
  std::size_t n_samples;
  double* stress;            ///< (n_samples)
  double* slopes;            ///< d stress: n_slopes of each sample, `stride` apart
  std::size_t stride;        ///< >= n_slopes
  double* permanent;         ///< break measure at the end
  double* permanent_slopes;  ///< (n_slopes)
};

using SlopeKernel = void (*)(const SlopesRun& run);

void slopes_baseline_kernel(const SlopesRun& run);
void slopes_avx2_kernel(const SlopesRun& run);

/// @param level  not Auto; one that this processor has. AVX-512 has nothing to add to AVX2.
SlopeKernel slope_kernel(InstructionSet level);

}  // namespace plastica::coupon
