#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_handle.hpp"

namespace plastica::io::h5 {

inline std::size_t count_of(const Hdf5Handle& space) {
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

/// Strings of a dataset or an attribute, of fixed or variable length.
/// @param read  reads all elements of a memory type into a buffer; false on failure
template <typename Read>
bool read_strings(const Hdf5Handle& type, const Hdf5Handle& space, const Read& read,
                  std::vector<std::string>& texts) {
  const std::size_t count = count_of(space);
  texts.assign(count, {});
  if (count == 0) return true;
  const Hdf5Handle memory(H5Tcopy(type.get()));
  if (H5Tis_variable_str(type.get()) > 0) {
    std::vector<char*> pointers(count, nullptr);
    if (!read(memory.get(), pointers.data())) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (pointers[i] != nullptr) texts[i] = pointers[i];
    }
    H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, pointers.data());
    return true;
  }
  const std::size_t size = H5Tget_size(type.get());
  std::vector<char> bytes(count * size);
  if (!read(memory.get(), bytes.data())) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(i * size);
    const auto end = begin + static_cast<std::ptrdiff_t>(size);
    texts[i].assign(begin, std::find(begin, end, '\0'));
  }
  return true;
}

/// Names of a group's links: in the order in which they were written if it knows that, else by
/// name. @return false on failure
inline bool read_link_names(const Hdf5Handle& group, std::vector<std::string>& names) {
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  // Closed before the iteration: to close anything forgets why that failed.
  const H5_index_t index = [&] {
    const Hdf5Handle creation(H5Gget_create_plist(group.get()));
    unsigned order = 0;
    H5Pget_link_creation_order(creation.get(), &order);
    return (order & H5P_CRT_ORDER_INDEXED) != 0U ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  }();
  return H5Literate(group.get(), index, H5_ITER_INC, nullptr, take, &names) >= 0;
}

/// Names of an object's attributes, by name. @return false on failure
inline bool read_attribute_names(const Hdf5Handle& object, std::vector<std::string>& names) {
  const auto take = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  return H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names) >= 0;
}

}  // namespace plastica::io::h5
