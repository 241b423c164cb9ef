#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "plastica/model/check_value.hpp"
#include "plastica/model/hardening_parts.hpp"

namespace plastica::model_detail {
namespace {

constexpr std::size_t kPoints = Hardening::kTablePoints;
/// How steeply a table may fall [Pa]: by a tenth of what a point of the material would snap back
/// from, in tension or shear.
double steepest_fall(const MaterialValues<double>& values) {
  const double young = number_of(values, MaterialField::YoungsModulus);
  const double given = number_of(values, MaterialField::ShearModulus);
  const double nu = number_of(values, MaterialField::PoissonRatio);
  const double shear = given > 0.0 ? given : young / (2.0 * (1.0 + nu));
  const double shear_yield = number_of(values, MaterialField::ShearYieldStress);
  const double ratio = shear_yield > 0.0
                           ? number_of(values, MaterialField::YieldStress) / shear_yield
                           : std::numbers::sqrt3;
  return 0.1 * std::min(young, shear * ratio * ratio);
}

constexpr std::array<std::string_view, kPoints> kStrains{
    "material.hardening.plastic_strain_1", "material.hardening.plastic_strain_2",
    "material.hardening.plastic_strain_3", "material.hardening.plastic_strain_4",
    "material.hardening.plastic_strain_5", "material.hardening.plastic_strain_6",
    "material.hardening.plastic_strain_7", "material.hardening.plastic_strain_8",
    "material.hardening.plastic_strain_9", "material.hardening.plastic_strain_10"};
constexpr std::array<std::string_view, kPoints> kStresses{
    "material.hardening.flow_stress_1", "material.hardening.flow_stress_2",
    "material.hardening.flow_stress_3", "material.hardening.flow_stress_4",
    "material.hardening.flow_stress_5", "material.hardening.flow_stress_6",
    "material.hardening.flow_stress_7", "material.hardening.flow_stress_8",
    "material.hardening.flow_stress_9", "material.hardening.flow_stress_10"};

constexpr MaterialField at(MaterialField first, std::size_t point) {
  return static_cast<MaterialField>(static_cast<std::size_t>(first) + point);
}

template <std::size_t I>
constexpr Field kStrain = number < [](auto& setup) -> auto& {
  return setup.scene.material.hardening.plastic_strain[I];
}
> (kStrains[I], Dimension::Strain, kNotNegative,
   "multilinear: plastic strain of a point of the table", at(MaterialField::PlasticStrain1, I));

template <std::size_t I>
constexpr Field kStress = number < [](auto& setup) -> auto& {
  return setup.scene.material.hardening.flow_stress[I];
}
> (kStresses[I], Dimension::Stress, kNotNegative, "multilinear: stress of a point of the table",
   at(MaterialField::FlowStress1, I));

template <std::size_t... I>
constexpr std::array<Field, 2 * kPoints + 1> all_fields(std::index_sequence<I...>) {
  return {kStrain<I>..., kStress<I>..., kKinematicFraction};
}

class Multilinear final : public HardeningKind {
 public:
  HardeningLaw law() const override { return HardeningLaw::Multilinear; }
  std::string_view word() const override { return "multilinear"; }
  std::string_view phrase() const override { return "multilinear hardening"; }
  std::span<const Field> parameters() const override {
    static constexpr auto kFields = all_fields(std::make_index_sequence<kPoints>());
    return kFields;
  }
  std::optional<BrokenRule> broken_rule(const MaterialValues<double>& values) const override {
    const double steepest = steepest_fall(values);
    double strain = 0.0;
    double stress = number_of(values, MaterialField::YieldStress);
    bool ended = false;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double next_strain = number_of(values, MaterialField::PlasticStrain1, i);
      const double next_stress = number_of(values, MaterialField::FlowStress1, i);
      if (next_strain == 0.0 && next_stress == 0.0) {
        ended = true;
        continue;
      }
      if (ended || next_strain <= strain) {
        return BrokenRule{at(MaterialField::PlasticStrain1, i),
                          i == 0 ? "must be above 0, where the stress is material.yield_stress"
                          : next_strain == 0.0 ? "must be above 0: the point's flow stress has none"
                          : ended              ? "must follow the points before it without a gap"
                                  : "must be above the one before, " + number_text(strain)};
      }
      const double least = stress - steepest * (next_strain - strain);
      if (next_stress <= 0.0 || next_stress < least) {
        return BrokenRule{at(MaterialField::FlowStress1, i),
                          next_stress == 0.0
                              ? "must be above 0: the point's plastic strain has none"
                          : next_stress < 0.0
                              ? "must be above 0"
                              : "falls from " + number_text(stress) + " more steeply than " +
                                    number_text(steepest) + " Pa, a tenth of the elastic modulus"};
      }
      strain = next_strain;
      stress = next_stress;
    }
    if (strain > 0.0) return {};
    return BrokenRule{MaterialField::PlasticStrain1, "must be above 0: the table has no point"};
  }
  bool softens(const Material& material) const override {
    const Hardening& h = material.hardening;
    double stress = material.yield_stress;
    for (std::size_t i = 0; i < kPoints && h.plastic_strain[i] > 0.0; ++i) {
      if (h.flow_stress[i] < stress) return true;
      stress = h.flow_stress[i];
    }
    return false;
  }
  HardeningGrowth growth(const Hardening& /*h*/) const override {
    return HardeningGrowth::Saturates;
  }
  double monotonic_stress(double plastic_strain, const Material& material) const override {
    const Hardening& h = material.hardening;
    double strain = 0.0;
    double stress = material.yield_stress;
    for (std::size_t i = 0; i < kPoints && h.plastic_strain[i] > 0.0; ++i) {
      if (plastic_strain < h.plastic_strain[i]) {
        const double fraction = (plastic_strain - strain) / (h.plastic_strain[i] - strain);
        return stress + fraction * (h.flow_stress[i] - stress);
      }
      strain = h.plastic_strain[i];
      stress = h.flow_stress[i];
    }
    return stress;
  }
};

}  // namespace

const HardeningKind& multilinear_kind() {
  static const Multilinear kind;
  return kind;
}

}  // namespace plastica::model_detail
