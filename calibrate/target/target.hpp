#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/target/curve.hpp"

namespace plastica::calibrate {

/// One kind of mending done to the measured samples, and how often.
struct Repair {
  std::string kind;       ///< "nan-rows", "strain-reversals", "torn-last-row", …: a fixed word
  std::size_t count = 0;  ///< samples touched
  std::string text;       ///< one sentence for the report
};

/// One correction of the curve as a whole.
struct Correction {
  std::string kind;  ///< "toe", "preload-offset", "trim-at-break", "true-measure", …
  bool applied = false;
  double amount = 0.0;  ///< its size in SI: strain shift, stress shift, samples cut
  std::string unit;     ///< unit of the amount: "1", "Pa", "samples"
  std::string text;     ///< the rule that triggered it, or why it did not
};

/// When the specimen broke, between two samples.
struct BreakObservation {
  double last_intact_strain = 0.0;  ///< [1] largest that still carries load; cyclic: the last
  double last_intact_stress = 0.0;  ///< [Pa]
  /// [1] of the first sample after it, or a step on (find_break.hpp): never below
  /// last_intact_strain, but of a cyclic test that breaks on its way down.
  double first_broken_strain = 0.0;
  std::string rule;  ///< "fall-to-zero", "load-drop", "end-of-data"
  /// Middle of the sampling interval, the measured break strain [1].
  double strain() const { return 0.5 * (last_intact_strain + first_broken_strain); }
  /// Half of the interval: the break is known to +- this [1].
  double half_interval() const { return 0.5 * std::fabs(first_broken_strain - last_intact_strain); }
};

/// Characteristics after ISO 6892-1 / ASTM E8, from the corrected curve. What a curve does not
/// have is empty. Strains [1] and stresses [Pa] in the measure of the target.
struct Characteristics {
  std::optional<double> youngs_modulus;
  std::optional<double> youngs_modulus_stderr;  ///< of the regression
  double modulus_window_low = 0.0;              ///< stress window of the modulus [Pa]
  double modulus_window_high = 0.0;
  std::string modulus_method;          ///< "regression", "chord", "given"
  std::optional<double> offset;        ///< the proof-stress offset used [1], 0.002 by default
  std::optional<double> proof_stress;  ///< at that offset
  std::optional<double> reh;           ///< upper yield strength
  std::optional<double> rel;           ///< lower yield strength
  std::optional<double> rm;            ///< largest stress
  std::optional<double> strain_at_rm;
  std::optional<double> break_strain;          ///< total, middle of the sampling interval
  std::optional<double> break_strain_plastic;  ///< break_strain - stress/E
  std::optional<BreakObservation> observed_break;
  double largest_strain = 0.0;  ///< of the whole specimen

  /// Young's modulus, if its standard error is at most 5 %. One that is known worse stays in the
  /// file with its error, but is neither shown as a number nor averaged.
  std::optional<double> sound_modulus() const;
  /// How far the sampling of the break and the modulus's error leave the permanent strain open [1].
  double permanent_strain_error() const;
};

/// What became of a specimen on its way from the file to the fit.
enum class TargetStatus {
  Ready,        ///< can be fitted
  TooCoarse,    ///< too few samples on the elastic part or the plateau
  Rejected,     ///< cannot be repaired; `reason` says why
  Implausible,  ///< is that of no material (plausibility.hpp), most likely by a mistaken unit
};

/// One specimen, ready for a fit or rejected with its reason.
struct Target {
  std::string name;  ///< unique in a batch: the file's stem (and column, where a file holds many)
  std::string file;
  Test test = Test::Tension;
  Measure measure = Measure::Engineering;
  Loading loading = Loading::Monotonic;
  TargetStatus status = TargetStatus::Ready;
  std::string reason;  ///< for all but Ready

  std::vector<std::pair<std::string, std::string>> group;  ///< e.g. {"temperature", "20"}
  std::vector<std::pair<std::string, double>> properties;  ///< per-specimen SI values used (area…)

  /// One of `properties`, if it is there.
  std::optional<double> property(std::string_view property_name) const;

  Curve raw;        ///< as read, in SI, before any repair
  Curve corrected;  ///< repaired, corrected and trimmed: intact samples only, break not included
  std::vector<Repair> repairs;
  std::vector<Correction> corrections;
  std::vector<std::string> warnings;
  Characteristics characteristics;
  /// Error of the strain's zero [1]: the standard error of its shift, where the elastic line
  /// decided it; where the line misses the origin by too little for a shift, by how much, or the
  /// error of that, if it is larger. Not stored.
  double shift_error = 0.0;
  /// Whether samples beyond Rm, which have no true strain, were left out; not stored.
  bool ends_at_neck = false;
  bool ran_back = false;  ///< whether the strain was lost under load before the break; not stored
};

}  // namespace plastica::calibrate
