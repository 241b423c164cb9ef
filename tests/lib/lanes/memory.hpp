#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

#include "plastica/base/instruction_set.hpp"

namespace plastica::lanes::testing {

/// The instruction sets that this machine can run.
inline std::vector<InstructionSet> levels() {
  std::vector<InstructionSet> there;
  for (const InstructionSet level :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    if (has_instruction_set(level)) there.push_back(level);
  }
  return there;
}

/// Of a symmetric positive definite matrix.
inline std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t r = i + 1; r < n; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < n; ++c) a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c) b[i] -= a[i][c] * b[c];
    b[i] /= a[i][i];
  }
  return b;
}

/// Where the number of lane `lane` of entry `entry`, field `field`, is.
inline std::size_t place(std::size_t entry, std::size_t fields, std::size_t field,
                         std::size_t width, std::size_t lane) {
  return (entry * fields + field) * width + lane;
}

/// Memory of `width` beams, aligned for the kernels; zeros.
template <class Real>
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(std::size_t size)
      : at_(static_cast<Real*>(std::aligned_alloc(64, (size * sizeof(Real) + 63) / 64 * 64))) {
    for (std::size_t i = 0; i < size; ++i) at_[i] = Real(0);
  }
  Real* data() const { return at_.get(); }
  Real& operator[](std::size_t i) const { return at_[i]; }

 private:
  struct Free {
    void operator()(Real* p) const { std::free(p); }
  };
  std::unique_ptr<Real[], Free> at_;
};

}  // namespace plastica::lanes::testing
