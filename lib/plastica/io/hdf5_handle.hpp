#pragma once

// The HDF5 C API is included by the sources of this folder only.
#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace plastica::io::h5 {

static_assert(std::is_same_v<hid_t, std::int64_t>, "identifiers are held as std::int64_t");

/// HDF5's type in memory of an element type of ours.
template <typename T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

/// HDF5 prints its errors by itself unless told otherwise, in each thread anew. At the program's
/// end it closes once more what is open, and crashes on a file that a full disk kept it from
/// closing; ours are closed by then.
void keep_quiet();

/// The innermost message on HDF5's error stack, which says what really happened.
std::string innermost_error();

/// A string type of variable length, UTF-8; owned by the caller.
hid_t new_text_type();

/// How elements are transferred. Those whose type in memory is not that of the file, as of all
/// texts, HDF5 converts in two buffers of 1 MiB, which it sets to zero for each dataset however
/// small; these hold what there is to convert, at most 1 MiB.
/// @param count  elements of `type`, the one in memory
/// @return a property list, owned by the caller
hid_t new_transfer(std::size_t count, hid_t type);

}  // namespace plastica::io::h5
