#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_handle.hpp"

/// What is read of HDF5 files that other programs wrote; not installed.
namespace plastica::io::h5 {

/// A column, of numbers or of texts.
struct Column {
  std::string name;
  std::string unit;
  std::vector<double> numbers;
  std::vector<std::string> texts;

  std::size_t size() const { return std::max(numbers.size(), texts.size()); }
};

/// Where errors are: "curves.h5: /A-01/strain ...".
struct Place {
  std::string file;
  std::string path;

  Place operator/(const std::string& name) const {
    return {file, path == "/" ? path + name : path + "/" + name};
  }
  /// That of the group that holds it.
  Place above() const { return {file, path.substr(0, std::max<std::size_t>(path.rfind('/'), 1))}; }
  [[noreturn]] void refuse(std::string_view rule) const {
    throw InputError({file, 0}, path, "", rule);
  }
  /// Says what HDF5 said last.
  [[noreturn]] void fail() const { refuse("is damaged: " + h5::innermost_error()); }
};

/// Names in a group: in the order in which they were written if it knows that, else by name.
std::vector<std::string> names_in(const Hdf5Handle& group, const Place& place);

/// A hard link of a group, opened; without identifier if it leads elsewhere.
Hdf5Handle opened(const Hdf5Handle& group, const std::string& name, const Place& place);

/// Texts of an attribute; none if there is no such attribute, or it holds something else, or more
/// than an attribute of ours may.
std::vector<std::string> texts_of_attribute(const Hdf5Handle& object, const char* name,
                                            const Place& place);

bool is_group(const Hdf5Handle& object);
/// Whether an object of a group is a column of it: a dataset of one dimension, others being 1, of
/// numbers or texts.
bool is_column(const Hdf5Handle& object);
/// The same of more than one number.
bool is_column_of_numbers(const Hdf5Handle& object);
/// Whether an object is a table by itself: a dataset of records, or of two dimensions that names
/// its columns or has few.
bool is_table(const Hdf5Handle& object);

/// The columns of a group or of a dataset that is a table.
/// @throws InputError if one cannot be read
std::vector<Column> columns_of(Hdf5Handle object, const Place& place);

/// What is said of an object beside its columns, as columns of one row: its attributes and, of a
/// group, its datasets of one value. Numbers and texts; units are none.
std::vector<Column> properties_of(const Hdf5Handle& object, const Place& place);

}  // namespace plastica::io::h5
