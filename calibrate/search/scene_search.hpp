#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/problem/scene_problem.hpp"
#include "calibrate/search/least_squares.hpp"
#include "calibrate/search/search_record.hpp"

namespace plastica::calibrate {

class SceneErrors;

/// What a search is kept by: "polish 2".
std::string kept_name(std::string_view stage, std::size_t index);

/// Infinite of a search that has found no curve.
double cost_of_search(const LeastSquares& found);

/// The search for the least sum of squares of a fit through scenes, and for the noise that weights
/// its targets.
///
/// Sobol's points within the bounds are screened; from the start and from the best of them that lie
/// apart go short searches side by side, the best of these go on to their ends, and the best of all
/// past kinks. An algorithm that the options name searches alone, from the start.
class SceneSearch {
 public:
  /// Sets the problem's scales: the noise of targets that state theirs, else their largest
  /// ordinate.
  /// @param problem, options  must outlive this
  SceneSearch(SceneProblem& problem, const SceneFitOptions& options);

  /// Searches, then settles the noise. To be called once. @throws FitInterrupted
  void run();

  /// Whether any start gave a curve.
  bool found() const { return best_.outcome != LeastSquaresOutcome::NoStart; }
  /// The best point, with residuals over the scales that the problem has at the end.
  const LeastSquares& best() const { return best_; }
  const std::vector<SceneStart>& starts() const { return starts_; }  ///< in their order

  /// Whether all targets state their noise.
  bool knows_noise() const { return knows_noise_; }
  /// Sum of the squares of a target at the best point, without its weight and scale [SI^2].
  double cost_of(std::size_t t) const;
  /// The noise of a target, estimated from its residuals whatever the target states [SI].
  double noise_left(std::size_t t) const;

  /// Why the start's own scene gave no curve, and whether it was its abscissa's probe that turned.
  const std::string& first_reason() const { return first_reason_; }
  bool start_reverses() const { return start_reverses_; }

 private:
  using Points = std::vector<std::vector<double>>;

  std::vector<double> searched_values(std::span<const double> x) const;
  Points drawn(int count) const;
  std::vector<double> screened_costs(const Points& points);
  Points screened_starts(int count);
  std::vector<SearchRecord> search_from(std::string_view stage, const Points& starts,
                                        int evaluations);
  void search_together(std::string_view stage, const Points& starts, int evaluations,
                       std::span<const std::size_t> which, std::vector<SearchRecord>& records);
  void polish(std::vector<SearchRecord>& records);
  SearchRecord made_once(std::string_view stage, const std::function<SearchRecord()>& make);
  SearchRecord search_alone();
  void search_around();
  void pass_kinks(std::string_view stage);
  void search();
  void settle_noise();
  std::vector<double> costs() const;
  std::vector<TargetNoise> noise_of(const SceneErrors& errors) const;
  double rescale(std::vector<TargetNoise> noise);
  void set_left(const SceneErrors& errors);
  void tell(std::string_view stage, std::size_t done, std::size_t total) const;

  SceneProblem& problem_;
  const SceneFitOptions& options_;
  bool knows_noise_ = false;
  /// Of the residuals of each target that are its noise: degrees of freedom, and squares [SI^2].
  std::vector<double> degrees_left_, squares_left_;
  LeastSquares best_;
  std::vector<SceneStart> starts_;
  std::string first_reason_;
  bool start_reverses_ = false;
};

}  // namespace plastica::calibrate
