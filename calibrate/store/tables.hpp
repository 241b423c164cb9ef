#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/samples.hpp"
#include "plastica/io/result_file.hpp"

/// Rows of a result file: its fits, or the items of what each fit has a list of; not installed.
///
/// A layout (layout.hpp) says of rows, once for writing and reading, what of them stands where:
///   columns(PATH, DESCRIPTION)        a table, an element a row;
///   numbers(PATH, UNITS, MEMBER)      a list of numbers for each row;
///   samples(PATH, COLUMNS)            curves, see samples.hpp;
///   list(PATH, MEMBER, DESCRIPTION)   a table of what each row has a list of; its column `fit`
///   says
///                                     whose an item is. Gives the items as rows;
///   part(MEMBER), maybe(MEMBER)       members of the rows as rows, the second those of a
///                                     std::optional;
///   since(VERSION, LAYOUT)            what files have from a version on.
/// WrittenRows write it, ReadRows read it; CodedRows (coded_rows.hpp) put it into journals.
namespace plastica::calibrate::store {

/// @tparam Row  a null one is missing
template <typename Row>
class WrittenRows {
 public:
  /// @param remade  makes the fitted curves that are counted alone; empty: there are none
  WrittenRows(io::Hdf5Group& root, std::vector<const Row*> rows, CurveOfRow remade = {})
      : root_(root), rows_(std::move(rows)), remade_(std::move(remade)) {}

  /// @param own_units  see ColumnWriter
  template <typename Description>
  void columns(const std::string& path, const Description& description,
               std::string_view own_units = {}) {
    io::Hdf5Group group = root_.group(path);
    ColumnWriter<Row> writer(group, rows_, own_units);
    description(writer);
  }

  template <typename Member>
  void numbers(const std::string& path, std::string_view units, const Member& member) {
    using Value = typename std::remove_cvref_t<decltype(member(*rows_[0]))>::value_type;
    io::Ragged<Stored<Value>> lists;
    for (const Row* row : rows_) {
      const auto& list = member(*row);
      lists.push_back(std::vector<Stored<Value>>(list.begin(), list.end()));
    }
    root_.write_ragged(path, lists, {units, kDeflate});
  }

  template <typename Columns>
  void samples(const std::string& path, const Columns& columns) {
    SampleWriter<Row> writer(root_.group(path), rows_, remade_);
    columns(writer);
    writer.finish();
  }

  /// @param owner  the column that says whose an item is
  template <typename Member, typename Description>
  auto list(const std::string& path, const Member& member, const Description& description,
            std::string_view owner = "fit") {
    using Item = std::remove_cvref_t<decltype(*member(*rows_[0]).begin())>;
    std::vector<const Item*> items;
    std::vector<std::uint64_t> owners;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i] == nullptr) continue;
      for (const Item& item : member(*rows_[i])) {
        items.push_back(&item);
        owners.push_back(i);
      }
    }
    root_.group(path).write(owner, owners, {{}, kDeflate});
    WrittenRows<Item> of_items(root_, std::move(items));
    of_items.columns(path, description);
    return of_items;
  }

  template <typename Member>
  auto part(const Member& member) const {
    using Part = std::remove_cvref_t<decltype(member(*rows_[0]))>;
    std::vector<const Part*> parts;
    for (const Row* row : rows_) parts.push_back(&member(*row));
    constexpr bool kIsOfFit = std::is_same_v<Part, FitResult> || std::is_same_v<Row, FitResult>;
    return WrittenRows<Part>(root_, std::move(parts), kIsOfFit ? remade_ : CurveOfRow());
  }

  template <typename Member>
  auto maybe(const Member& member) const {
    using Part = typename std::remove_cvref_t<decltype(member(*rows_[0]))>::value_type;
    std::vector<const Part*> parts;
    for (const Row* row : rows_) parts.push_back(member(*row) ? &*member(*row) : nullptr);
    return WrittenRows<Part>(root_, std::move(parts));
  }

  template <typename Layout>
  void since(int /*version*/, const Layout& layout) {
    layout(*this);
  }

 private:
  io::Hdf5Group& root_;
  std::vector<const Row*> rows_;
  CurveOfRow remade_;
};

/// The file that rows are read from.
struct FileToRead {
  const io::Hdf5Group& root;
  std::span<const io::ValueRule> rules;
  int version = kNewest;
  FitSamples samples = FitSamples::Read;

  [[noreturn]] void refuse(const std::string& path, const std::string& rule) const {
    io::refuse_value(root, path, "", rule);
  }
};

template <typename Row>
class ReadRows {
 public:
  /// @param rows  are filled; a null one is left out
  ReadRows(const FileToRead& file, std::vector<Row*> rows) : file_(file), rows_(std::move(rows)) {}

  const std::vector<Row*>& rows() const { return rows_; }

  template <typename Description>
  void columns(const std::string& path, const Description& description) {
    const io::Hdf5Group group = file_.root.open_group(path);
    ColumnReader<Row> reader(group, rows_, file_.rules, file_.version);
    description(reader);
  }

  template <typename Member>
  void numbers(const std::string& path, std::string_view /*units*/, const Member& member) {
    using Value = typename std::remove_cvref_t<decltype(member(*rows_[0]))>::value_type;
    const auto lists = file_.root.template read_ragged<Stored<Value>>(path);
    if (lists.rows() != rows_.size()) {
      io::refuse_value(file_.root, path, std::to_string(lists.rows()) + " rows",
                       "must have " + std::to_string(rows_.size()));
    }
    const std::string values = path + "/values";
    io::check_numbers<Value>(file_.root, values, lists.values, io::rule_of(file_.rules, values));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto row = lists.row(i);
      member(*rows_[i]).assign(row.begin(), row.end());
    }
  }

  template <typename Columns>
  void samples(const std::string& path, const Columns& columns) {
    SampleReader<Row> reader(file_.root.open_group(path), rows_, file_.rules);
    if constexpr (requires(Row & row) { count_samples(row, std::size_t{}); }) {
      if (file_.samples == FitSamples::Counted) return reader.count(columns);
    }
    columns(reader);
  }

  /// Lengthens the rows' lists by the items of a table, and fills these.
  template <typename Member, typename Description>
  auto list(const std::string& path, const Member& member, const Description& description,
            const std::string& owner = "fit") {
    using Item = std::remove_reference_t<decltype(*member(*rows_[0]).begin())>;
    const std::string column = path + "/" + owner;
    const auto owners = file_.root.template read<std::uint64_t>(column);
    std::vector<std::size_t> next(rows_.size(), 0);
    for (const std::uint64_t of : owners) {
      if (of >= rows_.size()) {
        file_.refuse(column, fmt::format("names a {} that is not in the file", owner));
      }
      if (rows_[of] == nullptr) {
        file_.refuse(column, fmt::format("names a {} that has none of these", owner));
      }
      member(*rows_[of]).emplace_back();
    }
    // Only now that no list grows any more.
    std::vector<Item*> items;
    items.reserve(owners.size());
    for (const std::uint64_t of : owners) items.push_back(&member(*rows_[of])[next[of]++]);
    ReadRows<Item> of_items(file_, std::move(items));
    of_items.columns(path, description);
    return of_items;
  }

  template <typename Member>
  auto part(const Member& member) const {
    using Part = std::remove_cvref_t<decltype(member(*rows_[0]))>;
    std::vector<Part*> parts;
    for (Row* row : rows_) parts.push_back(&member(*row));
    return ReadRows<Part>(file_, std::move(parts));
  }

  template <typename Member>
  auto maybe(const Member& member) const {
    using Part = typename std::remove_cvref_t<decltype(member(*rows_[0]))>::value_type;
    std::vector<Part*> parts;
    for (Row* row : rows_) parts.push_back(member(*row) ? &*member(*row) : nullptr);
    return ReadRows<Part>(file_, std::move(parts));
  }

  template <typename Layout>
  void since(int version, const Layout& layout) {
    if (file_.version >= version) layout(*this);
  }

 private:
  FileToRead file_;
  std::vector<Row*> rows_;
};

/// What stands in which order in a file: names, then laws.
template <typename Record>
std::pair<std::string_view, Law> order_of(const Record& record) {
  return {name_of(record), record.result.law};
}

/// Pointers to records in the order in which a file has them: of their names, then of their laws.
/// @throws std::logic_error if two have both the same
template <typename Record>
std::vector<const Record*> in_order(const std::vector<Record>& records) {
  std::vector<const Record*> sorted = pointers_to(std::span(records));
  const auto key = [](const Record* record) { return order_of(*record); };
  std::ranges::sort(sorted, std::less<>(), key);
  const auto twice = std::ranges::adjacent_find(sorted, std::equal_to<>(), key);
  if (twice == sorted.end()) return sorted;
  throw std::logic_error("a result file: " + name_of(**twice) + " is the name of two fits");
}

/// Puts records in that order.
template <typename Record>
void sort_in_order(std::vector<Record>& records) {
  std::ranges::sort(records, std::less<>(), order_of<Record>);
}

/// Reports find the fits of a name beside each other, and a fit by its name and law.
/// @throws InputError
template <typename Record>
void check_order(const io::Hdf5Group& root, const std::vector<Record>& records) {
  const auto follows = [](const Record& a, const Record& b) { return order_of(a) >= order_of(b); };
  if (std::ranges::adjacent_find(records, follows) != records.end()) {
    io::refuse_value(root, "fits/name", "", "must rise, or be the same with a law that rises");
  }
}

}  // namespace plastica::calibrate::store
