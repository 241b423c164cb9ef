#include "calibrate/store/scene_result_bytes.hpp"

#include <gtest/gtest.h>

#include "plastica/io/storage_error.hpp"
#include "tests/calibrate/store/synthetic_scene_fits.hpp"

namespace plastica::calibrate {
namespace {

TEST(SceneResultBytes, GiveBackEveryFieldBitByBit) {
  for (const SceneFitRecord& record : {filled_scene_record("a"), failed_scene_record("b")}) {
    EXPECT_TRUE(same_bits(scene_result_from_bytes(bytes_of(record.result)), record.result));
  }
}

TEST(SceneResultBytes, GiveBackAnEmptyResult) {
  const SceneFitResult result;
  EXPECT_TRUE(same_bits(scene_result_from_bytes(bytes_of(result)), result));
}

TEST(SceneResultBytes, TellApartResultsThatDifferInASingleBit) {
  SceneFitResult result = filled_scene_record("a").result;
  const auto before = bytes_of(result);
  result.targets[0].fitted[0] = -0.0;  // was 0.0
  EXPECT_NE(bytes_of(result), before);
  EXPECT_FALSE(same_bits(scene_result_from_bytes(before), result));
}

TEST(SceneResultBytes, AreRefusedIfCutAnywhereOrTooLong) {
  auto bytes = bytes_of(filled_scene_record("a").result);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(scene_result_from_bytes(std::span(bytes).first(size)), io::StorageError) << size;
  }
  bytes.push_back(std::byte{0});
  EXPECT_THROW(scene_result_from_bytes(bytes), io::StorageError);
}

TEST(SceneResultBytes, AreRefusedIfOfAnotherVersion) {
  auto bytes = bytes_of(SceneFitResult());
  bytes[0] = std::byte{kSceneResultVersion + 1};
  EXPECT_THROW(scene_result_from_bytes(bytes), io::StorageError);
}

}  // namespace
}  // namespace plastica::calibrate
