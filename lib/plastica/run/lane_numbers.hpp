#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "plastica/law/uniaxial_material.hpp"
#include "plastica/run/chain_body.hpp"

/// How the kernels' numbers follow from a chain's.
namespace plastica {

/// A number to 40 bits, the last half rounded away from zero; infinity stays: even segments differ
/// by the rounding of where their ends are, and would be kinds of their own.
inline double without_noise(double number) {
  constexpr std::uint64_t kDropped = 12;  // of the 52 bits after the leading one
  constexpr std::uint64_t kHalf = std::uint64_t{1} << (kDropped - 1);
  constexpr std::uint64_t kKept = ~((std::uint64_t{1} << kDropped) - 1);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(number) + kHalf) & kKept);
}

/// The moment at which a part's joints yield about an axis of the section [N m].
/// @param material  of the scene's own part
template <class Body>
double yield_moment(const Body& body, std::size_t part, std::size_t axis,
                    const MaterialValues<double>& material) {
  if (body.model.scene.yield_model == YieldModel::Elastic) {
    return std::numeric_limits<double>::infinity();
  }
  const chain::PartForm& form = body.parts[part];
  const MaterialValues<double> values = part == 0 ? material : material_values(*form.material);
  return form.form.modulus[axis] * law::uniaxial_material(form.form.axis[axis], values).yield;
}

}  // namespace plastica
