#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/storage_error.hpp"

namespace plastica::io {

/// The element types that we store. Truth values are `std::uint8_t`.
template <typename T>
concept Hdf5Number = std::same_as<T, double> || std::same_as<T, float> ||
    std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::uint64_t> || std::same_as<T, std::uint8_t>;

/// Version of the HDF5 library that runs, which need not be the one that was compiled with:
/// "1.10.8". @throws StorageError
std::string hdf5_version();

/// What stands at a path of a file.
enum class Hdf5Kind {
  None,     ///< nothing
  Group,    ///< a group
  Real,     ///< a dataset of floating-point numbers
  Integer,  ///< a dataset of integers
  Text,     ///< a dataset of strings
  Other,    ///< something that we never write
};

/// How a dataset is stored.
struct DatasetOptions {
  std::string_view units;  ///< attribute `units`; none if empty
  int deflate = 0;         ///< 0: as it is; 1...9: in chunks, shuffled and deflated, if over 4 KiB
};

/// Rows of unequal length: row i is `values[offsets[i] ... offsets[i + 1])`.
template <Hdf5Number T>
struct Ragged {
  std::vector<T> values;
  std::vector<std::uint64_t> offsets{0};  ///< (rows + 1), from 0 to values.size()

  std::size_t rows() const { return offsets.size() - 1; }
  std::span<const T> row(std::size_t i) const {
    return std::span<const T>(values).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
  void push_back(std::span<const T> row) {
    values.insert(values.end(), row.begin(), row.end());
    offsets.push_back(values.size());
  }
};

/// Owns one identifier of the HDF5 library: a file, group, dataset, type, ...
class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  explicit Hdf5Handle(std::int64_t id) : id_(id) {}
  ~Hdf5Handle();
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.release()) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  std::int64_t get() const { return id_; }
  std::int64_t release() {
    const std::int64_t id = id_;
    id_ = -1;
    return id;
  }

 private:
  std::int64_t id_ = -1;
};

namespace h5 {
struct NewDataset;
}

/// A dataset of numbers that is written piece by piece, in order; it must not outlive its file.
class Hdf5Column {
 public:
  Hdf5Column(Hdf5Column&& other) noexcept;
  Hdf5Column& operator=(Hdf5Column&&) = delete;
  ~Hdf5Column();

  /// @throws StorageError; std::logic_error if these are more than the dataset takes, or of another
  ///         type than its own
  void append(std::span<const double> values);
  void append(std::span<const float> values);
  void append(std::span<const std::int32_t> values);
  /// To be called once all values are there. @throws StorageError; std::logic_error if one lacks
  void finish();

 private:
  friend class Hdf5Group;
  Hdf5Column(std::unique_ptr<h5::NewDataset> made, std::int64_t type, std::string file,
             std::string path);
  template <Hdf5Number T>
  void append_numbers(std::span<const T> values);
  void check(bool written) const;

  std::unique_ptr<h5::NewDataset> made_;
  std::int64_t type_;
  std::string file_;
  std::string path_;
  std::size_t taken_ = 0;
  std::vector<unsigned char> waiting_;  // of a dataset too short for chunks
};

/// A group of an open file. Paths are relative to it ("a/b"; "." is the group itself) or, with a
/// slash in front, to the file's root. Groups must not outlive their file.
///
/// What is read by its name may stand there under its old one (base/renamed.hpp).
///
/// Writing creates the groups on the way and throws StorageError when it fails, or when there is
/// something at the path already. Reading throws InputError when the path, the type or the shape
/// is not as asked, since the file is the user's; StorageError when the machine fails. What leads
/// out of the file (links of any kind but hard ones, external and virtual datasets), what is stored
/// with filters that we do not write, and what claims more values than the file can hold is refused
/// before it is followed or allocated.
/// HDF5 is not reentrant: all files must be used from one thread at a time.
class Hdf5Group {
 public:
  /// The group at a path, created if it is missing.
  Hdf5Group group(std::string_view path);
  /// The group at a path. @throws InputError if there is none
  Hdf5Group open_group(std::string_view path) const;

  Hdf5Kind kind(std::string_view path) const;
  bool exists(std::string_view path) const { return kind(path) != Hdf5Kind::None; }
  /// Names in the group, in the order in which they were written; by name in files of others.
  std::vector<std::string> children() const;
  /// Path of the group in the file: "/fits/0003".
  const std::string& path() const { return path_; }
  const std::string& file() const { return file_; }

  template <Hdf5Number T>
  void write(std::string_view path, T value, const DatasetOptions& options = {});
  /// A one-dimensional array.
  template <Hdf5Number T>
  void write(std::string_view path, std::span<const T> values, const DatasetOptions& options = {});
  template <Hdf5Number T>
  void write(std::string_view path, const std::vector<T>& values,
             const DatasetOptions& options = {}) {
    write(path, std::span<const T>(values), options);
  }
  /// @param values  (rows x columns), row by row
  template <Hdf5Number T>
  void write_table(std::string_view path, std::span<const T> values, std::size_t columns,
                   const DatasetOptions& options = {});
  /// An array of any shape, the last index running fastest.
  template <Hdf5Number T>
  void write_array(std::string_view path, std::span<const T> values,
                   std::span<const std::size_t> shape, const DatasetOptions& options = {});
  /// Begins a dataset of so many numbers, which lacks its end until `Hdf5Column::finish` is called.
  Hdf5Column column(std::string_view path, std::size_t count, const DatasetOptions& options = {});
  /// The same of another type, and of any shape, the last index running fastest.
  template <Hdf5Number T>
  Hdf5Column column(std::string_view path, std::span<const std::size_t> shape,
                    const DatasetOptions& options = {});
  /// A group with the datasets `values` and `offsets`.
  template <Hdf5Number T>
  void write_ragged(std::string_view path, const Ragged<T>& rows,
                    const DatasetOptions& options = {});
  /// UTF-8 text of any length, without zero bytes.
  void write_text(std::string_view path, const std::string& text);
  void write_texts(std::string_view path, std::span<const std::string> texts);

  /// Of a shape: any extent.
  static constexpr std::size_t kAnyExtent = ~std::size_t{0};

  template <Hdf5Number T>
  T read_scalar(std::string_view path) const;
  /// A one-dimensional array. An integer may be read as a real number or as a wider one of the same
  /// sign, not the reverse.
  template <Hdf5Number T>
  std::vector<T> read(std::string_view path) const;
  /// An array of the extents that are given, the last index running fastest.
  template <Hdf5Number T>
  std::vector<T> read_array(std::string_view path, std::span<const std::size_t> shape) const;
  /// Extents of a dataset; empty for a scalar.
  std::vector<std::size_t> shape(std::string_view path) const;
  template <Hdf5Number T>
  Ragged<T> read_ragged(std::string_view path) const;
  std::string read_text(std::string_view path) const;
  std::vector<std::string> read_texts(std::string_view path) const;

  /// Attributes of the group or dataset at a path; an earlier value is replaced.
  void set_attribute(std::string_view path, const std::string& name, std::string_view text);
  void set_attribute(std::string_view path, const std::string& name, const char* text) {
    set_attribute(path, name, std::string_view(text));
  }
  void set_attribute(std::string_view path, const std::string& name, double value);
  void set_attribute(std::string_view path, const std::string& name, std::int64_t value);
  void set_attribute(std::string_view path, const std::string& name, int value) {
    set_attribute(path, name, std::int64_t{value});
  }
  void set_attribute(std::string_view path, const std::string& name,
                     std::span<const std::string> texts);
  void set_attribute(std::string_view path, const std::string& name,
                     std::span<const std::int64_t> values);
  /// A text of ASCII alone, stored with its length, as some formats of others want it.
  void set_ascii_attribute(std::string_view path, const std::string& name, const std::string& text);

  bool has_attribute(std::string_view path, const std::string& name) const;
  /// Names of all attributes of the group or dataset at a path, by name.
  std::vector<std::string> attribute_names(std::string_view path) const;
  /// What an attribute holds: Real, Integer, Text or Other. @throws InputError if there is none
  Hdf5Kind attribute_kind(std::string_view path, const std::string& name) const;
  std::string text_attribute(std::string_view path, const std::string& name) const;
  std::vector<std::string> texts_attribute(std::string_view path, const std::string& name) const;
  double real_attribute(std::string_view path, const std::string& name) const;
  std::int64_t integer_attribute(std::string_view path, const std::string& name) const;

  /// How many deflate what is written, and may make it ready.
  int threads() const { return threads_; }

 private:
  friend class Hdf5File;
  Hdf5Group(Hdf5Handle handle, std::string file, std::string path, int threads = 1)
      : handle_(std::move(handle)),
        file_(std::move(file)),
        path_(std::move(path)),
        threads_(threads) {}

  std::string full_path(std::string_view path) const;
  bool has_links(const std::string& full) const;
  std::string stored_path(const std::string& full) const;
  void require_shape(std::string_view path, std::span<const std::size_t> wanted) const;
  std::vector<std::string> read_text_array(std::string_view path,
                                           std::span<const std::size_t> shape) const;
  Hdf5Handle open_object(std::string_view path) const;
  Hdf5Handle open_dataset(std::string_view path) const;
  Hdf5Handle open_attribute(std::string_view path, const std::string& name) const;
  void make_parents(std::string_view path);
  h5::NewDataset create_dataset(std::string_view path, std::int64_t type,
                                std::span<const std::size_t> shape, const DatasetOptions& options);
  void write_raw(std::string_view path, std::int64_t type, const void* values,
                 std::span<const std::size_t> shape, const DatasetOptions& options);
  void write_attribute(std::string_view path, const std::string& name, std::int64_t type,
                       const void* value, std::int64_t space);
  [[noreturn]] void fail(std::string_view action, std::string_view path) const;
  [[noreturn]] void fail_to_read(std::string_view path, const std::string& attribute = {}) const;
  [[noreturn]] void refuse(std::string_view path, std::string_view rule) const;

  Hdf5Handle handle_;
  std::string file_;
  std::string path_;
  int threads_;
};

/// An HDF5 file behind a digest of its bytes (see content_digest.hpp). The same content, written in
/// the same order, gives the same bytes.
class Hdf5File {
 public:
  /// Begins a new file. It appears under its name when it is committed (see `OutputFile`).
  /// @param threads  that deflate what is written, 0: as many as the machine has, which is also the
  ///                 most that are made; they change no byte
  /// @throws StorageError
  static Hdf5File create(const std::string& path, Overwrite overwrite = Overwrite::Allowed,
                         int threads = 1);
  /// Opens a file for reading, once it is known to be as it was written.
  /// @throws InputError if there is none, or it is no HDF5 file, or a damaged one
  static Hdf5File open(const std::string& path);

  /// Removes an uncommitted new file.
  ~Hdf5File();
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&&) = delete;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  Hdf5Group& root() { return root_; }
  const Hdf5Group& root() const { return root_; }
  /// HDF5's own identifier, for sources of this folder.
  std::int64_t identifier() const { return file_.get(); }

  /// Writes everything and the digest to the disk and moves the file into place; then it is closed.
  /// @throws StorageError as `OutputFile::commit`; an older file is untouched
  void commit();

 private:
  Hdf5File(Hdf5Handle file, Hdf5Group root, std::optional<OutputFile> output);

  std::optional<OutputFile> output_;  // of a new file; declared first: HDF5 closes before it goes
  Hdf5Handle file_;
  Hdf5Group root_;
};

}  // namespace plastica::io
