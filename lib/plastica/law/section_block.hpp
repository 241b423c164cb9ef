#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/matrix.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law::detail {

/// A symmetric matrix of section forces in which torsion stands alone.
template <class S>
struct SectionBlock {
  std::array<S, 7> at{};  ///< xx, yy, nn, tt, xy, xn, yn

  PLASTICA_ALWAYS_INLINE static SectionBlock diagonal(const SectionForce<S>& d) {
    const S zero = constant<S>(0);
    return {{d[kBendingX], d[kBendingY], d[kAxial], d[kTorsion], zero, zero, zero}};
  }

  /// Adds a full matrix times a factor; what couples torsion is not looked at.
  PLASTICA_ALWAYS_INLINE void add(const S& factor, const SectionTangent<S>& a) {
    at[0] += factor * a(kBendingX, kBendingX);
    at[1] += factor * a(kBendingY, kBendingY);
    at[2] += factor * a(kAxial, kAxial);
    at[3] += factor * a(kTorsion, kTorsion);
    at[4] += factor * a(kBendingX, kBendingY);
    at[5] += factor * a(kBendingX, kAxial);
    at[6] += factor * a(kBendingY, kAxial);
  }

  PLASTICA_ALWAYS_INLINE SectionForce<S> times(const SectionForce<S>& a) const {
    const S& x = a[kBendingX];
    const S& y = a[kBendingY];
    const S& n = a[kAxial];
    return {{at[0] * x + at[4] * y + at[5] * n, at[4] * x + at[1] * y + at[6] * n,
             at[3] * a[kTorsion], at[5] * x + at[6] * y + at[2] * n}};
  }

  /// The inverse among the components where `free` is 1, by cofactors; elsewhere it means nothing.
  PLASTICA_ALWAYS_INLINE SectionBlock inverse(const SectionForce<S>& free) const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S xx = select(free[kBendingX] > zero, at[0], one);
    const S yy = select(free[kBendingY] > zero, at[1], one);
    const S nn = select(free[kAxial] > zero, at[2], one);
    const S tt = select(free[kTorsion] > zero, at[3], one);
    const S xy = at[4] * (free[kBendingX] * free[kBendingY]);
    const S xn = at[5] * (free[kBendingX] * free[kAxial]);
    const S yn = at[6] * (free[kBendingY] * free[kAxial]);
    const S c_xx = yy * nn - yn * yn;
    const S c_xy = yn * xn - xy * nn;
    const S c_xn = xy * yn - yy * xn;
    const S over = one / (xx * c_xx + xy * c_xy + xn * c_xn);
    return {{c_xx * over, (xx * nn - xn * xn) * over, (xx * yy - xy * xy) * over, one / tt,
             c_xy * over, c_xn * over, (xy * xn - xx * yn) * over}};
  }

  /// As a full matrix.
  PLASTICA_ALWAYS_INLINE SectionTangent<S> full() const {
    const S zero = constant<S>(0);
    return {{at[0], at[4], zero, at[5],  //
             at[4], at[1], zero, at[6],  //
             zero, zero, at[3], zero,    //
             at[5], at[6], zero, at[2]}};
  }
};

}  // namespace plastica::law::detail
