#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace plastica::testing {

/// Standard normal numbers, the same on every machine.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : random_(seed) {}
  double draw() {
    constexpr double kRotation = 6.283185307179586;
    return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(kRotation * uniform());
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
  std::mt19937_64 random_;
};

}  // namespace plastica::testing
