#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "calibrate/report/csv_cells.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/result/describe.hpp"
#include "calibrate/result/words.hpp"

/// Visitors of descriptions (result/describe.hpp) that write summaries and tables; not installed.
namespace plastica::calibrate::report {

/// Adds what a description says of a record to a JSON object; null where there is none.
template <typename Row>
class JsonDescriber {
 public:
  /// @param row  null: the record is not there
  JsonDescriber(Json& object, const Row* row) : object_(object), row_(row) {}

  template <typename Member>
  void operator()(std::string_view name, std::string_view /*units*/, const Member& member,
                  std::string_view /*meaning*/ = {}) {
    object_[std::string(name)] = row_ == nullptr ? Json(nullptr) : value_of(member(*row_));
  }
  template <typename Function>
  void derived(std::string_view name, std::string_view units, const Function& function,
               std::string_view meaning = {}) {
    (*this)(name, units, function, meaning);
  }
  template <typename Columns>
  void since(int /*version*/, const Columns& columns) {
    columns(*this);
  }
  template <typename Condition, typename Columns>
  void only(const Condition& condition, const Columns& columns) {
    JsonDescriber those(object_, row_ != nullptr && condition(*row_) ? row_ : nullptr);
    columns(those);
  }
  /// Without the column that says whether it is there: null says so.
  template <typename Member, typename Columns>
  void optional(std::string_view /*name*/, const Member& member, const Columns& columns) {
    using Inner = typename std::remove_cvref_t<decltype(member(*row_))>::value_type;
    const bool there = row_ != nullptr && member(*row_).has_value();
    JsonDescriber<Inner> of_inner(object_, there ? &*member(*row_) : nullptr);
    columns(of_inner);
  }

 private:
  static Json value_of(bool value) { return value; }
  static Json value_of(const std::string& value) { return text_or_null(value); }
  static Json value_of(double value) { return number(value); }
  static Json value_of(const std::optional<double>& value) { return number(value); }
  template <typename Value>
  static Json value_of(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      return word_of(value);
    } else {
      return value;
    }
  }

  Json& object_;
  const Row* row_;
};

/// A record as a JSON object; null: all of it is null.
template <typename Row, typename Description>
Json described_json(const Row* row, const Description& description) {
  Json object = Json::object();
  JsonDescriber<Row> describer(object, row);
  description(describer);
  return object;
}

/// Records as a JSON array of objects.
template <typename Rows, typename Description>
Json described_list(const Rows& rows, const Description& description) {
  Json all = Json::array();
  for (const auto& row : rows) all.push_back(described_json(&row, description));
  return all;
}

/// Collects what a description says of a record as columns of a table: names with their units, and
/// cells, empty where there is none.
template <typename Row>
class CellDescriber {
 public:
  /// @param row  null: the record is not there
  /// @param prefix  of the names; what is called "value" has no other name
  CellDescriber(const Row* row, std::string prefix, std::string_view own_units)
      : row_(row), prefix_(std::move(prefix)), own_units_(own_units) {}

  template <typename Member>
  void operator()(std::string_view name, std::string_view units, const Member& member,
                  std::string_view /*meaning*/ = {}) {
    const std::string_view shown = units == kOwnUnits ? own_units_ : units;
    std::string title = prefix_;
    if (prefix_.empty()) title = name;
    if (!prefix_.empty() && name != "value") title += "." + std::string(name);
    if (!shown.empty()) title += " [" + std::string(shown) + "]";
    names.push_back(std::move(title));
    cells.push_back(row_ == nullptr ? std::string() : text_of(member(*row_)));
  }
  template <typename Function>
  void derived(std::string_view name, std::string_view units, const Function& function,
               std::string_view meaning = {}) {
    (*this)(name, units, function, meaning);
  }
  template <typename Columns>
  void since(int /*version*/, const Columns& columns) {
    columns(*this);
  }
  template <typename Condition, typename Columns>
  void only(const Condition& condition, const Columns& columns) {
    CellDescriber those(row_ != nullptr && condition(*row_) ? row_ : nullptr, prefix_, own_units_);
    columns(those);
    append(those);
  }
  template <typename Member, typename Columns>
  void optional(std::string_view /*name*/, const Member& member, const Columns& columns) {
    using Inner = typename std::remove_cvref_t<decltype(member(*row_))>::value_type;
    const bool there = row_ != nullptr && member(*row_).has_value();
    CellDescriber<Inner> of_inner(there ? &*member(*row_) : nullptr, prefix_, own_units_);
    columns(of_inner);
    append(of_inner);
  }
  /// Goes on with the columns of another record.
  template <typename Other>
  void append(const CellDescriber<Other>& others) {
    names.insert(names.end(), others.names.begin(), others.names.end());
    cells.insert(cells.end(), others.cells.begin(), others.cells.end());
  }

  std::vector<std::string> names;
  std::vector<std::string> cells;

 private:
  static std::string text_of(bool value) { return value ? "1" : "0"; }
  static std::string text_of(double value) { return cell_of(value); }
  template <typename Value>
  static std::string text_of(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      return std::string(word_of(value));
    } else if constexpr (std::is_integral_v<Value>) {
      return std::to_string(value);
    } else if constexpr (std::is_convertible_v<Value, std::string>) {
      return value;
    } else {
      return cell_of(value);
    }
  }

  const Row* row_;
  std::string prefix_;
  std::string_view own_units_;
};

}  // namespace plastica::calibrate::report
