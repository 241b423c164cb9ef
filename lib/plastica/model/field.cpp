#include "plastica/model/field.hpp"

#include <array>
#include <cmath>

#include "plastica/base/renamed.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/field_table.hpp"

namespace plastica {

using model_detail::number_text;

namespace {

const Setup& defaults() {
  static const Setup setup;
  return setup;
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = low_open ? value > low : value >= low;
  const bool below = high_open ? value < high : value <= high;
  return above && below && std::isfinite(value);
}

std::string Range::rule() const {
  const bool bounded_low = std::isfinite(low);
  const bool bounded_high = std::isfinite(high);
  std::string text = "must be ";
  if (bounded_low && bounded_high && !low_open && !high_open) {
    return text + "from " + number_text(low) + " to " + number_text(high);
  }
  if (bounded_low) text += (low_open ? "above " : "at least ") + number_text(low);
  if (bounded_low && bounded_high) text += " and ";
  if (bounded_high) text += (high_open ? "below " : "at most ") + number_text(high);
  if (!bounded_low && !bounded_high) text += "finite";
  return text;
}

const Field* find_field_or_null(std::string_view path) {
  const std::string now = new_path(path);
  for (const Field& field : fields()) {
    if (field.path == now) return &field;
  }
  return nullptr;
}

const Field& model_detail::find_in(std::span<const Field> table, std::string_view name,
                                   const SourceLocation& where) {
  const std::string now = new_path(name);
  const Field* found = nullptr;
  for (const Field& field : table) {
    if (field.path == now) return field;
  }
  for (const Field& field : table) {
    const auto dot = field.path.rfind('.');
    if (field.path.substr(dot + 1) != now) continue;
    if (found != nullptr) {
      throw InputError(
          where, name, "",
          "is ambiguous: " + std::string(found->path) + " or " + std::string(field.path));
    }
    found = &field;
  }
  if (found == nullptr) {
    throw InputError(where, name, "", "is not a field; `plastica fields` lists them");
  }
  return *found;
}

const Field& find_field(std::string_view name, const SourceLocation& where) {
  return model_detail::find_in(fields(), name, where);
}

void check_field(const Field& field, double value, const SourceLocation& where,
                 std::string_view shown) {
  const auto text = [&] { return shown.empty() ? number_text(value) : std::string(shown); };
  if (!field.range.contains(value)) {
    std::string rule = field.range.rule();
    const std::string_view unit = si_unit(field.dimension);
    if (unit != "1" && rule != "must be finite") rule += " " + std::string(unit);
    throw InputError(where, field.path, text(), rule);
  }
  if (field.kind == FieldKind::Integer && value != std::floor(value)) {
    throw InputError(where, field.path, text(), "must be an integer");
  }
}

void set_field(Setup& setup, const Field& field, const FieldValue& value,
               const SourceLocation& where, std::string_view shown) {
  if (const double* number = std::get_if<double>(&value)) {
    if (field.kind == FieldKind::Choice) {
      throw InputError(where, field.path, shown.empty() ? number_text(*number) : shown,
                       "must be a word");
    }
    check_field(field, *number, where, shown);
  } else if (const std::string* word = std::get_if<std::string>(&value)) {
    std::string list;
    bool known = false;
    for (const std::string_view choice : field.choices) {
      known = known || choice == *word;
      list += (list.empty() ? "" : ", ") + std::string(choice);
    }
    if (field.kind != FieldKind::Choice) {
      throw InputError(where, field.path, *word, "must be a number");
    }
    if (!known) throw InputError(where, field.path, *word, "must be one of " + list);
  } else if (!std::holds_alternative<std::monostate>(field.get(defaults()))) {
    throw InputError(where, field.path, shown, "cannot be left unset");
  }
  field.set(setup, value);
}

std::string default_text(const Field& field) {
  const FieldValue value = field.get(defaults());
  if (const double* number = std::get_if<double>(&value)) return number_text(*number);
  if (const std::string* word = std::get_if<std::string>(&value)) return *word;
  return "unset";
}

}  // namespace plastica
