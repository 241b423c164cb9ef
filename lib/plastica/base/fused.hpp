#pragma once

#include <type_traits>

#include "plastica/base/pack.hpp"
#include "plastica/base/sine_cosine.hpp"

/// A scalar whose products are rounded together with the sums that they go into.
namespace plastica {
PLASTICA_KERNELS_BEGIN

template <class S>
struct FusedProduct;

/// A number S (double, float or Pack) of which a b + c is multiply_add(a, b, c), and a b + c d is
/// multiply_add(a, b, c d). By type rather than by a compiler's choice: templates written with *
/// and + have the same bits for a lone number and for a lane.
template <class S>
struct Fused {
  using Real = real_t<S>;

  S value;

  PLASTICA_ALWAYS_INLINE Fused() : value(S()) {}
  PLASTICA_ALWAYS_INLINE explicit Fused(const S& number) : value(number) {}
  template <class R>
  requires(std::is_same_v<R, Real> && !std::is_same_v<R, S>) PLASTICA_ALWAYS_INLINE
      explicit Fused(R number)
      : value(number) {}
  /// A product that goes into no sum.
  PLASTICA_ALWAYS_INLINE Fused(const FusedProduct<S>& product) : value(product.a * product.b) {}

  PLASTICA_ALWAYS_INLINE static Fused load(const Real* from) {
    if constexpr (std::is_same_v<S, Real>) {
      return Fused(*from);
    } else {
      return Fused(S::load(from));
    }
  }
  PLASTICA_ALWAYS_INLINE void store(Real* to) const {
    if constexpr (std::is_same_v<S, Real>) {
      *to = value;
    } else {
      value.store(to);
    }
  }

  PLASTICA_ALWAYS_INLINE friend Fused operator+(const Fused& a, const Fused& b) {
    return Fused(a.value + b.value);
  }
  PLASTICA_ALWAYS_INLINE friend Fused operator-(const Fused& a, const Fused& b) {
    return Fused(a.value - b.value);
  }
  PLASTICA_ALWAYS_INLINE friend FusedProduct<S> operator*(const Fused& a, const Fused& b) {
    return {a.value, b.value};
  }
  PLASTICA_ALWAYS_INLINE friend Fused operator/(const Fused& a, const Fused& b) {
    return Fused(a.value / b.value);
  }
  PLASTICA_ALWAYS_INLINE friend Fused operator-(const Fused& a) { return Fused(-a.value); }
  template <class Term>
  PLASTICA_ALWAYS_INLINE Fused& operator+=(const Term& b) {
    return *this = *this + b;
  }
  template <class Term>
  PLASTICA_ALWAYS_INLINE Fused& operator-=(const Term& b) {
    return *this = *this - b;
  }
  PLASTICA_ALWAYS_INLINE friend auto operator<(const Fused& a, const Fused& b) {
    return a.value < b.value;
  }
  PLASTICA_ALWAYS_INLINE friend auto operator>(const Fused& a, const Fused& b) {
    return a.value > b.value;
  }

  // Not templates, so that they take a product beside a number.
  PLASTICA_ALWAYS_INLINE friend Fused select(const mask_t<S>& mask, const Fused& a,
                                             const Fused& b) {
    return Fused(plastica::select(mask, a.value, b.value));
  }
  PLASTICA_ALWAYS_INLINE friend Fused max(const Fused& a, const Fused& b) {
    return select(b > a, b, a);
  }
  PLASTICA_ALWAYS_INLINE friend Fused min(const Fused& a, const Fused& b) {
    return select(b < a, b, a);
  }
  PLASTICA_ALWAYS_INLINE friend Fused abs(const Fused& x) { return Fused(plastica::abs(x.value)); }
  PLASTICA_ALWAYS_INLINE friend Fused sqrt(const Fused& x) {
    return Fused(plastica::sqrt(x.value));
  }
};

/// A product of two numbers, not rounded yet; one of three and four is rounded from the left.
template <class S>
struct FusedProduct {
  S a, b;

  PLASTICA_ALWAYS_INLINE friend Fused<S> operator+(const FusedProduct& p, const Fused<S>& c) {
    return Fused<S>(multiply_add(p.a, p.b, c.value));
  }
  PLASTICA_ALWAYS_INLINE friend Fused<S> operator+(const Fused<S>& c, const FusedProduct& p) {
    return p + c;
  }
  PLASTICA_ALWAYS_INLINE friend Fused<S> operator+(const FusedProduct& p, const FusedProduct& q) {
    return p + Fused<S>(q);
  }
  PLASTICA_ALWAYS_INLINE friend Fused<S> operator-(const FusedProduct& p, const Fused<S>& c) {
    return p + -c;
  }
  PLASTICA_ALWAYS_INLINE friend Fused<S> operator-(const Fused<S>& c, const FusedProduct& p) {
    return -p + c;
  }
  PLASTICA_ALWAYS_INLINE friend Fused<S> operator-(const FusedProduct& p, const FusedProduct& q) {
    return p + -Fused<S>(q);
  }
  PLASTICA_ALWAYS_INLINE friend FusedProduct operator-(const FusedProduct& p) {
    return {-p.a, p.b};
  }
  PLASTICA_ALWAYS_INLINE friend FusedProduct operator*(const FusedProduct& p, const Fused<S>& c) {
    return {p.a * p.b, c.value};
  }
  PLASTICA_ALWAYS_INLINE friend FusedProduct operator*(const Fused<S>& c, const FusedProduct& p) {
    return {c.value, p.a * p.b};
  }
  PLASTICA_ALWAYS_INLINE friend FusedProduct operator*(const FusedProduct& p,
                                                       const FusedProduct& q) {
    return {p.a * p.b, q.a * q.b};
  }
};

template <class S>
struct ScalarTraits<Fused<S>> {
  using Real = real_t<S>;
  using Mask = mask_t<S>;
};

template <class S>
PLASTICA_ALWAYS_INLINE inline Fused<S> select(const std::type_identity_t<mask_t<S>>& mask,
                                              const Fused<S>& a, const Fused<S>& b) {
  return Fused<S>(plastica::select(mask, a.value, b.value));
}

/// Fused throughout, as all that such a scalar goes into.
template <class S, bool kFused>
struct SineCosine<Fused<S>, kFused> {
  Fused<S> sine, cosine;

  PLASTICA_ALWAYS_INLINE explicit SineCosine(const Fused<S>& x) {
    const SineCosine<S, true> at(x.value);
    sine = Fused<S>(at.sine);
    cosine = Fused<S>(at.cosine);
  }
};

PLASTICA_KERNELS_END
}  // namespace plastica
