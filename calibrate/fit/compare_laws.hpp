#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/fit/law.hpp"
#include "calibrate/fit/verdict.hpp"

namespace plastica::calibrate {

/// What a fit leaves of one curve: what its likelihood is made of.
struct Leftover {
  double mean_square = 0.0;      ///< of the residuals, as the fit weighs them [SI^2]
  double largest = 0.0;          ///< largest measured value, the size of "nothing left" [SI]
  double samples = 0.0;          ///< effective number by the weights, see `effective_samples`
  double autocorrelation = 0.0;  ///< of neighbouring residuals, see `autocorrelation`
  std::optional<double> noise;   ///< standard deviation, if it is known [SI]
};

/// One law's fit of some curves.
struct LawFit {
  Law law = Law::Ideal;
  bool fitted = false;
  std::vector<Leftover> curves;  ///< the same for all laws, in the same order
  /// Free ones that shape the curves (k); not break strains.
  std::vector<std::string> parameters;
  std::vector<Verdict> verdicts;  ///< of these
  std::size_t evaluations = 0;    ///< what the search cost
  double misfit_share = 0.0;      ///< rms over the largest measured value [1]
  bool lacks_fit = false;         ///< whether it does not describe a curve: `lacks_fit` below
};

/// A law among others, all fitted to the same curves.
///
/// With independent normal residuals of unknown size the likelihood's maximum leaves, but for what
/// all laws have alike, -2 ln L = sum over the curves of n ln s^2, s^2 the mean square of the
/// residuals (n s^2/noise^2 where the noise is known), and
///   AIC = -2 ln L + 2 K,  AICc = AIC + 2 K (K + 1)/(N - K - 1),  BIC = -2 ln L + K ln N
/// with K the law's parameters and one for each unknown noise, N the sum of n.
///
/// n is no count of samples but of what they are worth. Weighted ones count (sum w)^2/sum w^2
/// (Kish); the objective over the strain path is such a weighted sum. Neighbours alike, as in an
/// autoregressive process of correlation rho, count (1 - rho)/(1 + rho) of that (Bayley and
/// Hammersley). rho is that of the law with the least misfit: of all it shows best what is noise.
/// Where no law describes the curve, that is too large, n too small, and the differences between
/// laws come out too small rather than too large.
/// Sources: Burnham & Anderson, Model Selection and Multimodel Inference (2002), ch. 2 and 6;
/// Kish, Survey Sampling (1965), 11.7; Bayley & Hammersley, J. R. Stat. Soc. Suppl. 8 (1946) 184.
struct ComparedLaw {
  LawFit fit;
  double aic = 0.0;
  double aicc = 0.0;  ///< infinite where N <= K + 1
  double bic = 0.0;
};

struct LawComparison {
  std::vector<ComparedLaw> laws;       ///< by rising BIC; those that have no fit last
  double samples = 0.0;                ///< N
  std::optional<std::size_t> advised;  ///< index into `laws`; empty if none was fitted
  std::string advice;                  ///< one sentence: which law and why
};

/// Compares fits of several laws to the same curves. The law with the least BIC is advised, but of
/// those within 2 of it the one with the fewest parameters (a smaller difference is "not worth more
/// than a bare mention", Kass & Raftery, J. Am. Stat. Assoc. 90 (1995) 773).
LawComparison compare_laws(std::vector<LawFit> fits);

/// (sum w)^2/sum w^2.
double effective_samples(std::span<const double> weight);

/// sum r_i r_{i-1}/sum r_i^2; 0 for residuals that all vanish.
double autocorrelation(std::span<const double> residual);

/// Whether a law does not describe a curve, as far as the residuals tell: where they lie in runs
/// that noise would not (`kFewRuns`) and are more than 1 % of the largest value. For curves too
/// short to count runs, where they are more than 5 % of it.
/// @param share  rms of the residuals over the largest measured value
bool lacks_fit(double share, double runs_probability);

/// Says that it does not, and what to try; empty where it does.
/// @param try_next  `laws_to_try`
std::string lack_of_fit(std::string_view law, double share, double runs_probability,
                        std::string_view try_next);

}  // namespace plastica::calibrate
