#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plastica/model/drive.hpp"

namespace plastica::calibrate {

/// A stress-strain curve in SI: strain [1], stress [Pa], both (n).
struct Curve {
  std::vector<double> strain;
  std::vector<double> stress;
  std::size_t size() const { return strain.size(); }
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
