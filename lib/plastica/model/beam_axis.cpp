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

Point between(const Point& a, const Point& b, double fraction) {
  Point point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = a[i] + fraction * (b[i] - a[i]);
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

namespace {

constexpr double kSamePlace = 1e-9;  // of the length

/// Ends of the segments without regard to what is where on the beam.
std::vector<double> even_ends(const Scene& scene) {
  const auto count = static_cast<std::size_t>(scene.beam.segments);
  std::vector<double> ends(count + 1);
  const bool half_ends = scene.end_rule == EndRule::Half && count > 1;
  for (std::size_t i = 1; i < count; ++i) {
    ends[i] = half_ends ? (static_cast<double>(i) - 0.5) / static_cast<double>(count - 1)
                        : static_cast<double>(i) / static_cast<double>(count);
  }
  ends.back() = 1.0;
  return ends;
}

bool is_end(double fraction, std::span<const double> ends) {
  const auto after = std::lower_bound(ends.begin(), ends.end(), fraction - kSamePlace);
  return after != ends.end() && *after <= fraction + kSamePlace;
}

/// Deals segments to the stretches between `nodes` so that the longest is as short as possible, at
/// least one each: the next one goes to the stretch whose segments are longest, the first of
/// several. (Ceilings of stretch/length add up to the number of segments for some length. So no
/// stretch ends with less than its fraction of the segments that are left when each has one.)
/// @param half_ends  the two end segments are half as long as the others of their stretch
std::vector<std::size_t> dealt_segments(std::span<const double> nodes, std::size_t segments,
                                        bool half_ends) {
  constexpr double kTie = 1e-12;
  const std::size_t stretches = nodes.size() - 1;
  const auto fraction = [&](std::size_t i) { return nodes[i + 1] - nodes[i]; };
  std::vector<std::size_t> dealt(stretches, 1);
  const double sure = static_cast<double>(segments) - static_cast<double>(stretches) - 1.0;
  std::size_t left = segments;
  for (std::size_t i = 0; i < stretches; ++i) {
    const double own = std::floor(fraction(i) * sure) - 1.0;
    if (own > 1.0) dealt[i] = static_cast<std::size_t>(own);
    left -= dealt[i];
  }
  const auto length = [&](std::size_t i) {
    const double shorter = half_ends && (i == 0 || i + 1 == stretches) ? 0.5 : 0.0;
    return fraction(i) / (static_cast<double>(dealt[i]) - shorter);
  };
  for (; left > 0; --left) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < stretches; ++i) {
      if (length(i) > length(longest) * (1.0 + kTie)) longest = i;
    }
    ++dealt[longest];
  }
  return dealt;
}

}  // namespace

std::vector<NodePlace> node_places(const Scene& scene) {
  std::vector<NodePlace> places;
  const auto add = [&](const Place& place, const char* list, std::size_t index, const char* key) {
    if (place.segment || !(place.fraction >= 0.0 && place.fraction <= 1.0)) return;
    places.push_back({place.fraction, list, index, key});
  };
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    add(scene.regions[i].from, "region", i, ".from");
    add(scene.regions[i].to, "region", i, ".to");
  }
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    add(scene.supports[i].at, "support", i, ".at");
    if (scene.supports[i].to) add(*scene.supports[i].to, "support", i, ".to");
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    add(scene.loads[i].at, "load", i, ".at");
    if (scene.loads[i].to) add(*scene.loads[i].to, "load", i, ".to");
  }
  for (std::size_t i = 0; i < scene.masses.size(); ++i) add(scene.masses[i].at, "mass", i, ".at");
  if (scene.beam.shape == BeamShape::Polyline) {
    double along = 0.0;
    for (std::size_t i = 1; i + 1 < scene.beam.points.size(); ++i) {
      along += distance(scene.beam.points[i - 1], scene.beam.points[i]);
      add({along / scene.beam.length, {}}, "beam.points", i, "");
    }
  }
  return places;
}

std::vector<double> needed_ends(const Scene& scene) {
  std::vector<double> all;
  for (const NodePlace& place : node_places(scene)) all.push_back(place.fraction);
  std::sort(all.begin(), all.end());
  std::vector<double> needed{0.0};
  for (const double fraction : all) {
    if (fraction > needed.back() + kSamePlace && fraction < 1.0 - kSamePlace) {
      needed.push_back(fraction);
    }
  }
  needed.push_back(1.0);
  return needed;
}

std::vector<double> segment_ends(const Scene& scene) {
  const auto count = static_cast<std::size_t>(scene.beam.segments);
  if (!scene.beam.segment_fractions.empty()) {
    std::vector<double> ends(count + 1);
    for (std::size_t i = 0; i < count; ++i) ends[i + 1] = ends[i] + scene.beam.segment_fractions[i];
    ends.back() = 1.0;
    return ends;
  }
  std::vector<double> even = even_ends(scene);
  if (!scene.beam.joint_lengths.empty()) return even;
  const std::vector<double> needed = needed_ends(scene);
  const auto falls_on_even = [&](double fraction) { return is_end(fraction, even); };
  if (count + 1 < needed.size() || std::all_of(needed.begin(), needed.end(), falls_on_even)) {
    return even;
  }
  const bool half_ends = scene.end_rule == EndRule::Half && count > 1;
  const std::vector<std::size_t> dealt = dealt_segments(needed, count, half_ends);
  std::vector<double> ends{0.0};
  ends.reserve(count + 1);
  for (std::size_t i = 0; i < dealt.size(); ++i) {
    const double first = half_ends && i == 0 && dealt[i] > 1 ? 0.5 : 0.0;
    const double last = half_ends && i + 1 == dealt.size() && dealt[i] > 1 ? 0.5 : 0.0;
    const double whole = static_cast<double>(dealt[i]) - first - last;
    const double stretch = needed[i + 1] - needed[i];
    for (std::size_t k = 1; k < dealt[i]; ++k) {
      ends.push_back(needed[i] + stretch * (static_cast<double>(k) - first) / whole);
    }
    ends.push_back(needed[i + 1]);
  }
  return ends;
}

double fraction_of(const Place& place, std::span<const double> ends) {
  if (place.segment) return ends[static_cast<std::size_t>(*place.segment)];
  const auto after = std::lower_bound(ends.begin(), ends.end(), place.fraction - kSamePlace);
  return after != ends.end() && *after <= place.fraction + kSamePlace ? *after : place.fraction;
}

std::optional<int> segment_end_at(const Place& place, std::span<const double> ends) {
  const double fraction = fraction_of(place, ends);
  const auto at = std::lower_bound(ends.begin(), ends.end(), fraction);
  if (at == ends.end() || *at != fraction) return std::nullopt;
  return static_cast<int>(at - ends.begin());
}

EndRule resolved_end_rule(const Scene& scene) {
  if (scene.end_rule != EndRule::Auto) return scene.end_rule;
  return scene.formulas == Formulas::Report ? EndRule::Equal : EndRule::HalfJoint;
}

int nearest_segment_end(const Place& place, std::span<const double> ends) {
  const double fraction = fraction_of(place, ends);
  const auto after = std::lower_bound(ends.begin(), ends.end() - 1, fraction);
  const bool before = after != ends.begin() && fraction - *(after - 1) <= *after - fraction;
  return static_cast<int>(after - ends.begin()) - (before ? 1 : 0);
}

std::array<double, 3> axis_point(const Beam& beam, double fraction) {
  switch (beam.shape) {
    case BeamShape::Straight: break;
    case BeamShape::Arc: {
      // From the start along z, turning towards arc_towards on a circle of radius L/angle.
      const double radius = beam.length / beam.arc_angle;
      const double angle = beam.arc_angle * fraction;
      const double aside = 2.0 * radius * std::sin(angle / 2.0) * std::sin(angle / 2.0);
      return {aside * beam.arc_towards[0], aside * beam.arc_towards[1], radius * std::sin(angle)};
    }
    case BeamShape::Polyline: return polyline_point(beam.points, fraction * beam.length);
  }
  return {0.0, 0.0, fraction * beam.length};
}

double polyline_length(std::span<const std::array<double, 3>> points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  return length;
}

}  // namespace plastica
