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

constexpr int kDeflate = 1;
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

  bool write(StopFlag stop) {
    root_.set_attribute(".", "Version", std::vector<std::int64_t>{2, 0});
    root_.set_ascii_attribute(".", "Type", "PolyData");
    // One part, whose cells serve all steps.
    root_.write("NumberOfPoints", count(mesh_.points()));
    write_cells();
    write_steps();
    return write_points("Points", false, stop) &&
           write_points("PointData/displacement", true, stop) && write_fragments(stop) &&
           write_joints(stop);
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
    const Integers zeros(steps_);
    const Integers zeros_of_all(steps_ * kTopologies);
    steps.write("Values", times_of_steps(record_));
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

  bool write_points(const std::string& path, bool from_undeformed, StopFlag stop) {
    const std::vector<Point3> undeformed = mesh_.points_of(BeamPose(record_, kUndeformed));
    std::vector<float> values;
    values.reserve(3 * steps_ * mesh_.points());
    for (std::size_t f = 0; f < steps_; ++f) {
      if (is_raised(stop)) return false;
      const std::vector<Point3> now = mesh_.points_of(BeamPose(record_, f));
      for (std::size_t p = 0; p < now.size(); ++p) {
        add_point(from_undeformed ? sum(now[p], -1.0, undeformed[p]) : now[p], values);
      }
    }
    write_rows<float>(path, values, 3, "m");
    return true;
  }

  bool write_fragments(StopFlag stop) {
    root_.write("CellData/segment", mesh_.segment(), kPacked);
    root_.write("CellData/joint", mesh_.joint(), kPacked);
    std::vector<std::int32_t> fragments;
    fragments.reserve(steps_ * mesh_.cells());
    for (std::size_t f = 0; f < steps_; ++f) {
      if (is_raised(stop)) return false;
      const std::vector<std::int32_t> of_cells = mesh_.fragment_of(BeamPose(record_, f));
      fragments.insert(fragments.end(), of_cells.begin(), of_cells.end());
    }
    root_.write("CellData/fragment", fragments, kPacked);
    return true;
  }

  bool write_joints(StopFlag stop) {
    const ChainHistory& chain = record_.response.chain;
    for (const JointQuantity& quantity : kJointQuantities) {
      if (is_raised(stop)) return false;
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
    return true;
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

bool has_rising_times(const io::SceneRecord& record) {
  for (std::size_t f = 1; f < frames_of(record); ++f) {
    if (!(time_of_frame(record, f) > time_of_frame(record, f - 1))) return false;
  }
  return true;
}

std::vector<double> times_of_steps(const io::SceneRecord& record) {
  const bool rising = has_rising_times(record);
  std::vector<double> times;
  for (std::size_t f = 0; f < frames_of(record); ++f) {
    times.push_back(rising ? time_of_frame(record, f) : static_cast<double>(f));
  }
  return times;
}

bool write_vtkhdf(const std::string& path, const io::SceneRecord& record, io::Overwrite overwrite,
                  StopFlag stop) {
  if (record.outline.segments() == 0) {
    throw InputError({}, "", "", "a coupon has no beam to show");
  }
  if (frames_of(record) == 0) {
    throw InputError({}, "", "", "there is no frame: the run ended before the first");
  }
  io::Hdf5File file = io::Hdf5File::create(path, overwrite);
  if (!VtkhdfWriter(record, file.root().group(kVtkGroup)).write(stop)) return false;
  file.commit();
  return true;
}

}  // namespace plastica::report
