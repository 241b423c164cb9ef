#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plastica::io {

/// Elements as HDF5's filters shuffle and deflate, in this order, store them in a chunk: first the
/// first bytes of all elements, then the second ones, and so on; these as a stream of zlib (RFC
/// 1950), which every reader of HDF5 takes. libdeflate makes it in less than half of zlib's time.
/// What comes first and is noise, as the last digits of measured numbers, is stored as it is.
/// @param elements  one behind the other
/// @param element_bytes  of each; `elements` holds whole ones
/// @param level  of deflate, 1...9
/// @return the same bytes for the same elements
std::vector<unsigned char> deflated_chunk(std::span<const unsigned char> elements,
                                          std::size_t element_bytes, int level);

}  // namespace plastica::io
