#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/each_of.hpp"
#include "plastica/base/scalar.hpp"

/// Small vectors and matrices of kernels: sizes known to the compiler, no heap, any scalar.
///
/// Their operators are written out and always inlined: see `each_of`. Products go into sums as they
/// are, for scalars that fuse the two: see `Fused`.
namespace plastica {
PLASTICA_KERNELS_BEGIN

/// N numbers; starts at zero.
template <class S, std::size_t N>
struct Vec {
  std::array<S, N> at{};

  constexpr S& operator[](std::size_t i) { return at[i]; }
  constexpr const S& operator[](std::size_t i) const { return at[i]; }

  PLASTICA_ALWAYS_INLINE friend constexpr Vec operator+(const Vec& a, const Vec& b) {
    return {
        each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S { return a.at[i] + b.at[i]; })};
  }
  PLASTICA_ALWAYS_INLINE friend constexpr Vec operator-(const Vec& a, const Vec& b) {
    return {
        each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S { return a.at[i] - b.at[i]; })};
  }
  PLASTICA_ALWAYS_INLINE friend constexpr Vec operator-(const Vec& a) { return Vec{} - a; }
  PLASTICA_ALWAYS_INLINE friend constexpr Vec operator*(const S& s, const Vec& a) {
    return {each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S { return s * a.at[i]; })};
  }
  PLASTICA_ALWAYS_INLINE constexpr Vec& operator+=(const Vec& b) { return *this = *this + b; }
  PLASTICA_ALWAYS_INLINE constexpr Vec& operator-=(const Vec& b) { return *this = *this - b; }
};

template <class S, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr S dot(const Vec<S, N>& a, const Vec<S, N>& b) {
  if constexpr (N == 0) return constant<S>(0);
  return sum_of<S, N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { return a[i] * b[i]; });
}

template <class S, std::size_t N>
inline S size_of(const Vec<S, N>& v) {
  return sqrt(dot(v, v));
}

/// The same numbers in double, for what is recorded.
template <class S, std::size_t N>
constexpr Vec<double, N> in_double(const Vec<S, N>& v) {
  Vec<double, N> wide;
  for (std::size_t i = 0; i < N; ++i) wide[i] = v[i];
  return wide;
}

/// What an index among rows of C numbers is divided by; matrices without columns have no index.
template <std::size_t C>
inline constexpr std::size_t kDivisor = C == 0 ? 1 : C;

/// R x C numbers, row by row; starts at zero.
template <class S, std::size_t R, std::size_t C>
struct Mat {
  std::array<S, R * C> at{};

  constexpr S& operator()(std::size_t row, std::size_t column) { return at[row * C + column]; }
  constexpr const S& operator()(std::size_t row, std::size_t column) const {
    return at[row * C + column];
  }

  PLASTICA_ALWAYS_INLINE friend constexpr Mat operator+(const Mat& a, const Mat& b) {
    return {each_of<R * C>([&](std::size_t i)
                               PLASTICA_ALWAYS_INLINE -> S { return a.at[i] + b.at[i]; })};
  }
  PLASTICA_ALWAYS_INLINE friend constexpr Mat operator-(const Mat& a, const Mat& b) {
    return {each_of<R * C>([&](std::size_t i)
                               PLASTICA_ALWAYS_INLINE -> S { return a.at[i] - b.at[i]; })};
  }
  PLASTICA_ALWAYS_INLINE friend constexpr Mat operator-(const Mat& a) { return Mat{} - a; }
  PLASTICA_ALWAYS_INLINE friend constexpr Mat operator*(const S& s, const Mat& a) {
    return {each_of<R * C>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S { return s * a.at[i]; })};
  }
  PLASTICA_ALWAYS_INLINE constexpr Mat& operator+=(const Mat& b) { return *this = *this + b; }
  PLASTICA_ALWAYS_INLINE constexpr Mat& operator-=(const Mat& b) { return *this = *this - b; }
};

template <class S, std::size_t R, std::size_t K, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, R, C> operator*(const Mat<S, R, K>& a,
                                                        const Mat<S, K, C>& b) {
  return {each_of<R * C>([&](std::size_t at) PLASTICA_ALWAYS_INLINE -> S {
    return sum_of<S, K>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      return a(at / kDivisor<C>, k) * b(k, at % kDivisor<C>);
    });
  })};
}

template <class S, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, R> operator*(const Mat<S, R, C>& a, const Vec<S, C>& x) {
  return {each_of<R>([&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S {
    return sum_of<S, C>([&](std::size_t k) PLASTICA_ALWAYS_INLINE { return a(i, k) * x[k]; });
  })};
}

template <class S, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, C, R> transpose(const Mat<S, R, C>& a) {
  return {each_of<R * C>([&](std::size_t at) PLASTICA_ALWAYS_INLINE -> S {
    return a(at % kDivisor<R>, at / kDivisor<R>);
  })};
}

/// a^T x.
template <class S, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, C> transposed_times(const Mat<S, R, C>& a,
                                                            const Vec<S, R>& x) {
  return transpose(a) * x;
}

/// The R x C numbers of a matrix from a row and column on.
template <std::size_t R, std::size_t C, class S, std::size_t M, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, R, C> block(const Mat<S, M, N>& a, std::size_t row,
                                                    std::size_t column) {
  return {each_of<R * C>([&](std::size_t at) PLASTICA_ALWAYS_INLINE -> S {
    return a(row + at / kDivisor<C>, column + at % kDivisor<C>);
  })};
}

/// Puts a matrix into a larger one, from a row and column on.
template <class S, std::size_t M, std::size_t N, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr void put(Mat<S, M, N>& a, std::size_t row, std::size_t column,
                                          const Mat<S, R, C>& part) {
  for_each_of<R * C>([&](std::size_t at) PLASTICA_ALWAYS_INLINE {
    a(row + at / kDivisor<C>, column + at % kDivisor<C>) = part.at[at];
  });
}

/// Adds it there.
template <class S, std::size_t M, std::size_t N, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr void add(Mat<S, M, N>& a, std::size_t row, std::size_t column,
                                          const Mat<S, R, C>& part) {
  put(a, row, column, block<R, C>(a, row, column) + part);
}

/// `a` where the mask holds, `b` elsewhere.
template <class Mask, class S, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, N> select(const Mask& mask, const Vec<S, N>& a,
                                                  const Vec<S, N>& b) {
  return {each_of<N>([&](std::size_t i)
                         PLASTICA_ALWAYS_INLINE -> S { return select(mask, a[i], b[i]); })};
}
template <class Mask, class S, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, R, C> select(const Mask& mask, const Mat<S, R, C>& a,
                                                     const Mat<S, R, C>& b) {
  return {each_of<R * C>(
      [&](std::size_t i) PLASTICA_ALWAYS_INLINE -> S { return select(mask, a.at[i], b.at[i]); })};
}

/// a b^T.
template <class S, std::size_t R, std::size_t C>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, R, C> outer(const Vec<S, R>& a, const Vec<S, C>& b) {
  return {each_of<R * C>([&](std::size_t at) PLASTICA_ALWAYS_INLINE -> S {
    return a[at / kDivisor<C>] * b[at % kDivisor<C>];
  })};
}

template <class S, std::size_t N>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, N, N> identity() {
  return {each_of<N * N>([](std::size_t at) PLASTICA_ALWAYS_INLINE -> S {
    return constant<S>(at / kDivisor<N> == at % kDivisor<N> ? 1 : 0);
  })};
}

template <class S>
PLASTICA_ALWAYS_INLINE constexpr Vec<S, 3> cross(const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// The matrix of x -> a cross x.
template <class S>
PLASTICA_ALWAYS_INLINE constexpr Mat<S, 3, 3> skew(const Vec<S, 3>& a) {
  const S zero = constant<S>(0);
  return {{zero, -a[2], a[1], a[2], zero, -a[0], -a[1], a[0], zero}};
}

PLASTICA_KERNELS_END
}  // namespace plastica
