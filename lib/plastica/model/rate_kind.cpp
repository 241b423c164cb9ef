#include "plastica/model/rate_kind.hpp"

#include <array>
#include <cstddef>

#include "plastica/model/field_table.hpp"

namespace plastica {
namespace {

using model_detail::kNotNegative;
using model_detail::kPositive;
using model_detail::number;

constexpr Field kReferenceRate = number<PLASTICA_REACH(scene.material.rate.reference_rate)>(
    "material.rate.reference_rate", Dimension::StrainRate, kPositive,
    "cowper_symonds: C, at which the stress is doubled; johnson_cook: below which nothing changes",
    MaterialField::ReferenceRate);
constexpr Field kStrainRate = number<PLASTICA_REACH(scene.material.rate.strain_rate)>(
    "material.rate.strain_rate", Dimension::StrainRate, kPositive,
    "the rate of all; unset: in a motion each point has its own, elsewhere it must be set");
constexpr std::array<Field, 3> kCowperSymonds{
    kReferenceRate,
    number<PLASTICA_REACH(scene.material.rate.exponent)>(
        "material.rate.exponent", Dimension::None, Range{1.0},
        "cowper_symonds: P of 1 + (rate/C)^(1/P)", MaterialField::RateExponent),
    kStrainRate};
constexpr std::array<Field, 3> kJohnsonCook{
    kReferenceRate,
    number<PLASTICA_REACH(scene.material.rate.coefficient)>(
        "material.rate.coefficient", Dimension::None, kNotNegative,
        "johnson_cook: c of 1 + c ln(rate/reference_rate)", MaterialField::RateCoefficient),
    kStrainRate};

constexpr RateKind kNoneKind(RateLaw::None, "none", {});
constexpr RateKind kCowperSymondsKind(RateLaw::CowperSymonds, "cowper_symonds", kCowperSymonds);
constexpr RateKind kJohnsonCookKind(RateLaw::JohnsonCook, "johnson_cook", kJohnsonCook);
// In the order of their enumerators.
constexpr std::array<const RateKind*, 3> kKinds{&kNoneKind, &kCowperSymondsKind, &kJohnsonCookKind};

}  // namespace

std::span<const RateKind* const> rate_kinds() { return kKinds; }

const RateKind& rate_kind(RateLaw law) {
  const auto index = static_cast<std::size_t>(law);
  if (index < kKinds.size()) return *kKinds[index];
  throw InputError({}, "material.rate.law", std::to_string(static_cast<int>(law)),
                   "is none of the laws that there are");
}

}  // namespace plastica
