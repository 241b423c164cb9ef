#pragma once

#include "calibrate/result/describe.hpp"
#include "calibrate/result/fit_outcome.hpp"

/// What is said of a fit and of its search, see describe.hpp.
namespace plastica::calibrate {

/// Of an OptimizerStage.
inline constexpr auto kDescribeStage = [](auto& d) {
  d("algorithm", "", PLASTICA_MEMBER(algorithm), "of the stage");
  d("outcome", "", PLASTICA_MEMBER(outcome), "why it ended");
  d("evaluations", "1", PLASTICA_MEMBER(evaluations), "of the cost");
  d("cost", "Pa^2", PLASTICA_MEMBER(cost), "best of the stage");
};

/// Of a ModulusPrior.
inline constexpr auto kDescribeModulusPrior = [](auto& d) {
  d("prior_modulus", "Pa", PLASTICA_MEMBER(mean), "slope of the elastic part");
  d("prior_modulus_error", "Pa", PLASTICA_MEMBER(standard_deviation), "of the slope");
  d("prior_variance", "Pa^2", PLASTICA_MEMBER(variance),
    "what the slope's squared distance over its error counts in the cost");
};

/// Of StatedPriors.
inline constexpr auto kDescribeStatedPriors = [](auto& d) {
  d("stated_prior_variance", "Pa^2", PLASTICA_MEMBER(variance),
    "what the square of a value's distance from its prior's mean, over its standard deviation, "
    "counts in the cost");
  d("stated_prior_squared", "1", PLASTICA_MEMBER(squared), "the sum of these squares");
};

/// Of a SceneStart, but for its points.
inline constexpr auto kDescribeStart = [](auto& d) {
  d("cost", "1", PLASTICA_MEMBER(cost), "sum of the weighted squares where the search ended");
  d("outcome", "", PLASTICA_MEMBER(outcome), "why it ended");
  d("evaluations", "1", PLASTICA_MEMBER(evaluations), "of the residuals");
};

/// Of a SegmentsError.
inline constexpr auto kDescribeSegments = [](auto& d) {
  d("at_half", kOwnUnits, PLASTICA_MEMBER(at_half), "fitted with half the segments");
  d("at_own", kOwnUnits, PLASTICA_MEMBER(at_own), "fitted with the scene's segments");
  d("at_twice", kOwnUnits, PLASTICA_MEMBER(at_twice), "fitted with twice the segments");
  d("trend", "", PLASTICA_MEMBER(trend), "how the three values go with the segments");
  d("observed_order", "1", PLASTICA_MEMBER(observed_order), "of the three values");
  d("order", "1", PLASTICA_MEMBER(order), "that was extrapolated with");
  d("safety_factor", "1", PLASTICA_MEMBER(safety_factor), "of the grid convergence index");
  d("extrapolated", kOwnUnits, PLASTICA_MEMBER(extrapolated),
    "what the continuous beam would give");
  d("extrapolated_error", kOwnUnits, PLASTICA_MEMBER(extrapolated_error), "half its interval");
  d("error", kOwnUnits, PLASTICA_MEMBER(error),
    "half the interval about the value with the scene's segments");
};

/// Of a TargetFit, but for its curve.
inline constexpr auto kDescribeTargetFit = [](auto& d) {
  d.since(7, [](auto& later) { later("law", "", PLASTICA_MEMBER(law), "that its scene has"); });
  d("level", "", PLASTICA_MEMBER(level), "of the model");
  d("samples", "1", PLASTICA_MEMBER(samples), "that entered the fit");
  d("cost", "", PLASTICA_MEMBER(cost), "sum of the squared residuals");
  d("noise", "", PLASTICA_MEMBER(noise), "standard deviation that errors stand on");
  d("degrees_of_freedom", "1", PLASTICA_MEMBER(degrees_of_freedom),
    "of this; infinite: the target states it");
  d("misfit_fraction", "1", PLASTICA_MEMBER(misfit_fraction),
    "rms residual over the largest measured ordinate");
  d("runs_test_p", "1", PLASTICA_MEMBER(runs_test_p),
    "of as few runs of residuals of one sign, if they were independent");
  d("break_strain", "1", PLASTICA_MEMBER(break_strain),
    "permanent strain of the fitted model where the target broke");
};

/// Of a FitOutcome, whatever was fitted.
inline constexpr auto kDescribeOutcome = [](auto& d) {
  d("law", "", PLASTICA_MEMBER(law), "that was fitted");
  d("status", "", PLASTICA_MEMBER(status), "how the fit ended");
  d("reason", "", PLASTICA_MEMBER(reason), "why it gave nothing");
};

/// Of a FitResult, beside its outcome.
inline constexpr auto kDescribeFit = [](auto& d) {
  d("samples", "1", PLASTICA_MEMBER(samples), "that entered the fit");
  d("seed", "", PLASTICA_MEMBER(seed), "of the target's random numbers");
  d("noise", "Pa", PLASTICA_MEMBER(noise), "stated standard deviation of the stress");
  d("simpler_evaluations", "1", PLASTICA_MEMBER(simpler_evaluations),
    "of the fits of simpler laws whose values were tried as starts");
  const auto fitted = [](const auto& result) { return result.status == FitStatus::Fitted; };
  d.only(fitted, [](auto& only) {
    only("cost", "Pa^2", PLASTICA_MEMBER(cost), "objective, with the break term of a free limit");
    only("misfit_rms", "Pa", PLASTICA_MEMBER(misfit_rms), "root of the stress misfit");
    only("misfit_fraction", "1", PLASTICA_MEMBER(misfit_fraction),
         "misfit over the largest stress");
    only("misfit_word", "", PLASTICA_MEMBER(misfit_word), "close, fair or poor");
    only("runs_test_p", "1", PLASTICA_MEMBER(runs_test_p),
         "of as few runs of residuals of one sign, if they were independent");
    only("autocorrelation", "1", PLASTICA_MEMBER(autocorrelation), "of neighbouring residuals");
    only("effective_samples", "1", PLASTICA_MEMBER(effective_samples), "by their weights");
  });
  d("break_strain_total", "1", PLASTICA_MEMBER(break_strain_total),
    "total strain at which the fitted model breaks");
  d.since(7, [](auto& later) {
    later.optional("weighed_modulus", PLASTICA_MEMBER(modulus_prior), kDescribeModulusPrior);
    later("unseen_squared", "1", PLASTICA_MEMBER(unseen),
          "square of the misfit by fits of other specimens, over the largest stress");
  });
  d.since(8, [](auto& later) {
    later.optional("stated_priors", PLASTICA_MEMBER(stated_priors), kDescribeStatedPriors);
  });
  d.since(11, [](auto& later) {
    later("evaluations_left_out", "1", PLASTICA_MEMBER(trace.left_out),
          "evaluations of which only the number is kept");
  });
};

/// Of a SceneFitResult, beside its outcome.
inline constexpr auto kDescribeSceneFit = [](auto& d) {
  d("degrees_of_freedom", "1", PLASTICA_MEMBER(degrees_of_freedom),
    "of the estimated noise; infinite: all targets state theirs");
  d("outcome", "", PLASTICA_MEMBER(outcome), "of the best search");
  d("runs", "1", PLASTICA_MEMBER(runs), "of scenes");
  d("search_runs", "1", PLASTICA_MEMBER(search_runs), "of these, what the search took");
  d("failed_runs", "1", PLASTICA_MEMBER(failed_runs), "of all, without a curve");
  d("segment_iterations", "1", PLASTICA_MEMBER(segment_iterations), "of all runs");
  d.optional("remeshed", PLASTICA_MEMBER(segments), [](auto& inner) {
    inner("segments", "1", PLASTICA_MEMBER(segments), "of the first beam");
    inner("segments_note", "", PLASTICA_MEMBER(note), "why a fit with other segments is missing");
  });
  d.since(11, [](auto& later) {
    later("objective", "", PLASTICA_MEMBER(objective), "by which the samples counted");
    later("stated_prior_squared", "1", PLASTICA_MEMBER(prior_squared),
          "sum of the squares of what values are off their priors, over their standard deviations");
  });
};

}  // namespace plastica::calibrate
