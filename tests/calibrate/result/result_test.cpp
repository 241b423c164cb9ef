#include "calibrate/result/result.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace plastica::calibrate {
namespace {

TEST(FitResult, NamesItsStatus) {
  EXPECT_EQ(name_of(FitStatus::Fitted), "fitted");
  EXPECT_EQ(name_of(FitStatus::Failed), "failed");
  EXPECT_EQ(name_of(FitStatus::Rejected), "rejected");
}

TEST(FitResult, FindsAParameterByName) {
  FitResult result;
  result.parameters.resize(2);
  result.parameters[1].path = "material.yield_stress";
  EXPECT_EQ(&result.parameter("yield_stress"), &result.parameters[1]);
  EXPECT_THROW(result.parameter("break_strain"), std::out_of_range);
}

}  // namespace
}  // namespace plastica::calibrate
