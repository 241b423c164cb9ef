#include <array>
#include <cmath>

#include "plastica/model/check_value.hpp"
#include "plastica/model/hardening_parts.hpp"

namespace plastica::model_detail {
namespace {

class VoceChaboche final : public HardeningKind {
 public:
  HardeningLaw law() const override { return HardeningLaw::VoceChaboche; }
  std::string_view word() const override { return "voce_chaboche"; }
  std::string_view phrase() const override { return "Voce-Chaboche hardening"; }
  std::span<const Field> parameters() const override {
    using enum Dimension;
    static constexpr std::array<Field, 8> kFields{
        number<PLASTICA_REACH(scene.material.hardening.saturation_stress)>(
            "material.hardening.saturation_stress", Stress, Range{},
            "voce_chaboche: Q, growth of the yield stress", MaterialField::SaturationStress),
        number<PLASTICA_REACH(scene.material.hardening.saturation_rate)>(
            "material.hardening.saturation_rate", None, kNotNegative,
            "voce_chaboche: b, how fast Q is reached", MaterialField::SaturationRate),
        number<PLASTICA_REACH(scene.material.hardening.backstress_modulus[0])>(
            "material.hardening.backstress_modulus_1", Stress, kNotNegative,
            "voce_chaboche: C of the first back stress", MaterialField::BackModulus1),
        number<PLASTICA_REACH(scene.material.hardening.backstress_modulus[1])>(
            "material.hardening.backstress_modulus_2", Stress, kNotNegative,
            "voce_chaboche: C of the second back stress", MaterialField::BackModulus2),
        number<PLASTICA_REACH(scene.material.hardening.backstress_modulus[2])>(
            "material.hardening.backstress_modulus_3", Stress, kNotNegative,
            "voce_chaboche: C of the third back stress", MaterialField::BackModulus3),
        number<PLASTICA_REACH(scene.material.hardening.backstress_rate[0])>(
            "material.hardening.backstress_rate_1", None, kNotNegative,
            "voce_chaboche: gamma of the first back stress", MaterialField::BackRate1),
        number<PLASTICA_REACH(scene.material.hardening.backstress_rate[1])>(
            "material.hardening.backstress_rate_2", None, kNotNegative,
            "voce_chaboche: gamma of the second back stress", MaterialField::BackRate2),
        number<PLASTICA_REACH(scene.material.hardening.backstress_rate[2])>(
            "material.hardening.backstress_rate_3", None, kNotNegative,
            "voce_chaboche: gamma of the third back stress", MaterialField::BackRate3)};
    return kFields;
  }
  std::optional<BrokenRule> broken_rule(const MaterialValues<double>& values) const override {
    const double yield = number_of(values, MaterialField::YieldStress);
    if (number_of(values, MaterialField::SaturationStress) > -yield) return {};
    return BrokenRule{MaterialField::SaturationStress,
                      "must be above -material.yield_stress = " + number_text(-yield)};
  }
  HardeningGrowth growth(const Hardening& h) const override {
    // A back stress without recovery grows for ever.
    for (std::size_t k = 0; k < h.backstress_modulus.size(); ++k) {
      if (h.backstress_modulus[k] > 0.0 && h.backstress_rate[k] == 0.0) {
        return HardeningGrowth::Goes;
      }
    }
    return HardeningGrowth::Saturates;
  }
  double monotonic_stress(double plastic_strain, const Material& material) const override {
    const Hardening& h = material.hardening;
    double stress = material.yield_stress -
                    h.saturation_stress * std::expm1(-h.saturation_rate * plastic_strain);
    for (std::size_t i = 0; i < h.backstress_modulus.size(); ++i) {
      const double rate = h.backstress_rate[i];
      const double flow = rate > 0.0 ? -std::expm1(-rate * plastic_strain) / rate : plastic_strain;
      stress += h.backstress_modulus[i] * flow;
    }
    return stress;
  }
};

}  // namespace

const HardeningKind& voce_chaboche_kind() {
  static const VoceChaboche kind;
  return kind;
}

}  // namespace plastica::model_detail
