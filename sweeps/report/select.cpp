#include "sweeps/report/select.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "plastica/base/check.hpp"
#include "plastica/io/units.hpp"

namespace plastica::sweeps {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& rule) {
  throw InputError({}, "--case", text, rule);
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// The axis of a path, or of the last part of one.
std::size_t axis_of(const SweepRecord& record, const std::string& name, const std::string& text) {
  std::string all;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    const std::string_view path = record.axes[a].field->path;
    if (path == name || path.ends_with("." + name)) return a;
    all += (all.empty() ? "" : ", ") + std::string(path);
  }
  refuse(text, fmt::format("{} is no axis of this sweep; it has {}", name,
                           all.empty() ? std::string("none") : all));
}

/// A number as the text has it, in SI; none if it is none of the axis' unit.
std::optional<double> number_of(const std::string& text, const Field& field) {
  try {
    return io::parse_quantity(text, field.dimension);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Which of an axis' values the text means. @return a flag for each value
std::vector<bool> values_of(const Axis& axis, const std::string& value, const std::string& text) {
  std::vector<bool> wanted;
  const std::optional<double> number =
      axis.field->kind == FieldKind::Choice ? std::nullopt : number_of(value, *axis.field);
  for (const FieldValue& one : axis.values) {
    const auto* its = std::get_if<double>(&one);
    // Reports show six digits.
    const bool near = number && its != nullptr && std::abs(*its - *number) <= 1e-5 * std::abs(*its);
    wanted.push_back(near || value_text(*axis.field, one) == value);
  }
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) {
    refuse(text, fmt::format("{} has no value {}", axis.field->path, value));
  }
  return wanted;
}

std::vector<std::size_t> by_values(const SweepRecord& record, const std::string& text) {
  std::vector<bool> picked(record.cases(), true);
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, comma - at);
    at = comma + 1;
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) refuse(text, "must be AXIS = VALUE, AXIS = VALUE, …");
    const std::size_t axis = axis_of(record, trimmed(part.substr(0, equals)), text);
    const auto wanted = values_of(record.axes[axis], trimmed(part.substr(equals + 1)), text);
    for (std::size_t i = 0; i < record.cases(); ++i) {
      picked[i] = picked[i] && wanted[record.position[i * record.axes.size() + axis]];
    }
  }
  std::vector<std::size_t> cases;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (picked[i]) cases.push_back(i);
  }
  if (cases.empty()) refuse(text, "no case has these values together");
  return cases;
}

}  // namespace

std::vector<std::size_t> select_cases(const SweepRecord& record, const std::string& text) {
  if (text.find('=') != std::string::npos) return by_values(record, text);
  std::vector<std::size_t> cases;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (!text.empty() && record.ids[i].starts_with(text)) cases.push_back(i);
  }
  if (cases.empty()) {
    refuse(text, "must be the id of a case of this sweep, as export has it, or AXIS = VALUE, …");
  }
  for (const std::size_t i : cases) {
    if (record.ids[i] != record.ids[cases.front()]) {
      refuse(text, fmt::format("begins the ids {} and {}; say more of it",
                               record.ids[cases.front()], record.ids[i]));
    }
  }
  // Cases of one id are the same.
  cases.resize(1);
  return cases;
}

}  // namespace plastica::sweeps
