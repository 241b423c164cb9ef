#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plastica/io/hdf5.hpp"
#include "plastica/io/hdf5_handle.hpp"

/// How long datasets are cut into chunks, shuffled and deflated; for the sources of this folder.
namespace plastica::io::h5 {

/// Sets chunks of about 256 KiB: whole rows, all that has one index in the first dimension.
/// @param shape  of a dataset that is not empty
void set_chunks(hid_t creation, std::span<const std::size_t> shape, std::size_t element_bytes);

/// Writes a dataset that has such chunks, in order, each deflated by itself, several at a time.
class ChunkWriter {
 public:
  /// @param dataset  that has just been created by `creation`, with shuffle and deflate; outlives
  ///                 this
  /// @param threads  0: as many as the machine has; changes no byte
  ChunkWriter(hid_t dataset, hid_t creation, std::span<const std::size_t> shape,
              std::size_t element_bytes, int level, int threads);

  /// Takes what comes next, as in the file. @return whether HDF5 took what was ready
  bool append(std::span<const unsigned char> bytes);
  /// Writes what is left, once the dataset is full. @return whether HDF5 took it
  bool finish();

 private:
  bool write(std::span<const unsigned char> bytes);

  hid_t dataset_;
  std::size_t element_bytes_;
  int level_;
  int threads_;
  std::size_t rows_;         // of a chunk
  std::size_t chunk_bytes_;  // of a whole one
  std::size_t bytes_of_dataset_;
  std::size_t at_once_;        // bytes of several
  std::vector<hsize_t> next_;  // where the next chunk begins
  std::vector<unsigned char> waiting_;
};

/// A dataset that has just been created.
struct NewDataset {
  Hdf5Handle dataset;
  std::size_t count = 0;              ///< elements
  std::optional<ChunkWriter> chunks;  ///< empty: it has none
};

}  // namespace plastica::io::h5
