#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "tests/support/has.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::has;

/// A column along z, which a force presses at its end.
io::SceneRecord column(const std::string& thrust, const std::string& solver) {
  std::string text = testing::cantilever_text("0 N", R"([[load]]
at = "end"
force = ["0 N", "0 N", ")" + thrust + "\"]\n");
  const std::string mark = "steps = 5\n";
  return testing::record_of(text.insert(text.find(mark) + mark.size(), solver));
}

TEST(ModeReport, ShowsBucklingFactorsAndFrequencies) {
  const io::SceneRecord record = column("-1 kN", "buckling = 2\nfrequencies = 1\n");
  const std::string text = scene_report(record);
  EXPECT_TRUE(has(text, "\nBuckling about factor 1, elastic, all forces growing on at its shape\n"))
      << text;
  EXPECT_TRUE(has(text, "\nNatural frequencies about the loaded state, in its plane\n")) << text;
  const auto json = nlohmann::json::parse(scene_json(record));
  EXPECT_EQ(json["buckling"]["about"], 1.0);
  ASSERT_EQ(json["buckling"]["modes"].size(), 2U);
  // pi^2/4 E I/L^2 = 6.9 kN; square, so that it buckles in and out of the plane alike.
  for (const auto& mode : json["buckling"]["modes"]) {
    EXPECT_NEAR(mode["factor"].get<double>(), 6.9, 0.1);
    EXPECT_EQ(mode["mode"].size(), 15U);
  }
  ASSERT_EQ(json["vibration"].size(), 1U);
  EXPECT_GT(json["vibration"][0]["frequency"], 1.0);
}

TEST(ModeReport, SaysWhereNothingIsFound) {
  EXPECT_TRUE(
      has(scene_report(column("1 kN", "buckling = 1\n")), "  none below 1e15 times the load\n"));
  io::SceneRecord record = column("-1 kN", "buckling = 1\n");
  record.response.buckling.reset();
  EXPECT_TRUE(has(scene_report(record),
                  "  none is reported: nothing acts, no equilibrium on the path is stable"));
  record.setup.solver.buckling = 0;
  EXPECT_FALSE(has(scene_report(record), "Buckling"));
  EXPECT_TRUE(nlohmann::json::parse(scene_json(record))["buckling"].is_null());
}

}  // namespace
}  // namespace plastica::report
