#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "calibrate/result/scene_fit_record.hpp"

/// Records of made-up fits through scenes, for tests of what is written of them.
namespace plastica::calibrate::testing {

inline FittedParameter scene_parameter(const std::string& path, Dimension dimension, double value,
                                       double error) {
  FittedParameter p;
  p.path = path;
  p.dimension = dimension;
  p.value = value;
  p.start = 1.1 * value;
  p.lower = 0.1 * value;
  p.upper = 10.0 * value;
  p.standard_error = p.noise_error = error;
  p.interval_low = value - 2.0 * error;
  p.interval_high = value + 2.0 * error;
  p.judgement = {Verdict::Identified, error / value};
  return p;
}

/// A bar that is bent until it breaks at 60 mm and one that is twisted, fitted together.
inline SceneFitRecord scene_record(const std::string& name = "both", double modulus = 205e9,
                                   double yield = 380e6) {
  SceneFitRecord record;
  record.name = name;
  record.weights = {1.0, 1.0};
  record.targets.resize(2);
  SceneTarget& bent = record.targets[0];
  bent.name = "bent";
  bent.kind = Abscissa::Support;
  bent.driven = 1;
  bent.ordinate_probe = "force";
  bent.abscissa_is = Dimension::Length;
  bent.ordinate_is = Dimension::Force;
  bent.broke = SceneBreak{0.0605, 0.0005};
  SceneTarget& twisted = record.targets[1];
  twisted.name = "twisted";
  twisted.kind = Abscissa::Probe;
  twisted.abscissa_probe = "angle";
  twisted.ordinate_probe = "torque";
  twisted.abscissa_is = Dimension::Angle;
  twisted.ordinate_is = Dimension::Moment;
  twisted.noise = 3.0;

  SceneFitResult& r = record.result;
  r.status = FitStatus::Fitted;
  r.targets.resize(2);
  for (std::size_t p = 0; p < 2; ++p) {
    TargetFit& of_target = r.targets[p];
    SceneTarget& target = record.targets[p];
    of_target.name = target.name;
    of_target.level = p == 0 ? Level::Planar : Level::Twist;
    of_target.samples = p == 0 ? 30 : 20;
    of_target.noise = p == 0 ? 5.0 : 3.0;
    of_target.degrees_of_freedom = p == 0 ? 28.8 : std::numeric_limits<double>::infinity();
    of_target.misfit_fraction = p == 0 ? 0.0083 : 0.012;
    of_target.runs_test_p = p == 0 ? 0.41 : std::numeric_limits<double>::quiet_NaN();
    of_target.break_strain = p == 0 ? 0.021 : std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < of_target.samples; ++i) {
      const double at = (p == 0 ? 0.002 : 0.02) * static_cast<double>(i + 1);
      const double value = std::min(p == 0 ? 1e4 * at : 1e3 * at, p == 0 ? 400.0 : 250.0);
      const double noise = of_target.noise * std::sin(12.9898 * static_cast<double>(i));
      target.abscissa.push_back(at);
      of_target.fitted.push_back(value);
      of_target.fitted_error.push_back(0.2 * of_target.noise);
      target.ordinate.push_back(value + noise);
      of_target.cost += noise * noise;
    }
  }
  r.parameters = {scene_parameter("material.youngs_modulus", Dimension::Stress, modulus, 1.2e9),
                  scene_parameter("material.yield_stress", Dimension::Stress, yield, 2.1e6),
                  scene_parameter("material.break_strain", Dimension::Strain, 0.021, 0.0004)};
  r.parameters[2].judgement = {Verdict::LimitedBySampling, 0.018};
  r.parameters[2].noise_error = 1e-4;
  r.parameters[2].sampling_error = 3.9e-4;
  r.parameters[2].misfit_error = 2e-4;
  for (FittedParameter& parameter : r.parameters) parameter.degrees_of_freedom = 28.8;
  r.correlation = {1.0, -0.42, 0.1, -0.42, 1.0, 0.2, 0.1, 0.2, 1.0};
  r.degrees_of_freedom = 28.8;
  r.outcome = LeastSquaresOutcome::StepReached;
  const SegmentsError unknown;
  r.segments = SceneSegments{32,
                             "",
                             {segments_error(1.03 * modulus, modulus, 0.9925 * modulus, 2.0),
                              segments_error(1.04 * yield, yield, 1.01 * yield, 2.0), unknown}};
  r.starts = {
      {{200e9, 300e6}, {modulus, yield}, 49.1, r.outcome, 31},
      {{90e9, 1e9}, {}, std::numeric_limits<double>::infinity(), LeastSquaresOutcome::NoStart, 1},
      {{400e9, 200e6}, {150e9, 2e8}, 733.0, LeastSquaresOutcome::Stalled, 44},
      {{300e9, 250e6}, {modulus, yield}, 49.1, r.outcome, 27}};
  r.runs = 130;
  r.segment_iterations = 123456;
  return record;
}

/// The same with profiles, of which the yield stress's is open upwards and the break's on both
/// sides, and with a bootstrap of four resamples.
inline SceneFitRecord record_with_intervals() {
  SceneFitRecord record = scene_record();
  FitIntervals& all = record.result.intervals;
  all.profiles = {{202e9,
                   209e9,
                   ProfileEnd::Crossed,
                   ProfileEnd::Crossed,
                   4.0,
                   {202e9, 205e9, 209e9},
                   {4.0, 0.0, 4.0},
                   {202e9, 381e6, 205e9, 380e6, 209e9, 378e6}},
                  {375e6,
                   2e9,
                   ProfileEnd::Crossed,
                   ProfileEnd::Bound,
                   4.0,
                   {375e6, 380e6, 2e9},
                   {4.0, 0.0, 2.0},
                   {205e9, 375e6, 205e9, 380e6, 205e9, 2e9}},
                  {0.0, 1.0, ProfileEnd::Bound, ProfileEnd::Open, 4.0, {}, {}, {}}};
  all.residuals = {
      5,
      1,
      2,
      {204e9, 379e6, 0.020, 206e9, 381e6, 0.021, 205e9, 380e6, 0.022, 203e9, 382e6, 0.021},
      {{1.3e9, 203e9, 206e9}, {1.3e6, 379e6, 382e6}, {8e-4, 0.020, 0.022}}};
  return record;
}

/// One target, two parameters, no break.
inline SceneFitRecord lone_scene_record(const std::string& name, double modulus, double yield) {
  SceneFitRecord record = scene_record(name, modulus, yield);
  SceneFitResult& r = record.result;
  record.targets.resize(1);
  record.targets[0].name = name;
  record.targets[0].broke.reset();
  record.weights.resize(1);
  r.targets.resize(1);
  r.targets[0].name = name;
  r.targets[0].break_strain = std::numeric_limits<double>::quiet_NaN();
  r.parameters.resize(2);
  r.segments->parameters.resize(2);
  r.correlation = {1.0, -0.42, -0.42, 1.0};
  r.starts.resize(1);
  return record;
}

inline SceneFitRecord failed_scene_record(const std::string& name, const std::string& reason) {
  SceneFitRecord record = lone_scene_record(name, 2e11, 3e8);
  record.result = {};
  record.result.reason = reason;
  return record;
}

}  // namespace plastica::calibrate::testing
