#pragma once

#include <cstddef>
#include <type_traits>

#include "plastica/base/dual.hpp"
#include "plastica/coupon/material.hpp"
#include "plastica/coupon/slope_kernel.hpp"

/// The kernel of `slope_kernel.hpp`, for the instruction set that this file is compiled for.
namespace plastica::coupon {
PLASTICA_KERNELS_BEGIN

/// All that it calls is inlined: dual numbers that are passed in memory cost twice as much.
/// @tparam kAccumulates  whether the accumulated strain at the end is wanted; if not it costs
///                       nothing where the law does without
/// @param numbers  copied, so that the compiler knows that no store changes them
template <std::size_t N, bool kAccumulates, class Law>
[[gnu::noinline, gnu::flatten]] void follow(const SlopesRun& run, const Law& numbers,
                                            typename Law::State& end) {
  using D = Dual<double, N>;
  const Law law = numbers;
  const double* strain = run.strain;
  double* stress = run.stress;
  double* slopes = run.slopes;
  // Known to the compiler but for the widest, which also takes what does not fill it.
  const std::size_t n = N == kMaxSlopes ? run.n_slopes : N;
  const std::size_t stride = run.stride;
  const std::size_t n_samples = run.n_samples;
  typename Law::State state;
  for (std::size_t i = 0; i < n_samples; ++i, slopes += stride) {
    const auto now = law::respond(law, state, D(strain[i]));
    state = now.state;
    if constexpr (!kAccumulates) state.accumulated = D{};
    stress[i] = now.stress.value();
    for (std::size_t k = 0; k < n; ++k) slopes[k] = now.stress.derivative(k);
  }
  end = state;
}

template <std::size_t N>
void follow(const SlopesRun& run) {
  using D = Dual<double, N>;
  MaterialValues<D> material;
  // The table is longer than all else together, and most laws have none.
  const bool has_table = run.shape->hardening == HardeningLaw::Multilinear;
  const auto table = static_cast<std::size_t>(MaterialField::PlasticStrain1);
  for (std::size_t i = 0; i < (has_table ? kMaterialFields : table); ++i) {
    material[i] = D(run.material[i]);
  }
  for (std::size_t k = 0; k < run.n_slopes; ++k) {
    const std::size_t field = run.fields[k];
    material[field] = D::parameter(run.material[field], k);
  }
  const auto coupon = coupon_material(*run.shape, material);
  with_law(run.shape->hardening, coupon, material, [&](const auto& numbers) {
    using Law = std::remove_cvref_t<decltype(numbers)>;
    typename Law::State end;
    if constexpr (std::is_same_v<Law, law::IdealPlastic<D>>) {
      const bool net = run.shape->break_measure == BreakMeasure::Net;
      net ? follow<N, false>(run, numbers, end) : follow<N, true>(run, numbers, end);
    } else {
      follow<N, true>(run, numbers, end);
    }
    const D permanent = break_measure(*run.shape, end);
    *run.permanent = permanent.value();
    for (std::size_t k = 0; k < run.n_slopes; ++k) {
      run.permanent_slopes[k] = permanent.derivative(k);
    }
  });
}

inline void follow_any(const SlopesRun& run) {
  switch (run.n_slopes) {
    case 1: return follow<1>(run);
    case 2: return follow<2>(run);
    case 3: return follow<3>(run);
    case 4: return follow<4>(run);
    default: return follow<kMaxSlopes>(run);
  }
}

PLASTICA_KERNELS_END
}  // namespace plastica::coupon
