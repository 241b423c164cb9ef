#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/listed.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica::model_detail {
namespace {

/// Of sums and of unit vectors; half a unit in the last of ten places.
constexpr double kTolerance = 5e-10;

void check_count(std::string_view field, std::size_t count, int wanted) {
  if (count == static_cast<std::size_t>(wanted)) return;
  throw InputError({}, field, std::to_string(count) + " values",
                   "must be " + std::to_string(wanted) + " for the beam's segments");
}

void check_lengths(const Beam& beam) {
  if (!beam.segment_fractions.empty()) {
    check_count("beam.segment_lengths", beam.segment_fractions.size(), beam.segments);
    for (std::size_t i = 0; i < beam.segment_fractions.size(); ++i) {
      require_positive(beam.segment_fractions[i], {}, item_name("beam.segment_lengths", i));
    }
    const double sum =
        std::accumulate(beam.segment_fractions.begin(), beam.segment_fractions.end(), 0.0);
    require(std::abs(sum - 1.0) <= kTolerance, {}, "beam.segment_lengths", sum,
            "is the sum of the fractions and must be 1");
  }
  if (!beam.joint_lengths.empty()) {
    check_count("beam.joint_lengths", beam.joint_lengths.size(), beam.segments - 1);
    for (std::size_t i = 0; i < beam.joint_lengths.size(); ++i) {
      require_positive(beam.joint_lengths[i], {}, item_name("beam.joint_lengths", i));
    }
  }
}

void check_arc(const Beam& beam) {
  constexpr double kFullCircle = 6.283185307179586;
  require(beam.arc_angle > 0.0 && beam.arc_angle <= kFullCircle * (1.0 + kTolerance), {},
          "beam.arc_angle", beam.arc_angle, "must be above 0 and at most a full turn, 2 pi rad");
  const auto& towards = beam.arc_towards;
  check_finite(towards, "beam.arc_towards");
  require(std::abs(std::hypot(towards[0], towards[1], towards[2]) - 1.0) <= kTolerance, {},
          "beam.arc_towards", std::hypot(towards[0], towards[1], towards[2]),
          "is the vector's size and must be 1");
  require(std::abs(towards[2]) <= kTolerance, {}, "beam.arc_towards", towards[2],
          "is its z component and must be 0: the beam starts along z");
}

void check_polyline(const Beam& beam) {
  if (beam.points.size() < 2) {
    throw InputError({}, "beam.points", std::to_string(beam.points.size()) + " points",
                     "must be at least 2");
  }
  for (std::size_t i = 0; i < beam.points.size(); ++i) {
    check_finite(beam.points[i], item_name("beam.points", i));
  }
  if (beam.points[0] != std::array<double, 3>{}) {
    throw InputError({}, "beam.points[1]", "", "must be the origin, where a beam starts");
  }
  std::array<double, 3> before{0.0, 0.0, 1.0};
  for (std::size_t i = 1; i < beam.points.size(); ++i) {
    const auto& a = beam.points[i - 1];
    const auto& b = beam.points[i];
    const double leg = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    if (leg == 0.0) {
      throw InputError({}, item_name("beam.points", i), "", "is the same as the one before");
    }
    const std::array<double, 3> along{(b[0] - a[0]) / leg, (b[1] - a[1]) / leg,
                                      (b[2] - a[2]) / leg};
    const double cosine = before[0] * along[0] + before[1] * along[1] + before[2] * along[2];
    if (cosine < -1.0 + kTolerance) {
      throw InputError({}, item_name("beam.points", i), "",
                       i == 1 ? "runs straight against z, along which the beam starts"
                              : "turns straight back at the point before");
    }
    before = along;
  }
  const double length = polyline_length(beam.points);
  require(std::abs(length - beam.length) <= kTolerance * length, {}, "beam.length", beam.length,
          "must be the sum over beam.points, " + number_text(length) + " m");
}

/// The error of a region's part, under the region's name: "region[1].section.width".
template <typename Check>
void check_part(std::size_t region, const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw InputError({}, item_name("region", region, "." + error.field()), error.value(),
                     error.rule());
  }
}

/// The section at the end of a taper.
void check_taper(const Region& region, std::size_t i) {
  const std::string name = item_name("region", i, ".to_section");
  const SectionKind& kind = section_kind(region.section);
  if (&section_kind(*region.to_section) != &kind) {
    throw InputError({}, name + ".shape", std::string(section_kind(*region.to_section).word()),
                     "must be that of section, " + std::string(kind.word()));
  }
  if (kind.dimensions().empty() || !kind.has_fibres()) {
    throw InputError({}, name, "",
                     "cannot end a taper: the numbers of shape = \"" + std::string(kind.word()) +
                         "\" do not tell what is between");
  }
  try {
    check_section(*region.to_section);
  } catch (const InputError& error) {
    throw InputError({}, item_name("region", i, ".to_" + error.field()), error.value(),
                     error.rule());
  }
}

void check_regions(const Scene& scene, Ends ends) {
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Region& region = scene.regions[i];
    check_place(region.from, scene.beam.segments, item_name("region", i, ".from"));
    check_place(region.to, scene.beam.segments, item_name("region", i, ".to"));
    if (fraction_of(region.from, ends) >= fraction_of(region.to, ends)) {
      throw InputError({}, item_name("region", i, ".to"), place_text(region.to),
                       "must lie beyond from = " + place_text(region.from));
    }
    check_part(i, [&] { check_section(region.section); });
    check_part(i, [&] { check_material(region.material); });
    if (region.to_section) check_taper(region, i);
  }
}

/// The names of places, the first few of many.
std::string names_of(std::span<const NodePlace> places) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> names;
  for (const NodePlace& place : places) {
    names.push_back(item_name(place.list, place.index, place.key) + " = " +
                    number_text(place.fraction));
  }
  return listed(names, kMost);
}

/// Segments end where regions, supports, loads and corners are.
std::vector<double> checked_division(const Scene& scene) {
  std::vector<double> ends = segment_ends(scene);
  if (scene.beam.segment_fractions.empty() && scene.beam.joint_lengths.empty()) {
    const std::vector<double> needed = needed_ends(scene);
    const std::size_t fewest = needed.size() - 1;
    if (static_cast<std::size_t>(scene.beam.segments) >= fewest) return ends;
    std::vector<NodePlace> inner;
    for (std::size_t i = 1; i < fewest; ++i) {
      for (const NodePlace& place : node_places(scene)) {
        if (place.fraction != needed[i]) continue;
        inner.push_back(place);
        break;
      }
    }
    throw InputError({}, "beam.segments", std::to_string(scene.beam.segments),
                     "must be at least " + std::to_string(fewest) + ", since segments end at " +
                         names_of(inner));
  }
  for (const NodePlace& place : node_places(scene)) {
    if (place.list != std::string_view("region") || segment_end_at({place.fraction, {}}, ends)) {
      continue;
    }
    const auto after = std::upper_bound(ends.begin(), ends.end(), place.fraction);
    throw InputError({}, item_name(place.list, place.index, place.key), number_text(place.fraction),
                     "must be where a segment ends, which beam." +
                         std::string(scene.beam.segment_fractions.empty() ? "joint" : "segment") +
                         "_lengths sets; the nearest ends are " + number_text(*(after - 1)) +
                         " and " + number_text(*after));
  }
  return ends;
}

}  // namespace

std::string item_name(std::string_view list, std::size_t index, std::string_view key) {
  return std::string(list) + "[" + std::to_string(index + 1) + "]" + std::string(key);
}

std::string place_text(const Place& place) {
  if (place.segment && *place.segment != 0) {
    return "{ segment = " + std::to_string(*place.segment) + " }";
  }
  if (place.segment || place.fraction == 0.0) return "start";
  return place.fraction == 1.0 ? "end" : number_text(place.fraction);
}

void check_place(const Place& place, int segments, std::string_view field) {
  if (place.segment && (*place.segment < 0 || *place.segment > segments)) {
    throw InputError(
        {}, field, place_text(place),
        "must be a segment from 1 to " + std::to_string(segments) + ", or 0 for the start");
  }
  require(place.segment || (place.fraction >= 0.0 && place.fraction <= 1.0), {}, field,
          place.fraction, "must be a fraction of the length, 0 to 1");
}

void check_finite(std::span<const double> values, std::string_view field) {
  for (const double value : values)
    require(std::isfinite(value), {}, field, value, "must be finite");
}

std::vector<double> check_beam(const Scene& scene) {
  check_lengths(scene.beam);
  if (scene.beam.shape == BeamShape::Arc) check_arc(scene.beam);
  if (scene.beam.shape == BeamShape::Polyline) check_polyline(scene.beam);
  std::vector<double> ends = checked_division(scene);
  check_regions(scene, ends);
  return ends;
}

}  // namespace plastica::model_detail
