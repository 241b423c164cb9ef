#pragma once

#include <string>

#include "plastica/io/hdf5.hpp"

/// What of a file is not followed or read, whoever made it; not installed.
namespace plastica::io::h5 {

/// Results have no datasets of more dimensions.
inline constexpr int kMaxRank = 3;

/// The last link of a path.
enum class Link {
  None,       ///< there is nothing
  Here,       ///< a hard link: to something of the file
  Elsewhere,  ///< a soft, external or user-defined link: results have none
};

/// @param path  absolute, all of whose other links are `Here`
Link link_at(const Hdf5Handle& location, const std::string& path);

/// Why a dataset is not to be read, in words; empty if it may be: its values must stand in the file
/// itself, stored as we store them, and be no more than the file can hold.
std::string refusal_of_dataset(const Hdf5Handle& dataset);

/// The same of an attribute.
std::string refusal_of_attribute(const Hdf5Handle& attribute);

/// Why integers of a file are not to be read as a type, in words; empty if they may be: HDF5 would
/// change what does not fit without a word.
std::string refusal_of_integers(const Hdf5Handle& type, std::size_t size, bool is_signed);

}  // namespace plastica::io::h5
