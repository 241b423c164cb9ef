#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace plastica::io {

/// The machine failed while storing something: the disk is full, a folder may not be written.
///
/// Not the user's input, which is an InputError. The command turns it into exit code 3.
class StorageError : public std::runtime_error {
 public:
  /// @param path    file that was written or read
  /// @param reason  what failed and why, in the words of the system or of HDF5
  StorageError(std::string path, std::string reason)
      : std::runtime_error(path + ": " + reason),
        path_(std::move(path)),
        reason_(std::move(reason)) {}

  const std::string& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

}  // namespace plastica::io
