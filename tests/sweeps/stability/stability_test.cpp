#include "sweeps/stability/stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "sweeps/stability/scan.hpp"
#include "sweeps/stability/stability_map.hpp"
#include "sweeps/stability/summary.hpp"

namespace plastica::sweeps::stability {
namespace {

TEST(StabilityPoints, AreMoreThanTwoThousandAndNoneTwice) {
  std::set<std::string> ids;
  for (const StabilityPoint& point : stability_points()) {
    EXPECT_TRUE(ids.insert(point.id).second) << point.id;
    EXPECT_LE(point.segment_steps, 1e9) << point.id;
  }
  EXPECT_GE(ids.size(), 2000U);
}

TEST(StabilityPoints, ReachEveryEdgeAndEveryLevel) {
  std::set<std::string> ids;
  for (const StabilityPoint& point : stability_points()) ids.insert(point.id);
  for (const char* id :
       {"coupon torsion/poisson=0.5", "twist torque/segments=1e+05",
        "planar tip force/modulus=1000", "planar roll-up/length=1e-06", "planar hinge/load=1e+06",
        "planar rest/steps=1e+07", "planar reversed/reversal=1", "planar spin/spin=10000",
        "planar bursts/normal", "planar vibration/time step=1e-08",
        "spatial flight/mass ratio=1e+06", "spatial struck/damping=10000",
        "spatial interaction/yield=inf"}) {
    EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(StabilityPoints, HaveANormalPointThatIsValidInEveryScene) {
  const auto rows = run_stability({.only = {"/normal"}, .threads = 1});
  EXPECT_EQ(rows.size(), base_scenes().size());
  for (const StabilityRow& row : rows) {
    EXPECT_EQ(row.verdict.validity, Validity::Valid) << row.id << ": " << row.verdict.reason;
  }
}

TEST(RunStability, DrawsTheSameSampleForASeed) {
  StabilityOptions options{.only = {"coupon"}, .sample = 20, .threads = 1};
  const auto ids = [&] {
    std::vector<std::string> all;
    for (const StabilityRow& row : run_stability(options)) all.push_back(row.id);
    return all;
  };
  const auto first = ids();
  EXPECT_EQ(first.size(), 20U);
  EXPECT_EQ(ids(), first);
  options.seed = 2;
  EXPECT_NE(ids(), first);
}

TEST(RunStability, TellsOfBadInputAndOfAStop) {
  const auto rows = run_stability({.only = {"coupon tension/yield=0"}, .threads = 1});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].status, Status::Rejected);
  EXPECT_EQ(rows[0].verdict.validity, Validity::Failed);
  EXPECT_NE(rows[0].verdict.reason.find("material.yield_stress"), std::string::npos);
  const std::atomic<bool> stop{true};
  const auto none = run_stability({.only = {"coupon tension"}, .threads = 1, .stop = &stop});
  EXPECT_FALSE(none.empty());
  EXPECT_TRUE(std::none_of(none.begin(), none.end(), [](const auto& row) { return row.begun; }));
}

TEST(StabilitySummary, FindsTheRangeAroundTheNormalValue) {
  auto rows = run_stability({.only = {"twist torque/normal", "twist torque/load="}, .threads = 1});
  const auto range_of = [&](const std::string& axis) {
    for (const SafeRange& range : safe_ranges(rows)) {
      if (range.axis == axis) return range;
    }
    return SafeRange{};
  };
  EXPECT_EQ(range_of("load").low, 1e-6);
  EXPECT_TRUE(range_of("load").open_low);
  EXPECT_GE(range_of("load").high, 1e3);
  // The normal value is 0.5: a bad point at 10 ends the range at 3, one at 1e-4 at 1e-2.
  for (StabilityRow& row : rows) {
    if (row.id.ends_with("load=10") || row.id.ends_with("load=0.0001")) {
      row.verdict.validity = Validity::Inaccurate;
    }
  }
  EXPECT_EQ(range_of("load").low, 1e-2);
  EXPECT_EQ(range_of("load").high, 3.0);
  EXPECT_FALSE(range_of("load").open_high);
  EXPECT_NE(summary_text(rows).find("| load | 0.01 … 3 |"), std::string::npos)
      << summary_text(rows);
  EXPECT_NE(rows_csv(rows).find("twist torque/load=10,twist torque,twist,statics,load,10,,,"),
            std::string::npos);
  EXPECT_NE(stability_map(rows).text().find("inaccurate"), std::string::npos);
}

}  // namespace
}  // namespace plastica::sweeps::stability
