#pragma once

#include "plastica/lanes/kernel_table.hpp"
#include "plastica/lanes/planar_sight.hpp"
#include "plastica/lanes/planar_step.hpp"
#include "plastica/lanes/spatial_sight.hpp"
#include "plastica/lanes/spatial_step.hpp"

/// Fills a table with the kernels of the instruction set that this file is compiled for.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

template <class Real>
using Many = Pack<Real, static_cast<int>(kManyLanes<Real>)>;

template <class Real, int kOrder, bool kYields>
constexpr StepKernels<PlanarBeam<Real>> planar_kernels() {
  return {planar_steps<Real, kOrder, kYields>, planar_steps<Many<Real>, kOrder, kYields>};
}

template <class Real, int kOrder, bool kYields>
constexpr StepKernels<SpatialBeam<Real>> spatial_kernels() {
  return {spatial_steps<Real, 1, kOrder, kYields>,
          spatial_steps<Real, kManyLanes<Real>, kOrder, kYields>};
}

template <class Real>
constexpr KernelsOf<Real> kernels_of() {
  return {{{planar_kernels<Real, 1, false>(), planar_kernels<Real, 1, true>()},
           {planar_kernels<Real, 2, false>(), planar_kernels<Real, 2, true>()}},
          {planar_sight<Real>, planar_sight<Many<Real>>},
          {{spatial_kernels<Real, 1, false>(), spatial_kernels<Real, 1, true>()},
           {spatial_kernels<Real, 2, false>(), spatial_kernels<Real, 2, true>()}},
          {spatial_sight<Real>, spatial_sight<Many<Real>>}};
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
