#include "plastica/model/free_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::model_detail {
namespace {

/// A small rigid motion of each body between hinges, or what a support or a hinge resists of it:
/// translation along x, y, z, and rotation about x, y, z through the beam's start, in radians times
/// the beam's length (6 n_bodies).
using Motion = std::vector<double>;
using Point = std::array<double, 3>;

double dot(const Motion& a, const Motion& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The bodies of a beam between its hinges.
class Bodies {
 public:
  Bodies(const Scene& scene, std::span<const double> ends) : scene_(scene), ends_(ends) {
    for (const Support& support : scene.supports) {
      if (traits_of(support).releases) hinges_.push_back(fraction_of(support.at, ends));
    }
    std::sort(hinges_.begin(), hinges_.end());
  }

  std::size_t count() const { return hinges_.size() + 1; }
  Motion none() const { return Motion(6 * count()); }

  std::vector<Motion> resisted() {
    for (const Support& support : scene_.supports) {
      const double fraction = fraction_of(support.at, ends_);
      if (traits_of(support).releases) {
        add_hinge(fraction);
      } else if (support.to) {
        add_bed(support, fraction, fraction_of(*support.to, ends_));
      } else {
        add_support(support, body_at(fraction), fraction);
      }
    }
    return std::move(motions_);
  }

 private:
  /// A point at a hinge belongs to the body before it.
  std::size_t body_at(double fraction) const {
    return static_cast<std::size_t>(std::lower_bound(hinges_.begin(), hinges_.end(), fraction) -
                                    hinges_.begin());
  }
  /// Over the length.
  Point point_at(double fraction) const {
    Point point = axis_point(scene_.beam, fraction);
    for (double& component : point) component /= scene_.beam.length;
    return point;
  }

  /// What a resistance along `direction` at `point` resists: the velocity there of a motion (v, w)
  /// is v + w x point, so along the direction it is v.d + w.(point x d).
  static void put(const Point& d, const Point& p, double factor, double* motion) {
    const Point moment{p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2],
                       p[0] * d[1] - p[1] * d[0]};
    for (std::size_t i = 0; i < 3; ++i) {
      motion[i] += factor * d[i];
      motion[i + 3] += factor * moment[i];
    }
  }
  static Point unit(std::size_t axis) {
    Point direction{};
    direction[axis] = 1.0;
    return direction;
  }

  void add_support(const Support& support, std::size_t body, double fraction) {
    const Point point = point_at(fraction);
    const HeldFreedoms held = held_about_world(scene_, support, ends_);
    const auto add = [&](const Point& direction) {
      motions_.push_back(none());
      put(direction, point, 1.0, &motions_.back()[6 * body]);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (held[axis] || support.stiffness[axis] > 0.0) add(unit(axis));
      if (!held[axis + 3] && !(support.rotational_stiffness[axis] > 0.0)) continue;
      motions_.push_back(none());
      motions_.back()[6 * body + 3 + axis] = 1.0;
    }
    if (support.has_normal()) add(support.normal);
  }

  /// A bed holds each body as springs at both ends of what lies on it.
  void add_bed(const Support& support, double from, double to) {
    for (std::size_t body = 0; body < count(); ++body) {
      const double begin = std::max(from, body == 0 ? 0.0 : hinges_[body - 1]);
      const double end = std::min(to, body + 1 == count() ? 1.0 : hinges_[body]);
      if (end <= begin) continue;
      add_support(support, body, begin);
      add_support(support, body, end);
    }
  }

  /// A hinge ties both sides together but for bending.
  void add_hinge(double fraction) {
    const std::size_t body = body_at(fraction);
    const Point point = point_at(fraction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      motions_.push_back(none());
      put(unit(axis), point, 1.0, &motions_.back()[6 * body]);
      put(unit(axis), point, -1.0, &motions_.back()[6 * body + 6]);
    }
    const auto node = std::lower_bound(ends_.begin(), ends_.end(), fraction);
    const Point before = point_at(*(node - 1));
    const Point after = point_at(*(node + 1));
    motions_.push_back(none());
    for (std::size_t i = 0; i < 3; ++i) {
      motions_.back()[6 * body + 3 + i] = after[i] - before[i];
      motions_.back()[6 * body + 9 + i] = before[i] - after[i];
    }
  }

  const Scene& scene_;
  std::span<const double> ends_;
  std::vector<double> hinges_;
  std::vector<Motion> motions_;
};

/// Takes out of a motion what an orthonormal basis holds of it, twice, which leaves rounding alone.
void subtract(std::span<const Motion> basis, Motion& motion) {
  for (int pass = 0; pass < 2; ++pass) {
    for (const Motion& held : basis) {
      const double part = dot(held, motion);
      for (std::size_t i = 0; i < motion.size(); ++i) motion[i] -= part * held[i];
    }
  }
}

}  // namespace

std::array<bool, 6> freedoms_of(const LevelChoice& level) {
  switch (level.level) {
    case Level::Twist: return {false, false, false, false, false, true};
    case Level::Planar:
      return level.bending == BendingAxis::X
                 ? std::array<bool, 6>{false, true, true, true, false, false}
                 : std::array<bool, 6>{true, false, true, false, true, false};
    default: return {true, true, true, true, true, true};
  }
}

std::optional<std::string> free_motion(const Scene& scene, const LevelChoice& level,
                                       std::span<const double> ends) {
  constexpr double kNothing = 1e-9;  // well above the rounding of unit vectors
  const std::array<bool, 6> freedoms = freedoms_of(level);
  Bodies bodies(scene, ends);
  std::vector<Motion> basis;
  for (Motion motion : bodies.resisted()) {
    for (std::size_t i = 0; i < motion.size(); ++i) motion[i] *= freedoms[i % 6] ? 1.0 : 0.0;
    subtract(basis, motion);
    const double size = std::sqrt(dot(motion, motion));
    if (size < kNothing) continue;
    for (double& component : motion) component /= size;
    basis.push_back(motion);
  }
  // What is left of a unit motion after the basis is its part that nothing resists; of a motion
  // that is free altogether, all of it.
  std::size_t freest = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < 6 * bodies.count(); ++i) {
    if (!freedoms[i % 6]) continue;
    Motion motion = bodies.none();
    motion[i] = 1.0;
    subtract(basis, motion);
    const double left = std::sqrt(dot(motion, motion));
    if (left <= most + kNothing) continue;
    most = left;
    freest = i;
  }
  if (most < kNothing) return std::nullopt;
  constexpr std::array<const char*, 6> kNames{"move along x",   "move along y",   "move along z",
                                              "rotate about x", "rotate about y", "rotate about z"};
  const std::string beside = bodies.count() > 1 ? " beside a hinge" : "";
  return kNames[freest % 6] + beside;
}

}  // namespace plastica::model_detail
