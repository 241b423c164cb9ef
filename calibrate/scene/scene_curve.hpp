#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/scene/scene_target.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::calibrate {

/// The index of a scene's probe. @throws InputError naming those that there are
std::size_t probe_index(const Scene& scene, const std::string& name, std::string_view field,
                        const SourceLocation& where = {});

/// The curve that a scene gives where a target was measured, as a function of some of its fields.
///
/// The scene never breaks: its limits are taken off, so that no value of them makes the curve jump;
/// `permanent_strain` says what its limit would have to be. Between the recorded samples
/// (solver.steps) the curve is straight.
class SceneCurve {
 public:
  /// @param fields  what `run` sets, in its order; numbers of the field table
  /// @throws InputError if the scene is a coupon, is bad input, or lacks the target's probes
  SceneCurve(const Setup& setup, const SceneTarget& target, std::vector<const Field*> fields);

  /// Runs the scene.
  /// @param values  of the fields [SI]
  /// @return whether it gave a curve over the whole measured abscissa; else `reason` says why
  bool run(std::span<const double> values);

  /// Of the last run that gave one, at the measured abscissa and by its factor [SI] (n_samples).
  const std::vector<double>& ordinate() const { return ordinate_; }
  /// Of the same: the largest permanent strain of a joint, in the scene's break measure, at the
  /// abscissa of the break, or the last one if the target did not break [1].
  double permanent_strain() const { return permanent_strain_; }
  /// The same at another abscissa; empty where the path does not get there.
  std::optional<double> permanent_strain_at(double abscissa) const;
  const std::string& reason() const { return reason_; }
  /// Whether the last run failed because its abscissa turns round on the way.
  bool turns() const { return turns_; }
  int runs() const { return runs_; }
  int failed_runs() const { return failed_runs_; }
  /// Work of all runs, in a measure that no machine changes: segments x Newton iterations.
  std::int64_t segment_iterations() const { return segment_iterations_; }
  Level level() const { return model_.level; }

 private:
  void prepare_model();
  bool set_values(std::span<const double> values);
  bool take_path();
  bool fail(std::string reason);

  Setup setup_;
  const SceneTarget& target_;
  std::vector<const Field*> fields_;
  std::size_t abscissa_probe_ = 0;
  std::size_t ordinate_probe_ = 0;
  /// Whether all fields are parameters of one model; else each run prepares its own.
  bool prepared_ = false;
  Model model_;
  Workspace workspace_;
  Response response_;
  std::vector<double> path_, height_, strain_;  ///< of the path's samples, rising abscissa
  std::vector<double> ordinate_;
  double permanent_strain_ = 0.0;
  std::string reason_;
  bool turns_ = false;
  int runs_ = 0;
  int failed_runs_ = 0;
  std::int64_t segment_iterations_ = 0;
};

}  // namespace plastica::calibrate
