#include "calibrate/target/group_values.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>

#include "plastica/io/csv_number.hpp"

namespace plastica::calibrate {
namespace {

using io::csv_text::CellKind;

/// The number that a text is; empty: it is none, or not for certain.
std::optional<double> number_of(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  // Numbers of specimens with more of them would come to one double.
  if (std::ranges::count_if(text, is_digit) > std::numeric_limits<double>::digits10) return {};
  io::csv_text::Number number = io::csv_text::read_number(text, {});
  const bool may_have_comma =
      text.find(',') != std::string_view::npos && !io::csv_text::is_ambiguous(text);
  if (number.kind == CellKind::Text && may_have_comma) {
    number = io::csv_text::read_number(text, {.decimal = ','});
  }
  if (number.kind != CellKind::Number) return {};
  return number.value;
}

}  // namespace

void GroupValues::unite(std::span<Target> targets) {
  for (Target& target : targets) {
    for (auto& [column, text] : target.group) {
      const std::optional<double> number = number_of(text);
      if (number) text = first_.try_emplace({column, *number}, text).first->second;
    }
  }
}

}  // namespace plastica::calibrate
