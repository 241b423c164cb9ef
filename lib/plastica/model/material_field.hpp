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
  KinematicFraction,
  SaturationStress,
  SaturationRate,
  BackModulus1,
  BackModulus2,
  BackModulus3,
  BackRate1,
  BackRate2,
  BackRate3,
  ReferenceRate,
  RateExponent,
  RateCoefficient,
  PlasticStrain1,  ///< of the table's points, one after the other
  FlowStress1 = PlasticStrain1 + Hardening::kTablePoints,
  Count = FlowStress1 + Hardening::kTablePoints,
};

/// Whether it is of the table of multilinear hardening, and whether it is a stress of that.
constexpr bool is_of_table(MaterialField field) { return field >= MaterialField::PlasticStrain1; }
constexpr bool is_flow_stress(MaterialField field) { return field >= MaterialField::FlowStress1; }

inline constexpr auto kMaterialFields = static_cast<std::size_t>(MaterialField::Count);

/// A material's numbers as kernels take them, by `MaterialField`; S is the kernel's scalar.
template <class S>
using MaterialValues = std::array<S, kMaterialFields>;

/// One of them. @param k  how many behind `field`, for those that stand in a row
template <class S>
constexpr const S& number_of(const MaterialValues<S>& values, MaterialField field,
                             std::size_t k = 0) {
  return values[static_cast<std::size_t>(field) + k];
}

/// The numbers of a material in SI; unset ones are 0 and must be known as unset by the reader.
MaterialValues<double> material_values(const Material& material);

}  // namespace plastica
