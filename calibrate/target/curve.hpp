#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plastica/model/drive.hpp"

namespace plastica::calibrate {

class CurveSpool;

/// Where the samples of a curve lie that is put aside (curve_spool.hpp).
struct PlaceOfCurve {
  std::uint64_t offset = 0;   ///< of its first strain, in numbers
  std::size_t samples = 0;    ///< 0: it is not put aside
  std::uint64_t digest = 0;   ///< `digest_of` the curve
  std::size_t to_stress = 0;  ///< from the first strain to the first stress, in numbers
  double shift = 0.0;         ///< is subtracted from the strains that lie there [1]
};

/// A stress-strain curve in SI: strain [1], stress [Pa], both (n).
struct Curve {
  std::vector<double> strain;
  std::vector<double> stress;
  PlaceOfCurve aside{};  ///< of large batches: where the samples are, in place of the above
  std::shared_ptr<const CurveSpool> spool{};  ///< that has them; null: they were counted alone

  std::size_t size() const { return strain.size(); }
  /// How many it has, here or put aside.
  std::size_t samples() const { return is_aside() ? aside.samples : size(); }
  bool is_aside() const { return aside.samples > 0; }
};

/// The largest |value|; 0 if there is none. NaN is left out.
double largest_magnitude(std::span<const double> values);

/// What loads the specimen; says of which fibre strain and stress are (see `Deformation`).
using Test = Deformation;

/// How strain and stress are counted; stored and printed beside the yield stress.
enum class Measure { Engineering, True };

/// Monotonic: loaded once, to a break or the end. Cyclic: the reversals are the test.
enum class Loading { Monotonic, Cyclic };

}  // namespace plastica::calibrate
