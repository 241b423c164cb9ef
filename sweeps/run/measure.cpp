#include "sweeps/run/measure.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "plastica/run/natural_frequencies.hpp"

namespace plastica::sweeps {

bool is_simulated(const Quantity& quantity) {
  return quantity.kind != QuantityKind::NaturalFrequency && quantity.kind != QuantityKind::Fit;
}

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
  const LoadedFrequencies all = natural_frequencies(setup.scene, setup.solver, mode);
  result.status = all.status;
  if (!all.frequency.empty()) result.value = all.frequency[static_cast<std::size_t>(mode - 1)];
  result.segments = setup.scene.beam.segments;
  result.iterations = 1;
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
  const calibrate::SceneParameter& parameter = fitted.parameter(sweep.quantity.parameter);
  result.status = Status::Completed;
  result.value = parameter.value;
  if (std::isfinite(parameter.standard_error)) result.standard_error = parameter.standard_error;
  if (parameter.at_bound) result.reason = "the parameter is at its bound";
  return result;
}

}  // namespace

CaseResult measure(const Sweep& sweep, const Setup& setup, StopFlag stop) {
  const auto begin = std::chrono::steady_clock::now();
  CaseResult result =
      sweep.quantity.kind == QuantityKind::Fit ? fit(sweep, setup, stop) : frequency(sweep, setup);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  result.seconds = took.count();
  return result;
}

}  // namespace plastica::sweeps
