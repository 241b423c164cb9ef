#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/result/describe.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/words.hpp"
#include "plastica/base/renamed.hpp"
#include "plastica/io/value_rule.hpp"

/// Tables of a result file: a group with one dataset a column and an element a row; not installed.
///
/// Which columns a table has is said once, by a description (result/describe.hpp), or by a function
/// of this folder that calls `columns(NAME, UNITS, MEMBER)` for each; a ColumnWriter then writes
/// them and a ColumnReader fills the rows from them.
namespace plastica::calibrate::store {

/// How hard numbers are deflated: more costs much time and saves little.
inline constexpr int kDeflate = 1;

/// An old word is read as the new one. @throws InputError if the word is none of the enumeration's
template <typename Enum>
Enum enumerator_of(const io::Hdf5Group& group, std::string_view name, const std::string& word) {
  const auto words = words_of<Enum>();
  const std::string_view now = new_name(kRenamedWords, word);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == now) return static_cast<Enum>(i);
  }
  throw InputError({group.file(), 0}, group.path() + "/" + std::string(name), word,
                   "is not a word of this column");
}

/// The element type of a column in the file.
template <typename Value>
using Stored = std::conditional_t<
    std::is_same_v<Value, bool>, std::uint8_t,
    std::conditional_t<std::is_same_v<Value, int>, std::int64_t,
                       std::conditional_t<std::is_integral_v<Value>, std::uint64_t, double>>>;

/// @tparam Row  a null row is missing: NaN, 0 or no text
template <typename Row>
class ColumnWriter {
 public:
  /// @param own_units  of what has those of its row; empty: another column says them
  ColumnWriter(io::Hdf5Group& group, std::vector<const Row*> rows, std::string_view own_units = {})
      : group_(group), rows_(std::move(rows)), own_units_(own_units) {}

  /// @param meaning  attribute of the column; empty: none
  template <typename Member>
  void operator()(std::string_view name, std::string_view units, const Member& member,
                  std::string_view meaning = {}) {
    using Value = std::remove_cvref_t<decltype(member(std::declval<const Row&>()))>;
    if constexpr (std::is_same_v<Value, std::string> || std::is_enum_v<Value>) {
      std::vector<std::string> texts(rows_.size());
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i] != nullptr) texts[i] = text(member(*rows_[i]));
      }
      group_.write_texts(name, texts);
    } else {
      std::vector<Stored<Value>> values(rows_.size(), missing<Stored<Value>>());
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i] != nullptr) values[i] = number(member(*rows_[i]));
      }
      group_.write(name, values, {units == kOwnUnits ? own_units_ : units, kDeflate});
    }
    if (!meaning.empty()) group_.set_attribute(name, "meaning", meaning);
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

  /// Columns of what not every row has; the column `name` says which do.
  template <typename Member, typename Columns>
  void optional(std::string_view name, const Member& member, const Columns& columns) {
    using Inner = typename std::remove_cvref_t<decltype(member(*rows_[0]))>::value_type;
    std::vector<const Inner*> inner(rows_.size(), nullptr);
    std::vector<std::uint8_t> present(rows_.size(), 0);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i] == nullptr) continue;
      const auto& there = member(*rows_[i]);
      if (there) inner[i] = &*there;
      present[i] = there.has_value();
    }
    group_.write(name, present, {{}, kDeflate});
    ColumnWriter<Inner> writer(group_, std::move(inner), own_units_);
    columns(writer);
  }

  /// Columns that only those rows have for which `condition` holds.
  template <typename Condition, typename Columns>
  void only(const Condition& condition, const Columns& columns) {
    ColumnWriter writer(group_, rows_, own_units_);
    for (const Row*& row : writer.rows_) {
      if (!condition(*row)) row = nullptr;
    }
    columns(writer);
  }

 private:
  static std::string text(const std::string& value) { return value; }
  template <typename Enum>
  static std::string text(Enum value) requires std::is_enum_v<Enum> {
    return std::string(word_of(value));
  }
  template <typename Value>
  static Stored<Value> number(Value value) {
    return static_cast<Stored<Value>>(value);
  }
  static double number(const std::optional<double>& value) { return value.value_or(missing()); }
  template <typename T = double>
  static T missing() {
    if constexpr (std::is_floating_point_v<T>) return std::numeric_limits<T>::quiet_NaN();
    return T{};
  }

  io::Hdf5Group& group_;
  std::vector<const Row*> rows_;
  std::string_view own_units_;
};

/// Of tables that no version has changed.
inline constexpr int kNewest = std::numeric_limits<int>::max();

/// @tparam Row  a null row is missing: what the file has there does not count
template <typename Row>
class ColumnReader {
 public:
  /// @param rules  of the file's kind
  /// @param version  of the file: columns of later ones are left as they are
  ColumnReader(const io::Hdf5Group& group, std::vector<Row*> rows,
               std::span<const io::ValueRule> rules, int version)
      : group_(group), rows_(std::move(rows)), rules_(rules), version_(version) {}

  template <typename Member>
  void operator()(std::string_view name, std::string_view /*units*/, const Member& member,
                  std::string_view /*meaning*/ = {}) {
    using Value = std::remove_cvref_t<decltype(member(std::declval<Row&>()))>;
    if constexpr (std::is_same_v<Value, std::string> || std::is_enum_v<Value>) {
      std::vector<std::string> texts = checked(name, group_.read_texts(name));
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i] != nullptr) set(member(*rows_[i]), name, std::move(texts[i]));
      }
    } else {
      const auto values = checked(name, group_.template read<Stored<Value>>(name));
      check_present<Value>(name, values);
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i] != nullptr) set(member(*rows_[i]), values[i]);
      }
    }
  }

  template <typename Member, typename Columns>
  void optional(std::string_view name, const Member& member, const Columns& columns) {
    using Inner = typename std::remove_cvref_t<decltype(member(*rows_[0]))>::value_type;
    const auto present = checked(name, group_.template read<std::uint8_t>(name));
    check_present<bool>(name, present);
    std::vector<Inner*> inner(rows_.size(), nullptr);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (present[i] != 0 && rows_[i] != nullptr) inner[i] = &member(*rows_[i]).emplace();
    }
    ColumnReader<Inner> reader(group_, std::move(inner), rules_, version_);
    columns(reader);
  }

  template <typename Function>
  void derived(std::string_view, std::string_view, const Function&, std::string_view = {}) {}

  template <typename Columns>
  void since(int version, const Columns& columns) {
    if (version_ >= version) columns(*this);
  }

  template <typename Condition, typename Columns>
  void only(const Condition& condition, const Columns& columns) {
    ColumnReader reader(group_, rows_, rules_, version_);
    for (Row*& row : reader.rows_) {
      if (!condition(*row)) row = nullptr;
    }
    columns(reader);
  }

 private:
  /// Whether the numbers of the rows that are there are as the rules want them.
  template <typename Value, typename Number>
  void check_present(std::string_view name, const std::vector<Number>& values) const {
    using Member = std::conditional_t<std::is_integral_v<Value>, Value, double>;
    io::ValueRule rule = io::rule_of(rules_, io::path_from_root(group_, name));
    if constexpr (std::is_same_v<Value, std::optional<double>>) rule.may_lack = true;
    std::vector<Number> present;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i] != nullptr) present.push_back(values[i]);
    }
    io::check_numbers<Member>(group_, name, present, rule);
  }
  template <typename Values>
  Values checked(std::string_view name, Values values) const {
    if (values.size() == rows_.size()) return values;
    throw InputError({group_.file(), 0}, group_.path() + "/" + std::string(name),
                     std::to_string(values.size()) + " rows",
                     "must have " + std::to_string(rows_.size()) + ", as the rest of its table");
  }

  static void set(std::string& value, std::string_view, std::string&& text) {
    value = std::move(text);
  }
  template <typename Enum>
  void set(Enum& value, std::string_view name,
           const std::string& text) const requires std::is_enum_v<Enum> {
    value = enumerator_of<Enum>(group_, name, text);
  }
  template <typename Value, typename Number>
  static void set(Value& value, Number number) {
    if constexpr (std::is_same_v<Value, bool>) {
      value = number != 0;
    } else {
      value = static_cast<Value>(number);
    }
  }
  static void set(std::optional<double>& value, double number) {
    value.reset();
    if (number == number) value = number;  // NaN: missing
  }

  const io::Hdf5Group& group_;
  std::vector<Row*> rows_;
  std::span<const io::ValueRule> rules_;
  int version_;
};

/// The addresses of rows.
template <typename Row>
std::vector<Row*> pointers_to(std::span<Row> rows) {
  std::vector<Row*> pointers(rows.size());
  std::ranges::transform(rows, pointers.begin(), [](Row& row) { return &row; });
  return pointers;
}

}  // namespace plastica::calibrate::store
