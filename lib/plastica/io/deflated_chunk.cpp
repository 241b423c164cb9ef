#include "plastica/io/deflated_chunk.hpp"

#include <libdeflate.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace plastica::io {
namespace {

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
  }
};

std::vector<unsigned char> shuffled(std::span<const unsigned char> elements,
                                    std::size_t element_bytes) {
  const std::size_t count = elements.size() / element_bytes;
  std::vector<unsigned char> planes(elements.size());
  for (std::size_t byte = 0; byte < element_bytes; ++byte) {
    unsigned char* const plane = planes.data() + byte * count;
    for (std::size_t i = 0; i < count; ++i) plane[i] = elements[i * element_bytes + byte];
  }
  return planes;
}

}  // namespace

std::vector<unsigned char> deflated_chunk(std::span<const unsigned char> elements,
                                          std::size_t element_bytes, int level) {
  if (element_bytes == 0 || elements.size() % element_bytes != 0) {
    throw std::logic_error("deflated_chunk: the bytes are not those of whole elements");
  }
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(level));
  if (!compressor) throw std::bad_alloc();
  const std::vector<unsigned char> bytes = shuffled(elements, element_bytes);
  std::vector<unsigned char> stream(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  stream.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                         stream.data(), stream.size()));
  if (stream.empty()) throw std::logic_error("deflated_chunk: the stream has no room");
  return stream;
}

}  // namespace plastica::io
