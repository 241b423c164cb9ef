#include "calibrate/config/read_target_options.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string_view>
#include <utility>

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

/// Of a proof stress: standards have 0.01 % to 1 %.
constexpr double kLargestOffset = 0.05;

/// A fraction for which low < fraction < high. @param value  0.1, or "10 %"
void read_fraction(const TomlTable& table, std::string_view key, double low, double high,
                   double& fraction) {
  const auto value = table.find(key);
  if (!value) return;
  fraction = value->quantity(Dimension::None);
  if (fraction <= low || fraction >= high) {
    throw value->error(fmt::format("must be above {:g} and below {:g}", low, high));
  }
}

void read_modulus(const TomlValue& value, TargetOptions& options) {
  options.youngs_modulus.reset();
  if (value.is_string() && value.string() == "regression") {
    options.modulus_method = ModulusMethod::Regression;
  } else if (value.is_string() && value.string() == "chord") {
    options.modulus_method = ModulusMethod::Chord;
  } else {
    if (!is_quantity(value)) {
      throw value.error("must be \"regression\", \"chord\" or a stress such as \"200 GPa\"");
    }
    options.youngs_modulus = value.quantity(Dimension::Stress);
    if (*options.youngs_modulus <= 0.0) throw value.error("must be above 0 Pa");
  }
}

/// Two stresses, or two fractions of the proof stress.
void read_window(const TomlValue& value, TargetOptions& options) {
  const auto ends = value.array();
  if (ends.size() != 2) throw value.error("must be two stresses or two fractions, [lower, upper]");
  const auto is_fraction = [](const TomlValue& end) {
    return end.is_number() || (end.is_string() && end.string().ends_with('%'));
  };
  const bool fractions = is_fraction(ends[0]);
  if (fractions != is_fraction(ends[1])) {
    throw value.error("must be two stresses or two fractions of the proof stress, not one of each");
  }
  const Dimension dimension = fractions ? Dimension::None : Dimension::Stress;
  const double low = ends[0].quantity(dimension);
  const double high = ends[1].quantity(dimension);
  if (low < 0.0 || low >= high) throw value.error("must rise, from 0 or more");
  if (fractions && high > 1.0) throw value.error("must not exceed 100 % of the proof stress");
  options.modulus_window.reset();
  if (fractions) {
    options.modulus_low = low;
    options.modulus_high = high;
  } else {
    options.modulus_window = std::pair(low, high);
  }
}

}  // namespace

bool is_quantity(const TomlValue& value) {
  if (!value.is_string()) return value.is_number();
  return std::string_view("+-.0123456789").find(value.string()[0]) != std::string_view::npos;
}

CorrectionChoice read_choice(const TomlValue& value, Dimension dimension) {
  using enum CorrectionChoice::Mode;
  if (value.is_string() && value.string() == "auto") return {Automatic, 0.0};
  if (value.is_string() && value.string() == "off") return {Off, 0.0};
  if (!is_quantity(value)) {
    throw value.error("must be \"auto\", \"off\" or a " + std::string(name_of(dimension)));
  }
  return {Set, value.quantity(dimension)};
}

void read_corrections(const TomlTable& table, TargetOptions& options) {
  if (const auto value = table.find("toe")) options.toe = read_choice(*value);
  if (const auto value = table.find("preload")) options.preload = read_choice(*value);
  if (const auto value = table.find("trim")) {
    options.trim = read_choice(*value);
    if (options.trim.mode == CorrectionChoice::Mode::Set && options.trim.amount <= 0.0) {
      throw value->error("must be above 0");
    }
  }
  if (const auto value = table.find("measure")) {
    static constexpr std::array<std::string_view, 3> kWords{"as-measured", "true", "true-forced"};
    const std::size_t word = value->word(kWords);
    options.convert_to_true = word > 0;
    options.force_true = word > 1;
    if (word > 0 && options.measure == Measure::True) {
      throw value->error("the columns are true strain and stress already");
    }
    if (word > 0 && options.test != Test::Tension) {
      throw value->error("goes with test = \"tension\" alone");
    }
  }
  if (const auto value = table.find("reversal_tolerance")) {
    options.reversal_tolerance = value->quantity(Dimension::Strain);
    if (options.reversal_tolerance < 0.0) throw value->error("must be at least 0");
  }
  constexpr double kNone = -std::numeric_limits<double>::min();
  read_fraction(table, "shift_threshold", kNone, 1.0, options.shift_threshold);
  read_fraction(table, "drop_fraction", 0.0, 1.0, options.drop_fraction);
  read_fraction(table, "zero_fraction", kNone, 1.0, options.zero_fraction);
  if (const auto value = table.find("end_fraction")) {
    options.end_fraction = value->quantity(Dimension::None);
    if (!(options.end_fraction > 0.0 && options.end_fraction <= 1.0)) {
      throw value->error("must be above 0 and at most 100 %");
    }
  }
}

void read_characteristics(const TomlTable& table, TargetOptions& options) {
  const auto modulus = table.find("modulus");
  const auto window = table.find("window");
  if (modulus) read_modulus(*modulus, options);
  if (window) read_window(*window, options);
  if (window && options.youngs_modulus) throw window->error("is of no use: the modulus is given");
  if (options.modulus_method == ModulusMethod::Chord && !options.youngs_modulus &&
      !options.modulus_window) {
    throw InputError(table.where(), table.key() + ".window", "",
                     "must be two stresses where the modulus is a chord");
  }
  if (const auto value = table.find("offset")) {
    options.offset = value->quantity(Dimension::Strain);
    if (options.offset <= 0.0 || options.offset > kLargestOffset) {
      throw value->error("must be above 0 % and at most 5 %: 0.2 % or 0.002, not 0.2");
    }
  }
  read_fraction(table, "yield_drop", 0.0, 1.0, options.yield_drop);
  if (const auto value = table.find("min_samples")) {
    options.min_samples = static_cast<std::size_t>(value->integer(2, 1'000'000));
  }
}

}  // namespace plastica::calibrate
