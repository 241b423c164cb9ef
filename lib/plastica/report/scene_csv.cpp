#include "plastica/report/scene_csv.hpp"

#include <ostream>

#include <fmt/format.h>

#include "plastica/base/check.hpp"

namespace plastica::report {
namespace {

std::string quoted_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += c;
  }
  return cell + '"';
}

}  // namespace

void write_probes_csv(std::ostream& out, const io::SceneRecord& record) {
  const Scene& scene = record.setup.scene;
  const bool coupon = record.level == Level::Coupon;
  out << (coupon ? "sample,drive [1]" : "sample,time [s],factor [1]");
  for (const Probe& probe : scene.probes) {
    out << ','
        << quoted_cell(fmt::format("{} [{}]", probe.name,
                                   unit_of(probe.quantity, scene.drive.deformation)));
  }
  out << '\n';
  const ChainHistory& chain = record.response.chain;
  for (std::size_t i = 0; i < record.response.samples; ++i) {
    out << (coupon ? fmt::format("{},{}", i, scene.drive.strain[i])
                   : fmt::format("{},{},{}", i, chain.time[i], chain.factor[i]));
    for (const auto& values : record.response.probes) out << fmt::format(",{}", values[i]);
    out << '\n';
  }
}

void write_joints_csv(std::ostream& out, const io::SceneRecord& record) {
  const ChainHistory& chain = record.response.chain;
  if (chain.joints == 0) {
    throw InputError({}, "--what", "joints", "is not of a coupon, which has none");
  }
  out << "joint,share of length [1],x [m],y [m],z [m],moment x [N m],moment y [N m],"
         "torque z [N m],shear x [N],shear y [N],axial z [N],angle x [rad],angle y [rad],"
         "angle z [rad],plastic angle x [rad],plastic angle y [rad],plastic angle z [rad],"
         "plastic strain [1],bending stress [Pa]\n";
  if (chain.time.empty()) return;
  for (std::size_t i = 0; i < chain.joints; ++i) {
    const std::size_t at = (chain.time.size() - 1) * chain.joints + i;
    out << fmt::format("{},{}", i, record.outline.ends[i]);
    for (const auto* values :
         {&chain.position, &chain.moment, &chain.force, &chain.angle, &chain.plastic_angle}) {
      for (std::size_t k = 0; k < 3; ++k) out << fmt::format(",{}", (*values)[3 * at + k]);
    }
    out << fmt::format(",{},{}\n", chain.plastic_strain[at], chain.stress[at]);
  }
}

}  // namespace plastica::report
