#pragma once

#include <optional>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// What the slope of a curve's elastic part says of Young's modulus, as a prior of its fit.
///
/// The objective weighs samples by the strain that they stand for, and a law that cannot follow the
/// plastic part bends the elastic one to make up for it: both give E away, which the elastic part
/// alone knows well. With n samples' worth of residuals whose mean square is f,
///   -2 ln L = n ln f + z^2,  z = (E - mean)/standard_deviation,
/// is least where f + (f/n) z^2 is, f/n held: there f' + (f/n)(z^2)' = 0. So the cost has
/// variance z^2 added, with variance = f/n, which is found by repeating the search. Of a law that
/// leaves nothing, f = 0, the prior says nothing; where residuals are one long run (n = 1) it is
/// worth as much as the whole curve.
struct ModulusPrior {
  double mean = 0.0;                ///< of the elastic slope [Pa]
  double standard_deviation = 0.0;  ///< [Pa]
  double variance = 0.0;            ///< f/n [Pa^2]
};

/// The prior of a target's fit, its variance 0; empty where there is none: the options take it out,
/// E is not free, or the slope is not one of the curve's own (bending, torsion, a chord, given).
///
/// The standard deviation is that of the regression, 2 % and what the window decides, together. A
/// slope has errors that its scatter does not show, such as a class 1 extensometer's (ISO 9513:
/// 1 %) or a bent specimen's. And the part that is taken for elastic may not be straight, of metals
/// that yield early or a grip that slips: the slopes of the window's quarters are measurements of
/// their own, and where they differ by more than noise the standard error of their mean counts
/// (batch means: Schmeiser, Oper. Res. 30 (1982) 556).
std::optional<ModulusPrior> modulus_prior(const Target& target, const FitOptions& options);

}  // namespace plastica::calibrate
