#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/scalar.hpp"

/// Small vectors and matrices of kernels: sizes known to the compiler, no heap, any scalar.
namespace plastica {
PLASTICA_KERNELS_BEGIN

/// N numbers; starts at zero.
template <class S, std::size_t N>
struct Vec {
  std::array<S, N> at{};

  constexpr S& operator[](std::size_t i) { return at[i]; }
  constexpr const S& operator[](std::size_t i) const { return at[i]; }

  friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend constexpr Vec operator-(const Vec& a) { return Vec{} - a; }
  friend constexpr Vec operator*(const S& s, Vec a) {
    for (std::size_t i = 0; i < N; ++i) a.at[i] = s * a.at[i];
    return a;
  }
  constexpr Vec& operator+=(const Vec& b) {
    for (std::size_t i = 0; i < N; ++i) at[i] = at[i] + b.at[i];
    return *this;
  }
  constexpr Vec& operator-=(const Vec& b) {
    for (std::size_t i = 0; i < N; ++i) at[i] = at[i] - b.at[i];
    return *this;
  }
};

template <class S, std::size_t N>
constexpr S dot(const Vec<S, N>& a, const Vec<S, N>& b) {
  if constexpr (N == 0) return constant<S>(0);
  S sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum = sum + a[i] * b[i];
  return sum;
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

/// R x C numbers, row by row; starts at zero.
template <class S, std::size_t R, std::size_t C>
struct Mat {
  std::array<S, R * C> at{};

  constexpr S& operator()(std::size_t row, std::size_t column) { return at[row * C + column]; }
  constexpr const S& operator()(std::size_t row, std::size_t column) const {
    return at[row * C + column];
  }

  friend constexpr Mat operator+(Mat a, const Mat& b) { return a += b; }
  friend constexpr Mat operator-(Mat a, const Mat& b) { return a -= b; }
  friend constexpr Mat operator*(const S& s, Mat a) {
    for (std::size_t i = 0; i < R * C; ++i) a.at[i] = s * a.at[i];
    return a;
  }
  constexpr Mat& operator+=(const Mat& b) {
    for (std::size_t i = 0; i < R * C; ++i) at[i] = at[i] + b.at[i];
    return *this;
  }
  constexpr Mat& operator-=(const Mat& b) {
    for (std::size_t i = 0; i < R * C; ++i) at[i] = at[i] - b.at[i];
    return *this;
  }
};

template <class S, std::size_t R, std::size_t K, std::size_t C>
constexpr Mat<S, R, C> operator*(const Mat<S, R, K>& a, const Mat<S, K, C>& b) {
  Mat<S, R, C> product;
  if constexpr (K == 0) return product;
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) {
      S sum = a(i, 0) * b(0, j);
      for (std::size_t k = 1; k < K; ++k) sum = sum + a(i, k) * b(k, j);
      product(i, j) = sum;
    }
  }
  return product;
}

template <class S, std::size_t R, std::size_t C>
constexpr Vec<S, R> operator*(const Mat<S, R, C>& a, const Vec<S, C>& x) {
  Vec<S, R> product;
  if constexpr (C == 0) return product;
  for (std::size_t i = 0; i < R; ++i) {
    S sum = a(i, 0) * x[0];
    for (std::size_t k = 1; k < C; ++k) sum = sum + a(i, k) * x[k];
    product[i] = sum;
  }
  return product;
}

template <class S, std::size_t R, std::size_t C>
constexpr Mat<S, C, R> transpose(const Mat<S, R, C>& a) {
  Mat<S, C, R> turned;
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) turned(j, i) = a(i, j);
  }
  return turned;
}

/// a^T x.
template <class S, std::size_t R, std::size_t C>
constexpr Vec<S, C> transposed_times(const Mat<S, R, C>& a, const Vec<S, R>& x) {
  Vec<S, C> product;
  if constexpr (R == 0) return product;
  for (std::size_t j = 0; j < C; ++j) {
    S sum = a(0, j) * x[0];
    for (std::size_t k = 1; k < R; ++k) sum = sum + a(k, j) * x[k];
    product[j] = sum;
  }
  return product;
}

/// `a` where the mask holds, `b` elsewhere.
template <class Mask, class S, std::size_t N>
constexpr Vec<S, N> select(const Mask& mask, const Vec<S, N>& a, const Vec<S, N>& b) {
  Vec<S, N> chosen;
  for (std::size_t i = 0; i < N; ++i) chosen[i] = select(mask, a[i], b[i]);
  return chosen;
}
template <class Mask, class S, std::size_t R, std::size_t C>
constexpr Mat<S, R, C> select(const Mask& mask, const Mat<S, R, C>& a, const Mat<S, R, C>& b) {
  Mat<S, R, C> chosen;
  for (std::size_t i = 0; i < R * C; ++i) chosen.at[i] = select(mask, a.at[i], b.at[i]);
  return chosen;
}

/// a b^T.
template <class S, std::size_t R, std::size_t C>
constexpr Mat<S, R, C> outer(const Vec<S, R>& a, const Vec<S, C>& b) {
  Mat<S, R, C> product;
  for (std::size_t i = 0; i < R; ++i) {
    for (std::size_t j = 0; j < C; ++j) product(i, j) = a[i] * b[j];
  }
  return product;
}

template <class S, std::size_t N>
constexpr Mat<S, N, N> identity() {
  Mat<S, N, N> one;
  for (std::size_t i = 0; i < N; ++i) one(i, i) = constant<S>(1);
  return one;
}

template <class S>
constexpr Vec<S, 3> cross(const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// The matrix of x -> a cross x.
template <class S>
constexpr Mat<S, 3, 3> skew(const Vec<S, 3>& a) {
  const S zero = constant<S>(0);
  return {{zero, -a[2], a[1], a[2], zero, -a[0], -a[1], a[0], zero}};
}

PLASTICA_KERNELS_END
}  // namespace plastica
