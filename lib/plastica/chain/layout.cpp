#include "plastica/chain/layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plastica/chain/rotation.hpp"
#include "plastica/chain/support_axes.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/region.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::chain {
namespace {

using Point = Vec<double, 3>;
using Frame = Mat<double, 3, 3>;

Point unit(const Point& v) { return 1.0 / std::sqrt(dot(v, v)) * v; }

/// The frame turned least so that its z axis points along `direction`.
Frame rotated_along(const Frame& frame, const Point& direction) {
  const Point z{{frame(0, 2), frame(1, 2), frame(2, 2)}};
  const Point axis = cross(z, direction);
  const double sine = std::sqrt(dot(axis, axis));
  if (sine < 1e-15) return frame;
  const double angle = std::atan2(sine, dot(z, direction));
  return rotation_matrix(angle / sine * axis) * frame;
}

/// Half way from one frame to another.
Frame between(const Frame& a, const Frame& b) {
  if (a.at == b.at) return a;
  return a * rotation_matrix(0.5 * rotation_vector(transpose(a) * b));
}

/// The frame at a fraction of an arc, whose z axis is its tangent.
Frame arc_frame(const Beam& beam, double fraction) {
  const Point along{{0.0, 0.0, 1.0}};
  const Point towards{{beam.arc_towards[0], beam.arc_towards[1], beam.arc_towards[2]}};
  return rotation_matrix(fraction * beam.arc_angle * cross(along, towards));
}

void place_frames(const Beam& beam, Layout& layout) {
  const std::size_t n = layout.size();
  Frame frame = identity<double, 3>();
  for (std::size_t i = 0; i < n; ++i) {
    frame = rotated_along(frame, unit(layout.node[i + 1] - layout.node[i]));
    layout.segment_frame.push_back(frame);
  }
  layout.joint_frame.push_back(layout.segment_frame.front());
  for (std::size_t i = 1; i < n; ++i) {
    layout.joint_frame.push_back(between(layout.segment_frame[i - 1], layout.segment_frame[i]));
  }
  layout.joint_frame.push_back(layout.segment_frame.back());
  if (beam.shape == BeamShape::Arc) {
    layout.joint_frame.front() = arc_frame(beam, 0.0);
    layout.joint_frame.back() = arc_frame(beam, 1.0);
  }
}

/// Whether the end segments belong whole to their only joint.
bool has_whole_ends(const Layout& layout) {
  return layout.end_rule == EndRule::Half || layout.end_rule == EndRule::ThreeHalves;
}

void set_joint_lengths(const Scene& scene, Layout& layout) {
  const std::size_t n = layout.size();
  const auto& length = layout.segment_length;
  auto& joint = layout.joint_length;
  joint.assign(n + 1, 0.0);
  auto& before = layout.length_before;
  before.assign(n + 1, 0.0);
  joint.front() = 0.5 * length.front();
  joint.back() = before.back() = 0.5 * length.back();
  for (std::size_t i = 1; i < n; ++i) {
    joint[i] = 0.5 * (length[i - 1] + length[i]);
    before[i] = 0.5 * length[i - 1];
  }
  if (n > 1 && has_whole_ends(layout)) {
    joint[1] += 0.5 * length.front();
    before[1] += 0.5 * length.front();
    joint[n - 1] += 0.5 * length.back();
  }
  if (!scene.beam.joint_lengths.empty()) {
    for (std::size_t i = 1; i < n; ++i) {
      before[i] *= scene.beam.joint_lengths[i - 1] / joint[i];
      joint[i] = scene.beam.joint_lengths[i - 1];
    }
  }
}

/// Whether a rigid support holds a place, or may push there.
bool is_held(const Scene& scene, std::size_t node, const std::vector<double>& ends) {
  return std::ranges::any_of(scene.supports, [&](const Support& support) {
    const SupportTraits& traits = traits_of(support);
    if (support.to || traits.springs || traits.releases) return false;
    const HeldFreedoms held = support.held();
    return (held[0] || held[1] || held[2] || support.has_normal()) &&
           segment_end_at(support.at, ends) == static_cast<int>(node);
  });
}

/// See `Layout::shift_before`.
void set_shift_lengths(const Scene& scene, Layout& layout) {
  const std::size_t n = layout.size();
  auto& before = layout.shift_before = layout.length_before;
  auto& beyond = layout.shift_beyond;
  for (std::size_t i = 0; i <= n; ++i) beyond.push_back(layout.joint_length[i] - before[i]);
  if (!has_whole_ends(layout)) {
    if (n > 1) before[1] += 0.5 * layout.segment_length.front();
    beyond[n - 1] += 0.5 * layout.segment_length.back();
  }
  if (!scene.beam.joint_lengths.empty()) return;
  for (std::size_t i = 2; i < n; ++i) {
    if (!is_held(scene, i, layout.ends)) continue;
    beyond[i - 1] += before[i];
    before[i] = 0.0;
  }
}

/// See `Layout::bare_half`.
void set_bare_halves(const Scene& scene, Layout& layout) {
  const std::array<double, 2> half{0.5 * layout.segment_length.front(),
                                   0.5 * layout.segment_length.back()};
  if (layout.end_rule != EndRule::HalfJoint) return;
  constexpr std::array<double, 3> kNothing{};
  for (std::size_t e = 0; e < 2; ++e) {
    const double fraction = layout.ends[e == 0 ? 0 : layout.size()];
    bool has_moment = false;
    std::array<bool, 3> held{};
    const Frame& frame = e == 0 ? layout.segment_frame.front() : layout.segment_frame.back();
    for (const Load& load : scene.loads) {
      const bool here = !load.to && fraction_of(load.at, layout.ends) == fraction;
      const double along = dot(Point{{frame(0, 2), frame(1, 2), frame(2, 2)}}, Point{load.force});
      layout.bears[e] = layout.bears[e] || (here && std::fabs(along) > 0.0);
      has_moment = has_moment || (here && load.moment != kNothing);
    }
    for (const PointMass& mass : scene.masses) {
      has_moment = has_moment ||
                   (mass.has_rotational_inertia() && fraction_of(mass.at, layout.ends) == fraction);
    }
    for (const Support& support : scene.supports) {
      if (support.to || fraction_of(support.at, layout.ends) != fraction) continue;
      // At a clamp the half joint there has the section already.
      const HeldFreedoms all = support.held();
      layout.bears[e] = layout.bears[e] || (all[2] && !all[3] && !all[4]);
      has_moment = has_moment || support.rotational_stiffness != kNothing;
      const auto holds = held_rotations(support, layout.joint_frame[e == 0 ? 0 : layout.size()]);
      for (std::size_t k = 0; k < 3; ++k) {
        held[k] = held[k] || (holds ? (*holds)[k] : support.held()[3 + k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_bare = has_moment && !held[k];
      layout.bare_half[e][k] = is_bare ? half[e] : 0.0;
      layout.bears[e] = layout.bears[e] || is_bare;
    }
  }
}

/// The last region that holds a point; 0: none.
std::size_t region_at(const Scene& scene, double fraction, const std::vector<double>& ends) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Region& region = scene.regions[i];
    if (fraction < fraction_of(region.from, ends) || fraction > fraction_of(region.to, ends))
      continue;
    number = i + 1;
  }
  return number;
}

void set_regions(const Scene& scene, std::optional<law::GaugePlane> yields, Layout& layout) {
  const bool one_surface = yields && has_one_surface(scene.yield_model);
  const auto add = [&](std::size_t number, const Section& section, const Material& material) {
    BeamRegion region{.scene_region = number, .section = section, .material = material};
    region.properties = section_properties(section, material.poisson_ratio);
    region.form =
        law::section_form(section, region.properties, material, scene.yield_cap, scene.formulas);
    if (one_surface) {
      region.gauge =
          law::gauge_form(section, scene.yield_model, scene.yield_cap, scene.formulas, *yields);
    }
    layout.regions.push_back(std::move(region));
    return layout.regions.size() - 1;
  };
  add(0, scene.section, scene.material);
  for (const Region& region : scene.regions) {
    add(layout.regions.size(), region.section, region.material);
  }
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const double begin = layout.ends[i], end = layout.ends[i + 1];
    const double middle = 0.5 * (begin + end);
    const std::size_t number = region_at(scene, middle, layout.ends);
    layout.segment_regions.push_back({number, number, number});
    if (number == 0 || !scene.regions[number - 1].to_section) continue;
    const Region& region = scene.regions[number - 1];
    const double from = fraction_of(region.from, layout.ends);
    const double extent = fraction_of(region.to, layout.ends) - from;
    const auto add_at = [&](double fraction) {
      return add(number, tapered_section(region, (fraction - from) / extent), region.material);
    };
    SegmentRegions& own = layout.segment_regions[i];
    // The joint between two segments of one taper has one section.
    const bool goes_on =
        i > 0 && layout.regions[layout.segment_regions[i - 1].outer].scene_region == number;
    own.inner = goes_on ? layout.segment_regions[i - 1].outer : add_at(begin);
    own.middle = add_at(middle);
    own.outer = add_at(end);
  }
}

}  // namespace

Layout make_layout(const Scene& scene, std::vector<double> ends,
                   std::optional<law::GaugePlane> yields) {
  Layout layout;
  layout.ends = std::move(ends);
  layout.end_rule = resolved_end_rule(scene);
  layout.has_corners = scene.beam.shape == BeamShape::Polyline;
  for (const double fraction : layout.ends) {
    const auto at = axis_point(scene.beam, fraction);
    layout.node.push_back({{at[0], at[1], at[2]}});
  }
  for (std::size_t i = 0; i + 1 < layout.ends.size(); ++i) {
    layout.segment_length.push_back((layout.ends[i + 1] - layout.ends[i]) * scene.beam.length);
  }
  place_frames(scene.beam, layout);
  set_joint_lengths(scene, layout);
  set_shift_lengths(scene, layout);
  set_bare_halves(scene, layout);
  set_regions(scene, yields, layout);
  return layout;
}

SegmentPoint segment_point(const Layout& layout, double fraction) {
  const auto after =
      std::lower_bound(layout.ends.begin() + 1, layout.ends.end() - 1, fraction - 1e-12);
  const auto segment = static_cast<std::size_t>(after - layout.ends.begin()) - 1;
  const double within =
      (fraction - layout.ends[segment]) / (layout.ends[segment + 1] - layout.ends[segment]);
  const Point chord = layout.node[segment + 1] - layout.node[segment];
  return {segment, within * transposed_times(layout.segment_frame[segment], chord)};
}

}  // namespace plastica::chain
