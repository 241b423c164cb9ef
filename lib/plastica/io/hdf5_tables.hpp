#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plastica::io {

/// Whose an HDF5 file is.
enum class Hdf5Origin {
  None,     ///< it is no HDF5 file
  Results,  ///< a result of ours
  Others,   ///< of another program: it may hold measured tables
  Unknown,  ///< it cannot be opened
};
/// Never throws.
Hdf5Origin hdf5_origin(const std::string& path);

/// A column of a table of `Hdf5Tables`: numbers or texts.
struct Hdf5TableColumn {
  std::string header;  ///< its name, and its unit behind it: "Stress [MPa]"; empty: none
  std::vector<double> numbers;
  std::vector<std::string> texts;

  bool has_texts() const { return !texts.empty(); }
  std::size_t size() const { return has_texts() ? texts.size() : numbers.size(); }
};

/// The measured tables of an HDF5 file that other programs wrote. A table is
/// - a group whose datasets of one dimension are its columns, two or more,
/// - a dataset of records, whose fields are its columns, or
/// - a dataset of two dimensions, (rows x columns), with an attribute `columns` that names these,
/// or
///   without.
/// Units are those of the attribute `units` or `unit` of a column, or stand in its name:
/// "Stress [MPa]". Links that lead elsewhere are not followed. For several threads.
class Hdf5Tables {
 public:
  /// @throws InputError if the file cannot be read, or holds no table
  explicit Hdf5Tables(const std::string& path);
  ~Hdf5Tables();
  Hdf5Tables(const Hdf5Tables&) = delete;
  Hdf5Tables& operator=(const Hdf5Tables&) = delete;

  /// Paths of the tables, without the slash in front: "batch 1/A-01"; "/" if the file itself is
  /// one. By name, or in the order in which they were written if the file knows it.
  const std::vector<std::string>& names() const { return names_; }
  /// Those that a pattern matches, in which a `*` stands for any characters; empty: all.
  /// @throws InputError if there is none
  std::vector<std::string> matching(const std::optional<std::string>& pattern) const;
  const std::string& file() const { return path_; }

  /// The columns of a table, of one length.
  /// @throws InputError if they are of unlike lengths or cannot be read
  std::vector<Hdf5TableColumn> columns(const std::string& name) const;

  /// Columns as text: a line with their headers, if one has some, then one for each row; cells
  /// between tabs. Numbers read back bit by bit.
  struct Text {
    std::string text;
    bool has_header = false;
  };
  static Text text_of(const std::vector<Hdf5TableColumn>& columns);
  /// What is said of a table beside its columns, as columns of one row: the attributes of the
  /// table and of the groups that hold it, and their datasets of one value. Of one name the nearest
  /// counts.
  /// @throws InputError if they cannot be read
  std::vector<Hdf5TableColumn> properties(const std::string& name) const;

 private:
  struct Opened;

  void find_in(const std::string& name, std::size_t depth);

  std::string path_;
  std::unique_ptr<Opened> opened_;
  std::vector<std::string> names_;
};

}  // namespace plastica::io
