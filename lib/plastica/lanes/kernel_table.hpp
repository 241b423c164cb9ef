#pragma once

#include <cstddef>

#include "plastica/base/instruction_set.hpp"
#include "plastica/lanes/planar_beam.hpp"
#include "plastica/lanes/spatial_beam.hpp"

/// The kernels of one instruction set. Each set is a source file of its own (kernels_*.cpp) with
/// the same templates in an inline namespace of its own.
namespace plastica::lanes {

/// `steps` steps of one length [s].
/// @param aimed  whether the steps before had the same length and left off here
template <class Beam>
using StepKernel = void (*)(const Beam& beam, double step, std::size_t steps, bool aimed);

/// Steps of one scenario, and of as many as a register of the widest set holds; the bits of a
/// scenario are the same.
template <class Beam>
struct StepKernels {
  StepKernel<Beam> one;
  StepKernel<Beam> many;
};

/// Computes where beams are and what energies they have.
template <class Beam>
struct ObservablesKernels {
  void (*one)(const Beam& beam);
  void (*many)(const Beam& beam);
};

/// Scenarios that `many` steps together.
template <class Real>
inline constexpr std::size_t kManyLanes = 64 / sizeof(Real);

template <class Real>
struct KernelsOf {
  /// By order of the scheme less 1, and whether joints yield.
  StepKernels<PlanarBeam<Real>> planar[2][2];
  ObservablesKernels<PlanarBeam<Real>> planar_observables;
  StepKernels<SpatialBeam<Real>> spatial[2][2];
  ObservablesKernels<SpatialBeam<Real>> spatial_observables;
};

struct KernelTable {
  KernelsOf<double> in_double;
  KernelsOf<float> in_float;
};

extern const KernelTable kBaselineKernels;
extern const KernelTable kAvx2Kernels;
extern const KernelTable kAvx512Kernels;

/// @param level  not Auto; one that this build has
const KernelTable& kernels(InstructionSet level);

/// Those of a precision.
template <class Real>
const KernelsOf<Real>& of_precision(const KernelTable& table) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    return table.in_double;
  } else {
    return table.in_float;
  }
}

}  // namespace plastica::lanes
