#include "calibrate/result/scene_fit_record.hpp"

#include <gtest/gtest.h>

namespace plastica::calibrate {
namespace {

TEST(SceneFitRecord, HasTheWarningsOfItsTargetsBeforeThoseOfTheFit) {
  SceneFitCase one;
  one.targets.resize(2);
  one.targets[1].target.name = "b";
  one.targets[1].target.warnings = {"in percent?"};
  SceneFitResult result;
  result.warnings = {"of the fit"};
  const SceneFitRecord record = record_of(one, result);
  EXPECT_EQ(record.result.warnings, (std::vector<std::string>{"b: in percent?", "of the fit"}));
}

}  // namespace
}  // namespace plastica::calibrate
