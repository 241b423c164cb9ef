#include "plastica/io/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "plastica/io/unit_words.hpp"

namespace plastica::io {
namespace {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Why a unit is refused.
enum class Refusal { None, Unknown, BareNumber };

struct Lookup {
  Refusal refusal = Refusal::Unknown;
  UnitConversion conversion;
};

std::string_view examples(Dimension dimension) {
  switch (dimension) {
    case Dimension::None: return "1, %";
    case Dimension::Strain: return "%, 1, mm/mm, um/m";
    case Dimension::Angle: return "rad, deg";
    case Dimension::Stress: return "Pa, MPa, ksi";
    case Dimension::Length: return "m, mm, in";
    case Dimension::Area: return "m^2, mm^2, in^2";
    case Dimension::SectionModulus: return "m^3, cm^3, in^3";
    case Dimension::SecondMoment: return "m^4, cm^4, in^4";
    case Dimension::Force: return "N, kN, lbf";
    case Dimension::Moment: return "N m, kN m, lbf in";
    case Dimension::Curvature: return "rad/m, deg/m, 1/mm";
    case Dimension::Density: return "kg/m^3, g/cm^3";
    case Dimension::Temperature: return "K, degC";
    case Dimension::Time: return "s, min, h";
    case Dimension::StrainRate: return "1/s, %/min";
    case Dimension::Acceleration: return "m/s^2, gravity";
    case Dimension::Stiffness: return "N/m, kN/mm, lbf/in";
    case Dimension::RotationalStiffness: return "N m/rad, kN m/deg";
    case Dimension::ForcePerLength: return "N/m, kN/m, lbf/in";
    case Dimension::MomentPerLength: return "N m/m, kN m/m";
    case Dimension::Velocity: return "m/s, km/h";
    case Dimension::AngularVelocity: return "rad/s, deg/s";
    case Dimension::Mass: return "kg, g, t";
    case Dimension::MomentOfInertia: return "kg m^2, kg cm^2";
    case Dimension::Energy: return "J, kJ, N m";
    case Dimension::EnergyDensity: return "J/m^3, MJ/m^3";
    case Dimension::Momentum: return "N s, kg m/s";
    case Dimension::AngularMomentum: return "N m s, kg m^2/s";
    case Dimension::Frequency: return "Hz, kHz, 1/s";
  }
  return "";
}

/// Words that udunits2 does not know, and what they mean to it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 21> kSpellings{{
    {"Nm", "(N m)"},
    {"kNm", "(kN m)"},
    {"MNm", "(MN m)"},
    {"Nmm", "(N mm)"},
    {"kNmm", "(kN mm)"},
    {"deg", "arc_degree"},
    {"secs", "s"},
    // As machines and laboratories write them; each has but one meaning.
    {"KN", "kN"},
    {"Kn", "kN"},
    {"Mpa", "MPa"},
    {"MPA", "MPa"},
    {"Gpa", "GPa"},
    {"GPA", "GPa"},
    {"KPa", "kPa"},
    {"Kpa", "kPa"},
    {"PSI", "psi"},
    {"KSI", "ksi"},
    {"Lbf", "lbf"},
    {"LBF", "lbf"},
    {"MM", "mm"},
    {"SEC", "s"},
}};

/// Whether a number in a text is zero. As a factor it makes no unit, and udunits2 loses the memory
/// of the word that follows it.
bool has_zero(std::string_view text) {
  while (!text.empty()) {
    if (!is_digit(text[0]) && text[0] != '.') {
      text.remove_prefix(1);
      continue;
    }
    double value = 1.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && value == 0.0) return true;
    text.remove_prefix(std::max<std::size_t>(static_cast<std::size_t>(end - text.data()), 1));
  }
  return false;
}

/// A unit in the spelling of udunits2.
std::string respelled(std::string_view unit) {
  std::string text;
  while (!unit.empty()) {
    std::size_t length = 0;
    while (length < unit.size() && is_letter(unit[length])) ++length;
    std::string_view word = unit.substr(0, std::max<std::size_t>(length, 1));
    unit.remove_prefix(word.size());
    for (const auto& [ours, theirs] : kSpellings) {
      if (word == ours) word = theirs;
    }
    text += word;
  }
  return text;
}

/// Pure numbers are a closed list: to udunits2 an angle, a ratio and a count are the same.
std::optional<double> strain_scale(std::string_view unit) {
  if (unit.empty() || unit == "1") return 1.0;
  if (unit == "%" || unit == "percent") return 0.01;
  if (unit == "‰" || unit == "permille") return 1e-3;
  for (const std::string_view name : {"microstrain", "ustrain", "µε", "μɛ", "με", "µɛ", "µm/m",
                                      "μm/m", "um/m", "uin/in", "µin/in"}) {
    if (unit == name) return 1e-6;
  }
  for (const std::string_view name : {"mm/mm", "m/m", "in/in", "cm/cm", "strain", "-"}) {
    if (unit == name) return 1.0;
  }
  if (unit == "mm/m") return 1e-3;
  return std::nullopt;
}

std::optional<double> angle_scale(std::string_view unit) {
  for (const std::string_view name : {"rad", "radian", "radians"}) {
    if (unit == name) return 1.0;
  }
  if (unit == "mrad") return 1e-3;
  for (const std::string_view name : {"deg", "degree", "degrees", "°"}) {
    if (unit == name) return std::numbers::pi / 180.0;
  }
  return std::nullopt;
}

std::optional<double> pure_scale(std::string_view unit) {
  if (unit.empty() || unit == "1" || unit == "-") return 1.0;
  if (unit == "%" || unit == "percent") return 0.01;
  return std::nullopt;
}

/// To udunits2 a radian is 1, so that a turn in a second were 6.28 Hz, and 5 Hz were 5 rad/s.
std::optional<double> frequency_scale(std::string_view unit) {
  if (unit == "Hz" || unit == "1/s") return 1.0;
  if (unit == "mHz") return 1e-3;
  if (unit == "kHz") return 1e3;
  if (unit == "MHz") return 1e6;
  return std::nullopt;
}

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// udunits2 and what was looked up already; all access is under the mutex, since udunits2 keeps
/// its status and parser in globals.
class UnitTable {
 public:
  Lookup find(std::string_view unit, Dimension dimension) {
    const std::lock_guard lock(mutex_);
    const auto key = std::pair(std::string(unit), dimension);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    const Lookup found = look_up(unit, dimension);
    known_.emplace(key, found);
    return found;
  }

  bool parses(std::string_view unit) {
    const std::lock_guard lock(mutex_);
    return parsed(unit) != nullptr;
  }

 private:
  ut_system* system() {
    if (system_ == nullptr) {
      ut_set_error_message_handler(ut_ignore);
      system_ = ut_read_xml(nullptr);
      if (system_ == nullptr) throw std::runtime_error("udunits2: cannot read its table of units");
    }
    return system_;
  }

  Unit parsed(std::string_view unit) {
    if (unit.empty() || unit[0] == '.' || unit[0] == '+' || unit[0] == '-') return nullptr;
    if (has_factor(unit) || has_zero(unit) || is_torn(unit)) return nullptr;
    return Unit(ut_parse(system(), respelled(unit).c_str(), UT_UTF8));
  }

  Lookup look_up(std::string_view unit, Dimension dimension) {
    if (has_wrong_word(unit, dimension)) return {};
    const Unit from = parsed(unit);
    if (!from) return {};
    const Unit to(ut_parse(system(), std::string(si_unit(dimension)).c_str(), UT_UTF8));
    if (!to || ut_are_convertible(from.get(), to.get()) == 0) return {};
    cv_converter* converter = ut_get_converter(from.get(), to.get());
    if (converter == nullptr) return {};
    const double at_0 = cv_convert_double(converter, 0.0);
    const double at_1 = cv_convert_double(converter, 1.0);
    const double at_2 = cv_convert_double(converter, 2.0);
    cv_free(converter);
    // udunits2 also "converts" to the reciprocal (s to Hz) and to logarithms (dB): not a unit here.
    if (!std::isfinite(at_0) || !std::isfinite(at_1)) return {};
    if (at_0 != 0.0 && dimension != Dimension::Temperature) return {};
    const double slope = at_1 - at_0;
    if (std::abs(at_2 - at_0 - 2.0 * slope) > 1e-9 * (std::abs(at_2) + std::abs(at_0))) return {};
    return {Refusal::None, {at_0 == 0.0 ? shortest(at_1, 1e-15) : shortest(slope, 1e-13), at_0}};
  }

  /// Undoes rounding: 0.001^2 is not quite 1e-6, 274.15 - 273.15 not quite 1.
  /// @param tolerance  of the rounding, relative
  static double shortest(double value, double tolerance) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::general, 12);
    double rounded = value;
    std::from_chars(text.data(), end.ptr, rounded);
    return std::abs(rounded - value) < tolerance * std::abs(value) ? rounded : value;
  }

  std::mutex mutex_;
  ut_system* system_ = nullptr;  // lives as long as the process
  std::map<std::pair<std::string, Dimension>, Lookup> known_;
};

UnitTable& unit_table() {
  // Never destroyed, so that threads that outlive main may still ask.
  static auto& table = *new UnitTable;
  return table;
}

Lookup found(std::optional<double> scale) {
  if (!scale) return {};
  return {Refusal::None, {*scale, 0.0}};
}

Lookup look_up(std::string_view unit, Dimension dimension) {
  switch (dimension) {
    case Dimension::None: return found(pure_scale(unit));
    case Dimension::Strain: return found(strain_scale(unit));
    case Dimension::Angle:
      if (unit.empty() || unit == "1") return {Refusal::BareNumber, {}};
      return found(angle_scale(unit));
    case Dimension::Frequency:
      if (unit.empty() || unit == "1") return {Refusal::BareNumber, {}};
      return found(frequency_scale(unit));
    default: break;
  }
  if (unit.empty() || unit == "1") return {Refusal::BareNumber, {}};
  return unit_table().find(unit, dimension);
}

std::string article_for(std::string_view noun) { return noun.starts_with('a') ? "an " : "a "; }

std::string rule_for(Refusal refusal, Dimension dimension) {
  const std::string name(name_of(dimension));
  const std::string such_as = " (examples: " + std::string(examples(dimension)) + ")";
  if (refusal == Refusal::BareNumber) {
    return article_for(name) + name + " needs a unit" + such_as;
  }
  return "is not a unit of " + (dimension == Dimension::None ? "a " + name : name) + such_as;
}

}  // namespace

UnitConversion unit_conversion(std::string_view unit, Dimension dimension,
                               const SourceLocation& where, std::string_view field) {
  const std::string_view text = without_blanks(unit);
  const Lookup result = look_up(text, dimension);
  if (result.refusal != Refusal::None) {
    throw InputError(where, field, text, rule_for(result.refusal, dimension));
  }
  return result.conversion;
}

bool is_unit_of(std::string_view unit, Dimension dimension) {
  return look_up(without_blanks(unit), dimension).refusal == Refusal::None;
}

bool is_unit(std::string_view text) {
  text = without_blanks(text);
  if (text.empty()) return false;
  if (text.size() == 1) {
    // udunits2 knows most letters ("a" is 100 m^2, "d" a day); in headers they number things.
    constexpr std::string_view kLetters = "%msKNVAh";
    return kLetters.find(text[0]) != std::string_view::npos;
  }
  if (text == "force") return false;  // to udunits2 that is gravity
  return strain_scale(text) || angle_scale(text) || unit_table().parses(text);
}

bool is_scaled_unit(std::string_view text) {
  const std::optional<Factor> factor = factor_at(without_blanks(text));
  return factor && is_unit(factor->behind);
}

std::string factor_in_name(std::string_view name, Dimension dimension, bool has_unit) {
  const auto is_of_word = [&](std::size_t i) {
    return is_letter(name[i]) || is_digit(name[i]) || name[i] == '.' || name[i] == ',' ||
           name[i] == '^' || name[i] == '-';
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins_word = is_digit(name[i]) || is_letter(name[i]);
    if (i > 0 && begins_word && is_of_word(i - 1)) continue;
    const std::optional<Factor> factor = factor_at(name.substr(i));
    if (!factor) continue;
    const std::string_view rest = factor->behind;
    const std::size_t end = std::min(rest.find_first_of(")]"), rest.size());
    const std::string_view unit = without_blanks(rest.substr(0, end));
    // Of "3 x 10 mm", a size, the sign stands behind a number; "L0 = 100 mm" is a length.
    const std::string_view before = without_blanks(name.substr(0, i));
    const char last = before.empty() ? ' ' : before.back();
    const bool is_of_another =
        !factor->of_what_follows && is_unit(unit) && !is_unit_of(unit, dimension);
    if (last == '=' || is_of_another) continue;
    const bool multiplies = factor->multiplies && !is_digit(last);
    const bool scales = unit.empty()
                            ? factor->is_power && i > 0 && end < rest.size()
                            : is_unit_of(unit, dimension) && (!has_unit || factor->is_power);
    if (!multiplies && !scales) continue;
    const std::size_t length = name.size() - i - rest.size() + (scales ? end : 0);
    return std::string(without_blanks(name.substr(i, length)));
  }
  return {};
}

double parse_quantity(std::string_view text, Dimension dimension, const SourceLocation& where,
                      std::string_view field) {
  const std::string_view whole = without_blanks(text);
  std::string_view rest = whole;
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error == std::errc::result_out_of_range || (error == std::errc{} && !std::isfinite(value))) {
    throw InputError(where, field, whole, "is not a finite number");
  }
  if (error != std::errc{}) {
    throw InputError(where, field, whole,
                     "does not begin with a number; wanted: a number and a unit of " +
                         std::string(name_of(dimension)) + ", such as \"1 " +
                         std::string(si_unit(dimension)) + "\"");
  }
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (rest.size() > 1 && rest[0] == ',' && is_digit(rest[1])) {
    throw InputError(where, field, whole, "has a decimal comma; write a point");
  }
  const std::string_view unit = without_blanks(rest);
  const Lookup result = look_up(unit, dimension);
  if (result.refusal != Refusal::None) {
    const std::string quoted = unit.empty() || result.refusal == Refusal::BareNumber
                                   ? std::string()
                                   : "\"" + std::string(unit) + "\" ";
    throw InputError(where, field, whole, quoted + rule_for(result.refusal, dimension));
  }
  // "20" is more likely 20 % than 2000 %.
  if (dimension == Dimension::Strain && unit.empty() && std::fabs(value) >= 1.0) {
    throw InputError(where, field, whole,
                     fmt::format("would be {:g} % as a fraction: write the unit, \"{:g} %\" or "
                                 "\"{:g} %\"",
                                 100.0 * value, value, 100.0 * value));
  }
  return result.conversion(value);
}

}  // namespace plastica::io
