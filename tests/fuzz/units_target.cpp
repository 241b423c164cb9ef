#include <cmath>
#include <string>
#include <string_view>

#include "plastica/base/quantity.hpp"
#include "plastica/io/csv_text.hpp"
#include "plastica/io/units.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Quantities and units: "355 MPa", of each dimension, and as a column's header has them.
namespace plastica::fuzz {
namespace {

void read_units(Bytes bytes) {
  const std::string_view text = text_of(bytes);
  const SourceLocation where{"fuzzed.toml", 1};
  for (int i = 0; i <= static_cast<int>(kLastDimension); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    if (const auto value =
            result_or_refused([&] { return io::parse_quantity(text, dimension, where, "key"); })) {
      require(std::isfinite(*value), "a quantity that is not finite");
    }
    const auto conversion =
        result_or_refused([&] { return io::unit_conversion(text, dimension, where, "key"); });
    require(io::is_unit_of(text, dimension) == conversion.has_value(),
            "is_unit_of and unit_conversion differ");
    if (!conversion) continue;
    require(std::isfinite(conversion->scale) && conversion->scale != 0.0,
            "a unit without a finite scale");
    require(std::isfinite(conversion->offset), "a unit without a finite offset");
  }
  io::is_unit(text);
  io::csv_text::name_and_unit(text);
  io::csv_text::unit_cell(text);
}

const Registered kUnits{"units", read_units};

}  // namespace
}  // namespace plastica::fuzz
