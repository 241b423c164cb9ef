#include "calibrate/search/start_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "calibrate/problem/given_weights.hpp"
#include "calibrate/target/characteristics.hpp"
#include "plastica/coupon/shape.hpp"

namespace plastica::calibrate {
namespace {

double largest_weighted_stress(const Curve& curve, const FitOptions& options) {
  if (options.weights.empty()) return largest_magnitude(curve.stress);
  double stress = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (given_weight(options.weights, curve.strain[i]) > 0.0) {
      stress = std::max(stress, std::fabs(curve.stress[i]));
    }
  }
  return stress;
}

/// A factor around the start, within the field's range.
StartValue around(double start, double factor) { return {start, start / factor, start * factor}; }

/// A turn of the strain: where, the stress there, and how far the stroke to it went.
struct Turn {
  double strain = 0.0, stress = 0.0, range = 0.0;
};

/// Where the strain turns back by a twentieth of its range: less is noise.
std::vector<Turn> turns_of(const Curve& curve) {
  constexpr double kTurns = 0.05;
  const std::vector<double>& strain = curve.strain;
  const auto [low, high] = std::minmax_element(strain.begin(), strain.end());
  const double least = kTurns * (*high - *low);
  std::vector<Turn> turns;
  std::size_t furthest = 0;
  double from = 0.0, sign = 0.0;
  const auto turn = [&] {
    turns.push_back({strain[furthest], curve.stress[furthest], strain[furthest] - from});
    from = strain[furthest];
  };
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const double beyond = strain[i] - strain[furthest];
    if (sign == 0.0) {
      if (std::abs(strain[i] - strain[0]) > least) sign = std::copysign(1.0, strain[i] - strain[0]);
      furthest = i;
    } else if (sign * beyond > 0.0) {
      furthest = i;
    } else if (-sign * beyond > least) {
      turn();
      sign = -sign;
      furthest = i;
    }
  }
  if (sign != 0.0) turn();
  return turns;
}

/// Whether a cyclic curve carries less than before at the end of a stroke that went no less far,
/// from and to, in the same direction: by a hundredth, and by 8 times the noise.
bool softens(const Target& target) {
  if (target.loading != Loading::Cyclic) return false;
  constexpr double kLess = 0.01, kNoises = 8.0, kAsFar = 0.99;
  const Curve& curve = target.corrected;
  const double least = std::max(kLess * largest_magnitude(curve.stress),
                                kNoises * noise_of(curve.strain, curve.stress));
  const std::vector<Turn> turns = turns_of(curve);
  for (std::size_t later = 1; later < turns.size(); ++later) {
    for (std::size_t i = 0; i < later; ++i) {
      const Turn &a = turns[i], &b = turns[later];
      const double sign = std::copysign(1.0, a.range);
      const bool as_far = sign * b.range >= kAsFar * std::abs(a.range) &&
                          sign * (b.strain - a.strain) >= (kAsFar - 1.0) * std::abs(a.range);
      if (as_far && sign * (a.stress - b.stress) > least) return true;
    }
  }
  return false;
}

/// Of what saturates: it hardens, unless the curve shows that it softens.
StartValue saturation_start(double stress, const Target& target) {
  if (!softens(target)) return around(0.3 * stress, 100.0);
  return {-0.1 * stress, -stress, 30.0 * stress};
}

/// Of a rate law: as given, or what is usual of steel.
StartValue rate_start(MaterialField field, const RateDependence& rate) {
  switch (field) {
    case MaterialField::ReferenceRate: return around(rate.reference_rate.value_or(1.0), 1e4);
    case MaterialField::RateExponent: return {rate.exponent.value_or(5.0), 1.0, 50.0};
    default: return {rate.coefficient.value_or(0.01), 0.0, 1.0};
  }
}

StartValue raw_start(MaterialField field, const CurveSizes& s, const Target& target,
                     const FitOptions& options) {
  const Material& material = options.setup.scene.material;
  const bool torsion = target.test == Test::Torsion;
  const double yield_ratio = torsion ? std::sqrt(3.0) : 1.0;
  switch (field) {
    case MaterialField::YoungsModulus: {
      const double ratio = torsion ? 2.0 * (1.0 + material.poisson_ratio) : 1.0;
      return around(s.modulus * ratio, 30.0);
    }
    case MaterialField::ShearModulus: return around(s.modulus, 30.0);
    case MaterialField::PoissonRatio: return {material.poisson_ratio, 0.0, 0.5};
    case MaterialField::YieldStress: return around(s.yield * yield_ratio, 30.0);
    case MaterialField::ShearYieldStress: return around(s.yield, 30.0);
    case MaterialField::BreakStrain:
    case MaterialField::BreakShearStrain: {
      const double permanent = target.characteristics.break_strain_plastic.value_or(0.0);
      const double by_test = field == MaterialField::BreakStrain ? yield_ratio : 1.0;
      const double start = (permanent > 0.0 ? permanent : s.strain) / by_test;
      StartValue found = around(start, 30.0);
      // One that broke without any has next to none.
      const bool broke = target.characteristics.observed_break.has_value();
      if (broke && !(permanent > 0.0)) found = {start / 30.0, 1e-4 * start, found.upper};
      return found;
    }
    case MaterialField::TangentModulus: {
      // Hardening moduli of torsion are a third of those of tension; E is 2(1+nu) G.
      const double young = torsion ? 2.0 * (1.0 + material.poisson_ratio) * s.modulus : s.modulus;
      return {torsion ? 3.0 * s.slope : s.slope, 0.0, 0.999 * young};
    }
    case MaterialField::KinematicFraction: return {0.5, 0.0, 1.0};
    case MaterialField::SaturationStress: return saturation_start(s.stress, target);
    case MaterialField::SaturationRate: return around(3.0 / s.strain, 1000.0);
    // Back stresses that each carry a fifth of the stress and are full after 3 %, 30 % of the
    // strain and never.
    case MaterialField::BackModulus1: return around(6.0 * s.stress / s.strain, 1000.0);
    case MaterialField::BackModulus2: return around(0.6 * s.stress / s.strain, 1000.0);
    case MaterialField::BackModulus3: return around(0.06 * s.stress / s.strain, 1000.0);
    case MaterialField::BackRate1: return around(30.0 / s.strain, 1000.0);
    case MaterialField::BackRate2: return around(3.0 / s.strain, 1000.0);
    case MaterialField::BackRate3: return around(0.3 / s.strain, 1000.0);
    case MaterialField::ReferenceRate:
    case MaterialField::RateExponent:
    case MaterialField::RateCoefficient: return rate_start(field, material.rate);
    default: break;
  }
  // The table as it is given.
  const double given = number_of(material_values(material), field);
  return {given, 0.0, 10.0 * given};
}

/// The yield stress in shear, of one in tension of 1; 0: it does not follow that.
double shear_over_yield(const FitOptions& options) {
  for (const Parameter& p : options.parameters) {
    if (p.field->material != MaterialField::ShearYieldStress) continue;
    const bool follows =
        p.role == ParameterRole::Tied && p.tied_to->material == MaterialField::YieldStress;
    return follows ? p.factor : 0.0;
  }
  const Scene& scene = options.setup.scene;
  if (scene.material.shear_yield_stress) return 0.0;
  return scene.formulas == Formulas::Report ? 1.0 : 1.0 / std::sqrt(3.0);
}

}  // namespace

CurveSizes curve_sizes(const Target& target, const FitOptions& options) {
  const Characteristics& c = target.characteristics;
  CurveSizes s;
  s.stress = largest_magnitude(target.corrected.stress);
  s.strain = largest_magnitude(target.corrected.strain);
  s.modulus = c.youngs_modulus.value_or(s.stress / s.strain);
  const double strength = c.rm.value_or(s.stress);
  const double proof = c.proof_stress.value_or(strength);
  if (target.loading == Loading::Cyclic) {
    s.yield = 0.8 * s.stress;
  } else if (options.setup.scene.material.hardening.law == HardeningLaw::Ideal) {
    s.yield = 0.5 * (proof + strength);
  } else {
    s.yield = proof;
  }
  // The largest of noisy stresses lies above the plateau, where the model does not yield at all and
  // no slope leads back.
  if (!c.proof_stress && target.loading == Loading::Monotonic) s.yield *= 0.95;
  const double strain_at_proof = proof / s.modulus;
  const double run = c.strain_at_rm.value_or(s.strain) - strain_at_proof;
  if (run > 0.0) s.slope = std::max(0.0, (strength - proof) / run);
  return s;
}

StartValue start_value(const Field& field, const CurveSizes& sizes, const Target& target,
                       const FitOptions& options) {
  StartValue value = raw_start(*field.material, sizes, target, options);
  value.lower = std::max(value.lower, field.range.low);
  value.upper = std::min(value.upper, field.range.high);
  value.start = std::clamp(value.start, value.lower, value.upper);
  return value;
}

double largest_useful_value(const Field& field, const Target& target, const FitOptions& options) {
  const bool torsion = target.test == Test::Torsion;
  const bool shear = field.material == MaterialField::ShearYieldStress;
  if ((field.material != MaterialField::YieldStress && !shear) || (shear && !torsion)) {
    return std::numeric_limits<double>::infinity();
  }
  const double stress = largest_weighted_stress(target.corrected, options);
  if (target.test == Test::Tension) return stress;
  Scene scene = options.setup.scene;
  scene.drive.deformation = target.test;
  const double cap = coupon::coupon_shape(scene).cap_factor;
  if (!torsion || shear) return stress / cap;
  const double ratio = shear_over_yield(options);
  return ratio > 0.0 ? stress / cap / ratio : std::numeric_limits<double>::infinity();
}

}  // namespace plastica::calibrate
