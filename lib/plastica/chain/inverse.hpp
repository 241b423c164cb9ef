#pragma once

#include "plastica/base/matrix.hpp"

/// Inverses of the small matrices of a joint, without branches on the numbers.
namespace plastica::chain {

template <class S>
inline Mat<S, 0, 0> inverse(const Mat<S, 0, 0>& m) {
  return m;
}

template <class S>
inline Mat<S, 1, 1> inverse(const Mat<S, 1, 1>& m) {
  return {{constant<S>(1) / m(0, 0)}};
}

template <class S>
inline Mat<S, 2, 2> inverse(const Mat<S, 2, 2>& m) {
  const S scale = constant<S>(1) / (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0));
  return {{scale * m(1, 1), -(scale * m(0, 1)), -(scale * m(1, 0)), scale * m(0, 0)}};
}

template <class S>
inline Mat<S, 3, 3> inverse(const Mat<S, 3, 3>& m) {
  const auto minor = [&](std::size_t r, std::size_t s, std::size_t c, std::size_t d) {
    return m(r, c) * m(s, d) - m(r, d) * m(s, c);
  };
  Mat<S, 3, 3> adjugate{{minor(1, 2, 1, 2), minor(0, 2, 2, 1), minor(0, 1, 1, 2), minor(1, 2, 2, 0),
                         minor(0, 2, 0, 2), minor(0, 1, 2, 0), minor(1, 2, 0, 1), minor(0, 2, 1, 0),
                         minor(0, 1, 0, 1)}};
  const S determinant =
      m(0, 0) * adjugate(0, 0) + m(0, 1) * adjugate(1, 0) + m(0, 2) * adjugate(2, 0);
  return (constant<S>(1) / determinant) * adjugate;
}

/// By its last three rows and columns first: stretch and shear, which always resist.
template <class S>
inline Mat<S, 6, 6> inverse(const Mat<S, 6, 6>& m) {
  const Mat<S, 3, 3> inner = inverse(block<3, 3>(m, 3, 3));
  const Mat<S, 3, 3> across = block<3, 3>(m, 0, 3) * inner;
  const Mat<S, 3, 3> down = inner * block<3, 3>(m, 3, 0);
  const Mat<S, 3, 3> rest = inverse(block<3, 3>(m, 0, 0) - across * block<3, 3>(m, 3, 0));
  const Mat<S, 3, 3> right = rest * across;
  const Mat<S, 3, 3> left = down * rest;
  const Mat<S, 3, 3> last = inner + left * across;
  Mat<S, 6, 6> result;
  put(result, 0, 0, rest);
  put(result, 0, 3, -constant<S>(1) * right);
  put(result, 3, 0, -constant<S>(1) * left);
  put(result, 3, 3, last);
  return result;
}

}  // namespace plastica::chain
