#include "calibrate/config/templates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plastica/io/csv.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

TEST(Templates, RunAsTheyAre) {
  const auto scene = template_files("coupon");
  ASSERT_EQ(scene.size(), 1U);
  const auto file = io::parse_scene_file(scene[0].text, scene[0].name);
  EXPECT_EQ(file.setup.scene.drive.strain.size(), 304U);
  EXPECT_EQ(file.setup.scene.probes.size(), 3U);
  const Response response = simulate(file.setup.scene, file.setup.solver);
  ASSERT_TRUE(response.event);
  EXPECT_GT(response.event->strain, 0.03);
}

TEST(Templates, BeginAChainWithACantilever) {
  const auto scene = template_files("scene");
  ASSERT_EQ(scene.size(), 1U);
  const auto setup = io::parse_scene_file(scene[0].text, scene[0].name).setup;
  EXPECT_FALSE(setup.scene.is_coupon());
  EXPECT_EQ(setup.scene.beam.segments, 32);
  ASSERT_EQ(setup.scene.supports.size(), 1U);
  EXPECT_EQ(setup.scene.supports[0].kind, SupportKind::Clamp);
  ASSERT_EQ(setup.scene.loads.size(), 1U);
  EXPECT_EQ(setup.scene.loads[0].force[1], -140.0);
  EXPECT_EQ(setup.scene.probes.size(), 3U);
  EXPECT_EQ(choose_level(setup.scene, setup.solver).reason,
            "planar: every load, support and joint axis lies in the y-z plane");
}

TEST(Templates, BringTheShippedBendTest) {
  const auto files = template_files("scene-fit");
  ASSERT_EQ(files.size(), 3U);
  const std::string data = std::string(PLASTICA_SOURCE_DIR) + "/data/";
  EXPECT_EQ(files[1].text, io::read_text_file(data + "scenes/" + files[1].name));
  EXPECT_EQ(files[2].text, io::read_text_file(data + "targets/" + files[2].name));
}

TEST(Templates, AreListedByKind) {
  for (const auto kind : template_kinds()) EXPECT_FALSE(template_files(kind).empty());
  EXPECT_EQ(testing::message_of([] { template_files("fits"); }),
            "init = fits: must be one of fit, scene-fit, scene, coupon");
}

TEST(ExampleCurve, HasTheFormOfATensionTestWithABreak) {
  const auto table = io::CsvTable::parse(example_curve(), "example-curve.csv");
  EXPECT_EQ(table.names(), (std::vector<std::string>{"Strain", "Stress"}));
  EXPECT_EQ(table.units(), (std::vector<std::string>{"%", "MPa"}));
  const auto strain = table.numbers(0);
  const auto stress = table.numbers(1);
  ASSERT_EQ(strain.size(), 112U);
  double sum = 0.0;
  double square = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    if (strain[i] > 2.175) {
      EXPECT_EQ(stress[i], 0.0);
      continue;
    }
    const double noise = stress[i] - std::min(2000.0 * strain[i], 350.0);
    sum += noise;
    square += noise * noise;
    ++count;
  }
  EXPECT_EQ(count, 109U);
  // Three standard errors of mean and variance of that many numbers with variance 1.
  EXPECT_LT(std::abs(sum / 109.0), 0.29);
  EXPECT_NEAR(square / 109.0, 1.0, 0.41);
}

TEST(ExampleCurve, IsTheSameEveryTime) {
  EXPECT_EQ(example_curve(), example_curve());
  EXPECT_TRUE(example_curve().starts_with("Strain (%),Stress (MPa)\n0.00,"));
}

}  // namespace
}  // namespace plastica::calibrate
