#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/each_of.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/base/scalar.hpp"
#include "plastica/base/sine_cosine.hpp"

namespace plastica {
PLASTICA_KERNELS_BEGIN
namespace detail {

/// How a dual number is laid out. A Pack fills registers by itself: its derivatives are one of them
/// each.
/// @tparam T  a Pack
template <class T>
struct DualLayout {
  using Register = T;
  static constexpr std::size_t kLanes = 1;

  PLASTICA_ALWAYS_INLINE static const T& lane(const Register& from, std::size_t /*i*/) {
    return from;
  }
  static void set_lane(Register& to, std::size_t /*i*/, const T& x) { to = x; }
};

/// Of a lone number a register holds as many derivatives as fit, and another the value in each of
/// its lanes: products and comparisons need nothing moved between lanes, and a comparison is at
/// once the mask of the derivatives. (A mask made of a bool costs six instructions, or a branch.)
template <class T>
requires std::is_floating_point_v<T>
struct DualLayout<T> {
  static constexpr std::size_t kLanes = kRegisterBytes / sizeof(T);
  using Register = Pack<T, static_cast<int>(kLanes)>;

  PLASTICA_ALWAYS_INLINE static T lane(const Register& from, std::size_t i) {
    return from[static_cast<int>(i)];
  }
  static void set_lane(Register& to, std::size_t i, T x) { to.set(static_cast<int>(i), x); }
};

}  // namespace detail

/// A value and its derivatives by N parameters (forward differentiation); a scalar of kernels.
///
/// Its operators are always inlined: in a large function a compiler would call them instead.
/// Where a kernel selects, the derivative is that of the chosen branch: at a kink, one-sided.
/// @tparam T  double, float or a Pack of them
template <class T, std::size_t N>
class Dual {
  using Layout = detail::DualLayout<T>;
  static constexpr std::size_t kLanes = Layout::kLanes;

 public:
  using Register = typename Layout::Register;
  using Mask = mask_t<Register>;
  /// The derivatives; lanes that fill the last register up are not looked at.
  using Slopes = std::array<Register, (N + kLanes - 1) / kLanes>;

  Dual() = default;
  PLASTICA_ALWAYS_INLINE explicit Dual(const T& constant_value) : value_(constant_value) {}
  template <class R>
  requires(!std::is_same_v<R, T> && std::is_same_v<R, real_t<T>>) explicit Dual(R constant_value)
      : value_(T(constant_value)) {}

  /// The parameter number `index` itself: derivative 1 by itself.
  static Dual parameter(const T& value, std::size_t index) {
    Dual x(value);
    Layout::set_lane(x.slopes_[index / kLanes], index % kLanes, constant<T>(1));
    return x;
  }

  /// A constant, from what `values` gives.
  PLASTICA_ALWAYS_INLINE static Dual of_values(const Register& values) {
    Dual x;
    x.value_ = values;
    return x;
  }

  /// f(x), given f and df/dx at x's value.
  PLASTICA_ALWAYS_INLINE static Dual chain(const Register& f, const Register& slope,
                                           const Dual& x) {
    return make(f, [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return x.slopes_[i] * slope; });
  }

  PLASTICA_ALWAYS_INLINE T value() const { return Layout::lane(value_, 0); }
  PLASTICA_ALWAYS_INLINE T derivative(std::size_t i) const {
    return Layout::lane(slopes_[i / kLanes], i % kLanes);
  }
  /// The value as kernels have it: in each lane of a register.
  PLASTICA_ALWAYS_INLINE const Register& values() const { return value_; }

  PLASTICA_ALWAYS_INLINE friend Dual operator+(const Dual& a, const Dual& b) {
    return make(a.value_ + b.value_,
                [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return a.slopes_[i] + b.slopes_[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator-(const Dual& a, const Dual& b) {
    return make(a.value_ - b.value_,
                [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return a.slopes_[i] - b.slopes_[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator*(const Dual& a, const Dual& b) {
    return make(a.value_ * b.value_, [&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      return a.slopes_[i] * b.value_ + a.value_ * b.slopes_[i];
    });
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator/(const Dual& a, const Dual& b) {
    const Register ratio = a.value_ / b.value_;
    return make(ratio, [&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      return (a.slopes_[i] - ratio * b.slopes_[i]) / b.value_;
    });
  }
  PLASTICA_ALWAYS_INLINE friend Dual operator-(const Dual& a) {
    return make(-a.value_, [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return -a.slopes_[i]; });
  }
  PLASTICA_ALWAYS_INLINE Dual& operator+=(const Dual& b) { return *this = *this + b; }
  PLASTICA_ALWAYS_INLINE Dual& operator-=(const Dual& b) { return *this = *this - b; }
  PLASTICA_ALWAYS_INLINE Dual& operator*=(const Dual& b) { return *this = *this * b; }

  PLASTICA_ALWAYS_INLINE friend Mask operator<(const Dual& a, const Dual& b) {
    return a.value_ < b.value_;
  }
  PLASTICA_ALWAYS_INLINE friend Mask operator>(const Dual& a, const Dual& b) {
    return a.value_ > b.value_;
  }
  PLASTICA_ALWAYS_INLINE friend Mask operator<=(const Dual& a, const Dual& b) {
    return a.value_ <= b.value_;
  }
  PLASTICA_ALWAYS_INLINE friend Mask operator>=(const Dual& a, const Dual& b) {
    return a.value_ >= b.value_;
  }

  /// `a` where the mask holds, `b` elsewhere.
  PLASTICA_ALWAYS_INLINE static Dual chosen(const Mask& mask, const Dual& a, const Dual& b) {
    return make(select(mask, a.value_, b.value_), [&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      return select(mask, a.slopes_[i], b.slopes_[i]);
    });
  }

  /// The number times the sign of its value: by its bit, which is there sooner than a comparison.
  PLASTICA_ALWAYS_INLINE Dual turned() const {
    using Native = typename Register::Native;
    using Bits = typename Register::NativeMask;
    const Bits sign_bit = (Bits)(-Native{});
    const auto flip = [&](const Register& x) PLASTICA_ALWAYS_INLINE {
      return Register::by_part([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
        return (Native)((Bits)x.part[i] ^ ((Bits)value_.part[i] & sign_bit));
      });
    };
    return make(flip(value_),
                [&](std::size_t i) PLASTICA_ALWAYS_INLINE { return flip(slopes_[i]); });
  }

 private:
  template <class F>
  PLASTICA_ALWAYS_INLINE static Dual make(const Register& value, const F& slope) {
    Dual x;
    x.value_ = value;
    x.slopes_ = each_of<std::tuple_size_v<Slopes>>(slope);
    return x;
  }

  Register value_{};
  Slopes slopes_{};
};

template <class T, std::size_t N>
struct ScalarTraits<Dual<T, N>> {
  using Real = real_t<T>;
  using Mask = typename Dual<T, N>::Mask;
};

template <class T, std::size_t N>
inline constexpr bool kCarriesDerivatives<Dual<T, N>> = true;

template <class T, std::size_t N>
PLASTICA_ALWAYS_INLINE inline Dual<T, N> select(const typename Dual<T, N>::Mask& mask,
                                                const Dual<T, N>& a, const Dual<T, N>& b) {
  return Dual<T, N>::chosen(mask, a, b);
}

/// |x|; at 0 with the derivative of x, at -0 with that of -x.
template <class T, std::size_t N>
PLASTICA_ALWAYS_INLINE inline Dual<T, N> abs(const Dual<T, N>& x) {
  return x.turned();
}

template <class T, std::size_t N>
PLASTICA_ALWAYS_INLINE inline Dual<T, N> sqrt(const Dual<T, N>& x) {
  const auto root = sqrt(x.values());
  using Register = std::remove_const_t<decltype(root)>;
  return Dual<T, N>::chain(root, constant<Register>(0.5) / root, x);
}

template <class T, std::size_t N>
PLASTICA_ALWAYS_INLINE inline Dual<T, N> exp(const Dual<T, N>& x) {
  const auto power = exp(x.values());
  return Dual<T, N>::chain(power, power, x);
}

template <class T, std::size_t N>
inline Dual<T, N> log(const Dual<T, N>& x) {
  const auto at = x.values();
  using Register = std::remove_const_t<decltype(at)>;
  return Dual<T, N>::chain(Register(log(x.value())), constant<Register>(1) / at, x);
}

template <class T, std::size_t N, bool kFused>
struct SineCosine<Dual<T, N>, kFused> {
  Dual<T, N> sine, cosine;

  explicit SineCosine(const Dual<T, N>& x) {
    const SineCosine<typename Dual<T, N>::Register, kFused> at(x.values());
    sine = Dual<T, N>::chain(at.sine, at.cosine, x);
    cosine = Dual<T, N>::chain(at.cosine, -at.sine, x);
  }
};

template <class T, std::size_t N>
inline Dual<T, N> sin(const Dual<T, N>& x) {
  return Dual<T, N>::chain(sin(x.values()), cos(x.values()), x);
}

template <class T, std::size_t N>
inline Dual<T, N> cos(const Dual<T, N>& x) {
  return Dual<T, N>::chain(cos(x.values()), -sin(x.values()), x);
}

PLASTICA_KERNELS_END
}  // namespace plastica
