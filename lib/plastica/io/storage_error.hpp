#pragma once

#include <string>
#include <utility>

#include "plastica/base/machine_error.hpp"

namespace plastica::io {

/// The machine failure that has a path: the disk is full, a folder may not be written.
class StorageError : public MachineError {
 public:
  /// @param path    file that was written or read
  /// @param reason  what failed and why, in the words of the system or of HDF5
  StorageError(std::string path, std::string reason)
      : MachineError(path + ": " + reason), path_(std::move(path)), reason_(std::move(reason)) {}

  const std::string& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

}  // namespace plastica::io
