#include "sweeps/run/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "calibrate/result/usable.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/run/case_warnings.hpp"

namespace plastica::sweeps {

CaseResult rejected(std::string reason) {
  CaseResult result;
  result.status = Status::Rejected;
  result.reason = std::move(reason);
  return result;
}

CaseResult result_of(const BatchRow& row, const Quantity& quantity) {
  if (row.response.status == Status::Rejected) return rejected(row.reason);
  if (!row.reason.empty()) {
    CaseResult result;
    result.reason = row.reason;
    return result;
  }
  return result_of_run(row, quantity);
}

namespace {

CaseResult frequency(const Sweep& sweep, const Setup& setup) {
  CaseResult result;
  result.level = prepare(setup.scene, setup.solver).level;
  const int mode = sweep.quantity.mode;
  const auto all = unloaded_frequencies(setup.scene, setup.solver, mode);
  result.value = all[static_cast<std::size_t>(mode - 1)];
  result.status = Status::Completed;
  result.segments = setup.scene.beam.segments;
  result.iterations = 1;
  return result;
}

/// Of modes about the loaded state. One that is found is an answer, however the path to it ended.
CaseResult mode_about_load(const Sweep& sweep, const Setup& setup) {
  CaseResult result;
  const auto mode = static_cast<std::size_t>(sweep.quantity.mode);
  result.level = prepare(setup.scene, setup.solver).level;
  result.segments = setup.scene.beam.segments;
  result.iterations = 1;
  if (sweep.quantity.kind == QuantityKind::LoadedFrequency) {
    const auto all = natural_frequencies(setup.scene, setup.solver, sweep.quantity.mode);
    result.status = all.status;
    if (all.status == Status::Completed) result.value = all.frequency[mode - 1];
    return result;
  }
  SolverOptions solver = setup.solver;
  solver.buckling = sweep.quantity.mode;
  const Response response = simulate(setup.scene, solver);
  result.warnings = warnings_of_run(setup, response);
  result.status = response.status;
  // A straight column needs no iteration to stay straight; its modes are work, too.
  result.iterations = std::max(1, response.counters.iterations);
  if (response.buckling && response.buckling->factor.size() >= mode) {
    result.status = Status::Completed;
    result.value = response.buckling->factor[mode - 1];
  } else if (response.status == Status::Completed) {
    result.reason = "there are not so many below 1e15 times the load";
  }
  return result;
}

CaseResult fit(const Sweep& sweep, const Setup& setup, StopFlag stop) {
  CaseResult result;
  result.level = prepare(setup.scene, setup.solver).level;
  calibrate::SceneFitOptions options = sweep.fit->options;
  options.hooks.stop = stop;
  const auto fitted = calibrate::fit_scene(setup, sweep.fit->target, options);
  result.segments = setup.scene.beam.segments;
  result.iterations = fitted.segment_iterations / result.segments;
  if (fitted.status != calibrate::FitStatus::Fitted) {
    result.status = Status::NotConverged;
    result.reason = fitted.reason;
    return result;
  }
  const calibrate::FittedParameter& parameter = fitted.parameter(sweep.quantity.parameter);
  result.status = Status::Completed;
  result.warnings = fitted.warnings;
  const std::string no_use = calibrate::why_unusable(fitted);
  result.reason =
      no_use.empty() ? calibrate::why_no_answer(parameter) : "the fit is of no use: " + no_use;
  if (!result.reason.empty()) return result;
  result.value = parameter.value;
  if (std::isfinite(parameter.standard_error)) result.standard_error = parameter.standard_error;
  return result;
}

}  // namespace

CaseResult measure(const Sweep& sweep, const Setup& setup, StopFlag stop) {
  const auto begin = std::chrono::steady_clock::now();
  CaseResult result;
  switch (sweep.quantity.kind) {
    case QuantityKind::Fit: result = fit(sweep, setup, stop); break;
    case QuantityKind::NaturalFrequency: result = frequency(sweep, setup); break;
    default: result = mode_about_load(sweep, setup);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  result.seconds = took.count();
  return result;
}

}  // namespace plastica::sweeps
