#include "plastica/report/vtk/vtkhdf_file.hpp"

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/vtk/beam_fields.hpp"
#include "plastica/report/vtk/beam_mesh.hpp"

namespace plastica::report {
namespace {

constexpr int kDeflate = 4;
constexpr io::DatasetOptions kPacked{.units = {}, .deflate = kDeflate};

using Integers = std::vector<std::int64_t>;

void add_point(const Point3& point, std::vector<float>& values) {
  for (const double x : point) values.push_back(static_cast<float>(x));
}

/// 0, n, 2n, … for each step.
Integers offsets_of(std::size_t steps, std::size_t each) {
  Integers offsets;
  for (std::size_t s = 0; s < steps; ++s) offsets.push_back(static_cast<std::int64_t>(s * each));
  return offsets;
}

class VtkhdfWriter {
 public:
  VtkhdfWriter(const io::SceneRecord& record, io::Hdf5Group root)
      : record_(record), mesh_(record), steps_(frames_of(record)), root_(std::move(root)) {}

  void write() {
    root_.set_attribute(".", "Version", std::vector<std::int64_t>{2, 0});
    root_.set_ascii_attribute(".", "Type", "PolyData");
    // One part, whose cells serve all steps.
    root_.write("NumberOfPoints", count(mesh_.points()));
    write_cells();
    write_steps();
    write_poses();
    write_joints();
  }

 private:
  static Integers count(std::size_t n) { return {static_cast<std::int64_t>(n)}; }

  void write_cells() {
    for (const char* none : {"Vertices", "Lines", "Strips"}) write_topology(none, {}, {0});
    Integers begins;
    for (std::size_t c = 0; c <= mesh_.cells(); ++c) {
      begins.push_back(static_cast<std::int64_t>(4 * c));
    }
    write_topology("Polygons", mesh_.corners(), begins);
  }

  void write_topology(const std::string& name, const Integers& corners, const Integers& begins) {
    root_.write(name + "/NumberOfCells", count(begins.size() - 1));
    root_.write(name + "/NumberOfConnectivityIds", count(corners.size()));
    root_.write(name + "/Connectivity", corners, kPacked);
    root_.write(name + "/Offsets", begins, kPacked);
  }

  void write_steps() {
    constexpr std::size_t kTopologies = 4;
    io::Hdf5Group steps = root_.group("Steps");
    steps.set_attribute(".", "NSteps", static_cast<std::int64_t>(steps_));
    std::vector<double> times;
    for (std::size_t f = 0; f < steps_; ++f) times.push_back(time_of_frame(record_, f));
    const Integers zeros(steps_);
    const Integers zeros_of_all(steps_ * kTopologies);
    steps.write("Values", times, {.units = "s"});
    steps.write("PartOffsets", zeros);
    steps.write("NumberOfParts", Integers(steps_, 1));
    steps.write("PointOffsets", offsets_of(steps_, mesh_.points()));
    for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) {
      steps.write_table<std::int64_t>(name, zeros_of_all, kTopologies);
    }
    steps.write("PointDataOffsets/displacement", offsets_of(steps_, mesh_.points()));
    for (const char* name : {"segment", "joint"}) {
      steps.write(std::string("CellDataOffsets/") + name, zeros);
    }
    const auto changing = [&](std::string_view name) {
      steps.write("CellDataOffsets/" + std::string(name), offsets_of(steps_, mesh_.cells()));
    };
    changing("fragment");
    for (const JointQuantity& quantity : kJointQuantities) changing(quantity.name);
  }

  void write_poses() {
    std::vector<float> points;
    std::vector<float> displacements;
    std::vector<std::int32_t> fragments;
    points.reserve(3 * steps_ * mesh_.points());
    displacements.reserve(points.capacity());
    fragments.reserve(steps_ * mesh_.cells());
    const std::vector<Point3> undeformed = mesh_.points_of(BeamPose(record_, kUndeformed));
    for (std::size_t f = 0; f < steps_; ++f) {
      const BeamPose pose(record_, f);
      const std::vector<Point3> now = mesh_.points_of(pose);
      for (std::size_t p = 0; p < now.size(); ++p) {
        add_point(now[p], points);
        add_point(sum(now[p], -1.0, undeformed[p]), displacements);
      }
      const std::vector<std::int32_t> of_cells = mesh_.fragment_of(pose);
      fragments.insert(fragments.end(), of_cells.begin(), of_cells.end());
    }
    write_rows<float>("Points", points, 3, "m");
    write_rows<float>("PointData/displacement", displacements, 3, "m");
    root_.write("CellData/segment", mesh_.segment(), kPacked);
    root_.write("CellData/joint", mesh_.joint(), kPacked);
    root_.write("CellData/fragment", fragments, kPacked);
  }

  void write_joints() {
    const ChainHistory& chain = record_.response.chain;
    for (const JointQuantity& quantity : kJointQuantities) {
      const std::size_t n = quantity.components;
      const std::vector<double>& of_joints = quantity.values(chain);
      std::vector<float> values;
      values.reserve(steps_ * mesh_.cells() * n);
      for (std::size_t f = 0; f < steps_; ++f) {
        for (const std::int32_t joint : mesh_.joint()) {
          const std::size_t first = (f * chain.joints + static_cast<std::size_t>(joint)) * n;
          for (std::size_t k = 0; k < n; ++k) {
            values.push_back(static_cast<float>(of_joints[first + k]));
          }
        }
      }
      write_rows<float>("CellData/" + std::string(quantity.name), values, n, quantity.unit);
    }
  }

  /// One number in a row is a list.
  template <typename T>
  void write_rows(const std::string& path, std::span<const T> values, std::size_t components,
                  std::string_view unit) {
    const io::DatasetOptions options{.units = unit, .deflate = kDeflate};
    if (components == 1) {
      root_.write(path, values, options);
    } else {
      root_.write_table(path, values, components, options);
    }
  }

  const io::SceneRecord& record_;
  BeamMesh mesh_;
  std::size_t steps_;
  io::Hdf5Group root_;
};

}  // namespace

void write_vtkhdf(const std::string& path, const io::SceneRecord& record, io::Overwrite overwrite) {
  io::Hdf5File file = io::Hdf5File::create(path, overwrite);
  VtkhdfWriter(record, file.root().group(kVtkGroup)).write();
  file.commit();
}

}  // namespace plastica::report
