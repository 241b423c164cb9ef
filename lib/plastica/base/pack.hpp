#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "plastica/base/scalar.hpp"

namespace plastica {

/// W numbers that are worked on together, a scenario in each lane; a scalar of kernels.
///
/// Over the compiler's vector extension: each operation is the same IEEE operation in every lane,
/// so that a lane has the bits that a lone double would have.
template <class T, int W>
struct Pack {
  using Native [[gnu::vector_size(sizeof(T) * W)]] = T;
  using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
  /// All bits set in a lane where the mask holds.
  using NativeMask [[gnu::vector_size(sizeof(T) * W)]] = Integer;

  struct Mask {
    NativeMask lanes;
    friend Mask operator&(const Mask& a, const Mask& b) { return {a.lanes & b.lanes}; }
    friend Mask operator|(const Mask& a, const Mask& b) { return {a.lanes | b.lanes}; }
    friend Mask operator!(const Mask& a) { return {~a.lanes}; }
    bool operator[](int lane) const { return lanes[lane] != 0; }
  };

  Native lanes{};

  Pack() = default;
  explicit Pack(T value) : lanes(value - Native{}) {}

  static Pack load(const T* from) {
    Pack pack;
    for (int lane = 0; lane < W; ++lane) pack.lanes[lane] = from[lane];
    return pack;
  }
  void store(T* to) const {
    for (int lane = 0; lane < W; ++lane) to[lane] = lanes[lane];
  }
  T operator[](int lane) const { return lanes[lane]; }
  void set(int lane, T value) { lanes[lane] = value; }

  friend Pack operator+(const Pack& a, const Pack& b) { return from(a.lanes + b.lanes); }
  friend Pack operator-(const Pack& a, const Pack& b) { return from(a.lanes - b.lanes); }
  friend Pack operator*(const Pack& a, const Pack& b) { return from(a.lanes * b.lanes); }
  friend Pack operator/(const Pack& a, const Pack& b) { return from(a.lanes / b.lanes); }
  friend Pack operator-(const Pack& a) { return from(-a.lanes); }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }

  friend Mask operator<(const Pack& a, const Pack& b) { return {a.lanes < b.lanes}; }
  friend Mask operator>(const Pack& a, const Pack& b) { return {a.lanes > b.lanes}; }
  friend Mask operator<=(const Pack& a, const Pack& b) { return {a.lanes <= b.lanes}; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return {a.lanes >= b.lanes}; }

  static Pack from(const Native& lanes) {
    Pack pack;
    pack.lanes = lanes;
    return pack;
  }
};

template <class T, int W>
struct ScalarTraits<Pack<T, W>> {
  using Real = T;
  using Mask = typename Pack<T, W>::Mask;
};

template <class T, int W>
inline Pack<T, W> select(const typename Pack<T, W>::Mask& mask, const Pack<T, W>& a,
                         const Pack<T, W>& b) {
  return Pack<T, W>::from(mask.lanes ? a.lanes : b.lanes);
}

/// Any type with lanes that is a mask: `mask_t<Pack>` cannot be deduced through its outer class.
template <class Mask>
requires requires(const Mask& mask) { mask.lanes[0] != 0; }
inline bool any(const Mask& mask) {
  bool found = false;
  for (std::size_t lane = 0; lane < sizeof(mask.lanes) / sizeof(mask.lanes[0]); ++lane) {
    found = found || mask.lanes[lane] != 0;
  }
  return found;
}

template <class T, int W>
inline Pack<T, W> abs(const Pack<T, W>& x) {
  const auto mask = (~typename Pack<T, W>::NativeMask{}) ^
                    (typename Pack<T, W>::NativeMask)(-Pack<T, W>(T(0)).lanes);
  using Native = typename Pack<T, W>::Native;
  using NativeMask = typename Pack<T, W>::NativeMask;
  return Pack<T, W>::from((Native)((NativeMask)x.lanes & mask));
}

template <class T, int W>
inline Pack<T, W> sqrt(const Pack<T, W>& x) {
  Pack<T, W> root;
  for (int lane = 0; lane < W; ++lane) root.lanes[lane] = std::sqrt(x.lanes[lane]);
  return root;
}

template <class T, int W>
inline Pack<T, W> power_of_two(const Pack<T, W>& k_plus_round) {
  using NativeMask = typename Pack<T, W>::NativeMask;
  using Native = typename Pack<T, W>::Native;
  constexpr int kBias = sizeof(T) == 8 ? 1023 : 127;
  constexpr int kShift = sizeof(T) == 8 ? 52 : 23;
  // The addition and the shift must not overflow a signed lane: only the low bits matter.
  using Unsigned = std::make_unsigned_t<typename Pack<T, W>::Integer>;
  using NativeUnsigned [[gnu::vector_size(sizeof(T) * W)]] = Unsigned;
  const auto bits = (NativeUnsigned)(NativeMask)k_plus_round.lanes;
  return Pack<T, W>::from((Native)((bits + Unsigned{kBias}) << Unsigned{kShift}));
}

}  // namespace plastica
