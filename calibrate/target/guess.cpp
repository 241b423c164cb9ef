#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "calibrate/target/import.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

bool fits(const std::string& unit, Dimension dimension) {
  try {
    io::unit_conversion(unit, dimension);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Unit at the end of a name: "Stress_MPa", "elongation_mm"; empty if that is none.
std::string unit_in_name(const std::string& name, Dimension dimension) {
  const std::size_t cut = name.find_last_of("_ ");
  if (cut == std::string::npos) return {};
  std::string unit = name.substr(cut + 1);
  if (unit == "percent" || unit == "pct") unit = "%";
  const bool number = !unit.empty() && std::isdigit(static_cast<unsigned char>(unit[0]));
  return !unit.empty() && !number && fits(unit, dimension) ? unit : std::string();
}

/// Words that tell what a column is: within its name, or all of it for short ones.
struct Words {
  std::span<const std::string_view> within;
  std::span<const std::string_view> whole;
};

constexpr std::array<std::string_view, 2> kStrainWithin{"strain", "dehnung"};
constexpr std::array<std::string_view, 4> kStrainWhole{"e", "eps", "epsilon", "e_true"};
constexpr std::array<std::string_view, 3> kStressWithin{"stress", "spannung", "sigma"};
constexpr std::array<std::string_view, 2> kStressWhole{"s", "sig"};
constexpr std::array<std::string_view, 4> kElongationWithin{"elongation", "extension",
                                                            "extensometer", "verlängerung"};
constexpr std::array<std::string_view, 1> kElongationWhole{"dl"};
constexpr std::array<std::string_view, 3> kForceWithin{"force", "load", "kraft"};
constexpr std::array<std::string_view, 1> kForceWhole{"f"};

std::optional<ColumnSource> guess(const io::CsvTable& table, const Words& words,
                                  Dimension dimension) {
  for (std::size_t i = 0; i < table.columns(); ++i) {
    const std::string name = lower(table.names()[i]);
    const bool rate = name.find("rate") != std::string::npos;
    const bool hit = std::any_of(words.within.begin(), words.within.end(),
                                 [&](auto word) { return name.find(word) != std::string::npos; }) ||
                     std::find(words.whole.begin(), words.whole.end(), name) != words.whole.end();
    if (!hit || rate) continue;
    ColumnSource source{table.names()[i], std::nullopt, {}};
    if (!table.units()[i].empty()) {
      if (!fits(table.units()[i], dimension)) continue;
      source.unit = table.units()[i];
    } else if (const std::string unit = unit_in_name(table.names()[i], dimension); !unit.empty()) {
      source.unit = unit;
    }
    return source;
  }
  return std::nullopt;
}

}  // namespace

TargetSource guess_source(const io::CsvTable& table) {
  TargetSource source;
  source.files = {table.file()};
  source.strain = guess(table, {kStrainWithin, kStrainWhole}, Dimension::Strain);
  // An elongation in % is a strain already.
  const Words elongation{kElongationWithin, kElongationWhole};
  if (!source.strain) {
    auto length = guess(table, elongation, Dimension::Length);
    if (length && length->unit) {
      source.elongation = std::move(length);
    } else if (auto fraction = guess(table, elongation, Dimension::Strain);
               fraction && fraction->unit) {
      source.strain = std::move(fraction);
    } else {
      source.elongation = std::move(length);
    }
  }
  source.stress = guess(table, {kStressWithin, kStressWhole}, Dimension::Stress);
  if (!source.stress) source.force = guess(table, {kForceWithin, kForceWhole}, Dimension::Force);
  for (const auto* column : {&source.strain, &source.stress}) {
    if (*column && lower((*column)->column).find("true") != std::string::npos) {
      source.measure = Measure::True;
    }
  }
  return source;
}

}  // namespace plastica::calibrate
