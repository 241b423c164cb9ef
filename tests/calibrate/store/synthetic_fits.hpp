#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"

namespace plastica::calibrate {

/// SYNTHETIC: the curve of an ideal-plastic bar that breaks, with its characteristics.
/// @param yield  [Pa]
inline Target ideal_target(const std::string& name, double yield, std::size_t samples = 60) {
  constexpr double kModulus = 200e9;
  constexpr double kLast = 0.02;
  Target t;
  t.name = name;
  t.file = name + ".csv";
  for (std::size_t i = 0; i < samples; ++i) {
    const double e = kLast * static_cast<double>(i * i) / static_cast<double>(samples * samples);
    const double ripple = 1.0 + 2e-3 * std::sin(static_cast<double>(7 * i));
    t.corrected.strain.push_back(e);
    t.corrected.stress.push_back(ripple * std::min(kModulus * e, yield));
  }
  t.raw = t.corrected;
  Characteristics& c = t.characteristics;
  c.youngs_modulus = kModulus;
  c.proof_stress = yield;
  c.rm = yield;
  c.strain_at_rm = kLast;
  c.largest_strain = t.corrected.strain.back();
  c.observed_break = BreakObservation{c.largest_strain, yield, kLast, "fall-to-zero"};
  c.break_strain = c.observed_break->strain();
  c.break_strain_plastic = *c.break_strain - yield / kModulus;
  return t;
}

/// Targets of different yield stresses; one of them is rejected.
inline std::vector<Target> ideal_targets(std::size_t count) {
  std::vector<Target> targets;
  for (std::size_t i = 0; i < count; ++i) {
    targets.push_back(ideal_target("bar-" + std::to_string(i), 3e8 + 1e7 * static_cast<double>(i)));
  }
  if (count > 2) {
    targets[2].status = TargetStatus::TooCoarse;
    targets[2].reason = "2 samples on the elastic part, 5 are needed";
  }
  return targets;
}

inline FitOptions ideal_options() {
  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress", "break_strain"}) {
    options.parameters.emplace_back().field = &find_field("material." + std::string(name));
  }
  return options;
}

/// A record in which no field has its default, with the parameters of `ideal_options`.
inline FitRecord filled_record(const std::string& name) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  FitRecord record;
  Target& t = record.target;
  t = ideal_target(name, 355e6, 7);
  t.test = Deformation::Torsion;
  t.measure = Measure::True;
  t.loading = Loading::Cyclic;
  t.reason = "Prüfung – gut";
  t.group = {{"temperature", "20 °C"}, {"lot", "A"}};
  t.properties = {{"area", 1e-4}, {"gauge_length", 0.05}};
  t.raw = {{0.0, kNan, -0.0, 1e-310}, {1.0, 2.0, kNan, -INFINITY}};
  t.repairs = {{"nan-rows", 3, "3 rows without a number"}, {"torn-last-row", 1, ""}};
  t.corrections = {{"toe", true, 1.5e-4, "1", "moved"}, {"preload-offset", false, 0.0, "Pa", "no"}};
  t.warnings = {"a", "", "ß"};
  Characteristics& c = t.characteristics;
  c.youngs_modulus_stderr = 1e8;
  c.modulus_window_low = 1e7;
  c.modulus_window_high = 1e8;
  c.modulus_method = "regression";
  c.offset = 0.002;
  c.reh = 3.7e8;
  c.rel = 3.5e8;

  FitResult& r = record.result;
  r.status = FitStatus::Fitted;
  r.reason = "none";
  for (const Parameter& parameter : ideal_options().parameters) {
    FittedParameter p;
    p.path = parameter.field->path;
    p.dimension = parameter.field->dimension;
    p.value = 1.0 + static_cast<double>(r.parameters.size());
    p.start = 0.1;
    p.lower = 0.01;
    p.upper = 1e12;
    p.logarithmic = true;
    p.at_lower = true;
    p.at_upper = true;
    p.identified = false;
    p.judgement = {Verdict::AtBound, 1e12};
    r.parameters.push_back(p);
  }
  r.parameters[1].standard_error = 0.25;
  r.parameters[1].noise_error = 0.24;
  r.parameters[1].interval_low = 0.5;
  r.parameters[1].interval_high = 1.5;
  r.correlation = {1.0, kNan, kNan, 1.0};
  r.cost = 1e10;
  r.misfit_rms = 1e5;
  r.misfit_fraction = 0.001;
  r.misfit_word = "close";
  r.law = Law::Ideal;
  r.runs_test_p = 0.31;
  r.autocorrelation = -0.2;
  r.effective_samples = 6.4;
  r.noise = 2e6;
  r.simpler_evaluations = 44;
  r.samples = 7;
  r.break_strain_total = 0.0201;
  r.modulus_prior = {{193e9, 3e9, 2e12}};
  r.stated_priors = {{2e12, 1.7}};
  r.held_out = {1e-6, 0.0, 3e-5, 1e-310, 2e-6};
  r.unseen = 4e-5;
  r.seed = 0xfedcba9876543210U;
  r.stages = {{"GN_CRS2_LM", "maxeval-reached", 60, 2e10}, {"LD_SLSQP", "xtol-reached", 9, 1e10}};
  r.trace = {{0, 2}, {1.0, 2.0, 3.0, 4.0, kNan, -0.0}, {5.0, INFINITY, 7.0}, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    LikelihoodProfile& profile = r.intervals.profiles.emplace_back();
    profile.low = i == 1 ? kNan : 0.5 * static_cast<double>(i);
    profile.high = 3.0 + static_cast<double>(i);
    profile.low_end = ProfileEnd::Crossed;
    profile.high_end = i == 2 ? ProfileEnd::Bound : ProfileEnd::NoCurves;
    profile.threshold = 3.94;
    if (i == 1) continue;
    profile.value = {0.5, 1.0, 3.0};
    profile.rise = {3.9, 0.0, 4.1};
    profile.searched = {0.5, 2.0, 1.0, 2.1, 3.0, 2.2};
  }
  r.intervals.residuals = {20,
                           18,
                           3,
                           {1.0, 2.0, 3.0, 4.0, 5.0, 6.0},
                           {{0.1, 0.5, 1.5}, {kNan, kNan, kNan}, {0.3, 2.0, 4.0}}};
  r.fitted = t.corrected;
  r.warnings = {"yield_stress is at its upper bound"};
  return record;
}

/// A record of a target that could not even be read.
inline FitRecord rejected_record(const std::string& name) {
  FitRecord record;
  record.target.name = name;
  record.target.status = TargetStatus::Rejected;
  record.target.reason = "has no column Stress";
  record.result.reason = record.target.reason;
  return record;
}

}  // namespace plastica::calibrate
