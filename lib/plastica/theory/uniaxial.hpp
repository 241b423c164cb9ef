#pragma once

#include "plastica/model/material.hpp"

namespace plastica::theory {

// Closed forms of the uniaxial response; stresses [Pa], moduli [Pa], strains [1].

/// Ideal plasticity, monotonic from the virgin state: E strain, held at +-sigma_y.
double ideal_plastic_stress(double strain, double youngs_modulus, double yield_stress);

/// Ideal plasticity after one reversal: loaded to `turning_strain`, then back to `strain`.
///
/// sigma = sigma_t - E (eps_t - eps), held at the opposite yield stress.
/// @param strain  on the way back: below turning_strain if that is positive, above if negative
double ideal_plastic_unloading_stress(double strain, double turning_strain, double youngs_modulus,
                                      double yield_stress);

/// Permanent strain of ideal plasticity after monotonic loading: eps - sigma/E.
double ideal_plastic_permanent_strain(double strain, double youngs_modulus, double yield_stress);

/// Linear hardening, monotonic: E strain up to yield, then with slope E_t.
double bilinear_stress(double strain, double youngs_modulus, double yield_stress,
                       double tangent_modulus);

/// Voce: sigma_y + Q (1 - exp(-b p)).
/// Source: Voce, J. Inst. Metals 74 (1948) 537.
/// @param accumulated_strain  p, accumulated plastic strain [1], >= 0
double voce_yield_stress(double accumulated_strain, double yield_stress, double saturation_stress,
                         double saturation_rate);

/// An Armstrong-Frederick back-stress after plastic flow in one direction.
///
/// X = d C/gamma + (X_0 - d C/gamma) exp(-gamma |increment|), d the sign of the increment;
/// X_0 + C increment for gamma = 0. Source: Lemaitre & Chaboche, Mechanics of Solid Materials,
/// 1990, ch. 5, integral of dX = C de_p - gamma X dp.
/// @param start      X_0 [Pa]
/// @param increment  plastic strain since X_0 [1], either sign
double backstress(double start, double increment, double modulus, double rate);

/// Amplitude of a back-stress on the stabilized symmetric cycle: (C/gamma) tanh(gamma a).
/// Source: as backstress; X(-a -> a) = -X(a -> -a).
/// @param plastic_amplitude  a, half of the plastic strain range [1], >= 0
double stabilized_backstress(double plastic_amplitude, double modulus, double rate);

/// Stress of monotonic tension from the virgin state at a plastic strain, all hardening laws; slow,
/// without what a rate law adds.
/// The total strain is plastic_strain + stress/E.
/// @param plastic_strain  [1], >= 0 @throws std::domain_error if it is not
double monotonic_stress(double plastic_strain, const Material& material);

/// The same at a total strain, by bisection to the last bit of the plastic strain.
/// @param strain  [1], >= 0 @throws std::domain_error if it is not
double tension_stress(double strain, const Material& material);

}  // namespace plastica::theory
