#pragma once

#include "plastica/lanes/articulated_observables.hpp"
#include "plastica/lanes/articulated_step.hpp"
#include "plastica/lanes/kernel_table.hpp"

/// Fills a table with the kernels of the instruction set that this file is compiled for.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Spatial beams go as many together as a register holds: a body alone fills most of the registers
/// there are.
template <class Real>
inline constexpr std::size_t kRegisterLanes = plastica::detail::kRegisterBytes / sizeof(Real);

template <class Real, int kOrder, bool kYields>
constexpr StepKernels<PlanarBeam<Real>> planar_kernels() {
  constexpr std::size_t kW = kManyLanes<Real>;
  return {articulated_steps<PlanarForm, Real, 1, 1, kOrder, kYields>,
          articulated_steps<PlanarForm, Real, kW, kW, kOrder, kYields>};
}

template <class Real, int kOrder, bool kYields>
constexpr StepKernels<SpatialBeam<Real>> spatial_kernels() {
  constexpr std::size_t kW = kManyLanes<Real>;
  return {articulated_steps<SpatialForm, Real, 1, 1, kOrder, kYields>,
          articulated_steps<SpatialForm, Real, kW, kRegisterLanes<Real>, kOrder, kYields>};
}

template <template <class, std::size_t> class FormOf, class Real>
constexpr auto observables_kernels() {
  constexpr std::size_t kW = kManyLanes<Real>;
  using One = FormOf<Fused<Real>, 1>;
  return ObservablesKernels<typename One::Beam>{
      articulated_observables<One>, articulated_observables<FormOf<Fused<LanesOf<Real, kW>>, kW>>};
}

template <class Real>
constexpr KernelsOf<Real> kernels_of() {
  return {{{planar_kernels<Real, 1, false>(), planar_kernels<Real, 1, true>()},
           {planar_kernels<Real, 2, false>(), planar_kernels<Real, 2, true>()}},
          observables_kernels<PlanarForm, Real>(),
          {{spatial_kernels<Real, 1, false>(), spatial_kernels<Real, 1, true>()},
           {spatial_kernels<Real, 2, false>(), spatial_kernels<Real, 2, true>()}},
          observables_kernels<SpatialForm, Real>()};
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
