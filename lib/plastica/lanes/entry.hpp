#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/base/scalar.hpp"

/// How kernels read and write the memory of scenarios side by side.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// How many numbers of the kernels' memory one S takes.
template <class S>
inline constexpr std::size_t kLanes = sizeof(S) / sizeof(real_t<S>);

template <class S>
PLASTICA_ALWAYS_INLINE inline S load_lanes(const real_t<S>* from) {
  if constexpr (kLanes<S> == 1) {
    return *from;
  } else {
    return S::load(from);
  }
}

template <class S>
PLASTICA_ALWAYS_INLINE inline void store_lanes(const S& value, real_t<S>* to) {
  if constexpr (kLanes<S> == 1) {
    *to = value;
  } else {
    value.store(to);
  }
}

/// One entry of an array with `F::kCount` numbers an entry.
/// @tparam kStride  from a lane's number to that of the next field: as many lanes as the memory has
template <class S, class F, std::size_t kStride = kLanes<S>>
class Entry {
 public:
  using Real = real_t<S>;
  using Fields = F;

  PLASTICA_ALWAYS_INLINE Entry(Real* array, std::size_t index)
      : at_(array + index * Fields::kCount * kStride) {}
  PLASTICA_ALWAYS_INLINE S get(std::size_t field) const {
    return load_lanes<S>(at_ + field * kStride);
  }
  PLASTICA_ALWAYS_INLINE void set(std::size_t field, const S& value) const {
    store_lanes<S>(value, at_ + field * kStride);
  }

 private:
  Real* at_;
};

template <class S, class F, std::size_t kStride = kLanes<S>>
class ConstantEntry {
 public:
  using Real = real_t<S>;
  using Fields = F;

  PLASTICA_ALWAYS_INLINE ConstantEntry(const Real* array, std::size_t index)
      : at_(array + index * Fields::kCount * kStride) {}
  PLASTICA_ALWAYS_INLINE S get(std::size_t field) const {
    return load_lanes<S>(at_ + field * kStride);
  }

 private:
  const Real* at_;
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
