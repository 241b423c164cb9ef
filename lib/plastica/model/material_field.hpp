#pragma once

#include <array>
#include <cstddef>

#include "plastica/model/material.hpp"

namespace plastica {

/// The material numbers that a kernel reads and a fit may move, in the order of their array.
enum class MaterialField {
  YoungsModulus,
  PoissonRatio,
  ShearModulus,
  YieldStress,
  ShearYieldStress,
  BreakStrain,
  BreakShearStrain,
  TangentModulus,
  KinematicShare,
  SaturationStress,
  SaturationRate,
  BackModulus1,
  BackModulus2,
  BackModulus3,
  BackRate1,
  BackRate2,
  BackRate3,
};

inline constexpr std::size_t kMaterialFields = 17;

/// A material's numbers as kernels take them, by `MaterialField`; S is the kernel's scalar.
template <class S>
using MaterialValues = std::array<S, kMaterialFields>;

/// The numbers of a material in SI; unset ones are 0 and must be known as unset by the reader.
MaterialValues<double> material_values(const Material& material);

}  // namespace plastica
