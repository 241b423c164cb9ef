#pragma once

#include <limits>
#include <optional>
#include <string>

#include "calibrate/inference/verdict.hpp"
#include "calibrate/problem/parameter.hpp"
#include "plastica/base/quantity.hpp"

namespace plastica::calibrate {

/// What a fit says of one parameter [SI]. What there is not is NaN.
struct FittedParameter {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string path;  ///< "material.yield_stress"
  Dimension dimension = Dimension::None;
  ParameterRole role = ParameterRole::Free;
  double value = 0.0;
  double start = 0.0;
  double lower = 0.0;  ///< bounds; equal to the value if fixed or tied
  double upper = 0.0;
  bool logarithmic = false;  ///< whether it was searched by its logarithm
  /// As one of the material: from noise, sampling, misfit and segments, whose squares add up; NaN
  /// for fixed parameters, at a bound, and where the curves do not determine it.
  double standard_error = kNone;
  /// What of it is the noise's, as if residuals were independent, and of coupons the errors of the
  /// strain that many samples share (strain_errors.hpp).
  double noise_error = kNone;
  /// What of it is a break's, which lies anywhere between two samples: half its interval over the
  /// root of 3; 0 of all others.
  double sampling_error = 0.0;
  /// What residuals that lie in runs, as those of a model that cannot follow, add to it, as the
  /// root of a difference of squares: of a coupon by how alike neighbours are, through scenes after
  /// Newey and West (material_interval.hpp, score_covariance.hpp). So does the scatter of targets
  /// that share the parameters and differ (unlike_targets.hpp). 0 where they are noise, NaN where
  /// it is not known.
  double misfit_error = kNone;
  /// Confidence interval of the material's, from all of these errors together
  /// (material_interval.hpp). With segments it lies about the extrapolated value, not about
  /// `value`.
  double interval_low = kNone;
  double interval_high = kNone;
  /// Of the noise in the standard error, after Welch and Satterthwaite: those of the targets that
  /// determine it. Infinite where they state their noise.
  double degrees_of_freedom = kNone;
  bool at_lower = false;
  bool at_upper = false;
  bool identified = true;  ///< free: whether the curves determine it
  /// Free and fitted: how well the curves determine it, and the number behind the word
  /// (verdict.hpp).
  std::optional<Judgement> judgement;

  std::string name() const;  ///< "yield_stress" of "material.yield_stress"
  /// Whether it is a break strain, in tension or in torsion.
  bool is_break() const;
  bool at_bound() const { return at_lower || at_upper; }
  /// Takes errors and interval of the one that it is tied to, times the factor.
  void follow(const FittedParameter& base, double factor);
  /// How far the value would move in another test of the same specimen: noise and sampling.
  double scatter_error() const;
  /// What noise and lack of fit make of it; of the noise alone where the other is not known.
  double model_error() const;
  bool has_error() const { return standard_error == standard_error; }
  /// Not identified, and NaN, where nothing was judged.
  Verdict verdict() const { return judgement ? judgement->verdict : Verdict::NotIdentified; }
  double verdict_number() const { return judgement ? judgement->number : kNone; }
};

}  // namespace plastica::calibrate
