#pragma once

#include <string>
#include <string_view>

#include "plastica/io/storage_error.hpp"

namespace plastica::io {

/// Whether an output may take the place of a file that is there.
enum class Overwrite { Refused, Allowed };

inline Overwrite overwrite_if(bool allowed) {
  return allowed ? Overwrite::Allowed : Overwrite::Refused;
}

/// The one way in which an output is written: to a fresh file beside it, which is forced to the
/// disk and takes the output's place whole, or not at all.
///
/// The fresh file is `PATH.PROCESS-NUMBER.part`; never one that is there already, nor what a link
/// leads to. A file that is replaced hands its mode (and, as far as the system lets it, its owner)
/// on to the new one.
class OutputFile {
 public:
  /// Opens the fresh file.
  /// @throws StorageError if the folder does not take it, or a link, pipe or device stands there
  OutputFile(std::string path, Overwrite overwrite);
  /// Removes the fresh file, unless it was committed or has to be kept.
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  const std::string& path() const { return path_; }
  const std::string& part() const { return part_; }  ///< the fresh file, for who writes by path
  int descriptor() const { return descriptor_; }     ///< of the fresh file, for reading and writing

  /// Adds bytes. @throws StorageError if the disk does not take them all
  void write(std::string_view bytes);

  /// Forces the file to the disk and moves it into place.
  /// @throws StorageError if the disk fails, after which the fresh file is gone; or if it cannot be
  ///         moved: a file stands there that may not be replaced, or that is no regular file. What
  ///         was written is then kept as `part()`, and the message says so.
  void commit();

 private:
  void move_into_place();
  [[noreturn]] void keep_part(const std::string& why);

  std::string path_;
  std::string part_;  // empty: nothing to remove
  Overwrite overwrite_;
  int descriptor_ = -1;
};

/// What stands at a path, "a link", "a named pipe", …; empty for a regular file and for nothing.
std::string special_file(const std::string& path);

/// Why a path cannot be an output, whatever is forced: "is a link: …"; empty if it can.
std::string no_output_reason(const std::string& path);

/// Whether an open file is what stands at a path: not if it was removed or replaced since.
bool is_named(int descriptor, const std::string& path);

/// Keeps an output for one run at a time: a lock on `PATH.lock` beside it, which goes when the run
/// ends, however it ends. Taken before a long run, so that two of them do not compute the same in
/// vain.
class OutputLock {
 public:
  /// @throws StorageError if another run has it, or the folder does not take the file; InputError
  ///         if something stands in its place that is no lock (a lock is empty)
  explicit OutputLock(const std::string& output);
  ~OutputLock();
  OutputLock(OutputLock&&) = delete;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

/// The lock's file of an output: "OUT.h5.lock".
std::string lock_path(const std::string& output);

}  // namespace plastica::io
