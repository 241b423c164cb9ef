#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "plastica/chain/section_joints.hpp"

/// How a level sees space: x, y, z to its own coordinates, and back for the response.
namespace plastica::chain {

template <class L>
struct View;

template <class S>
struct View<Twist<S>> {
  using L = Twist<S>;
  typename L::Point point(const Vec<double, 3>& /*v*/) const { return {}; }
  typename L::Spin spin(const Vec<double, 3>& v) const { return {{constant<S>(v[2])}}; }
  typename L::Frame frame(const Mat<double, 3, 3>& m) const {
    return {constant<S>(std::atan2(m(1, 0), m(0, 0)))};
  }
  Vec<S, 3> point_in_space(const typename L::Point& /*p*/) const { return {}; }
  Vec<S, 3> spin_in_space(const typename L::Spin& w) const { return {{S{}, S{}, w[0]}}; }
  template <class T>
  std::array<T, 3> translations(const std::array<T, 6>& /*of_space*/) const {
    return {};
  }
  template <class T>
  std::array<T, 3> rotations(const std::array<T, 6>& of_space) const {
    return {of_space[5]};
  }
  SectionAxes<L> section_axes() const { return {}; }
};

template <class S>
struct View<Planar<S>> {
  using L = Planar<S>;
  std::size_t across = 1;  ///< 1: the y-z plane, bending about x; 0: the x-z plane, about y

  /// An angle from z to y turns against x.
  double sense() const { return across == 1 ? -1.0 : 1.0; }
  std::size_t normal() const { return 1 - across; }

  typename L::Point point(const Vec<double, 3>& v) const {
    return {{constant<S>(v[2]), constant<S>(v[across])}};
  }
  typename L::Spin spin(const Vec<double, 3>& v) const {
    return {{constant<S>(sense() * v[normal()])}};
  }
  typename L::Frame frame(const Mat<double, 3, 3>& m) const {
    return L::rotation({{constant<S>(std::atan2(m(across, 2), m(2, 2)))}});
  }
  Vec<S, 3> point_in_space(const typename L::Point& p) const {
    Vec<S, 3> v;
    v[2] = p[0];
    v[across] = p[1];
    return v;
  }
  Vec<S, 3> spin_in_space(const typename L::Spin& w) const {
    Vec<S, 3> v;
    v[normal()] = constant<S>(sense()) * w[0];
    return v;
  }
  template <class T>
  std::array<T, 3> translations(const std::array<T, 6>& of_space) const {
    return {of_space[2], of_space[across]};
  }
  template <class T>
  std::array<T, 3> rotations(const std::array<T, 6>& of_space) const {
    return {of_space[3 + normal()]};
  }
  SectionAxes<L> section_axes() const { return {normal()}; }
};

template <class S>
struct View<Spatial<S>> {
  using L = Spatial<S>;
  typename L::Point point(const Vec<double, 3>& v) const {
    return {{constant<S>(v[0]), constant<S>(v[1]), constant<S>(v[2])}};
  }
  typename L::Spin spin(const Vec<double, 3>& v) const { return point(v); }
  typename L::Frame frame(const Mat<double, 3, 3>& m) const {
    typename L::Frame f;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) f.axes(i, j) = constant<S>(m(i, j));
    }
    return f;
  }
  Vec<S, 3> point_in_space(const typename L::Point& p) const { return p; }
  Vec<S, 3> spin_in_space(const typename L::Spin& w) const { return w; }
  template <class T>
  std::array<T, 3> translations(const std::array<T, 6>& of_space) const {
    return {of_space[0], of_space[1], of_space[2]};
  }
  template <class T>
  std::array<T, 3> rotations(const std::array<T, 6>& of_space) const {
    return {of_space[3], of_space[4], of_space[5]};
  }
  SectionAxes<L> section_axes() const { return {}; }
};

/// Unit vector of a coordinate of a level.
template <class V>
V unit_vector(std::size_t k) {
  V v;
  v[k] = constant<std::remove_cvref_t<decltype(v[k])>>(1);
  return v;
}

}  // namespace plastica::chain
