#include "sweeps/run/case_result.hpp"

#include <gtest/gtest.h>

namespace plastica::sweeps {
namespace {

/// A beam of four segments that the scene cuts at 1 s, and that breaks at joint 3 at 2 s.
BatchRow cut_and_broken() {
  BatchRow row;
  row.response.status = Status::Broken;
  row.response.chain.joints = 5;
  ChainBreak cut;
  cut.time = 1.0;
  cut.factor = 0.1;
  cut.joints.resize(1);
  cut.joints[0].joint = 2;
  cut.joints[0].cause = BreakCause::Cut;
  ChainBreak broken = cut;
  broken.time = 2.0;
  broken.factor = 0.2;
  broken.joints[0].joint = 3;
  broken.joints[0].cause = BreakCause::BendingX;
  row.response.chain.events = {cut, broken};
  return row;
}

CaseResult result(const BatchRow& row, QuantityKind kind) {
  Quantity quantity;
  quantity.kind = kind;
  return result_of_run(row, quantity);
}

TEST(CaseResult, TakesNoCutOfTheSceneForABreak) {
  BatchRow row = cut_and_broken();
  EXPECT_EQ(result(row, QuantityKind::BreakTime).value, 2.0);
  EXPECT_EQ(result(row, QuantityKind::BreakLoad).value, 0.2);
  EXPECT_EQ(result(row, QuantityKind::BreakPlace).value, 0.75);
  EXPECT_EQ(result(row, QuantityKind::BreakPlace).break_joint, 3);
  row.response.chain.events.pop_back();
  for (const QuantityKind kind :
       {QuantityKind::BreakTime, QuantityKind::BreakLoad, QuantityKind::BreakPlace}) {
    EXPECT_FALSE(result(row, kind).value);
    EXPECT_EQ(result(row, kind).reason, "nothing breaks");
  }
}

TEST(CaseResult, SaysWhereAPathBifurcated) {
  BatchRow row;
  row.response.status = Status::Unstable;
  row.response.chain.joints = 5;
  row.response.critical.emplace();
  row.response.critical->factor = {0.50625, 0.9};
  EXPECT_TRUE(result(row, QuantityKind::LimitLoad)
                  .reason.starts_with("it bifurcates at factor 0.50625: stay below"));
}

TEST(CaseResult, HasNoBreakPlaceOfARunThatEndedBefore) {
  BatchRow row = cut_and_broken();
  row.response.status = Status::NotConverged;
  EXPECT_FALSE(result(row, QuantityKind::BreakPlace).value);
}

}  // namespace
}  // namespace plastica::sweeps
