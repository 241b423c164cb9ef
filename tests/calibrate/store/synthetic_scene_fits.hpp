#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "calibrate/result/scene_fit_record.hpp"
#include "tests/calibrate/store/same_bits.hpp"

namespace plastica::calibrate {

// As in same_bits.hpp: what is new does not compile until it is named here.
inline auto members(const SceneBreak& v) {
  const auto& [a, b, c] = v;
  return std::tie(a, b, c);
}
inline auto members(const SceneTarget& v) {
  // Where the user's words stood is not stored, and warnings are with the fit's.
  const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, repairs, warnings, where, other_where] = v;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, repairs);
}
inline auto members(const TargetFit& v) {
  const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = v;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
}
inline auto members(const SceneStart& v) {
  const auto& [a, b, c, d, e] = v;
  return std::tie(a, b, c, d, e);
}
inline auto members(const SegmentsError& v) {
  const auto& [a, b, c, d, e, f, g, h, i, j] = v;
  return std::tie(a, b, c, d, e, f, g, h, i, j);
}
inline auto members(const SceneSegments& v) {
  const auto& [a, b, c] = v;
  return std::tie(a, b, c);
}
inline auto members(const SceneFitResult& v) {
  static_assert(sizeof(SceneFitResult) == sizeof(FitOutcome) + 168,
                "all members are compared here");
  return std::tie(static_cast<const FitOutcome&>(v), v.targets, v.objective, v.prior_squared,
                  v.degrees_of_freedom, v.starts, v.outcome, v.runs, v.search_runs, v.failed_runs,
                  v.segment_iterations, v.segments);
}
inline auto members(const SceneFitRecord& v) {
  const auto& [a, b, c, d, e] = v;
  return std::tie(a, b, c, d, e);
}

/// SYNTHETIC: two targets, three parameters, three starts; no field has its default.
inline SceneFitRecord filled_scene_record(const std::string& name) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SceneTarget bent;
  bent.name = name + ", bent";
  bent.kind = Abscissa::Support;
  bent.driven = 1;
  bent.table = 2;
  bent.abscissa = {0.0, 0.01, 0.02, 0.03, 0.02};
  bent.ordinate = {-0.0, 95.0, 190.0, 210.0, 120.0};
  bent.ordinate_probe = "force";
  bent.abscissa_is = Dimension::Length;
  bent.ordinate_is = Dimension::Force;
  bent.abscissa_factor = -1.0;
  bent.ordinate_factor = 2.0;
  bent.noise = 1.5;
  bent.broke = SceneBreak{0.029, 0.0005};
  bent.repairs = {{"nan-rows", 3, "3 rows without a number: ä"}, {"duplicates", 1, ""}};
  SceneTarget twisted;
  twisted.name = name + ", verdreht ä";
  twisted.abscissa = {0.0, 0.1, 0.2};
  twisted.ordinate = {0.0, 5.0, 6.0};
  twisted.abscissa_probe = "twist";
  twisted.ordinate_probe = "torque";
  twisted.abscissa_is = Dimension::Angle;
  twisted.ordinate_is = Dimension::Moment;
  twisted.repairs = {{"abscissa-reversals", 7, "7 samples"}};

  SceneFitResult r;
  r.status = FitStatus::Fitted;
  r.reason = "none";
  constexpr ParameterRole kFree = ParameterRole::Free;
  r.parameters = {
      {"material.youngs_modulus", Dimension::Stress, kFree, 205e9, 200e9, 50e9, 500e9, true, 1.2e9,
       1.2e9, 0.0, 0.3e9, 202.6e9, 207.4e9, 6.5, false, false, true,
       Judgement{Verdict::Identified, 1.2 / 205.0}},
      {"material.yield_stress", Dimension::Stress, kFree, 380e6, 300e6, 100e6, 380e6, true, kNan,
       kNan, 1.0, kNan, kNan, kNan, 7.0, false, true, false, Judgement{Verdict::AtBound, 380e6}},
      {"material.break_strain", Dimension::Strain, kFree, 0.021, 0.05, 1e-4, 1.0, false, 4e-4, 1e-4,
       3.87e-4, 2e-5, 0.0202, 0.0218, 5.0, true, false, true,
       Judgement{Verdict::LimitedBySampling, 0.018}}};
  r.held_out = {1e-6, 0.0, 3e-5, 1e-310, 2e-6};
  r.correlation = {1.0, kNan, -0.97, kNan, 1.0, kNan, -0.97, kNan, 1.0};
  r.targets = {{bent.name,
                Law::Ideal,
                Level::Planar,
                5,
                12.0,
                1.5,
                3.5,
                0.008,
                kNan,
                {0.0, 96.0, 189.0, 211.0, 119.0},
                {0.0, 0.5, 1.0, 1.25, 1.0},
                0.021},
               {twisted.name,
                Law::Linear,
                Level::Twist,
                3,
                0.02,
                0.1,
                std::numeric_limits<double>::infinity(),
                0.02,
                0.004,
                {0.0, 5.1, 5.9},
                {0.0, 0.1, 0.1},
                kNan}};
  r.objective = Objective::Path;
  r.prior_squared = 2.25;
  r.degrees_of_freedom = 6.5;
  r.starts = {
      {{200e9, 300e6}, {205e9, 380e6}, 7.1, LeastSquaresOutcome::StepReached, 31},
      {{90e9, 1e9}, {}, std::numeric_limits<double>::infinity(), LeastSquaresOutcome::NoStart, 1},
      {{400e9, 200e6}, {204e9, 379e6}, 7.4, LeastSquaresOutcome::Stalled, 44}};
  r.outcome = LeastSquaresOutcome::StepReached;
  r.runs = 130;
  r.failed_runs = 2;
  r.segment_iterations = 9'000'000'000;
  r.segments = SceneSegments{
      32,
      "no fit with half the segments: ä",
      {{206e9, 205e9, 204.8e9, SegmentsTrend::Monotone, 2.3, 2.0, 1.25, 204.7e9, 8e7, 4e8},
       {},
       {kNan, 0.021, 0.022, SegmentsTrend::Assumed, kNan, 1.0, 3.0, 0.023, 0.003, 0.006}}};
  r.intervals.profiles = {{201e9,
                           208e9,
                           ProfileEnd::Crossed,
                           ProfileEnd::NoCurves,
                           5.9,
                           {201e9, 205e9, 208e9},
                           {5.9, 0.0, 5.0},
                           {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}},
                          {100e6, 380e6, ProfileEnd::Bound, ProfileEnd::Bound, 5.9, {}, {}, {}},
                          {kNan,
                           0.0218,
                           ProfileEnd::Open,
                           ProfileEnd::Crossed,
                           5.9,
                           {0.02, 0.021},
                           {5.9, 0.0},
                           {1.0, 2.0, 3.0, 4.0}}};
  r.intervals.residuals = {40,
                           38,
                           3,
                           {205e9, 380e6, 0.021, 204e9, 379e6, 0.0212},
                           {{1.1e9, 203e9, 207e9}, {2e6, 371e6, 380e6}, {3e-4, 0.0203, kNan}}};
  r.intervals.specimens = {
      20, 20, 1, {}, {{kNan, kNan, kNan}, {kNan, kNan, kNan}, {kNan, kNan, kNan}}};
  r.warnings = {"the break is two samples wide", "", "ß"};
  r.law = Law::Linear;
  r.search_runs = 101;
  return {name, {bent, twisted}, {1.0, 0.25}, r, 1.25};
}

/// A fit that could not be made.
inline SceneFitRecord failed_scene_record(const std::string& name) {
  SceneFitRecord record = filled_scene_record(name);
  SceneFitResult& r = record.result;
  const SceneFitResult none;
  r.status = FitStatus::Failed;
  r.reason = "no curve at the start";
  r.correlation.clear();
  for (TargetFit& of_target : r.targets) {
    of_target.fitted.clear();
    of_target.fitted_error.clear();
  }
  r.intervals = {};
  r.starts.resize(1);
  r.starts[0].to.clear();
  r.outcome = none.outcome;
  return record;
}

}  // namespace plastica::calibrate
