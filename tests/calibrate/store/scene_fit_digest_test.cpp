#include "calibrate/store/scene_fit_digest.hpp"

#include <gtest/gtest.h>

namespace plastica::calibrate {
namespace {

std::uint64_t digest_of(const SceneTarget& target) {
  io::Digest digest;
  add_to(digest, target);
  return digest.value();
}

/// The samples are the same, and what is stored and said of them is not.
TEST(SceneFitDigest, TellsRepairsAndWarningsApart) {
  SceneTarget target;
  target.abscissa = target.ordinate = {0.0, 1.0};
  const std::uint64_t clean = digest_of(target);
  target.repairs = {{"nan-rows", 1, "1 rows"}};
  const std::uint64_t repaired = digest_of(target);
  EXPECT_NE(repaired, clean);
  target.repairs[0].count = 2;
  EXPECT_NE(digest_of(target), repaired);
  target.repairs.clear();
  target.warnings = {"strains above 100 %"};
  EXPECT_NE(digest_of(target), clean);
}

TEST(SceneFitDigest, TellsObjectivesAndAlgorithmsApart) {
  const auto of = [](const SceneFitOptions& options) {
    io::Digest digest;
    add_to(digest, options);
    return digest.value();
  };
  SceneFitOptions options;
  const std::uint64_t usual = of(options);
  options.objective = Objective::Path;
  EXPECT_NE(of(options), usual);
  options = {};
  options.algorithm = "bobyqa";
  EXPECT_NE(of(options), usual);
}

}  // namespace
}  // namespace plastica::calibrate
