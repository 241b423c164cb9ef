#include "plastica/io/read_place.hpp"

#include <array>
#include <filesystem>
#include <limits>
#include <utility>

#include "plastica/io/csv_column.hpp"
#include "plastica/io/read_fields.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io {
namespace {

History cycles(std::int64_t count) {
  std::vector<double> turns;
  for (std::int64_t i = 0; i < count; ++i) turns.insert(turns.end(), {1.0, -1.0});
  turns.push_back(0.0);
  return History::turning_points(turns);
}

/// { period, cycles, phase, offset }
History sine(const TomlTable& table) {
  const TomlValue period = table.at("period");
  const TomlValue cycles = table.at("cycles");
  const auto phase = table.find("phase");
  const auto offset = table.find("offset");
  const double seconds = period.quantity(Dimension::Time);
  if (!(seconds > 0.0)) throw period.error("must be above 0 s");
  const double count = cycles.quantity(Dimension::None);
  if (!(count > 0.0 && count <= 100'000.0)) throw cycles.error("must be above 0, at most 100000");
  return History::sine(seconds, count, phase ? phase->quantity(Dimension::Angle) : 0.0,
                       offset ? offset->quantity(Dimension::None) : 0.0);
}

History smooth_step(const TomlValue& list) {
  const std::vector<double> times = read_quantities(list, Dimension::Time);
  if (times.size() != 2 || times[0] < 0.0 || !(times[0] < times[1])) {
    throw list.error(
        "must be two times, from and to, the first not before 0 and the second after it");
  }
  return History::smooth_step(times[0], times[1]);
}

/// Rows, with straight lines or a spline between them.
History through(std::vector<double> time, std::vector<double> factor, const TomlTable& table) {
  static constexpr std::array<std::string_view, 2> kWords{"linear", "cubic"};
  const auto word = table.find("interpolation");
  if (!word || word->word(kWords) == 0) return {std::move(time), std::move(factor)};
  // What is not a table is refused where the scene is checked.
  for (std::size_t row = 1; row < time.size(); ++row) {
    if (!(time[row] > time[row - 1])) return {std::move(time), std::move(factor)};
  }
  if (time.size() != factor.size()) return {std::move(time), std::move(factor)};
  if (time.size() < 2) throw word->error("needs two rows at least");
  return History::spline(std::move(time), std::move(factor));
}

/// Columns of a CSV file beside the scene's.
History tabled(const TomlTable& table, const TomlValue& name) {
  const std::string& file = name.where().file;
  const auto path = std::filesystem::path(file).parent_path() / name.string();
  if (!is_file(path)) {
    throw name.error("is not a file in the folder of " + file + why_no_file(path));
  }
  const CsvTable csv = CsvTable::read(path.string());
  std::size_t time_index = 0;
  const auto column = [&](std::string_view key, Dimension dimension) {
    const TomlValue words = table.at(key);
    NamedColumn source;
    source.name = words.is_string() ? words.string() : std::to_string(words.integer(1, 1'000'000));
    source.where = words.where();
    source.key = words.key();
    if (const auto unit = table.find(std::string(key) + "_unit")) {
      source.unit = unit->string();
      source.where = unit->where();
    }
    source.override_unit = table.is_set("override_unit");
    const std::size_t index = csv.find(source.name, source.where, source.key);
    if (dimension == Dimension::Time) time_index = index;
    if (dimension == Dimension::Time && !source.unit && csv.units()[index].empty()) {
      throw words.error("has no unit in the header of " + path.string() +
                        ": say time_unit = \"s\"");
    }
    return read_column(csv, source, dimension);
  };
  const std::vector<double> time = column("time", Dimension::Time);
  const std::string& header = csv.names()[time_index];
  for (std::size_t row = 1; row < time.size(); ++row) {
    if (time[row] > time[row - 1]) continue;
    throw InputError({csv.file(), csv.line_of_row(row)}, header,
                     std::string(csv.cell(row, time_index)), "must rise from one to the next");
  }
  return through(time, column("factor", Dimension::None), table);
}

}  // namespace

Place read_place(const TomlValue& value) {
  if (value.is_integer() && value.number() > 0.0) {
    throw value.error("is neither a segment nor a fraction: write { segment = " + value.written() +
                      " } for the outer end of that segment, or a fraction of the length with a "
                      "point, 0.25 (the end is 1.0 or \"end\")");
  }
  if (value.is_number()) return {value.number(), {}};
  if (value.is_table()) {
    const TomlValue segment = value.table().at("segment");
    return {0.0, static_cast<int>(segment.integer(0, std::numeric_limits<int>::max()))};
  }
  if (!value.is_string() || (value.string() != "start" && value.string() != "end" &&
                             value.string().find('%') == std::string::npos)) {
    throw value.error(
        "must be \"start\", \"end\", { segment = 3 } (its outer end), or a fraction of the length: "
        "0.25, \"25 %\"");
  }
  if (value.string() == "start") return Place::start();
  if (value.string() == "end") return Place::end();
  return {value.quantity(Dimension::None), {}};
}

History read_history(const TomlValue& value) {
  constexpr std::string_view kRule =
      "must be \"ramp\", \"constant\", { cycles }, { turning_points }, { time, factor }, "
      "{ smooth_step }, { period, cycles } or { table, time, factor }";
  if (value.is_string()) {
    if (value.string() == "ramp") return History::ramp();
    if (value.string() == "constant") return History::constant();
  }
  if (!value.is_table()) throw value.error(kRule);
  const TomlTable table = value.table();
  if (table.contains("frequency")) {
    throw table.at("frequency").error("is not known: a sine is { period = \"0.5 s\", cycles }");
  }
  if (table.contains("period")) return sine(table);
  if (const auto name = table.find("table")) return tabled(table, *name);
  const auto count = table.find("cycles");
  const auto turns = table.find("turning_points");
  const auto step = table.find("smooth_step");
  const auto time = table.find("time");
  const auto factor = table.find("factor");
  if ((count ? 1 : 0) + (turns ? 1 : 0) + (step ? 1 : 0) + (time || factor ? 1 : 0) != 1) {
    table.check_unused();
    throw value.error(kRule);
  }
  if (count) return cycles(count->integer(1, 100'000));
  if (turns) return History::turning_points(read_quantities(*turns, Dimension::None));
  if (step) return smooth_step(*step);
  return through(read_quantities(table.at("time"), Dimension::Time),
                 read_quantities(table.at("factor"), Dimension::None), table);
}

}  // namespace plastica::io
