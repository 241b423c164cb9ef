#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/problem/scene_parameters.hpp"
#include "calibrate/problem/target_noise.hpp"
#include "calibrate/search/least_squares.hpp"
#include "calibrate/trial/scene_model.hpp"

namespace plastica::calibrate {

/// A setup with the values of parameters that are fixed, or tied to one that is.
Setup with_fixed(const Setup& setup, const SceneFitOptions& options);

/// Runs that a fit has made.
struct RunCounters {
  int runs = 0;
  int failed = 0;
  std::int64_t segment_iterations = 0;

  void add(const RunCounters& others) {
    runs += others.runs;
    failed += others.failed;
    segment_iterations += others.segment_iterations;
  }
};

/// What came of a point at which all targets were run.
struct PointRun {
  bool found = false;     ///< whether all targets have a curve
  std::string reason;     ///< else why not
  bool reversed = false;  ///< whether because the probe of an abscissa turns round
  RunCounters runs;
};

/// The sum of squares of a fit through scenes: for each target sqrt(weight w_i) (model -
/// measured)/scale at its samples, w_i 1 or, along the path, the sample's part of it, one target
/// after the other, then (value - mean)/standard deviation of each prior. Where the hinge length is
/// free, the break strain is known, and each target that broke in bending has a residual more: what
/// its permanent strain is off at the break, over the standard deviation of a break that is
/// anywhere within its sampling interval, or 0.1 % of the strain if that is more.
class SceneProblem {
 public:
  /// @param targets, options  checked; must outlive this
  /// @throws InputError for a scene that is bad input or cannot follow its target
  SceneProblem(std::span<const WeightedTarget> targets, const SceneFitOptions& options);
  SceneProblem(const SceneProblem&) = delete;
  SceneProblem& operator=(const SceneProblem&) = delete;

  const SceneParameters& parameters() const { return parameters_; }
  std::span<const WeightedTarget> targets() const { return targets_; }
  const SceneModel& model(std::size_t t) const { return models_[t]; }
  /// Those of a target's scene at a point (n_free), see `SceneModel::warnings`.
  std::vector<std::string> warnings_of(std::size_t t, std::span<const double> point) const {
    return models_[t].warnings(parameters_.values(point));
  }
  /// With the scales that are set now.
  const LeastSquaresProblem& squares() const { return squares_; }
  std::size_t samples() const;  ///< of all targets

  /// Where a target's residuals begin.
  std::size_t first_residual(std::size_t t) const { return first_[t]; }
  /// A break whose strain is known.
  struct KnownBreak {
    std::size_t target = 0;
    double strain = 0.0;
  };
  /// Those that a free hinge length is fitted to: the last residuals, one each.
  std::span<const KnownBreak> known_breaks() const { return known_breaks_; }

  /// What the targets' residuals are divided by, at first 1 (n_targets).
  const std::vector<TargetNoise>& noise() const { return noise_; }
  void set_noise(std::vector<TargetNoise> noise) { noise_ = std::move(noise); }
  double scale(std::size_t t) const { return noise_[t].deviation; }  ///< [SI]
  /// Of the squares of a target's samples: the target's weight times the sample's (n_samples).
  std::span<const double> weights(std::size_t t) const { return weights_[t]; }
  /// Model - measured of a target's samples [SI] (n_samples).
  /// @param residuals  of the problem at a point, over weights and scales (m)
  std::vector<double> unscaled(std::size_t t, std::span<const double> residuals) const;

  /// The curves of all targets at several points, run in parallel; what was run there lately is not
  /// run again, if it was beside the same lead (`leads_of`).
  /// @param points  coordinates (count x n), row by row
  /// @return by target and point (n_targets, count)
  std::vector<std::vector<SceneCurve>> curves(std::span<const double> points, std::size_t count);

  /// Whose companion each point of a list is, where that is not said: `leads_among` them; without
  /// companions its own.
  /// @param points  coordinates (count x n), row by row
  std::vector<std::size_t> leads_of(std::span<const double> points, std::size_t count) const;

  /// Residuals at several points, which are run whatever was run before: what that took depends on
  /// the points alone.
  /// @param points  coordinates (count x n), row by row
  /// @param residuals  to be filled where they are found (count x m)
  /// @param leads  whose companion each may be; empty: `leads_of` them (count)
  /// @return of each point (count)
  std::vector<PointRun> evaluate(std::span<const double> points, std::size_t count,
                                 std::span<double> residuals,
                                 std::span<const std::size_t> leads = {});

  /// Of the last run without a curve.
  const std::string& reason() const { return reason_; }
  const RunCounters& counters() const { return counters_; }
  /// Counts runs that were made elsewhere.
  void count(const RunCounters& runs) { counters_.add(runs); }

 private:
  void set_residuals(std::span<const double> points, std::span<double> residuals,
                     std::span<bool> found);
  std::vector<PointRun> compare(const std::vector<std::vector<SceneCurve>>& curves,
                                std::span<const double> points, std::span<double> residuals) const;
  void add_residuals(std::size_t t, const SceneCurve& curve, std::span<double> residuals) const;
  std::vector<std::vector<SceneCurve>> run(const std::vector<std::vector<double>>& points,
                                           std::span<const std::size_t> leads);
  std::vector<double> point(std::span<const double> points, std::size_t index) const;
  void add_priors(std::span<const double> x, std::span<double> residuals) const;
  void add_known_breaks();
  /// @return whether the path gets to the break of every target
  bool add_breaks(const std::vector<std::vector<SceneCurve>>& curves, std::size_t point,
                  std::span<double> residuals) const;

  std::span<const WeightedTarget> targets_;
  const SceneFitOptions& options_;
  SceneParameters parameters_;
  std::vector<SceneModel> models_;
  std::vector<std::size_t> first_;
  std::vector<TargetNoise> noise_;
  std::vector<std::vector<double>> weights_;  ///< by target and sample
  std::vector<std::size_t> priors_;           ///< parameters that have one
  std::vector<KnownBreak> known_breaks_;
  LeastSquaresProblem squares_;
  static constexpr std::size_t kMaxKnown = 64;
  /// Curves of the targets by the lead's coordinates and the point's own: a companion's differ from
  /// those of a lone run within the tolerance.
  std::map<std::vector<double>, std::vector<SceneCurve>> known_;
  RunCounters counters_;
  std::string reason_;
};

}  // namespace plastica::calibrate
