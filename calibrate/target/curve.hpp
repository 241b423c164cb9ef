#pragma once

#include <cstddef>
#include <vector>

namespace plastica::calibrate {

/// A stress-strain curve in SI: strain [1], stress [Pa], both (n).
struct Curve {
  std::vector<double> strain;
  std::vector<double> stress;
  std::size_t size() const { return strain.size(); }
};

/// What loads the specimen. Strain and stress are those of the extreme fibre:
/// tension: elongation/gauge length and F/A; bending: kappa h/2 and M/W_elastic;
/// torsion: gamma = (J/W_t) twist per length and T/W_t.
enum class Test { Tension, Bending, Torsion };

/// How strain and stress are counted; stored and printed beside the yield stress.
enum class Measure { Engineering, True };

/// Monotonic: loaded once, to a break or the end. Cyclic: the reversals are the test.
enum class Loading { Monotonic, Cyclic };

}  // namespace plastica::calibrate
