#include "plastica/model/beam_axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plastica {
namespace {

using Point = std::array<double, 3>;

double distance(const Point& a, const Point& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

Point between(const Point& a, const Point& b, double share) {
  Point point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = a[i] + share * (b[i] - a[i]);
  return point;
}

Point polyline_point(std::span<const Point> points, double along) {
  for (std::size_t i = 0; i + 2 < points.size(); ++i) {
    const double leg = distance(points[i], points[i + 1]);
    if (along <= leg) return between(points[i], points[i + 1], along / leg);
    along -= leg;
  }
  const Point& last = points[points.size() - 1];
  const Point& before = points[points.size() - 2];
  return between(before, last, along / distance(before, last));
}

}  // namespace

std::vector<double> segment_ends(const Scene& scene) {
  const auto count = static_cast<std::size_t>(scene.beam.segments);
  std::vector<double> ends(count + 1);
  if (!scene.beam.segment_shares.empty()) {
    for (std::size_t i = 0; i < count; ++i) ends[i + 1] = ends[i] + scene.beam.segment_shares[i];
  } else if (scene.end_rule == EndRule::Half && count > 1) {
    for (std::size_t i = 1; i < count; ++i) {
      ends[i] = (static_cast<double>(i) - 0.5) / static_cast<double>(count - 1);
    }
  } else {
    for (std::size_t i = 1; i < count; ++i) {
      ends[i] = static_cast<double>(i) / static_cast<double>(count);
    }
  }
  ends.back() = 1.0;
  return ends;
}

double share_of(const Place& place, std::span<const double> ends) {
  if (place.segment) return ends[static_cast<std::size_t>(*place.segment)];
  constexpr double kSame = 1e-9;
  const auto after = std::lower_bound(ends.begin(), ends.end(), place.fraction - kSame);
  return after != ends.end() && *after <= place.fraction + kSame ? *after : place.fraction;
}

std::optional<int> segment_end_at(const Place& place, std::span<const double> ends) {
  const double share = share_of(place, ends);
  const auto at = std::lower_bound(ends.begin(), ends.end(), share);
  if (at == ends.end() || *at != share) return std::nullopt;
  return static_cast<int>(at - ends.begin());
}

int nearest_segment_end(const Place& place, std::span<const double> ends) {
  const double share = share_of(place, ends);
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (std::abs(ends[i] - share) < std::abs(ends[nearest] - share)) nearest = i;
  }
  return static_cast<int>(nearest);
}

std::array<double, 3> axis_point(const Beam& beam, double share) {
  switch (beam.shape) {
    case BeamShape::Straight: break;
    case BeamShape::Arc: {
      // From the start along z, turning towards arc_towards on a circle of radius L/angle.
      const double radius = beam.length / beam.arc_angle;
      const double turned = beam.arc_angle * share;
      const double aside = 2.0 * radius * std::sin(turned / 2.0) * std::sin(turned / 2.0);
      return {aside * beam.arc_towards[0], aside * beam.arc_towards[1], radius * std::sin(turned)};
    }
    case BeamShape::Polyline: return polyline_point(beam.points, share * beam.length);
  }
  return {0.0, 0.0, share * beam.length};
}

double polyline_length(std::span<const std::array<double, 3>> points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  return length;
}

}  // namespace plastica
