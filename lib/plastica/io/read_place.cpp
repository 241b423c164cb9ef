#include "plastica/io/read_place.hpp"

#include <limits>

#include "plastica/io/read_fields.hpp"

namespace plastica::io {
namespace {

History cycles(std::int64_t count) {
  std::vector<double> turns;
  for (std::int64_t i = 0; i < count; ++i) turns.insert(turns.end(), {1.0, -1.0});
  turns.push_back(0.0);
  return History::turning_points(turns);
}

}  // namespace

Place read_place(const TomlValue& value) {
  if (value.is_whole() && value.number() > 0.0) {
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
      "must be \"ramp\", \"constant\", { cycles }, { turning_points } or { time, factor }";
  if (value.is_string()) {
    if (value.string() == "ramp") return History::ramp();
    if (value.string() == "constant") return History::constant();
  }
  if (!value.is_table()) throw value.error(kRule);
  const TomlTable table = value.table();
  const auto count = table.find("cycles");
  const auto turns = table.find("turning_points");
  const auto time = table.find("time");
  const auto factor = table.find("factor");
  if ((count ? 1 : 0) + (turns ? 1 : 0) + (time || factor ? 1 : 0) != 1) {
    table.check_unused();
    throw value.error(kRule);
  }
  if (count) return cycles(count->integer(1, 100'000));
  if (turns) return History::turning_points(read_quantities(*turns, Dimension::None));
  return {read_quantities(table.at("time"), Dimension::Time),
          read_quantities(table.at("factor"), Dimension::None)};
}

}  // namespace plastica::io
