#include "plastica/report/scene_mode_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <span>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/table.hpp"

namespace plastica::report {
namespace {

/// Segments that will have turned by more have another shape [rad].
constexpr double kLargeRotation = 0.1;

/// Where a mode goes most: the joint, as a fraction of the length, and the axis.
struct Largest {
  double at = 0.0;
  std::size_t axis = 0;
  bool moves = false;  ///< else sections turn about the beam alone
};

Largest largest_of_mode(const io::SceneRecord& record, std::span<const double> all,
                        std::size_t mode) {
  const auto& ends = record.outline.ends;
  Largest most;
  double largest = 0.0;
  for (std::size_t joint = 0; joint < ends.size(); ++joint) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size = std::fabs(all[(mode * ends.size() + joint) * 3 + axis]);
      // Of alike ones the first, whatever rounding says.
      if (size <= largest * (1.0 + 1e-6)) continue;
      largest = size;
      most = {ends[joint], axis, true};
    }
  }
  return most;
}

void add_row(const io::SceneRecord& record, std::span<const double> modes, std::size_t mode,
             std::string value, Table& table) {
  const Largest most = largest_of_mode(record, modes, mode);
  table.add({std::to_string(mode + 1), std::move(value),
             most.moves ? std::string(1, "xyz"[most.axis]) : "twist",
             most.moves ? place_label(most.at) : ""});
}

Table table_of(std::string value, std::string unit) {
  return Table({{"mode", Table::Align::Right},
                {std::move(value), Table::Align::Right, std::move(unit)},
                {"goes along", Table::Align::Left},
                {"most at", Table::Align::Right, "of length"}});
}

}  // namespace

std::string buckling_text(const io::SceneRecord& record, const Ink& ink) {
  const auto asked = static_cast<std::size_t>(record.setup.solver.buckling);
  if (asked == 0) return {};
  const Response& response = record.response;
  std::string text = '\n' + ink.heading("Buckling");
  if (!response.buckling) {
    return text +
           "\n  none is reported: nothing acts, no equilibrium on the path is stable and has not "
           "yielded,\n  or the tangent there is not symmetric\n";
  }
  const BucklingModes& modes = *response.buckling;
  text += fmt::format(" about factor {:.5g}, elastic, all forces growing on at its shape\n",
                      modes.about);
  Table table = table_of("factor", "1");
  bool rotates = false;
  for (std::size_t k = 0; k < modes.factor.size(); ++k) {
    add_row(record, modes.mode, k, fmt::format("{:.6g}", modes.factor[k]), table);
    rotates = rotates || modes.rotation[k] > kLargeRotation;
  }
  if (!modes.factor.empty()) text += table.text(2, kWidth);
  if (modes.factor.size() < asked) {
    text +=
        fmt::format("  no{} below 1e15 times the load\n", modes.factor.empty() ? "ne" : " more");
  }
  if (rotates) {
    text +=
        wrapped("  ",
                fmt::format("up to the last of them segments will have turned by {:.2g} rad, as "
                            "they begin to here: the shape there is another, and so may be the "
                            "factors; nearer to them they are surer",
                            modes.rotation.back()),
                kWidth);
  }
  return text;
}

std::string vibration_text(const io::SceneRecord& record, const Ink& ink) {
  if (record.setup.solver.frequencies == 0) return {};
  std::string text = '\n' + ink.heading("Natural frequencies about the loaded state");
  if (!record.response.vibration)
    return text + "\n  none is reported: the path ended before, or the tangent is not symmetric\n";
  text += record.level == Level::Planar ? ", in its plane\n" : "\n";
  const VibrationModes& modes = *record.response.vibration;
  Table table = table_of("frequency", "Hz");
  for (std::size_t k = 0; k < modes.frequency.size(); ++k) {
    add_row(record, modes.mode, k, fmt::format("{:.6g}", modes.frequency[k]), table);
  }
  return text + table.text(2, kWidth);
}

}  // namespace plastica::report
