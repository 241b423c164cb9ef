#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/inference/verdict.hpp"
#include "calibrate/problem/law.hpp"

namespace plastica::calibrate {

/// Residual of a fit to one curve: what its likelihood is made of.
struct CurveResidual {
  double mean_square = 0.0;      ///< of the residuals, as the fit weighs them [SI^2]
  double largest = 0.0;          ///< largest measured value, the size of "no residual" [SI]
  double samples = 0.0;          ///< effective number by the weights, see `effective_samples`
  double autocorrelation = 0.0;  ///< of neighbouring residuals, see `autocorrelation`
  std::optional<double> noise;   ///< standard deviation, if it is known [SI]
  /// z^2 of the priors that the fit was weighed with (weighed_priors.hpp); 0 without any.
  double prior = 0.0;
};

/// Root of the mean of what is left of parts or specimens that a fit has not seen, as fractions
/// squared [1]; NaN of none.
double unseen_misfit(std::span<const double> squares);

/// One law's fit of some curves.
struct LawFit {
  Law law = Law::Ideal;
  bool fitted = false;
  std::vector<CurveResidual> curves;  ///< the same for all laws, in the same order
  /// Free ones that shape the curves (k); not break strains.
  std::vector<std::string> parameters;
  std::vector<Verdict> verdicts;  ///< of these
  std::size_t evaluations = 0;    ///< of the search, and of those that gave it its starts
  std::size_t runs = 0;           ///< of scenes in the search; 0: a coupon
  /// Time that the fit took [s]; NaN: not known.
  double seconds = std::numeric_limits<double>::quiet_NaN();
  double misfit_fraction = 0.0;  ///< rms over the largest measured value [1]
  bool lacks_fit = false;        ///< whether it does not describe a curve: `lacks_fit` below
  /// What is left of samples that the fit has not seen, as fractions of the largest value squared
  /// [1]: of each part of a curve (held_out.hpp), and of each specimen whose curve was predicted
  /// from others (unseen.hpp). Each mean is a square of a misfit.
  std::vector<double> parts, specimens;
};

/// What laws are ranked by, and how a report says it.
enum class RankedBy {
  Information,  ///< BIC
  Parts,        ///< parts of the curves that the fits have not seen
  Specimens,    ///< specimens that the fits have not seen
};

/// "BIC", "parts of the curve held out", "specimens not seen".
std::string_view name_of(RankedBy by);

/// A law among others, all fitted to the same curves.
///
/// Independent normal residuals r of standard deviation s have
///   -2 ln L = sum over the curves of (sum r^2/s^2 + n ln(2 pi s^2)).
/// Where s is not known it is a parameter as any other; L is greatest at the mean square of the
/// residuals, s^2 = sum r^2/n, and n ln s^2 is left, but for what all laws have alike. Where s is
/// stated it is the same for all laws, and sum r^2/s^2 = n (mean square)/s^2 is left: chi^2. Then
///   AIC = -2 ln L + 2 K,  AICc = AIC + 2 K (K + 1)/(N - K - 1),  BIC = -2 ln L + K ln N
/// with K the law's parameters and one for each unknown noise, N the sum of n. A prior adds its z^2
/// to -2 ln L: a law must not buy a smaller misfit by a modulus that the curve contradicts.
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
  double held_out = 0.0;  ///< rms misfit of parts held out, as a fraction; NaN: not known
  double unseen = 0.0;    ///< of specimens that were not seen; NaN: not known
  double aic = 0.0;
  double aicc = 0.0;  ///< infinite where N <= K + 1
  double bic = 0.0;
};

struct LawComparison {
  std::vector<ComparedLaw> laws;  ///< the best first; those that have no fit last
  RankedBy ranked_by = RankedBy::Information;
  double samples = 0.0;  ///< N
  /// Whether information compares them: N is at least ten for each curve. Below, the residuals are
  /// hardly more than one shape that no law has, and the price of a parameter, ln N, is nothing.
  bool is_informed = true;
  std::optional<std::size_t> advised;  ///< index into `laws`; empty if none was fitted
  std::string advice;                  ///< one sentence: which law and why
};

/// Compares fits of several laws to the same curves.
///
/// Where information compares them, the law with the least BIC is advised, but of those within 2 of
/// it the one with the fewest parameters (a smaller difference is "not worth more than a bare
/// mention", Kass & Raftery, J. Am. Stat. Assoc. 90 (1995) 773).
///
/// Where it does not, the law is advised that leaves the least squares of what it has not seen: of
/// three specimens and more, else of parts; but of laws that are as good, the one with the fewest
/// parameters. As good is what a misfit of parts 2 % larger than the best law's would leave; or 10
/// % larger, if the squares differ by no more than the standard error of the difference, that of
/// the mean of the differences part by part or specimen by specimen. It is the misfit of parts that
/// counts, of specimens, too: what specimens differ by is in all laws alike, and would hide that a
/// law cannot follow. Source: Breiman, Friedman, Olshen & Stone, Classification and Regression
/// Trees (1984), 3.4.3; both limits are ours: parts that all differ by next to nothing have next to
/// no error, and the difference of few parts may be one part's alone.
///
/// Where information decides against what specimens say that were not seen, the advice says so.
LawComparison compare_laws(std::vector<LawFit> fits);

/// The laws over several targets, as if each target had the law's parameters of its own: sums of
/// the targets that every law was fitted to; where there is none, of the laws that were fitted to
/// every target.
/// @param targets  the fits of each, a law each, the same laws
LawComparison compare_laws_over(std::vector<std::vector<LawFit>> targets);

}  // namespace plastica::calibrate
