#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/result/result.hpp"

/// Records of made-up fits, for tests of what is written of them.
namespace plastica::calibrate::testing {

inline FittedParameter free_parameter(const std::string& name, Dimension dimension, double value,
                                      double error, double start, double lower, double upper) {
  FittedParameter parameter;
  parameter.path = "material." + name;
  parameter.dimension = dimension;
  parameter.value = value;
  parameter.start = start;
  parameter.lower = lower;
  parameter.upper = upper;
  parameter.logarithmic = true;
  parameter.standard_error = error;
  parameter.interval_low = value - 1.96 * error;
  parameter.interval_high = value + 1.96 * error;
  parameter.judgement = {Verdict::Identified, error / value};
  return parameter;
}

/// A tension test of an ideally plastic bar, E 70 GPa, 280 MPa, that breaks at 10.4 % in total;
/// one toe correction, one repair.
inline FitRecord fitted_record(std::string name = "bar-01", double yield = 280e6,
                               std::string temperature = "20") {
  constexpr double kModulus = 70e9;
  FitRecord record;
  Target& target = record.target;
  target.name = std::move(name);
  target.file = "targets/" + target.name + ".csv";
  target.group = {{"temperature", std::move(temperature)}};
  target.repairs = {{"nan-rows", 3, "rows without a number were left out"}};
  target.corrections = {
      {"toe", true, -0.00021, "1", "the foot below 40 MPa is softer than the modulus"},
      {"preload-offset", false, 0.0, "Pa", "the curve begins at zero load"}};
  for (int i = 0; i <= 208; ++i) {
    const double strain = 0.0005 * i;
    const double noise = 1.5e6 * std::sin(12.9898 * i);
    record.result.fitted.strain.push_back(strain);
    record.result.fitted.stress.push_back(std::min(kModulus * strain, yield));
    target.corrected.strain.push_back(strain);
    target.corrected.stress.push_back(record.result.fitted.stress.back() + noise);
  }
  target.raw = target.corrected;
  Characteristics& all = target.characteristics;
  all.youngs_modulus = kModulus;
  all.youngs_modulus_stderr = 0.21e9;
  all.modulus_window_low = 28e6;
  all.modulus_window_high = 112e6;
  all.modulus_method = "regression";
  all.offset = 0.002;
  all.proof_stress = yield;
  all.rm = yield + 1.4e6;
  all.strain_at_rm = 0.08;
  all.observed_break = BreakObservation{0.104, yield, 0.1045, "fall-to-zero"};
  all.break_strain = all.observed_break->strain();
  all.break_strain_plastic = *all.break_strain - yield / kModulus;
  all.largest_strain = 0.104;

  FitResult& result = record.result;
  result.status = FitStatus::Fitted;
  result.parameters = {
      free_parameter("youngs_modulus", Dimension::Stress, kModulus, 0.3e9, 69e9, 20e9, 400e9),
      free_parameter("yield_stress", Dimension::Stress, yield, 0.41e6, 279e6, 10e6, 2e9),
      free_parameter("break_strain", Dimension::Strain, 0.10025, 0.00025, 0.1, 0.001, 1.0)};
  result.correlation = {1.0, -0.62, 0.01, -0.62, 1.0, 0.2, 0.01, 0.2, 1.0};
  result.cost = 1.2e12;
  result.misfit_rms = 1.1e6;
  result.misfit_fraction = 0.0039;
  result.misfit_word = "close";
  result.samples = target.corrected.size();
  result.break_strain_total = 0.10425;
  result.fitted.strain.push_back(0.10425);
  result.fitted.stress.push_back(yield);
  result.seed = 12345;
  result.stages = {{"GN_CRS2_LM", "maxeval-reached", 60, 4e12},
                   {"LN_BOBYQA", "xtol-reached", 82, 1.2e12}};
  result.trace.active = {0, 1, 2};
  result.trace.costs.assign(142, 1.2e12);
  result.trace.values.assign(std::size_t{3} * 142, 1.0);
  return record;
}

inline FitRecord rejected_record(std::string name, std::string reason) {
  FitRecord record;
  record.target.name = std::move(name);
  record.target.file = "targets/" + record.target.name + ".csv";
  record.target.status = TargetStatus::Rejected;
  record.target.reason = std::move(reason);
  record.target.group = {{"temperature", "20"}};
  record.result.status = FitStatus::Rejected;
  return record;
}

inline FitRecord failed_record(std::string name, std::string reason) {
  FitRecord record = fitted_record(std::move(name));
  record.target.repairs.clear();
  record.result = {};
  record.result.status = FitStatus::Failed;
  record.result.reason = std::move(reason);
  return record;
}

inline FittedParameter& parameter_of(FitRecord& record, std::string_view name) {
  auto& all = record.result.parameters;
  return *std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name() == name; });
}

}  // namespace plastica::calibrate::testing
