#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/target/scene_target.hpp"
#include "plastica/run/companions.hpp"

namespace plastica::calibrate {

/// The index of a scene's probe. @throws InputError naming those that there are
std::size_t probe_index(const Scene& scene, const std::string& name, std::string_view field,
                        const SourceLocation& where = {});

/// A scene whose path ends before the measured abscissa does goes on to so many times its end.
inline constexpr int kMaxTimes = 4;

/// Largest permanent strains of a joint that takes the fitted limit, in the scene's break measure
/// [1]; NaN where the path does not get there.
struct StrainAtBreak {
  double at =
      std::numeric_limits<double>::quiet_NaN();  ///< where the target broke, or its last one
  double before = std::numeric_limits<double>::quiet_NaN();  ///< where it was intact for sure
  double after = std::numeric_limits<double>::quiet_NaN();   ///< where it was broken for sure
  /// The largest on the way, up to where it was intact for sure: of a net measure it may be that of
  /// an earlier stroke.
  double survived = std::numeric_limits<double>::quiet_NaN();
};

/// What a scene gives where a target was measured.
struct SceneCurve {
  bool was_run = true;      ///< a companion is not, whose lead has no curve
  bool usable = false;      ///< whether there is a curve over the whole measured abscissa
  std::string reason;       ///< else why not
  bool reverses = false;    ///< whether that is because the abscissa's probe turns round on the way
  bool ends_early = false;  ///< … or because the scene's path ends before the measured one
  bool is_extended = false;      ///< whether it is of a path beyond the scene's end (`kMaxTimes`)
  std::vector<double> ordinate;  ///< at the measured abscissa and by the target's factor [SI] (n)
  StrainAtBreak strain;
  /// Work, in a measure that no machine changes: segments x Newton iterations of the runs that led
  /// to it. What a companion has done before it had to run alone is not in it.
  std::int64_t segment_iterations = 0;
};

/// A scene as a function of some of its fields, held against a target.
///
/// The scene never breaks: its limits are taken off, so that no value of them makes the curve jump;
/// `StrainAtBreak` says what its limit would have to be. Driven by the target, the scene has a
/// sample where the target has one; else the curve is straight between the recorded samples
/// (solver.steps), and where the scene's path ends early its ramps go on (`is_extended`). Never
/// changes, so that threads share it.
class SceneModel {
 public:
  /// @param fields  what `run` sets, in its order; numbers of the field table
  /// @throws InputError if the scene is bad input, cannot follow the target or lacks its probes
  SceneModel(const Setup& setup, const SceneTarget& target, std::vector<const Field*> fields);

  /// Runs the scene at several points, in parallel, with the same bits in every company but that
  /// of its lead.
  /// @param values  of the fields [SI] (count x n_fields), row by row
  /// @param threads  0: as many as the machine has
  /// @param stop  once raised, no further run is begun, and what is not finished has no curve; may
  ///              be null
  /// @param leads  the point near to it whose companion each may be (plastica/run/companions.hpp),
  ///               or its own number (count); empty: all are on their own
  std::vector<SceneCurve> run(std::span<const double> values, std::size_t count, int threads = 1,
                              StopFlag stop = nullptr,
                              std::span<const std::size_t> leads = {}) const;
  /// Whether companions cost less than runs of their own.
  bool has_companions() const {
    return most_companions(extended_ ? *extended_ : model_) >
           0;  // the larger one, if there are two
  }
  /// What the points of differences are: "companions", or "runs of their own:" and why.
  std::string slopes_from() const;

  Level level() const { return model_.level; }
  /// What a reader must not overlook of the scene with values of the fields, which it runs with:
  /// its `run_warnings`. Of one that cannot run, nothing.
  std::vector<std::string> warnings(std::span<const double> values) const;
  /// Whether any region takes a limit of the scene's material: not if regions of others cover it
  /// all.
  bool takes_a_limit() const;

 private:
  /// The path may end short of the measured abscissa by this fraction of it: rounding of a motion
  /// that is prescribed to end there.
  static constexpr double kRounding = 1e-9;

  Setup setup_at(const Setup& base, std::span<const double> values) const;
  std::vector<SceneCurve> run(bool is_extended, std::span<const double> values,
                              std::span<const std::size_t> leads, const BatchOptions& how) const;
  std::vector<SceneCurve> run_alone(bool is_extended, std::span<const double> values,
                                    std::span<const std::size_t> which,
                                    const BatchOptions& how) const;
  /// @param which  the lead first
  std::vector<SceneCurve> run_together(bool is_extended, std::span<const double> values,
                                       std::span<const std::size_t> which, StopFlag stop) const;
  /// Of some of the points, row by row.
  std::vector<double> values_of(std::span<const double> values,
                                std::span<const std::size_t> which) const;
  // Of one point, by its values:
  SceneCurve curve_at(bool is_extended, std::span<const double> values,
                      const Response& response) const;
  SceneCurve curve_at(bool is_extended, std::span<const double> values, const BatchRow& row) const;
  BatchCase case_at(bool is_extended, std::span<const double> values, std::size_t number) const;
  void extend(std::span<const double> values, std::span<const std::size_t> leads,
              const BatchOptions& how, std::vector<SceneCurve>& curves) const;
  /// Which joints take a limit of the scene's material (N + 1): those of its regions, the weaker
  /// one of two that meet, which the values decide. Of a coupon none.
  std::vector<bool> joints_of_the_limit(const Setup& setup, const Model& model,
                                        std::span<const double> values) const;
  /// @param limited  `joints_of_the_limit`, of this and what it calls
  SceneCurve curve_of(const Response& response, const std::vector<bool>& limited,
                      bool is_extended) const;
  bool place(const Response& response, std::vector<double>& path, SceneCurve& curve) const;
  double strain_of(const Response& response, const std::vector<bool>& limited,
                   std::size_t sample) const;
  double strain_at(const Response& response, const std::vector<double>& path,
                   const std::vector<bool>& limited, double at) const;
  void set_ordinate(const Response& response, const std::vector<double>& path,
                    SceneCurve& curve) const;
  /// The largest up to a place of the path, and there.
  double largest_strain(const Response& response, const std::vector<double>& path,
                        const std::vector<bool>& limited, double until) const;
  void set_strain(const Response& response, const std::vector<double>& path,
                  const std::vector<bool>& limited, SceneCurve& curve) const;

  Setup setup_;
  SceneTarget target_;
  std::vector<const Field*> fields_;
  std::size_t abscissa_probe_ = 0;
  std::size_t ordinate_probe_ = 0;
  std::optional<std::size_t> strain_probe_;  ///< none: strains are those of the shapes
  /// Whether all fields are parameters of one model; else each run lays out its own.
  bool prepared_ = false;
  Model model_;
  std::optional<Setup> extended_setup_;  ///< whose path goes on, if it does
  std::optional<Model> extended_;
  /// Regions that take a limit of the scene's material, the beam beside them first; of a chain.
  std::vector<bool> limited_;
};

}  // namespace plastica::calibrate
