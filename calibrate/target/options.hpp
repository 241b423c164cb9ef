#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "calibrate/target/curve.hpp"

namespace plastica::calibrate {

/// Whether a correction follows its rule, is set by the user, or is off.
struct CorrectionChoice {
  enum class Mode { Automatic, Set, Off };
  Mode mode = Mode::Automatic;
  double amount = 0.0;  ///< with `Set` only; the correction says what it means
};

enum class ModulusMethod { Regression, Chord };

// What is left of the largest load at a break, and by how much of it the load falls there: of
// curves, where it can be told otherwise, and of beams.
inline constexpr double kBreakZero = 0.05;
inline constexpr double kBreakDrop = 0.2;

/// Beyond these a tension curve is that of no material, see plausibility.hpp. Yield strain: stress
/// at yield over Young's modulus.
struct PlausibleBounds {
  double min_modulus = 1e5;          ///< [Pa] soft silicones have 0.3 MPa
  double max_modulus = 1.3e12;       ///< [Pa] diamond has 1.2 TPa
  double min_yield_strain = 5e-5;    ///< [1] pure copper has 2e-4
  double max_yield_strain = 0.03;    ///< [1] of stresses above `strong_stress`: spring steel 0.01
  double max_elastic_strain = 0.08;  ///< [1] the same of what does not yield: glass fibres 0.056
  double strong_stress = 120e6;      ///< [Pa] plastics without fibres yield below
  /// [1] of proof stresses below `soft_modulus`: plastics have 0.01 and more
  double min_soft_yield_strain = 5e-3;
  double soft_modulus = 4.5e9;         ///< [Pa] metals are stiffer, even lead as it creeps
  double max_strain = 12.0;            ///< [1] rubbers tear at 10
  double max_strong_strain = 1.5;      ///< [1] of stresses above `strong_stress`
  double max_ductile_modulus = 450e9;  ///< [Pa] of what stretches by 2 %: tungsten has 410 GPa
  double modulus_factor = 2.5;         ///< that E may be off the expected one, > 1
  double group_factor = 10.0;          ///< that E and the strength may be off a group's median, > 1
};

/// How a measured curve becomes a target: repairs, corrections, characteristics. A monotonic curve
/// in compression (largest |stress| and its strain negative) or without a rising part is rejected.
struct TargetOptions {
  Test test = Test::Tension;
  Measure measure = Measure::Engineering;  ///< what the samples are, as measured
  /// Empty: found out. An unloading is a |stress| that falls below half of its peak while the
  /// strain turns back; the peak must reach half of the largest |stress|, as many tension tests
  /// start with settling cycles far below the yield stress. Cyclic if an unloading goes on to the
  /// other sign, beyond 0.1 of the largest |stress| in 2 samples, or if at least 3 are loaded again
  /// and together run back further than the strain range of the curve (pulsating tests). A tension
  /// test with a few loops to measure the modulus is monotonic, see `drop_unloading_loops`. Of the
  /// stresses, medians of three neighbours count: a lone outlier turns nothing.
  std::optional<Loading> loading;

  // Repairs
  double reversal_tolerance = 1e-5;  ///< [1] strain may fall this far below its maximum, monotonic

  // Corrections
  /// Toe (foot) compensation, amount: strain [1] taken off every sample. Automatic: the elastic
  /// line meets zero stress further than `shift_threshold` of the yield strain and 6 standard
  /// errors from zero strain, and the first sample is not on that line. Never automatic
  /// on a cyclic curve, or by more than the yield strain, unless the curve carries less than 5 % of
  /// the yield stress until nine tenths of the way there: slack. With a given modulus (its line
  /// goes through the measured zero) only slack beyond `given_modulus_threshold`, of a curve that
  /// rises within 15 % of it. Samples before the new origin are dropped.
  CorrectionChoice toe;
  /// Preload offset, amount: strain [1] taken off every sample. Automatic: as the toe, but the
  /// first sample is on the elastic line (nearer to it than half of the shift): the strain was
  /// zeroed at another load. With a given modulus: the line of that slope through the first sample
  /// misses the origin by more than `given_modulus_threshold` of the strain Rm/modulus; smaller
  /// offsets may as well be a modulus that differs from the given one.
  CorrectionChoice preload;
  double shift_threshold = 0.01;         ///< of the yield strain, see `toe`
  double given_modulus_threshold = 0.1;  ///< of Rm/modulus, see `preload`
  /// Trim at break, amount: measured strain [1] beyond which the specimen is broken.
  /// Automatic, after the largest stress, the first that holds:
  /// - a run of samples that falls by `drop_fraction` of Rm or more, each step steeper than half
  ///   the modulus: broken from the first sample below (1 - drop_fraction) of the run's start;
  /// - one step that falls by half of Rm or more;
  /// - a sample at or below `zero_fraction` of Rm;
  /// - the data end at or below `end_fraction` of Rm (necked): broken within one more step. Rm is
  ///   here the largest stress after an upper yield point, and the load must fall at the end: by a
  ///   quarter of the fall from Rm within the second half of the strain from Rm on. An
  ///   `end_fraction` above the default says that the end is the break, fall or not.
  /// In the first three the load must stay down: no later sample is above (1 - drop_fraction) of
  /// the load before the drop (or twice `zero_fraction` of Rm). Unloading is no break: see
  /// `drop_unloading`.
  /// Cyclic: only last rows within `zero_fraction` after more than half of the largest |stress|.
  CorrectionChoice trim;
  double drop_fraction = kBreakDrop;
  double zero_fraction = kBreakZero;
  double end_fraction = 0.9;
  /// Convert engineering to true: strain ln(1 + e), stress s (1 + e). Tension only. Samples
  /// beyond the strain at Rm are refused (cut, with the break) as the specimen necks there.
  bool convert_to_true = false;
  /// It was compressed, and the sign of its strain turned: -ln(1 - e), s (1 - e) are true.
  bool is_compressed = false;
  bool force_true = false;  ///< convert beyond Rm as well

  // Characteristics
  std::optional<double> youngs_modulus;  ///< [Pa] given: nothing is measured
  ModulusMethod modulus_method = ModulusMethod::Regression;
  /// Stress window of the modulus [Pa]; required for a chord. Empty: `modulus_low` to
  /// `modulus_high` of the proof stress (of Rm if there is none). Widened in steps of 0.1: at both
  /// ends, to at most 0 and 0.8, while it holds fewer than 3 samples; at the low end while the
  /// modulus has a standard error above 3 %. Of windows that agree with the proof stress of their
  /// own slope the steepest one counts. Samples lie in it by their place along the line. It moves
  /// down, to 0.75 of itself and at most four times, while the slope of its lower half exceeds that
  /// of the upper one by 40 % and 5 standard errors.
  std::optional<std::pair<double, double>> modulus_window;
  double modulus_low = 0.2;
  double modulus_high = 0.6;
  double offset = 0.002;  ///< [1] plastic strain of the proof stress
  /// Smallest fall after an upper yield point, as a fraction of it; also at least 8 times the
  /// noise. The stress must climb above it again, otherwise it is Rm. How deep a transient must be
  /// to be left out of the lower yield strength, too (`leave_out_transient`).
  double yield_drop = 0.003;

  /// Samples wanted on the elastic part and on the plateau of a monotonic curve; fewer: TooCoarse.
  /// They part at the yield strain, proof stress (or Rm) / modulus; those within its uncertainty
  /// (5 standard errors, 1e-6 to 10 %) count for both. A curve that is elastic to its end has no
  /// plateau to count.
  std::size_t min_samples = 5;

  // Plausibility
  PlausibleBounds plausible;
  std::optional<double> expected_modulus;  ///< [Pa] that of the material that the user names
  bool accept = false;                     ///< what is implausible is fitted, with a warning
};

}  // namespace plastica::calibrate
