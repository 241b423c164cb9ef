#pragma once

#include <cstddef>
#include <optional>

#include "calibrate/target/curve.hpp"
#include "calibrate/target/options.hpp"

namespace plastica::calibrate {

/// The elastic line stress = modulus (strain - zero_strain).
struct ElasticLine {
  double modulus = 0.0;             ///< [Pa]
  double modulus_stderr = 0.0;      ///< [Pa]; 0 unless by regression
  double zero_strain = 0.0;         ///< [1] where the line meets zero stress
  double zero_strain_stderr = 0.0;  ///< [1]
  double low = 0.0;                 ///< stress window [Pa]
  double high = 0.0;
  double yield_stress = 0.0;  ///< [Pa] the proof stress that the window refers to, or Rm
  std::size_t samples = 0;    ///< in the window
  /// Slope of the window's lower half over that of its upper half, if they differ by 5 standard
  /// errors; else 1. An elastic part is straight.
  double bend = 1.0;
  bool is_straight() const { return bend <= 1.25; }
};

/// Finds the elastic line by the rules of TargetOptions, on the first loading, up to the largest
/// stress (a cyclic curve that starts in compression is mirrored). Samples lie in the window by
/// their feet on the line, so that their noise does not decide which are in.
/// @param noise  of the stress [Pa], a floor of the standard errors
/// @return empty if the window holds too few samples even when widened
/// @throws InputError if a chord is asked for without a window, or a window is empty
std::optional<ElasticLine> find_elastic_line(const Curve& curve, Loading loading, double noise,
                                             const TargetOptions& options);

}  // namespace plastica::calibrate
