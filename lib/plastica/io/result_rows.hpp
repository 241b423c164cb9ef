#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "plastica/io/hdf5.hpp"

namespace plastica::io {

/// What the rows of a dataset of a result are called, as far as the file says so: by the column
/// `name` of its group (and `law`, where laws are compared), by the values of a sweep's axes, by
/// the fit that a column `fit` names. Rows of ragged lists are named by their offsets.
class ResultRows {
 public:
  /// @param path  of a dataset: "/fits/cost"
  ResultRows(const Hdf5Group& root, const std::string& path);

  /// What an element is called: "CA-RD-01", "beam.segments = 20 [3]", "[3, 5]".
  /// @param at  its place, the last index running fastest
  std::string name(std::size_t at, const std::vector<std::size_t>& shape) const;

 private:
  void find_names(const Hdf5Group& root, const std::string& group, std::size_t rows);
  void take_names(const Hdf5Group& root, const std::string& group, std::size_t rows);
  void take_axes(const Hdf5Group& root, const std::string& group, std::size_t rows);
  void take_fits(const Hdf5Group& root, const std::string& group, std::size_t rows);

  std::vector<std::string> names_;      ///< of the rows; empty: they have none
  std::vector<std::uint64_t> offsets_;  ///< of a ragged list; empty: it is none
};

}  // namespace plastica::io
