#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/each_of.hpp"
#include "plastica/base/scalar.hpp"
#include "plastica/base/sine_cosine.hpp"

namespace plastica {

/// A value and its derivatives by N parameters (forward differentiation); a scalar of kernels.
///
/// Its operators are always inlined: in a large function a compiler would call them instead.
/// Where a kernel selects, the derivative is that of the chosen branch: at a kink, one-sided.
/// @tparam T  double, float or a Pack of them
template <class T, std::size_t N>
struct Dual {
  T value{};
  std::array<T, N> derivative{};

  Dual() = default;
  explicit Dual(const T& constant_value) : value(constant_value) {}
  template <class R>
  requires(!std::is_same_v<R, T> && std::is_same_v<R, real_t<T>>) explicit Dual(R constant_value)
      : value(T(constant_value)) {}

  /// The parameter number `index` itself: derivative 1 by itself.
  static Dual parameter(const T& value, std::size_t index) {
    Dual x(value);
    x.derivative[index] = constant<T>(1);
    return x;
  }

  PLASTICA_ALWAYS_INLINE friend Dual operator+(const Dual& a, const Dual& b) {
    Dual c(a.value + b.value);
    c.derivative = each_of<N>(
        [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return a.derivative[i] + b.derivative[i]; });
    return c;
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator-(const Dual& a, const Dual& b) {
    Dual c(a.value - b.value);
    c.derivative = each_of<N>(
        [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return a.derivative[i] - b.derivative[i]; });
    return c;
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator*(const Dual& a, const Dual& b) {
    Dual c(a.value * b.value);
    c.derivative = each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      return a.derivative[i] * b.value + a.value * b.derivative[i];
    });
    return c;
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator/(const Dual& a, const Dual& b) {
    Dual c(a.value / b.value);
    c.derivative = each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      return (a.derivative[i] - c.value * b.derivative[i]) / b.value;
    });
    return c;
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator-(const Dual& a) {
    Dual c(-a.value);
    c.derivative =
        each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { return -a.derivative[i]; });
    return c;
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
};

template <class T, std::size_t N>
struct ScalarTraits<Dual<T, N>> {
  using Real = real_t<T>;
  using Mask = mask_t<T>;
};

template <class T, std::size_t N>
inline constexpr bool kCarriesDerivatives<Dual<T, N>> = true;

template <class T, std::size_t N>
PLASTICA_ALWAYS_INLINE inline Dual<T, N> select(const mask_t<T>& mask, const Dual<T, N>& a,
                                                const Dual<T, N>& b) {
  Dual<T, N> c(select(mask, a.value, b.value));
  c.derivative = each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
    return select(mask, a.derivative[i], b.derivative[i]);
  });
  return c;
}

/// |x| with the derivative of x at 0.
template <class T, std::size_t N>
PLASTICA_ALWAYS_INLINE inline Dual<T, N> abs(const Dual<T, N>& x) {
  return select(x.value < constant<T>(0), -x, x);
}

template <class T, std::size_t N>
inline Dual<T, N> sqrt(const Dual<T, N>& x) {
  Dual<T, N> root(sqrt(x.value));
  root.derivative = each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
    return x.derivative[i] / (root.value + root.value);
  });
  return root;
}

template <class T, std::size_t N>
inline Dual<T, N> exp(const Dual<T, N>& x) {
  Dual<T, N> power(exp(x.value));
  power.derivative = each_of<N>(
      [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return x.derivative[i] * power.value; });
  return power;
}

template <class T, std::size_t N, bool kFused>
struct SineCosine<Dual<T, N>, kFused> {
  Dual<T, N> sine, cosine;

  explicit SineCosine(const Dual<T, N>& x) {
    const SineCosine<T, kFused> at(x.value);
    sine = Dual<T, N>(at.sine);
    cosine = Dual<T, N>(at.cosine);
    for (std::size_t i = 0; i < N; ++i) {
      sine.derivative[i] = x.derivative[i] * at.cosine;
      cosine.derivative[i] = -(x.derivative[i] * at.sine);
    }
  }
};

template <class T, std::size_t N>
inline Dual<T, N> sin(const Dual<T, N>& x) {
  Dual<T, N> sine(sin(x.value));
  const T slope = cos(x.value);
  sine.derivative =
      each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { return x.derivative[i] * slope; });
  return sine;
}

template <class T, std::size_t N>
inline Dual<T, N> cos(const Dual<T, N>& x) {
  Dual<T, N> cosine(cos(x.value));
  const T slope = -sin(x.value);
  cosine.derivative =
      each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { return x.derivative[i] * slope; });
  return cosine;
}

}  // namespace plastica
