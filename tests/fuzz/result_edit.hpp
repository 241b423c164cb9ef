#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plastica/io/hdf5.hpp"
#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace plastica::fuzz {

/// Changes things in a result file, each into something that HDF5 takes.
class ResultEdit {
 public:
  /// Opens a file for writing.
  explicit ResultEdit(const std::string& path);

  /// Changes one object; what does not apply to it changes nothing.
  /// @param object  number of it, modulo how many there are
  /// @param kind    of the change, modulo how many there are
  void apply(std::size_t object, std::size_t kind, Bytes payload);

 private:
  void set_values(const std::string& path, ByteSource payload);
  void set_text(const std::string& path, ByteSource payload);
  void set_extent(const std::string& path, ByteSource payload);
  void set_type(const std::string& path, ByteSource payload);
  void set_attribute(const std::string& path, ByteSource payload);
  void link_to_another(const std::string& path, ByteSource payload);
  void remove(const std::string& path);

  io::Hdf5Handle file_;
  std::vector<std::string> paths_;
};

}  // namespace plastica::fuzz
