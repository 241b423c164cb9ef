#pragma once

#include <cstddef>
#include <vector>

#include "plastica/base/scalar.hpp"

namespace plastica::solve {

/// Of its own size, what rounding leaves of a pivot that would be zero, generously: 1e-14 with some
/// thousand segments, and a support that holds a shallow arch along its chord has 1e-9 and more.
template <class S>
inline constexpr double kRoundedPivot = kIsDouble<S> ? 1e-12 : 1e-5;

/// A dense system of a few unknowns (the constraints of a chain), solved by Gauss with column
/// pivots that are chosen lane by lane; `resize` allocates, nothing else does.
template <class S>
class SmallSystem {
 public:
  void resize(std::size_t n) {
    n_ = n;
    a_.resize(n * n);
    b_.resize(n);
  }
  std::size_t size() const { return n_; }
  S& a(std::size_t row, std::size_t column) { return a_[row * n_ + column]; }
  S& b(std::size_t row) { return b_[row]; }
  const S& b(std::size_t row) const { return b_[row]; }

  /// Replaces b by the solution; `a` is used up.
  void solve() {
    for (std::size_t k = 0; k < n_; ++k) {
      for (std::size_t i = k + 1; i < n_; ++i) swap_larger(k, i);
      const S pivot = constant<S>(1) / a(k, k);
      for (std::size_t i = k + 1; i < n_; ++i) {
        const S factor = a(i, k) * pivot;
        for (std::size_t j = k + 1; j < n_; ++j) a(i, j) = a(i, j) - factor * a(k, j);
        b(i) = b(i) - factor * b(k);
      }
    }
    for (std::size_t k = n_; k-- > 0;) {
      for (std::size_t j = k + 1; j < n_; ++j) b(k) = b(k) - a(k, j) * b(j);
      b(k) = b(k) / a(k, k);
    }
  }

  /// Eliminates the first rows in their order, as of a symmetric matrix, and visits the pivots:
  /// what is left of each row beside those before it. A pivot of 0 is left out; `a` is used up.
  /// @param visit  of a row and its pivot
  template <class Visit>
  void for_each_pivot(std::size_t rows, const Visit& visit) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    for (std::size_t k = 0; k < rows; ++k) {
      const S pivot = a(k, k);
      visit(k, pivot);
      const auto none = (pivot <= zero) & (pivot >= zero);
      const S scale = select(none, zero, one / select(none, one, pivot));
      for (std::size_t i = k + 1; i < rows; ++i) {
        const S factor = a(i, k) * scale;
        for (std::size_t j = k + 1; j < rows; ++j) a(i, j) = a(i, j) - factor * a(k, j);
      }
    }
  }

 private:
  /// Rows k and i change places where the lower one has the larger first entry.
  void swap_larger(std::size_t k, std::size_t i) {
    const auto swap = abs(a(i, k)) > abs(a(k, k));
    const auto exchange = [&](S& x, S& y) {
      const S kept = x;
      x = select(swap, y, x);
      y = select(swap, kept, y);
    };
    for (std::size_t j = k; j < n_; ++j) exchange(a(k, j), a(i, j));
    exchange(b(k), b(i));
  }

  std::size_t n_ = 0;
  std::vector<S> a_;
  std::vector<S> b_;
};

}  // namespace plastica::solve
