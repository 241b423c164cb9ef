#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "tests/support/has.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::cantilever_text;
using plastica::testing::has;
using plastica::testing::record_of;

const std::string kTwoMasses =
    "[[mass]]\nat = 0.5\nmass = '0 kg'\ninertia = ['0 kg m^2', '1 kg m^2', '0 kg m^2']\n"
    "[[mass]]\nat = 'end'\nmass = '2 kg'\n"
    "inertia = ['0.5 kg m^2', '0 kg m^2', '0.02 kg m^2']\n";

TEST(MassReport, ListsMassesBesideSupportsAndLoads) {
  const std::string text = scene_report(record_of(cantilever_text("-1 N", kTwoMasses)));
  EXPECT_TRUE(has(text,
                  "\n  masses          I_y 1 kg m^2 at 0.5; 2 kg, I_x 0.5 kg m^2, I_z 0.02 kg m^2 "
                  "at end\n"))
      << text;
  EXPECT_FALSE(has(scene_report(record_of(cantilever_text())), "masses"));
}

TEST(MassReport, HasThemInItsSummaryForScripts) {
  const auto masses =
      nlohmann::json::parse(scene_json(record_of(cantilever_text("-1 N", kTwoMasses))))["masses"];
  ASSERT_EQ(masses.size(), 2U);
  EXPECT_EQ(masses[0]["at"], 0.5);
  EXPECT_EQ(masses[0]["mass"], 0.0);
  EXPECT_EQ(masses[1]["mass"], 2.0);
  EXPECT_EQ(masses[1]["inertia"], (std::vector<double>{0.5, 0.0, 0.02}));
}

}  // namespace
}  // namespace plastica::report
