#include "plastica/io/hdf5_chunks.hpp"

#include <algorithm>
#include <vector>

#include "plastica/base/parallel_for.hpp"
#include "plastica/io/deflated_chunk.hpp"

namespace plastica::io::h5 {
namespace {

/// Of all that has one index in the first dimension.
std::size_t row_bytes(std::span<const std::size_t> shape, std::size_t element_bytes) {
  std::size_t bytes = element_bytes;
  for (const std::size_t extent : shape.subspan(1)) bytes *= extent;
  return bytes;
}

}  // namespace

void set_chunks(hid_t creation, std::span<const std::size_t> shape, std::size_t element_bytes) {
  constexpr std::size_t kChunkBytes = std::size_t{1} << 18U;
  std::vector<hsize_t> extents(shape.begin(), shape.end());
  extents[0] = std::clamp<hsize_t>(kChunkBytes / row_bytes(shape, element_bytes), 1, extents[0]);
  H5Pset_chunk(creation, static_cast<int>(extents.size()), extents.data());
}

ChunkWriter::ChunkWriter(hid_t dataset, hid_t creation, std::span<const std::size_t> shape,
                         std::size_t element_bytes, int level, int threads)
    : dataset_(dataset),
      element_bytes_(element_bytes),
      level_(level),
      threads_(resolved_threads(threads)),
      next_(shape.size(), 0) {
  // Held in memory: so many chunks, whatever the number of threads, so that columns which are
  // written side by side lie in the file alike; no more bytes if a row alone is long.
  constexpr std::size_t kAtOnce = 32;
  constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;
  std::vector<hsize_t> chunk(shape.size());
  H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  rows_ = chunk[0];
  chunk_bytes_ = rows_ * row_bytes(shape, element_bytes);
  bytes_of_dataset_ = shape[0] * row_bytes(shape, element_bytes);
  at_once_ = std::clamp<std::size_t>(kMaxBytes / chunk_bytes_, 1, kAtOnce) * chunk_bytes_;
}

bool ChunkWriter::append(std::span<const unsigned char> bytes) {
  if (bytes.size() < at_once_) waiting_.reserve(std::min(at_once_, bytes_of_dataset_));
  while (!bytes.empty()) {
    if (waiting_.empty() && bytes.size() >= at_once_) {
      if (!write(bytes.first(at_once_))) return false;
      bytes = bytes.subspan(at_once_);
      continue;
    }
    const std::size_t n = std::min(bytes.size(), at_once_ - waiting_.size());
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));
    bytes = bytes.subspan(n);
    if (waiting_.size() < at_once_) break;
    if (!write(waiting_)) return false;
    waiting_.clear();
  }
  return true;
}

bool ChunkWriter::finish() {
  const bool taken = write(waiting_);
  waiting_.clear();
  return taken;
}

bool ChunkWriter::write(std::span<const unsigned char> bytes) {
  const std::size_t count = (bytes.size() + chunk_bytes_ - 1) / chunk_bytes_;
  std::vector<std::vector<unsigned char>> deflated(count);
  const int threads = std::clamp(static_cast<int>(count), 1, threads_);
  parallel_for(count, {threads, nullptr}, [&](std::size_t i, int) {
    const std::size_t begin = i * chunk_bytes_;
    if (begin + chunk_bytes_ <= bytes.size()) {
      deflated[i] = deflated_chunk(bytes.subspan(begin, chunk_bytes_), element_bytes_, level_);
      return;
    }
    // In the file the last chunk is as long as the others.
    std::vector<unsigned char> filled(chunk_bytes_, 0);
    std::ranges::copy(bytes.subspan(begin), filled.begin());
    deflated[i] = deflated_chunk(filled, element_bytes_, level_);
  });
  for (const std::vector<unsigned char>& chunk : deflated) {
    if (H5Dwrite_chunk(dataset_, H5P_DEFAULT, 0, next_.data(), chunk.size(), chunk.data()) < 0) {
      return false;
    }
    next_[0] += rows_;
  }
  return true;
}

}  // namespace plastica::io::h5
