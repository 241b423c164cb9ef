#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "plastica/base/fused.hpp"
#include "plastica/base/matrix.hpp"

/// Symmetric matrices, and products of base/matrix.hpp with a term added, all of it fused.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// A symmetric matrix: what is on and right of its diagonal, row by row.
template <class S, std::size_t N>
struct Symmetric {
  std::array<S, N*(N + 1) / 2> at{};

  PLASTICA_ALWAYS_INLINE constexpr S& operator()(std::size_t i, std::size_t j) {
    return at[index(i, j)];
  }
  PLASTICA_ALWAYS_INLINE constexpr const S& operator()(std::size_t i, std::size_t j) const {
    return at[index(i, j)];
  }
  PLASTICA_ALWAYS_INLINE friend constexpr Symmetric operator+(const Symmetric& a,
                                                              const Symmetric& b) {
    return {each_of<N*(N + 1) / 2>([&](std::size_t i)
                                       PLASTICA_ALWAYS_INLINE -> S { return a.at[i] + b.at[i]; })};
  }

 private:
  PLASTICA_ALWAYS_INLINE static constexpr std::size_t index(std::size_t i, std::size_t j) {
    const std::size_t row = i < j ? i : j;
    return row * (2 * N - row - 1) / 2 + (i < j ? j : i);
  }
};

/// N numbers of a row, or of a column, of a matrix of either kind.
template <std::size_t N, class M>
PLASTICA_ALWAYS_INLINE constexpr auto row(const M& m, std::size_t i) {
  using S = std::remove_cvref_t<decltype(m(0, 0))>;
  return Vec<S, N>{each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE -> S { return m(i, k); })};
}
template <std::size_t N, class M>
PLASTICA_ALWAYS_INLINE constexpr auto column(const M& m, std::size_t j) {
  using S = std::remove_cvref_t<decltype(m(0, 0))>;
  return Vec<S, N>{each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE -> S { return m(k, j); })};
}

/// to = from, number by number: a matrix that is copied as a whole stays in memory, and the frames
/// of a spatial step do so at the cost of a third of it (AVX2).
template <class S, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr void assign(const Mat<S, R, C>& from, Mat<S, R, C>& to) {
  for_each_of<R * C>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { to.at[i] = from.at[i]; });
}

/// s a + b.
template <class S, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, N> scale_add(const std::type_identity_t<S>& s,
                                                     const Vec<S, N>& a, const Vec<S, N>& b) {
  return {each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S { return s * a[i] + b[i]; })};
}

/// a . b + c.
template <class S, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr S dot_add(const Vec<S, N>& a, const Vec<S, N>& b,
                                           const std::type_identity_t<S>& c) {
  S sum = c;
  for_each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { sum = a[i] * b[i] + sum; });
  return sum;
}

/// m x + c.
template <class M, class S, std::size_t C, std::size_t R>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, R> times_add(const M& m, const Vec<S, C>& x,
                                                     const Vec<S, R>& c) {
  return {each_of<R>([&](std::size_t i)
                         PLASTICA_ALWAYS_INLINE -> S { return dot_add(row<C>(m, i), x, c[i]); })};
}
/// m^T x + c.
template <class M, class S, std::size_t C, std::size_t R>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, R> transposed_times_add(const M& m, const Vec<S, C>& x,
                                                                const Vec<S, R>& c) {
  return {each_of<R>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S {
    return dot_add(column<C>(m, i), x, c[i]);
  })};
}

/// Adds s a a^T.
template <class S, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr void add_square(const std::type_identity_t<S>& s,
                                                 const Vec<S, N>& a, Symmetric<S, N>& m) {
  const Vec<S, N> b = s * a;
  for_each_of<N * N>([&](std::size_t at) PLASTICA_ALWAYS_INLINE {
    const std::size_t i = at / N, j = at % N;
    if (i <= j) m(i, j) += b[i] * a[j];
  });
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
