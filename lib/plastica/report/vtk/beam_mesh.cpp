#include "plastica/report/vtk/beam_mesh.hpp"

#include "plastica/chain/layout.hpp"
#include "plastica/model/beam_axis.hpp"

namespace plastica::report {
namespace {

/// Rings of a segment: at its inner end, its middle, its outer end.
constexpr std::size_t kRings = 3;

}  // namespace

BeamMesh::BeamMesh(const io::SceneRecord& record) {
  const chain::Layout layout = chain::make_layout(record.setup.scene, record.outline.ends);
  for (const chain::BeamRegion& region : layout.regions) {
    sections_.push_back(section_faces(region.section));
  }
  for (std::size_t s = 0; s < layout.size(); ++s) {
    section_of_.push_back(layout.segment_regions[s].middle);
    add_segment(s, sections_[section_of_.back()]);
  }
}

void BeamMesh::add_segment(std::size_t segment, const SectionFaces& faces) {
  const std::size_t ring = faces.corners.size();
  for (std::size_t half = 0; half < 2; ++half) {
    const std::size_t from = points_ + half * ring;
    const std::size_t to = from + ring;
    for (const auto& [a, b] : faces.edges) {
      add_cell({from + a, from + b, to + b, to + a}, segment, segment + half);
    }
  }
  const std::size_t outer = points_ + (kRings - 1) * ring;
  for (const auto& [a, b, c, d] : faces.faces) {
    add_cell({points_ + d, points_ + c, points_ + b, points_ + a}, segment, segment);
    add_cell({outer + a, outer + b, outer + c, outer + d}, segment, segment + 1);
  }
  points_ += kRings * ring;
}

void BeamMesh::add_cell(const std::array<std::size_t, 4>& corners, std::size_t segment,
                        std::size_t joint) {
  for (const std::size_t corner : corners) corners_.push_back(static_cast<std::int64_t>(corner));
  segment_.push_back(static_cast<std::int32_t>(segment));
  joint_.push_back(static_cast<std::int32_t>(joint));
}

std::vector<Point3> BeamMesh::points_of(const BeamPose& pose) const {
  std::vector<Point3> points;
  points.reserve(points_);
  for (std::size_t s = 0; s < pose.segments(); ++s) {
    sweep(s, pose.inner(s), pose.outer(s), pose.section_axis(s, 0), pose.section_axis(s, 1),
          points);
  }
  return points;
}

std::vector<Point3> BeamMesh::velocities_of(const BeamPose& pose) const {
  std::vector<Point3> velocities;
  velocities.reserve(points_);
  for (std::size_t s = 0; s < pose.segments(); ++s) {
    const Point3 spin = pose.spin(s);
    sweep(s, pose.inner_velocity(s), pose.outer_velocity(s), cross(spin, pose.section_axis(s, 0)),
          cross(spin, pose.section_axis(s, 1)), velocities);
  }
  return velocities;
}

void BeamMesh::sweep(std::size_t segment, const Point3& from, const Point3& to, const Point3& x,
                     const Point3& y, std::vector<Point3>& points) const {
  const Point3 middle = sum(sum({}, 0.5, from), 0.5, to);
  for (const Point3& at : {from, middle, to}) {
    for (const Point2& corner : sections_[section_of_[segment]].corners) {
      points.push_back(sum(sum(at, corner[0], x), corner[1], y));
    }
  }
}

std::vector<std::int32_t> BeamMesh::fragment_of(const BeamPose& pose) const {
  std::vector<std::int32_t> of_segment(pose.segments());
  std::int32_t number = 0;
  for (const Fragment& fragment : pose.fragments()) {
    for (int s = fragment.first; s <= fragment.last; ++s) {
      of_segment[static_cast<std::size_t>(s)] = number;
    }
    ++number;
  }
  std::vector<std::int32_t> of_cell;
  of_cell.reserve(cells());
  for (const std::int32_t s : segment_) of_cell.push_back(of_segment[static_cast<std::size_t>(s)]);
  return of_cell;
}

}  // namespace plastica::report
