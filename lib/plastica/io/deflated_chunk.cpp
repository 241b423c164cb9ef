#include "plastica/io/deflated_chunk.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdint>
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

using Bytes = std::span<const unsigned char>;

/// Whether deflate finds nothing in some bytes, by two parts of them: what differs from noise
/// elsewhere alone is stored as it is, and takes more room.
bool is_noise(libdeflate_compressor* compressor, Bytes bytes) {
  constexpr std::size_t kLooked = 4096;
  constexpr std::size_t kLeast = 8 * kLooked;  // below that, looking costs more than it saves
  if (bytes.size() < kLeast) return false;
  std::array<unsigned char, kLooked> out;
  for (const std::size_t begin : {bytes.size() / 4, 3 * (bytes.size() / 4)}) {
    // Those that take no less room than they had do not fit.
    if (libdeflate_deflate_compress(compressor, bytes.data() + begin, kLooked, out.data(),
                                    kLooked - kLooked / 50) != 0) {
      return false;
    }
  }
  return true;
}

/// Adds bytes as they are, in stored blocks (RFC 1951, 3.2.4) none of which is the last. The stream
/// must end with a whole byte, and does so again.
void add_stored(Bytes bytes, std::vector<unsigned char>& stream) {
  constexpr std::size_t kLargest = 0xFFFF;
  for (std::size_t begin = 0; begin < bytes.size(); begin += kLargest) {
    const std::size_t size = std::min(kLargest, bytes.size() - begin);
    const auto low = static_cast<unsigned char>(size & 0xFFU);
    const auto high = static_cast<unsigned char>(size >> 8U);
    const std::array<unsigned char, 5> header{0, low, high, static_cast<unsigned char>(~low),
                                              static_cast<unsigned char>(~high)};
    stream.insert(stream.end(), header.begin(), header.end());
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
    stream.insert(stream.end(), from, from + static_cast<std::ptrdiff_t>(size));
  }
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
  const std::vector<unsigned char> planes = shuffled(elements, element_bytes);
  const std::size_t plane = elements.size() / element_bytes;
  // The last digits of measured numbers are noise, which takes most of the time and no less room.
  std::size_t noise = 0;
  while (noise + plane < planes.size() &&
         is_noise(compressor.get(), Bytes(planes).subspan(noise, plane))) {
    noise += plane;
  }
  const Bytes rest = Bytes(planes).subspan(noise);
  std::vector<unsigned char> stream{0x78, 0x01};  // RFC 1950, 2.2: deflate, window of 32 kB, fast
  const std::size_t bound = libdeflate_deflate_compress_bound(compressor.get(), rest.size());
  constexpr std::size_t kHeaders = 5;
  stream.reserve(2 + noise + (noise / 0xFFFF + 8) * kHeaders + bound + 4);
  for (std::size_t at = 0; at < noise; at += plane) {
    add_stored(Bytes(planes).subspan(at, plane), stream);
  }
  const std::size_t begin = stream.size();
  stream.resize(begin + bound);
  const std::size_t size = libdeflate_deflate_compress(compressor.get(), rest.data(), rest.size(),
                                                       stream.data() + begin, bound);
  if (size == 0) throw std::logic_error("deflated_chunk: the stream has no room");
  stream.resize(begin + size);
  const std::uint32_t check = libdeflate_adler32(1, planes.data(), planes.size());
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    stream.push_back(static_cast<unsigned char>((check >> shift) & 0xFFU));
  }
  return stream;
}

}  // namespace plastica::io
