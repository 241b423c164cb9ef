#pragma once

#include <cstddef>
#include <type_traits>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/matrix.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/base/scalar.hpp"

/// How kernels read and write the memory of scenarios side by side.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// One number, or W.
template <class Real, std::size_t W>
using LanesOf = std::conditional_t<W == 1, Real, Pack<Real, static_cast<int>(W)>>;

/// One entry of an array with `F::kCount` numbers an entry.
/// @tparam S        a scalar with `load` and `store`
/// @tparam kStride  from a lane's number to that of the next field: as many lanes as the memory has
template <class S, class F, std::size_t kStride, class Number = real_t<S>>
class Entry {
 public:
  using Fields = F;

  PLASTICA_ALWAYS_INLINE Entry(Number* array, std::size_t index)
      : at_(array + index * Fields::kCount * kStride) {}
  PLASTICA_ALWAYS_INLINE S get(std::size_t field) const { return S::load(at_ + field * kStride); }
  PLASTICA_ALWAYS_INLINE void set(std::size_t field, const S& value) const {
    value.store(at_ + field * kStride);
  }

 private:
  Number* at_;
};

template <class S, class F, std::size_t kStride>
using ConstantEntry = Entry<S, F, kStride, const real_t<S>>;

/// N fields of an entry that follow one another.
template <std::size_t N, class E>
PLASTICA_ALWAYS_INLINE inline auto get_vec(const E& entry, std::size_t field) {
  using S = decltype(entry.get(field));
  return Vec<S, N>{
      each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE -> S { return entry.get(field + k); })};
}
template <class E, class S, std::size_t N>
PLASTICA_ALWAYS_INLINE inline void set_vec(const E& entry, std::size_t field, const Vec<S, N>& v) {
  for_each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE { entry.set(field + k, v[k]); });
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
