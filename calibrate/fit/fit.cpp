#include "calibrate/fit/fit.hpp"

#include <cmath>
#include <mutex>

#include "calibrate/fit/fit_law.hpp"
#include "calibrate/fit/require.hpp"
#include "calibrate/fit/search_target.hpp"
#include "calibrate/fit/unseen.hpp"
#include "calibrate/inference/fit_intervals.hpp"
#include "calibrate/inference/held_out.hpp"
#include "calibrate/problem/given_weights.hpp"
#include "calibrate/search/fit_interrupted.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/base/parallel_for.hpp"

namespace plastica::calibrate {
namespace {

/// The options with the bounds that a fit had: a start may have widened them.
FitOptions within(const FitResult& result, FitOptions options) {
  for (Parameter& p : options.parameters) {
    for (const FittedParameter& fitted : result.parameters) {
      if (p.role != ParameterRole::Free || fitted.path != p.field->path) continue;
      p.lower = fitted.lower;
      p.upper = fitted.upper;
    }
  }
  return options;
}

}  // namespace

void check_fit_options(const FitOptions& options) {
  check_parameters(options.parameters);
  check_law_parameters(options.parameters, options.setup.scene.material, options.laws);
  const StoppingRules& stop = options.stopping;
  const bool global = options.algorithm != "auto" && is_global(options.algorithm);
  require(stop.global_evaluations >= (global ? 1 : 0), "fit.global_evaluations",
          stop.global_evaluations, global ? "must be at least 1" : "must be at least 0");
  require(stop.local_evaluations >= 1, "fit.local_evaluations", stop.local_evaluations,
          "must be at least 1");
  require(options.confidence > 0.0 && options.confidence < 1.0, "fit.confidence",
          options.confidence, "must be between 0 and 1");
  require(options.break_weight >= 0.0 && std::isfinite(options.break_weight), "fit.break_weight",
          options.break_weight, "must be at least 0");
  if (options.noise) {
    require(*options.noise > 0.0 && std::isfinite(*options.noise), "fit.noise", *options.noise,
            "must be above 0 Pa");
  }
  check_weights(options);
  check_intervals(options.intervals);
}

FitResult fit_target(const Target& target, const FitOptions& options,
                     std::span<const StartPoint> further) {
  if (target.status == TargetStatus::Ready) check_fit_options(options);
  const FitPriors priors(target, options);
  std::optional<Misfit> searched;
  FitResult result = search_target(target, options, priors.told(), further, &searched);
  if (searched) weigh_priors(target, options, priors, *searched, result);
  add_intervals(target, options, result);
  return result;
}

std::vector<FitCase> cases_of(std::size_t targets, const FitOptions& options) {
  std::vector<FitCase> cases;
  for (std::size_t i = 0; i < targets; ++i) {
    if (options.laws.empty()) cases.push_back({i, std::nullopt});
    for (const Law law : options.laws) cases.push_back({i, law});
  }
  return cases;
}

std::vector<FitResult> fit_cases(std::span<const Target> targets, std::span<const FitCase> cases,
                                 const FitOptions& given, const BatchFitOptions& batch) {
  FitOptions options = given;
  if (batch.stop != nullptr) options.stop = batch.stop;
  check_fit_options(options);
  std::vector<FitResult> results(cases.size());
  for (FitResult& result : results) result.reason = "not run";
  std::mutex mutex;
  parallel_for(cases.size(), {batch.threads, batch.stop, batch.next}, [&](std::size_t i, int) {
    const CorrectedTarget read(targets[cases[i].target]);
    const Target& target = *read;
    try {
      if (cases[i].law) {
        results[i] = fit_law(target, options, *cases[i].law);
        const FitOptions own =
            within(results[i], options_of(*cases[i].law, options, target.loading));
        add_intervals(target, own, results[i]);
        if (options.laws.size() > 1) results[i].held_out = held_out(target, own, results[i]);
      } else {
        results[i] = fit_target(target, options);
      }
    } catch (const FitInterrupted&) {
      results[i] = {};
      results[i].reason = "not run";
      return;
    } catch (const InputError& error) {
      // The options were checked above: this one target does not go with them.
      results[i].status = FitStatus::Failed;
      results[i].reason = error.what();
      if (cases[i].law) results[i].law = *cases[i].law;
    }
    if (!options.keep_trace) results[i].trace.leave_out();
    results[i].fitted.strain.shrink_to_fit();  // it has grown by its break
    results[i].fitted.stress.shrink_to_fit();
    if (!batch.finished) return;
    const std::lock_guard lock(mutex);
    batch.finished(i, results[i]);
  });
  return results;
}

std::vector<FitResult> fit(std::span<const Target> targets, const FitOptions& options,
                           const BatchFitOptions& batch) {
  const std::vector<FitCase> cases = cases_of(targets.size(), options);
  std::vector<FitResult> results = fit_cases(targets, cases, options, batch);
  if (!is_raised(batch.stop)) add_unseen(targets, cases, options, batch.threads, results);
  return results;
}

}  // namespace plastica::calibrate
