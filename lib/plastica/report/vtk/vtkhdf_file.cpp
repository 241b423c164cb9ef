#include "plastica/report/vtk/vtkhdf_file.hpp"

#include <optional>
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

std::vector<float> in_float(const std::vector<Point3>& points) {
  std::vector<float> values;
  values.reserve(3 * points.size());
  for (const Point3& point : points) {
    for (const double x : point) values.push_back(static_cast<float>(x));
  }
  return values;
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

  bool write(const FrameHooks& hooks) {
    root_.set_attribute(".", "Version", std::vector<std::int64_t>{2, 0});
    root_.set_ascii_attribute(".", "Type", "PolyData");
    // One part, whose cells serve all steps.
    root_.write("NumberOfPoints", count(mesh_.points()));
    write_cells();
    write_steps();
    root_.write("CellData/segment", mesh_.segment(), kPacked);
    root_.write("CellData/joint", mesh_.joint(), kPacked);
    return write_frames(hooks);
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
    if (has_velocities(record_)) {
      steps.write("PointDataOffsets/velocity", offsets_of(steps_, mesh_.points()));
    }
    for (const char* name : {"segment", "joint"}) {
      steps.write(std::string("CellDataOffsets/") + name, zeros);
    }
    const auto changing = [&](std::string_view name) {
      steps.write("CellDataOffsets/" + std::string(name), offsets_of(steps_, mesh_.cells()));
    };
    changing("fragment");
    for (const JointQuantity& quantity : kJointQuantities) changing(quantity.name);
  }

  /// All that changes from step to step, a frame at a time.
  bool write_frames(const FrameHooks& hooks) {
    const std::vector<Point3> undeformed = mesh_.points_of(BeamPose(record_, kUndeformed));
    io::Hdf5Column points = column<float>("Points", mesh_.points(), 3, "m");
    io::Hdf5Column displacement = column<float>("PointData/displacement", mesh_.points(), 3, "m");
    std::optional<io::Hdf5Column> velocity;
    if (has_velocities(record_)) {
      velocity.emplace(column<float>("PointData/velocity", mesh_.points(), 3, "m/s"));
    }
    io::Hdf5Column fragment = column<std::int32_t>("CellData/fragment", mesh_.cells(), 1, "");
    std::vector<io::Hdf5Column> of_joints;
    of_joints.reserve(kJointQuantities.size());
    for (const JointQuantity& quantity : kJointQuantities) {
      of_joints.push_back(column<float>("CellData/" + std::string(quantity.name), mesh_.cells(),
                                        quantity.components, quantity.unit));
    }
    for (std::size_t f = 0; f < steps_; ++f) {
      if (is_raised(hooks.stop)) return false;
      const BeamPose pose(record_, f);
      std::vector<Point3> now = mesh_.points_of(pose);
      points.append(in_float(now));
      for (std::size_t i = 0; i < now.size(); ++i) now[i] = sum(now[i], -1.0, undeformed[i]);
      displacement.append(in_float(now));
      if (velocity) velocity->append(in_float(mesh_.velocities_of(pose)));
      fragment.append(mesh_.fragment_of(pose));
      for (std::size_t k = 0; k < of_joints.size(); ++k) {
        of_joints[k].append(of_cells(kJointQuantities[k], f));
      }
      if (hooks.on_frame) hooks.on_frame(f + 1);
    }
    for (io::Hdf5Column* one : {&points, &displacement, &fragment}) one->finish();
    if (velocity) velocity->finish();
    for (io::Hdf5Column& one : of_joints) one.finish();
    return true;
  }

  /// Begins a dataset of all steps. @param components  1: a list; else a table
  template <typename T>
  io::Hdf5Column column(const std::string& path, std::size_t rows_of_step, std::size_t components,
                        std::string_view unit) {
    std::vector<std::size_t> shape{steps_ * rows_of_step};
    if (components > 1) shape.push_back(components);
    return root_.column<T>(path, shape, {.units = unit, .deflate = kDeflate});
  }

  /// A quantity of joints, for each cell that of its joint.
  std::vector<float> of_cells(const JointQuantity& quantity, std::size_t frame) const {
    const ChainHistory& chain = record_.response.chain;
    const std::vector<double>& of_joints = quantity.values(chain);
    const std::size_t n = quantity.components;
    std::vector<float> values;
    values.reserve(mesh_.cells() * n);
    for (const std::int32_t joint : mesh_.joint()) {
      const std::size_t first = (frame * chain.joints + static_cast<std::size_t>(joint)) * n;
      for (std::size_t k = 0; k < n; ++k) {
        values.push_back(static_cast<float>(of_joints[first + k]));
      }
    }
    return values;
  }

  const io::SceneRecord& record_;
  BeamMesh mesh_;
  std::size_t steps_;
  io::Hdf5Group root_;
};

void check_has_surface(const io::SceneRecord& record) {
  if (record.outline.segments() == 0) {
    throw InputError({}, "", "", "a coupon has no beam to show");
  }
  if (frames_of(record) == 0) {
    throw InputError({}, "", "", "there is no frame: the run ended before the first");
  }
}

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

bool write_vtkhdf(io::Hdf5Group& root, const io::SceneRecord& record, const FrameHooks& hooks) {
  check_has_surface(record);
  return VtkhdfWriter(record, root.group(io::kVtkGroup)).write(hooks);
}

bool write_vtkhdf(const std::string& path, const io::SceneRecord& record, io::Overwrite overwrite,
                  const FrameHooks& hooks) {
  check_has_surface(record);
  constexpr int kThreadsOfMachine = 0;
  io::Hdf5File file = io::Hdf5File::create(path, overwrite, kThreadsOfMachine);
  if (!write_vtkhdf(file.root(), record, hooks)) return false;
  file.commit();
  return true;
}

}  // namespace plastica::report
