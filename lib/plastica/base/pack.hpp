#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/scalar.hpp"

namespace plastica {
PLASTICA_KERNELS_BEGIN

namespace detail {

/// Bytes of the widest vector register of the instruction set that this file is compiled for.
#if defined(__AVX512F__)
inline constexpr std::size_t kRegisterBytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t kRegisterBytes = 32;
#else
inline constexpr std::size_t kRegisterBytes = 16;
#endif

/// a b + c of a register, rounded once where the instruction set can.
template <class Register>
PLASTICA_ALWAYS_INLINE inline Register fused(const Register& a, const Register& b,
                                             const Register& c) {
#if defined(__AVX512F__)
  if constexpr (sizeof(a[0]) == 8) {
    return (Register)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
  } else {
    return (Register)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
  }
#elif defined(__FMA__) && defined(__AVX__)
  if constexpr (sizeof(a[0]) == 8) {
    return (Register)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
  } else {
    return (Register)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
  }
#else
  return a * b + c;
#endif
}

template <class Register>
PLASTICA_ALWAYS_INLINE inline Register square_root(const Register& x) {
#if defined(__AVX512F__)
  if constexpr (sizeof(x[0]) == 8) return (Register)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
  if constexpr (sizeof(x[0]) == 4) return (Register)_mm512_maskz_sqrt_ps(0xffff, (__m512)x);
#elif defined(__AVX__)
  if constexpr (sizeof(x[0]) == 8) return (Register)_mm256_sqrt_pd((__m256d)x);
  if constexpr (sizeof(x[0]) == 4) return (Register)_mm256_sqrt_ps((__m256)x);
#elif defined(__SSE2__)
  if constexpr (sizeof(x[0]) == 8) return (Register)_mm_sqrt_pd((__m128d)x);
  if constexpr (sizeof(x[0]) == 4) return (Register)_mm_sqrt_ps((__m128)x);
#else
  Register root = x;
  for (std::size_t i = 0; i < sizeof(x) / sizeof(x[0]); ++i) root[i] = std::sqrt(x[i]);
  return root;
#endif
}

}  // namespace detail

/// W numbers that are worked on together, a scenario in each lane; a scalar of kernels.
///
/// Over the compiler's vector extension, in as many registers as W numbers need: each operation is
/// the same IEEE operation in every lane, so that a lane has the bits that a lone double would
/// have.
template <class T, int W>
struct Pack {
  static constexpr std::size_t kBytes = sizeof(T) * static_cast<std::size_t>(W);
  static constexpr std::size_t kPartBytes =
      kBytes < detail::kRegisterBytes ? kBytes : detail::kRegisterBytes;
  static constexpr std::size_t kParts = kBytes / kPartBytes;
  static constexpr std::size_t kPartLanes = kPartBytes / sizeof(T);
  static_assert(kParts * kPartBytes == kBytes);

  using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
  using Native [[gnu::vector_size(kPartBytes)]] = T;
  /// All bits set in a lane where the mask holds.
  using NativeMask [[gnu::vector_size(kPartBytes)]] = Integer;

  struct Mask {
    NativeMask part[kParts];

    PLASTICA_ALWAYS_INLINE friend Mask operator&(const Mask& a, const Mask& b) {
      return mask_by_part([&](std::size_t i) { return a.part[i] & b.part[i]; });
    }
    PLASTICA_ALWAYS_INLINE friend Mask operator|(const Mask& a, const Mask& b) {
      return mask_by_part([&](std::size_t i) { return a.part[i] | b.part[i]; });
    }
    PLASTICA_ALWAYS_INLINE friend Mask operator!(const Mask& a) {
      return mask_by_part([&](std::size_t i) { return ~a.part[i]; });
    }
    bool operator[](int lane) const {
      const auto index = static_cast<std::size_t>(lane);
      return part[index / kPartLanes][index % kPartLanes] != 0;
    }
  };

  Native part[kParts];

  PLASTICA_ALWAYS_INLINE Pack() {
    *this = by_part([](std::size_t /*i*/) { return Native{}; });
  }
  PLASTICA_ALWAYS_INLINE explicit Pack(T value) {
    *this = by_part([value](std::size_t /*i*/) { return value - Native{}; });
  }

  /// Part by part: what is copied as a whole stays in memory.
  PLASTICA_ALWAYS_INLINE static Pack load(const T* from) {
    return by_part([from](std::size_t i) {
      Native lanes;
      __builtin_memcpy(&lanes, from + i * kPartLanes, kPartBytes);
      return lanes;
    });
  }
  PLASTICA_ALWAYS_INLINE void store(T* to) const {
    for (std::size_t i = 0; i < kParts; ++i) {
      __builtin_memcpy(to + i * kPartLanes, &part[i], kPartBytes);
    }
  }
  T operator[](int lane) const {
    const auto index = static_cast<std::size_t>(lane);
    return part[index / kPartLanes][index % kPartLanes];
  }
  void set(int lane, T value) {
    const auto index = static_cast<std::size_t>(lane);
    part[index / kPartLanes][index % kPartLanes] = value;
  }

  /// f(i) of each part. Written out rather than looped over: an array that a loop indexes stays in
  /// memory.
  template <class F>
  PLASTICA_ALWAYS_INLINE static Pack by_part(const F& f) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) PLASTICA_ALWAYS_INLINE {
      Pack pack(kUnset);
      ((pack.part[I] = f(I)), ...);
      return pack;
    }
    (std::make_index_sequence<kParts>{});
  }
  template <class F>
  PLASTICA_ALWAYS_INLINE static Mask mask_by_part(const F& f) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) PLASTICA_ALWAYS_INLINE {
      Mask mask;
      ((mask.part[I] = f(I)), ...);
      return mask;
    }
    (std::make_index_sequence<kParts>{});
  }

  PLASTICA_ALWAYS_INLINE friend Pack operator+(const Pack& a, const Pack& b) {
    return by_part([&](std::size_t i) { return a.part[i] + b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Pack operator-(const Pack& a, const Pack& b) {
    return by_part([&](std::size_t i) { return a.part[i] - b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Pack operator*(const Pack& a, const Pack& b) {
    return by_part([&](std::size_t i) { return a.part[i] * b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Pack operator/(const Pack& a, const Pack& b) {
    return by_part([&](std::size_t i) { return a.part[i] / b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Pack operator-(const Pack& a) {
    return by_part([&](std::size_t i) { return -a.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE Pack& operator+=(const Pack& b) { return *this = *this + b; }
  PLASTICA_ALWAYS_INLINE Pack& operator-=(const Pack& b) { return *this = *this - b; }
  PLASTICA_ALWAYS_INLINE Pack& operator*=(const Pack& b) { return *this = *this * b; }

  PLASTICA_ALWAYS_INLINE friend Mask operator<(const Pack& a, const Pack& b) {
    return mask_by_part([&](std::size_t i) { return a.part[i] < b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Mask operator>(const Pack& a, const Pack& b) {
    return mask_by_part([&](std::size_t i) { return a.part[i] > b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Mask operator<=(const Pack& a, const Pack& b) {
    return mask_by_part([&](std::size_t i) { return a.part[i] <= b.part[i]; });
  }
  PLASTICA_ALWAYS_INLINE friend Mask operator>=(const Pack& a, const Pack& b) {
    return mask_by_part([&](std::size_t i) { return a.part[i] >= b.part[i]; });
  }

 private:
  enum Unset { kUnset };
  PLASTICA_ALWAYS_INLINE explicit Pack(Unset /*parts follow*/) {}
};

template <class T, int W>
struct ScalarTraits<Pack<T, W>> {
  using Real = T;
  using Mask = typename Pack<T, W>::Mask;
};

template <class T, int W>
inline constexpr bool kHasLanes<Pack<T, W>> = true;

template <class T, int W>
PLASTICA_ALWAYS_INLINE inline Pack<T, W> select(const typename Pack<T, W>::Mask& mask,
                                                const Pack<T, W>& a, const Pack<T, W>& b) {
  return Pack<T, W>::by_part([&](std::size_t i) { return mask.part[i] ? a.part[i] : b.part[i]; });
}

/// Any type with parts that is a mask: `mask_t<Pack>` cannot be deduced through its outer class.
template <class Mask>
requires requires(const Mask& mask) { mask.part[0][0] != 0; }
PLASTICA_ALWAYS_INLINE inline bool any(const Mask& mask) {
  auto all = mask.part[0];
  for (std::size_t i = 1; i < sizeof(mask.part) / sizeof(mask.part[0]); ++i) all |= mask.part[i];
  bool found = false;
  for (std::size_t lane = 0; lane < sizeof(all) / sizeof(all[0]); ++lane) {
    found = found || all[lane] != 0;
  }
  return found;
}

template <class T, int W>
PLASTICA_ALWAYS_INLINE inline Pack<T, W> abs(const Pack<T, W>& x) {
  using Native = typename Pack<T, W>::Native;
  using NativeMask = typename Pack<T, W>::NativeMask;
  const NativeMask sign_bit = (NativeMask)(-Native{});
  return Pack<T, W>::by_part(
      [&](std::size_t i) { return (Native)((NativeMask)x.part[i] & ~sign_bit); });
}

template <class T, int W>
PLASTICA_ALWAYS_INLINE inline Pack<T, W> sqrt(const Pack<T, W>& x) {
  return Pack<T, W>::by_part([&](std::size_t i) { return detail::square_root(x.part[i]); });
}

/// Lane by lane.
template <class T, int W>
inline Pack<T, W> log(const Pack<T, W>& x) {
  Pack<T, W> y{};
  for (int lane = 0; lane < W; ++lane) y.set(lane, log(x[lane]));
  return y;
}

template <class T, int W>
PLASTICA_ALWAYS_INLINE inline Pack<T, W> multiply_add(const Pack<T, W>& a, const Pack<T, W>& b,
                                                      const Pack<T, W>& c) {
  return Pack<T, W>::by_part(
      [&](std::size_t i) { return detail::fused(a.part[i], b.part[i], c.part[i]); });
}

template <class T, int W>
inline Pack<T, W> power_of_two(const Pack<T, W>& k_plus_round) {
  using P = Pack<T, W>;
  constexpr int kBias = sizeof(T) == 8 ? 1023 : 127;
  constexpr int kShift = sizeof(T) == 8 ? 52 : 23;
  // The addition and the shift must not overflow a signed lane: only the low bits matter.
  using Unsigned = std::make_unsigned_t<typename P::Integer>;
  using NativeUnsigned [[gnu::vector_size(P::kPartBytes)]] = Unsigned;
  return P::by_part([&](std::size_t i) {
    const auto bits = (NativeUnsigned)(typename P::NativeMask)k_plus_round.part[i];
    return (typename P::Native)((bits + Unsigned{kBias}) << Unsigned{kShift});
  });
}

PLASTICA_KERNELS_END
}  // namespace plastica
