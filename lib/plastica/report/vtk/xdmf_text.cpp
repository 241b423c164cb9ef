#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/report/scene_frames.hpp"
#include "plastica/report/vtk/beam_fields.hpp"
#include "plastica/report/vtk/beam_mesh.hpp"
#include "plastica/report/vtk/vtkhdf_file.hpp"
#include "plastica/report/xml_text.hpp"

namespace plastica::report {
namespace {

class XdmfWriter {
 public:
  XdmfWriter(const io::SceneRecord& record, const std::string& heavy)
      : mesh_(record),
        steps_(frames_of(record)),
        times_(times_of_steps(record)),
        group_(xml_text(heavy) + ":/" + std::string(io::kVtkGroup) + "/"),
        moves_(has_velocities(record)) {}

  std::string text() {
    out_ =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
        "<Grid Name=\"beam\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t f = 0; f < steps_; ++f) add_step(f);
    out_ += "</Grid>\n</Domain>\n</Xdmf>\n";
    return std::move(out_);
  }

 private:
  void add_step(std::size_t step) {
    out_ += fmt::format("<Grid Name=\"beam\" GridType=\"Uniform\">\n<Time Value=\"{:.17g}\"/>\n",
                        times_[step]);
    out_ += fmt::format(
        "<Topology TopologyType=\"Quadrilateral\" NumberOfElements=\"{0}\">\n"
        "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"8\" Dimensions=\"{1}\">"
        "{2}Polygons/Connectivity</DataItem>\n</Topology>\n<Geometry GeometryType=\"XYZ\">\n",
        mesh_.cells(), 4 * mesh_.cells(), group_);
    add_rows("Points", "Float", mesh_.points(), 3, step);
    out_ += "</Geometry>\n";
    add_attribute("displacement", "Node", "PointData/displacement", "Float", mesh_.points(), 3,
                  step);
    if (moves_) {
      add_attribute("velocity", "Node", "PointData/velocity", "Float", mesh_.points(), 3, step);
    }
    for (const char* name : {"segment", "joint"}) {
      out_ += attribute(name, "Cell", 1);
      out_ += fmt::format(
          "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{}\">"
          "{}CellData/{}</DataItem>\n</Attribute>\n",
          mesh_.cells(), group_, name);
    }
    add_attribute("fragment", "Cell", "CellData/fragment", "Int", mesh_.cells(), 1, step);
    for (const JointQuantity& quantity : kJointQuantities) {
      const std::string name(quantity.name);
      add_attribute(name, "Cell", "CellData/" + name, "Float", mesh_.cells(), quantity.components,
                    step);
    }
    out_ += "</Grid>\n";
  }

  static std::string attribute(std::string_view name, std::string_view center,
                               std::size_t components) {
    return fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n", name,
                       components == 3 ? "Vector" : "Scalar", center);
  }

  void add_attribute(std::string_view name, std::string_view center, std::string_view path,
                     std::string_view type, std::size_t rows, std::size_t components,
                     std::size_t step) {
    out_ += attribute(name, center, components);
    add_rows(path, type, rows, components, step);
    out_ += "</Attribute>\n";
  }

  /// The rows of one step of a dataset that has those of all: "first:stride:count:shape of all", as
  /// the library of XDMF 3 has it.
  void add_rows(std::string_view path, std::string_view type, std::size_t rows,
                std::size_t components, std::size_t step) {
    const bool table = components > 1;
    const auto shape = [&](std::size_t of) {
      return table ? fmt::format("{} {}", of, components) : fmt::format("{}", of);
    };
    out_ += fmt::format(
        "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"4\" "
        "Dimensions=\"{}\">{}{}|{}:{}:{}:{}"
        "</DataItem>\n",
        type, shape(rows), group_, path, fmt::format("{}{}", step * rows, table ? " 0" : ""),
        table ? "1 1" : "1", shape(rows), shape(steps_ * rows));
  }

  BeamMesh mesh_;
  std::size_t steps_;
  std::vector<double> times_;
  std::string group_;
  bool moves_;
  std::string out_;
};

}  // namespace

std::string xdmf_text(const io::SceneRecord& record, const std::string& heavy) {
  return XdmfWriter(record, heavy).text();
}

}  // namespace plastica::report
