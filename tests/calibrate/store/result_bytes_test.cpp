#include "calibrate/store/result_bytes.hpp"

#include <gtest/gtest.h>

#include "calibrate/fit/fitted_curve.hpp"
#include "plastica/io/storage_error.hpp"
#include "tests/calibrate/store/same_bits.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/calibrate/store/synthetic_scene_fits.hpp"

namespace plastica::calibrate {
namespace {

/// Results of one kind of fits: full and partly empty ones, and one value that differs in a bit.
struct CurveFits {
  using Result = FitResult;
  static std::vector<Result> results() {
    FitResult failed;
    failed.status = FitStatus::Failed;
    failed.trace = {{1}, {2.0}, {INFINITY}, 0, 0};
    std::vector<FitResult> all{filled_record("Stab-ä").result, rejected_record("b").result, failed,
                               FitResult()};
    for (FitResult& result : all) count_alone(result);  // of curves no more is kept
    return all;
  }
  static void change_a_bit(Result& result) { result.trace.values[5] = 0.0; }  // was -0.0
};

struct SceneFits {
  using Result = SceneFitResult;
  static std::vector<Result> results() {
    return {filled_scene_record("a").result, failed_scene_record("b").result, SceneFitResult()};
  }
  static void change_a_bit(Result& result) { result.targets[0].fitted[0] = -0.0; }  // was 0.0
};

template <typename Fits>
class ResultBytes : public ::testing::Test {
 protected:
  using Result = typename Fits::Result;

  static Result back(std::span<const std::byte> bytes) { return result_from_bytes<Result>(bytes); }

  std::vector<Result> results_ = Fits::results();
};

using Kinds = ::testing::Types<CurveFits, SceneFits>;
TYPED_TEST_SUITE(ResultBytes, Kinds);

TYPED_TEST(ResultBytes, GiveBackEveryFieldBitByBit) {
  for (const auto& result : this->results_) {
    EXPECT_TRUE(same_bits(this->back(bytes_of(result)), result));
  }
}

TYPED_TEST(ResultBytes, TellApartResultsThatDifferInASingleBit) {
  auto result = this->results_[0];
  const auto before = bytes_of(result);
  TypeParam::change_a_bit(result);
  EXPECT_NE(bytes_of(result), before);
  EXPECT_FALSE(same_bits(this->back(before), result));
}

TYPED_TEST(ResultBytes, AreRefusedIfCutAnywhereOrTooLong) {
  auto bytes = bytes_of(this->results_[0]);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(this->back(std::span(bytes).first(size)), io::StorageError) << size;
  }
  bytes.push_back(std::byte{0});
  EXPECT_THROW(this->back(bytes), io::StorageError);
}

TYPED_TEST(ResultBytes, AreRefusedIfOfAnotherVersion) {
  auto bytes = bytes_of(this->results_[0]);
  bytes[0] = std::byte{kResultVersion + 1};
  EXPECT_THROW(this->back(bytes), io::StorageError);
}

TYPED_TEST(ResultBytes, OfADamagedCountAskForNoMemory) {
  auto bytes = bytes_of(this->results_[0]);
  // After the version stands the number of parameters.
  for (std::size_t i = 4; i < 12; ++i) bytes[i] = std::byte{0xff};
  EXPECT_THROW(this->back(bytes), io::StorageError);
}

}  // namespace
}  // namespace plastica::calibrate
