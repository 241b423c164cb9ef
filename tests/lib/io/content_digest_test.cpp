#include "plastica/io/content_digest.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "plastica/io/digest.hpp"
#include "plastica/io/hdf5.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

constexpr std::string_view kSignature = "\211HDF\r\n\032\n";

class ContentDigest : public ::testing::Test {
 protected:
  void SetUp() override {
    Hdf5File file = Hdf5File::create(path_);
    file.root().write("x", std::vector<double>{1.0, -2.0, 3.0});
    file.root().set_attribute(".", "schema", "plastica/test");
    file.commit();
    bytes_ = content_of(path_);
  }

  /// What opening says of these bytes; empty if they are taken.
  std::string on_opening(const std::string& bytes) const {
    folder_.write("a.h5", bytes);
    try {
      Hdf5File::open(path_);
    } catch (const InputError& error) {
      return error.rule();
    }
    return "";
  }

  ScratchFolder folder_;
  std::string path_ = folder_.file("a.h5");
  std::string bytes_;
};

TEST_F(ContentDigest, StandsInFrontAsText) {
  EXPECT_TRUE(bytes_.starts_with("Plastica result; HDF5 from byte 512 on\nbytes ")) << bytes_;
  EXPECT_EQ(bytes_.substr(kContentOffset, kSignature.size()), kSignature);
  EXPECT_TRUE(check_content_digest(path_));
  EXPECT_EQ(on_opening(bytes_), "");
}

TEST_F(ContentDigest, FindsABitThatIsFlippedInEveryPlace) {
  // One in each byte of the text in front, and some hundreds of the rest.
  constexpr std::size_t kFront = 100;
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < kFront + 300; ++i) {
    const std::size_t byte = i < kFront ? i : kFront + random() % (bytes_.size() - kFront);
    std::string damaged = bytes_;
    damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << (random() % 8)));
    folder_.write("a.h5", damaged);
    EXPECT_THROW(check_content_digest(path_), InputError) << "byte " << byte;
  }
}

TEST_F(ContentDigest, FindsWhatIsCutOffAddedOrSwapped) {
  EXPECT_EQ(on_opening(bytes_.substr(0, bytes_.size() - 1)),
            "is cut off: of " + std::to_string(bytes_.size()) + " bytes " +
                std::to_string(bytes_.size() - 1) + " are left");
  constexpr std::string_view kDiffers =
      "is damaged, or was changed by another program: it differs from its digest";
  EXPECT_EQ(on_opening(bytes_ + "x"), kDiffers);
  std::string swapped = bytes_;
  std::swap_ranges(swapped.begin() + 512, swapped.begin() + 520, swapped.begin() + 600);
  EXPECT_EQ(on_opening(swapped), kDiffers);
  std::string other_front = bytes_;
  other_front[3] = 'X';
  EXPECT_EQ(on_opening(other_front),
            "is damaged: what stands in front of its HDF5 part is not what Plastica writes");
  EXPECT_EQ(on_opening("text"), "is not an HDF5 file");
  EXPECT_EQ(on_opening(""), "is not an HDF5 file");
}

TEST_F(ContentDigest, IsNotAskedOfFilesWithoutABlock) {
  EXPECT_EQ(on_opening(bytes_.substr(kContentOffset)), "");
  EXPECT_FALSE(check_content_digest(path_));
}

TEST_F(ContentDigest, TellsAResultByItsBeginning) {
  const auto begins = [&](const std::string& content) {
    on_opening(content);
    return begins_as_result(path_);
  };
  EXPECT_TRUE(begins(bytes_));
  EXPECT_TRUE(begins(bytes_.substr(0, bytes_.size() / 2)));
  EXPECT_TRUE(begins(bytes_.substr(kContentOffset)));
  EXPECT_FALSE(begins("text"));
  EXPECT_FALSE(begins(""));
  EXPECT_FALSE(begins_as_result("/dev/zero"));
  EXPECT_FALSE(begins_as_result("/tmp/none"));
}

TEST_F(ContentDigest, IsOfRegularFiles) {
  EXPECT_EQ(message_from<InputError>([] { check_content_digest("/dev/zero"); }),
            "/dev/zero: is no regular file");
  EXPECT_EQ(message_from<InputError>([] { check_content_digest("/tmp"); }),
            "/tmp: cannot be read: it is a folder");
}

/// Of FNV-1a, under another word.
TEST_F(ContentDigest, IsCheckedInFilesOfOlderVersions) {
  const std::string content = bytes_.substr(kContentOffset);
  const Digest digest = Digest().bytes(std::as_bytes(std::span(content)));
  std::string block = "Plastica result; HDF5 from byte 512 on\nbytes " +
                      std::to_string(content.size()) + "\ndigest " + hexadecimal(digest.value()) +
                      "\n";
  block.resize(kContentOffset, '\0');
  EXPECT_EQ(on_opening(block + content), "");
  std::string damaged = block + content;
  damaged[kContentOffset + content.size() / 2] ^= 4;
  EXPECT_NE(on_opening(damaged), "");
}

}  // namespace
}  // namespace plastica::io
