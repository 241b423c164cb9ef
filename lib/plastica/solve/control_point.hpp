#pragma once

#include <cstddef>
#include <vector>

#include "plastica/solve/newton.hpp"

namespace plastica::solve {

/// The point whose motion path control watches: its position, or the angle of a twisted chain.
template <class L>
struct ControlPoint {
  static constexpr bool kRotates = L::kTranslations == 0;
  static constexpr std::size_t kSize = kRotates ? L::kRotations : L::kTranslations;
  using Value = Vec<typename L::Scalar, kSize>;

  std::size_t segment = 0;
  typename L::Point arm{};

  Value value(const chain::Placement<L>& placement) const {
    Value v;
    if constexpr (kRotates) {
      v[0] = placement.frame[segment].angle;
    } else {
      v = placement.point(segment, arm);
    }
    return v;
  }

  /// The covector of direction . value.
  chain::Wrench<L> covector(const Value& direction, const chain::Placement<L>& placement) const {
    if constexpr (kRotates) {
      return {{}, direction};
    } else {
      return {direction, L::moment(L::rotate(placement.frame[segment], arm), direction)};
    }
  }

  Value rate(const chain::Motion<L>& motion, const chain::Placement<L>& placement) const {
    if constexpr (kRotates) {
      return motion.spin;
    } else {
      return motion.shift + L::spun(motion.spin, L::rotate(placement.frame[segment], arm));
    }
  }
};

/// How the control point answers loads elastically, kept from one path to the next so that these
/// allocate nothing.
template <class L>
struct ElasticResponses {
  /// What one factor moves the control point by.
  struct Response {
    std::size_t history = 0;                    ///< the first of all that are equal
    typename ControlPoint<L>::Value by_unit{};  ///< of all of these
  };
  std::vector<Response> responses{};   ///< of histories that change
  std::vector<std::size_t> same_as{};  ///< the first of equal ones (histories)
};

}  // namespace plastica::solve
