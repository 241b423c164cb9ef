#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "calibrate/inference/held_out.hpp"
#include "calibrate/store/columns.hpp"
#include "plastica/io/result_file.hpp"

/// Tables of what each fit of a file has a list of: a row per item, in the order of the fits, and a
/// column `fit` that says whose it is; not installed.
namespace plastica::calibrate::store {

/// The items of all records, and whose they are.
template <typename Row>
struct Items {
  std::vector<Row*> rows;
  std::vector<std::uint64_t> fits;  ///< of each row
};

/// @param records  pointers to them
/// @param member  from a record to its list
template <typename Records, typename Member>
auto items_of(const Records& records, const Member& member) {
  using Row = std::remove_reference_t<decltype(*member(*records[0]).begin())>;
  Items<Row> items;
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (Row& row : member(*records[i])) {
      items.rows.push_back(&row);
      items.fits.push_back(i);
    }
  }
  return items;
}

template <typename Row, typename Description>
void write_columns(io::Hdf5Group& group, std::vector<const Row*> rows,
                   const Description& description, std::string_view own_units = {}) {
  ColumnWriter<Row> writer(group, std::move(rows), own_units);
  description(writer);
}

/// Writes a table, for more columns. @return its group
/// @param owner  the column that says whose a row is
template <typename Row, typename Description>
io::Hdf5Group write_items(io::Hdf5Group& root, const std::string& path, const Items<Row>& items,
                          const Description& description, std::string_view owner = "fit") {
  io::Hdf5Group group = root.group(path);
  group.write(owner, items.fits, {{}, kDeflate});
  using Bare = std::remove_const_t<Row>;
  write_columns<Bare>(group, {items.rows.begin(), items.rows.end()}, description);
  return group;
}

/// @throws InputError for another number of parts held out than none or all
inline void check_parts(const io::Hdf5Group& root, const std::string& path, std::size_t count) {
  if (count == 0 || count == kParts) return;
  io::refuse_value(root, path, "", "must have a number for each part of a fit, or none");
}

/// Reads tables of a file.
class TableReader {
 public:
  /// @param version  of the file
  TableReader(const io::Hdf5Group& root, std::span<const io::ValueRule> rules, int version)
      : root_(root), rules_(rules), version_(version) {}

  const io::Hdf5Group& root() const { return root_; }
  int version() const { return version_; }

  [[noreturn]] void refuse(const std::string& path, const std::string& rule) const {
    io::refuse_value(root_, path, "", rule);
  }

  template <typename Row, typename Description>
  void columns(const std::string& path, std::vector<Row*> rows,
               const Description& description) const {
    const io::Hdf5Group group = root_.open_group(path);
    ColumnReader<Row> reader(group, std::move(rows), rules_, version_);
    description(reader);
  }

  /// Lengthens the records' lists by the rows of a table, and fills these.
  /// @param records  pointers to them
  template <typename Records, typename Member, typename Description>
  auto items(const std::string& path, const Records& records, const Member& member,
             const Description& description, const std::string& owner = "fit") const {
    using Row = std::remove_reference_t<decltype(*member(*records[0]).begin())>;
    Items<Row> items;
    items.fits = root_.read<std::uint64_t>(path + "/" + owner);
    std::vector<std::size_t> next(records.size(), 0);
    for (const std::uint64_t fit : items.fits) {
      if (fit >= records.size()) {
        refuse(fmt::format("{}/{}", path, owner),
               fmt::format("names a {} that is not in the file", owner));
      }
      member(*records[fit]).emplace_back();
    }
    // Only now that no list grows any more.
    for (const std::uint64_t fit : items.fits) {
      items.rows.push_back(&member(*records[fit])[next[fit]++]);
    }
    columns(path, items.rows, description);
    return items;
  }

  io::Ragged<double> lists(const std::string& path, std::size_t n) const {
    return io::read_lists(root_, path, n, rules_);
  }

 private:
  const io::Hdf5Group& root_;
  std::span<const io::ValueRule> rules_;
  int version_;
};

}  // namespace plastica::calibrate::store
