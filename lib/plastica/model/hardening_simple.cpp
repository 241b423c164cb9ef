#include <array>

#include "plastica/model/check_value.hpp"
#include "plastica/model/hardening_parts.hpp"

namespace plastica::model_detail {
namespace {

class Ideal final : public HardeningKind {
 public:
  HardeningLaw law() const override { return HardeningLaw::Ideal; }
  std::string_view word() const override { return "ideal"; }
  std::string_view phrase() const override { return "ideal plasticity"; }
  std::span<const Field> parameters() const override { return {}; }
  std::optional<BrokenRule> broken_rule(const MaterialValues<double>& /*values*/) const override {
    return {};
  }
  HardeningGrowth growth(const Hardening& /*h*/) const override { return HardeningGrowth::None; }
  double monotonic_stress(double /*plastic_strain*/, const Material& material) const override {
    return material.yield_stress;
  }
};

class Linear final : public HardeningKind {
 public:
  HardeningLaw law() const override { return HardeningLaw::Linear; }
  std::string_view word() const override { return "linear"; }
  std::string_view phrase() const override { return "linear hardening"; }
  std::span<const Field> parameters() const override {
    static constexpr std::array<Field, 2> kFields{
        number<PLASTICA_REACH(scene.material.hardening.tangent_modulus)>(
            "material.hardening.tangent_modulus", Dimension::Stress, kNotNegative,
            "linear: slope of the stress-strain curve after yield, below E",
            MaterialField::TangentModulus),
        kKinematicFraction};
    return kFields;
  }
  std::optional<BrokenRule> broken_rule(const MaterialValues<double>& values) const override {
    const double young = number_of(values, MaterialField::YoungsModulus);
    if (number_of(values, MaterialField::TangentModulus) < young) return {};
    return BrokenRule{MaterialField::TangentModulus,
                      "must be below material.youngs_modulus = " + number_text(young)};
  }
  HardeningGrowth growth(const Hardening& h) const override {
    return h.tangent_modulus > 0.0 ? HardeningGrowth::Goes : HardeningGrowth::None;
  }
  double monotonic_stress(double plastic_strain, const Material& material) const override {
    return material.yield_stress +
           plastic_modulus(material.youngs_modulus, material.hardening.tangent_modulus) *
               plastic_strain;
  }
};

}  // namespace

const HardeningKind& ideal_kind() {
  static const Ideal kind;
  return kind;
}

const HardeningKind& linear_kind() {
  static const Linear kind;
  return kind;
}

}  // namespace plastica::model_detail
