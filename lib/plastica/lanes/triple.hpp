#pragma once

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/entry.hpp"

/// Vectors and matrices of the spatial kernels. Not those of base/matrix.hpp: an array that is
/// copied as a whole stays in memory, and here products and sums are fused.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

template <class S>
struct Triple {
  S x, y, z;
};

template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> operator+(const Triple<S>& a, const Triple<S>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> operator-(const Triple<S>& a, const Triple<S>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> operator-(const Triple<S>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> operator*(const S& s, const Triple<S>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

/// s a + b.
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> scale_add(const S& s, const Triple<S>& a,
                                                  const Triple<S>& b) {
  return {multiply_add(s, a.x, b.x), multiply_add(s, a.y, b.y), multiply_add(s, a.z, b.z)};
}

/// a . b + c.
template <class S>
PLASTICA_ALWAYS_INLINE inline S dot_add(const Triple<S>& a, const Triple<S>& b, const S& c) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, multiply_add(a.z, b.z, c)));
}
template <class S>
PLASTICA_ALWAYS_INLINE inline S dot(const Triple<S>& a, const Triple<S>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}

/// a x b + c.
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> cross_add(const Triple<S>& a, const Triple<S>& b,
                                                  const Triple<S>& c) {
  return {multiply_add(a.y, b.z, multiply_add(-a.z, b.y, c.x)),
          multiply_add(a.z, b.x, multiply_add(-a.x, b.z, c.y)),
          multiply_add(a.x, b.y, multiply_add(-a.y, b.x, c.z))};
}
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> cross(const Triple<S>& a, const Triple<S>& b) {
  return {multiply_add(a.y, b.z, -(a.z * b.y)), multiply_add(a.z, b.x, -(a.x * b.z)),
          multiply_add(a.x, b.y, -(a.y * b.x))};
}

/// Three columns, or three rows.
template <class S>
struct Columns {
  Triple<S> x, y, z;
};

/// m v + c by columns.
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> columns_add(const Columns<S>& m, const Triple<S>& v,
                                                    const Triple<S>& c) {
  return scale_add(v.x, m.x, scale_add(v.y, m.y, scale_add(v.z, m.z, c)));
}
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> columns_times(const Columns<S>& m, const Triple<S>& v) {
  return scale_add(v.x, m.x, scale_add(v.y, m.y, v.z * m.z));
}
/// m v by rows: m^T v by columns.
template <class S>
PLASTICA_ALWAYS_INLINE inline Triple<S> rows_times(const Columns<S>& m, const Triple<S>& v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

/// A symmetric matrix.
template <class S>
struct Symmetric {
  S xx, xy, xz, yy, yz, zz;

  PLASTICA_ALWAYS_INLINE Columns<S> columns() const {
    return {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  }
};

/// s a a^T + m.
template <class S>
PLASTICA_ALWAYS_INLINE inline Symmetric<S> square_add(const S& s, const Triple<S>& a,
                                                      const Symmetric<S>& m) {
  const Triple<S> b = s * a;
  return {multiply_add(b.x, a.x, m.xx), multiply_add(b.x, a.y, m.xy), multiply_add(b.x, a.z, m.xz),
          multiply_add(b.y, a.y, m.yy), multiply_add(b.y, a.z, m.yz), multiply_add(b.z, a.z, m.zz)};
}

template <class S>
PLASTICA_ALWAYS_INLINE inline Symmetric<S> operator+(const Symmetric<S>& a, const Symmetric<S>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}

/// Three fields of an entry that follow one another.
template <class E>
PLASTICA_ALWAYS_INLINE inline auto get_triple(const E& entry, std::size_t field)
    -> Triple<decltype(entry.get(field))> {
  return {entry.get(field), entry.get(field + 1), entry.get(field + 2)};
}
template <class E, class S>
PLASTICA_ALWAYS_INLINE inline void set_triple(const E& entry, std::size_t field,
                                              const Triple<S>& v) {
  entry.set(field, v.x);
  entry.set(field + 1, v.y);
  entry.set(field + 2, v.z);
}
template <class E>
PLASTICA_ALWAYS_INLINE inline auto get_columns(const E& entry, std::size_t field)
    -> Columns<decltype(entry.get(field))> {
  return {get_triple(entry, field), get_triple(entry, field + 3), get_triple(entry, field + 6)};
}
template <class E, class S>
PLASTICA_ALWAYS_INLINE inline void set_columns(const E& entry, std::size_t field,
                                               const Columns<S>& m) {
  set_triple(entry, field, m.x);
  set_triple(entry, field + 3, m.y);
  set_triple(entry, field + 6, m.z);
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
