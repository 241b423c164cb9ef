#include "plastica/model/scene.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "plastica/model/section_kind.hpp"
#include "tests/support/message.hpp"

namespace plastica {
namespace {

Scene valid_scene() {
  Scene scene;
  scene.drive.strain = {0.0, 0.01};
  return scene;
}

/// The error of a scene that `spoil` has changed.
std::string error_of(const std::function<void(Scene&)>& spoil) {
  Scene scene = valid_scene();
  spoil(scene);
  return testing::message_of([&] { check_scene(scene, {}); });
}

TEST(CheckScene, PassesAValidScene) {
  EXPECT_EQ(error_of([](Scene&) {}), "no error");
}

TEST(CheckScene, RefusesABadMaterialAndABadSection) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.material.yield_stress = 0.0;
            }).rfind("material.yield_stress = 0: ", 0),
            0U);
  EXPECT_EQ(error_of([](Scene& s) { s.section.width = -1.0; }).rfind("section.width = -1: ", 0),
            0U);
}

TEST(CheckScene, RefusesABeamWithoutLengthOrSegments) {
  EXPECT_EQ(error_of([](Scene& s) { s.beam.length = 0.0; }), "beam.length = 0: must be above 0 m");
  EXPECT_EQ(error_of([](Scene& s) { s.beam.segments = 0; }),
            "beam.segments = 0: must be from 1 to 1e+07");
}

TEST(CheckScene, RefusesWhatTheReportHasNoFormulasFor) {
  for (const SectionShape shape : {SectionShape::RoundTube, SectionShape::RectangularTube}) {
    EXPECT_EQ(
        error_of([&](Scene& s) {
          s.formulas = Formulas::Report;
          s.section.shape = shape;
        }),
        "rules.formulas = report: Wendelius' report has formulas for rectangles and circles, none "
        "for " +
            std::string(section_kind(shape).word()));
  }
  EXPECT_EQ(error_of([](Scene& s) {
              s.formulas = Formulas::Report;
              s.yield_cap = YieldCap::FullyPlastic;
            }),
            "rules.yield_cap = fully_plastic: Wendelius' caps are at first yield");
}

TEST(CheckScene, RefusesADriveWithoutFiniteSamples) {
  EXPECT_EQ(error_of([](Scene& s) { s.drive.strain.clear(); }),
            "support: is missing: a scene at rest has supports, or a drive; free flight needs "
            "solver.analysis = \"dynamics\"");
  EXPECT_EQ(
      error_of([](Scene& s) { s.drive.strain[1] = std::numeric_limits<double>::quiet_NaN(); }),
      "drive.strain = nan: must be finite");
}

TEST(CheckScene, RefusesProbesWithoutANameOfTheirOwn) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.probes.push_back({"", ProbeQuantity::Load});
            }),
            "probe[2].name: must not be empty");
  EXPECT_EQ(error_of([](Scene& s) {
              s.probes.push_back({"stress", ProbeQuantity::Load});
            }),
            "probe[2].name = stress: is used by another probe of the scene");
}

}  // namespace
}  // namespace plastica
