#include "calibrate/store/record_bytes.hpp"

#include <gtest/gtest.h>

#include "tests/calibrate/store/same_bits.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"

namespace plastica::calibrate {
namespace {

TEST(RecordBytes, GiveBackEveryFieldOfARecordBitByBit) {
  const FitRecord record = filled_record("Stab-ä");
  EXPECT_TRUE(same_bits(record_from_bytes(bytes_of(record)), record));
}

TEST(RecordBytes, GiveBackAnEmptyRecord) {
  const FitRecord record;
  EXPECT_TRUE(same_bits(record_from_bytes(bytes_of(record)), record));
}

TEST(RecordBytes, GiveBackAResultWithoutItsTarget) {
  const FitResult result = filled_record("a").result;
  EXPECT_TRUE(same_bits(result_from_bytes(bytes_of(result)), result));
}

TEST(RecordBytes, TellApartRecordsThatDifferInASingleBit) {
  FitRecord record = filled_record("a");
  const auto before = bytes_of(record);
  record.target.raw.strain[2] = 0.0;  // was -0.0
  EXPECT_NE(bytes_of(record), before);
  EXPECT_FALSE(same_bits(record_from_bytes(before), record));
}

TEST(RecordBytes, AreRefusedIfCutAnywhere) {
  const auto bytes = bytes_of(filled_record("a").result);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(result_from_bytes(std::span(bytes).first(size)), io::StorageError) << size;
  }
}

TEST(RecordBytes, AreRefusedIfTheyGoOn) {
  auto bytes = bytes_of(FitRecord());
  bytes.push_back(std::byte{0});
  EXPECT_THROW(record_from_bytes(bytes), io::StorageError);
}

TEST(RecordBytes, AreRefusedIfOfAnotherVersion) {
  auto bytes = bytes_of(FitResult());
  bytes[0] = std::byte{kRecordVersion + 1};
  EXPECT_THROW(result_from_bytes(bytes), io::StorageError);
}

TEST(RecordBytes, OfADamagedCountAskForNoMemory) {
  auto bytes = bytes_of(FitResult());
  // After version, status and an empty reason stands the number of parameters.
  for (std::size_t i = 16; i < 24; ++i) bytes[i] = std::byte{0xff};
  EXPECT_THROW(result_from_bytes(bytes), io::StorageError);
}

}  // namespace
}  // namespace plastica::calibrate
