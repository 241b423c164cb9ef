#include "plastica/model/hardening_kind.hpp"

#include <array>
#include <cstddef>

#include "plastica/model/hardening_parts.hpp"

namespace plastica {

std::span<const HardeningKind* const> hardening_kinds() {
  using namespace model_detail;
  // In the order of their enumerators.
  static const std::array<const HardeningKind*, 4> kinds{
      &ideal_kind(), &linear_kind(), &voce_chaboche_kind(), &multilinear_kind()};
  return kinds;
}

const HardeningKind& hardening_kind(HardeningLaw law) {
  const auto kinds = hardening_kinds();
  const auto index = static_cast<std::size_t>(law);
  if (index < kinds.size()) return *kinds[index];
  throw InputError({}, "material.hardening.law", std::to_string(static_cast<int>(law)),
                   "is none of the laws that there are");
}

}  // namespace plastica
