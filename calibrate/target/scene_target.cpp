#include "calibrate/target/scene_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "calibrate/target/scene_break.hpp"
#include "calibrate/trial/scene_drive.hpp"
#include "calibrate/trial/scene_model.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

struct Column {
  std::size_t index = 0;
  io::UnitConversion convert;
};

Column find_column(const io::CsvTable& table, const ColumnSource& source,
                   const SourceLocation& unit_where, Dimension dimension, std::string_view field) {
  Column column;
  column.index = table.find(source.column, source.where, field);
  const std::string unit = source.unit.value_or(table.units()[column.index]);
  const SourceLocation where = source.unit ? unit_where : SourceLocation{table.file(), 0};
  column.convert = io::unit_conversion(unit, dimension, where, source.column);
  return column;
}

}  // namespace

SceneTarget read_scene_target(const SceneTargetSource& source, const Scene& scene,
                              SceneTarget probes) {
  SceneTarget target = std::move(probes);
  const io::CsvTable table = io::CsvTable::read(source.file, source.csv);
  if (target.name.empty()) target.name = std::filesystem::path(source.file).stem().string();
  const Probe& probe = scene.probes[probe_index(scene, target.ordinate_probe, "ordinate.probe",
                                                target.ordinate_where)];
  target.abscissa_is = abscissa_dimension(scene, target, target.abscissa_where);
  target.ordinate_is = dimension_of(probe.quantity, scene.drive.deformation);
  const Column x =
      find_column(table, source.abscissa, source.abscissa_unit, target.abscissa_is, "abscissa");
  const Column y =
      find_column(table, source.ordinate, source.ordinate_unit, target.ordinate_is, "ordinate");
  target.abscissa.clear();
  target.ordinate.clear();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const SourceLocation where{table.file(), table.line_of_row(row)};
    const auto number = [&](const Column& column) {
      const double value = table.number(row, column.index);
      if (!std::isfinite(value)) {
        throw InputError(where, table.names()[column.index], table.cell(row, column.index),
                         "must be a number in every row of a measured beam");
      }
      return column.convert(value);
    };
    const double at = number(x);
    if (!is_driven(target.kind) && !target.abscissa.empty() && at < target.abscissa.back()) {
      throw InputError(
          where, table.names()[x.index], table.cell(row, x.index),
          "goes back: a beam's curve is followed one way; a scene that this column drives "
          "follows it to and fro");
    }
    target.abscissa.push_back(at);
    target.ordinate.push_back(number(y));
  }
  cut_at_break(target, source.trim);
  return target;
}

}  // namespace plastica::calibrate
