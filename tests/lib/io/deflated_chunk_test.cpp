#include "plastica/io/deflated_chunk.hpp"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>

#include "plastica/io/hdf5.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

std::vector<double> measured(std::size_t count) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, 0.1);
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i % 600) / 600.0;
    values[i] = 300.0 * std::tanh(5.0 * x) + noise(random);
  }
  return values;
}

TEST(DeflatedChunk, IsShortWhereElementsAreAlike) {
  const std::vector<unsigned char> alike(32768, 7);
  EXPECT_LT(deflated_chunk(alike, 8, 1).size(), 300U);
  // Numbers that grow by one: their first bytes differ, the others stand side by side.
  std::vector<unsigned char> ramp(4 * 8192, 0);
  for (std::size_t i = 0; i < 8192; ++i) {
    ramp[4 * i] = static_cast<unsigned char>(i % 256);
    ramp[4 * i + 1] = static_cast<unsigned char>(i / 256);
  }
  EXPECT_LT(deflated_chunk(ramp, 4, 1).size(), ramp.size() / 40);
}

TEST(DeflatedChunk, IsTheSameForTheSameElements) {
  std::mt19937_64 random(3);
  std::vector<unsigned char> noise(8 * 4096);
  for (unsigned char& byte : noise) byte = static_cast<unsigned char>(random());
  EXPECT_EQ(deflated_chunk(noise, 8, 1), deflated_chunk(noise, 8, 1));
  EXPECT_LT(deflated_chunk(noise, 8, 1).size(), noise.size() + 100);
}

/// What is stored as it is takes no more room than deflate finds it to have, to a hundredth, and
/// can be read: noise alone, digits of measured numbers, and digits that come again.
TEST(DeflatedChunk, StoresNoiseAndNothingElse) {
  constexpr std::size_t kCount = 32768;
  std::vector<double> repeated = measured(600);
  while (repeated.size() < kCount) repeated.push_back(repeated[repeated.size() - 600]);
  std::mt19937_64 random(3);
  std::vector<double> noise(kCount);
  for (double& value : noise) value = std::bit_cast<double>(random() >> 2U);
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(1);
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  for (const std::vector<double>& values : {noise, measured(kCount), repeated}) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(values.data());
    const std::size_t size = values.size() * sizeof(double);
    const std::vector<unsigned char> stream = deflated_chunk({bytes, size}, sizeof(double), 1);
    std::vector<unsigned char> planes(size);
    ASSERT_EQ(libdeflate_zlib_decompress(decompressor, stream.data(), stream.size(), planes.data(),
                                         size, nullptr),
              LIBDEFLATE_SUCCESS);
    for (std::size_t i = 0; i < size; ++i) {
      ASSERT_EQ(planes[(i % sizeof(double)) * kCount + i / sizeof(double)], bytes[i]);
    }
    std::vector<unsigned char> all(libdeflate_zlib_compress_bound(compressor, size));
    const std::size_t least =
        libdeflate_zlib_compress(compressor, planes.data(), size, all.data(), all.size());
    EXPECT_LT(static_cast<double>(stream.size()), 1.01 * static_cast<double>(least));
  }
  libdeflate_free_compressor(compressor);
  libdeflate_free_decompressor(decompressor);
}

TEST(DeflatedChunk, RefusesPartsOfElements) {
  EXPECT_THROW(deflated_chunk(std::vector<unsigned char>(9), 8, 1), std::logic_error);
  EXPECT_THROW(deflated_chunk(std::vector<unsigned char>(8), 0, 1), std::logic_error);
}

/// HDF5's own filters read what is written here. Lengths around whole chunks of 256 KiB, where the
/// last is filled up in the file alone, and more than is deflated at once.
TEST(DeflatedChunk, StandsInFilesThatHdf5Reads) {
  const ScratchFolder folder;
  for (const std::size_t count : {513U, 32767U, 32768U, 32769U, 3U * 32768U, 270'001U}) {
    const std::string path = folder.file("a.h5");
    const std::vector<double> values = measured(count);
    const std::size_t shape[] = {count / 9, 3, 3};
    const std::vector<double> cut(values.begin(),
                                  values.begin() + static_cast<std::ptrdiff_t>(9 * (count / 9)));
    std::vector<std::uint8_t> small(count);
    for (std::size_t i = 0; i < count; ++i) small[i] = static_cast<std::uint8_t>(i * i);
    std::string files[2];
    for (const int threads : {1, 3}) {
      Hdf5File file = Hdf5File::create(path, Overwrite::Allowed, threads);
      file.root().write("values", values, {.units = "Pa", .deflate = 1});
      file.root().write("small", small, {.units = {}, .deflate = 9});
      file.root().group("within").write_table<double>("table", cut, 3, {{}, 1});
      file.root().write_array<double>("array", cut, shape, {{}, 1});
      file.commit();
      const Hdf5File read = Hdf5File::open(path);
      EXPECT_EQ(read.root().read<double>("values"), values);
      EXPECT_EQ(read.root().read<std::uint8_t>("small"), small);
      const std::size_t table[] = {cut.size() / 3, 3};
      EXPECT_EQ(read.root().read_array<double>("within/table", table), cut);
      EXPECT_EQ(read.root().read_array<double>("array", shape), cut);
      files[threads == 1 ? 0 : 1] = content_of(path);
    }
    EXPECT_TRUE(files[0] == files[1]) << count;
  }
}

}  // namespace
}  // namespace plastica::io
