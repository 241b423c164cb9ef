#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "calibrate/report/json_values.hpp"
#include "calibrate/result/describe.hpp"
#include "calibrate/result/words.hpp"

/// What descriptions (result/describe.hpp) say of records, for summaries and tables; not installed.
namespace plastica::calibrate::report {

/// One of a record's numbers, words or texts.
struct Entry {
  std::string name;
  std::string_view units;
  Json value;  ///< null: there is none
};

/// Adds what a description says of a record.
template <typename Row>
class Describer {
 public:
  /// @param row  null: the record is not there
  Describer(std::vector<Entry>& entries, const Row* row) : entries_(entries), row_(row) {}

  template <typename Member>
  void operator()(std::string_view name, std::string_view units, const Member& member,
                  std::string_view /*meaning*/ = {}) {
    entries_.push_back(
        {std::string(name), units, row_ == nullptr ? Json(nullptr) : value_of(member(*row_))});
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
    Describer those(entries_, row_ != nullptr && condition(*row_) ? row_ : nullptr);
    columns(those);
  }
  /// Without the column that says whether it is there: null says so.
  template <typename Member, typename Columns>
  void optional(std::string_view /*name*/, const Member& member, const Columns& columns) {
    using Inner = typename std::remove_cvref_t<decltype(member(*row_))>::value_type;
    const bool there = row_ != nullptr && member(*row_).has_value();
    Describer<Inner> of_inner(entries_, there ? &*member(*row_) : nullptr);
    columns(of_inner);
  }

 private:
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

  std::vector<Entry>& entries_;
  const Row* row_;
};

/// @param row  null: all values are
template <typename Row, typename Description>
std::vector<Entry> described(const Row* row, const Description& description) {
  std::vector<Entry> entries;
  Describer<Row> describer(entries, row);
  description(describer);
  return entries;
}

inline void append(std::vector<Entry>& entries, std::vector<Entry> more) {
  for (Entry& entry : more) entries.push_back(std::move(entry));
}

/// As a JSON object.
inline Json json_of(const std::vector<Entry>& entries, Json object = Json::object()) {
  for (const Entry& entry : entries) object[entry.name] = entry.value;
  return object;
}

/// Records as a JSON array of objects.
template <typename Rows, typename Description>
Json described_list(const Rows& rows, const Description& description) {
  Json all = Json::array();
  for (const auto& row : rows) all.push_back(json_of(described(&row, description)));
  return all;
}

}  // namespace plastica::calibrate::report
