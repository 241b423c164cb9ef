#pragma once

#include <span>
#include <string>
#include <string_view>

/// What residuals say of the law that left them.
namespace plastica::calibrate {

/// What weighted samples count: (sum w)^2/sum w^2.
/// Source: Kish, Survey Sampling (1965), 11.7.
double effective_samples(std::span<const double> weight);

/// sum r_i r_{i-1}/sum r_i^2; 0 for residuals that all vanish.
double autocorrelation(std::span<const double> residual);

/// What samples are worth whose residuals are alike by rho, as those of an autoregressive process:
/// n (1 - rho)/(1 + rho), with rho within [0, 0.999]. Source: Bayley &
/// Hammersley, J. R. Stat. Soc. Suppl. 8 (1946) 184.
double samples_worth(double samples, double autocorrelation);

/// What residuals say of a noise that is stated.
enum class StatedNoise { Fits, TooSmall, TooLarge };
/// Too small or too large where noise would leave such residuals once in a thousand times, and, so
/// that a careful statement passes, at most half as large as stated. By the squares of the
/// residuals over the noise, chi^2, of which sqrt(2 chi^2) is about normal.
/// Source: Fisher, Statistical Methods for Research Workers (1925), 20.
/// @param over     root mean square of the residuals, by their degrees of freedom, over it [1]
/// @param degrees  of freedom of the residuals, > 0.5; fewer tell nothing
StatedNoise judge_stated_noise(double over, double degrees);

/// Whether a law does not describe a curve, as far as the residuals tell: where they lie in runs
/// that noise would not (`kFewRuns`) and are more than 1 % of the largest value. For curves too
/// short to count runs, where they are more than 5 % of it.
/// @param fraction  rms of the residuals over the largest measured value
bool lacks_fit(double fraction, double runs_test_p);

/// How well a law describes a curve, in one word for all that speaks of it:
/// - "poor": `lacks_fit`;
/// - "close": the residuals are noise (no fewer runs than noise has, neighbours not alike), or they
///   are below 1 % of the largest value;
/// - "fair": what is left, such as 1 to 5 % of a curve too short to count runs.
/// @param autocorrelation  of neighbouring residuals: many elastic samples may hide the runs of few
///                         others from the count
std::string_view misfit_word(double fraction, double runs_test_p, double autocorrelation);

/// Says that it does not, and what to try; empty where it does.
/// @param try_next  `laws_to_try`
std::string lack_of_fit(std::string_view law, double fraction, double runs_test_p,
                        std::string_view try_next);

}  // namespace plastica::calibrate
