#include <gtest/gtest.h>

#include <cmath>

#include "calibrate/engine/engine_text.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/calibrate/engine/parse_engine_texts.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::testing {
namespace {

using calibrate::engine_text;
using calibrate::EngineBeam;
using calibrate::EngineFormat;
using calibrate::EngineSegment;

Scene loaded_scene() {
  Scene scene = breakable_scene();
  scene.masses = {{{0.5, {}}, 0.8, {0.02, 0.04, 0.06}}, {Place::end(), 1.5, {0.1, 0.2, 0.3}}};
  return scene;
}

TEST(EngineMasses, AreInTheMassCenterAndInertiaOfTheirSegments) {
  const EngineBeam bare = beam_of(breakable_scene());
  const EngineBeam beam = beam_of(loaded_scene());
  EXPECT_FALSE(bare.carries_masses);
  EXPECT_TRUE(beam.carries_masses);
  EXPECT_TRUE(has(beam.notes.back(), "point masses are in the mass"));
  EXPECT_EQ(beam.segments[0].mass, bare.segments[0].mass);
  const double own = bare.segments[0].mass;
  EXPECT_NEAR(beam.segments[1].mass, own + 0.4, 1e-12);
  EXPECT_NEAR(beam.segments[2].mass, own + 0.4, 1e-12);
  const EngineSegment& last = beam.segments[3];
  EXPECT_NEAR(last.mass, own + 1.5, 1e-12);
  // Of a rod and a point at its end: the common center, and inertias about it.
  const double center = (own * 0.875 + 1.5) / (own + 1.5);
  EXPECT_NEAR(last.center()[2], center, 1e-12);
  EXPECT_NEAR(last.inertia[0],
              bare.segments[3].inertia[0] + 0.1 + own * std::pow(center - 0.875, 2) +
                  1.5 * std::pow(1.0 - center, 2),
              1e-12);
  EXPECT_NEAR(last.inertia[2], bare.segments[3].inertia[2] + 0.3, 1e-12);
  EXPECT_NEAR(
      beam.segments[1].inertia[1] + beam.segments[2].inertia[1],
      2.0 * bare.segments[1].inertia[1] + 0.04 + 2.0 * own * 0.4 / (own + 0.4) * 0.125 * 0.125,
      1e-12);
}

TEST(EngineMasses, ReadBackFromTheFormatsThatTakeThem) {
  const EngineBeam beam = beam_of(loaded_scene());
  const ParsedBeam agx = parse_agx(engine_text(beam, EngineFormat::Agx));
  const ParsedBeam chrono = parse_chrono(engine_text(beam, EngineFormat::Chrono));
  const ParsedBeam mjcf = parse_mjcf(engine_text(beam, EngineFormat::Mjcf));
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const EngineSegment& segment = beam.segments[i];
    for (const ParsedBeam* parsed : {&agx, &chrono, &mjcf}) {
      EXPECT_NEAR(parsed->segments[i].mass, segment.mass, 1e-13 * segment.mass);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(parsed->segments[i].inertia[k], segment.inertia[k], 1e-13 * segment.inertia[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(agx.segments[i].center[k], segment.center()[k], 1e-13);
    }
    EXPECT_NEAR(mjcf.segments[i].center[2], segment.center()[2] - segment.start[2], 1e-13);
  }
  // Joints are where they were, as a body sees them whose origin is its center of mass.
  for (const auto& joint : beam.joints) {
    EXPECT_NEAR(agx.joints.at(joint.name).point[2], joint.point[2], 1e-13);
  }
}

TEST(EngineMasses, ThatAFormatDoesNotHoldAreRefused) {
  const EngineBeam beam = beam_of(loaded_scene());
  EXPECT_NO_THROW(engine_text(beam, EngineFormat::Csv));
  EXPECT_EQ(message_of([&] { engine_text(beam, EngineFormat::OpenSees); }),
            "mass: does not go with opensees, whose segments have their mass evenly: csv, mjcf, "
            "agx, bullet and chrono take point masses");
  Scene bent = loaded_scene();
  bent.beam.shape = BeamShape::Arc;
  bent.beam.arc_angle = 1.0;
  EXPECT_EQ(message_of([&] { beam_of(bent); }),
            "mass.inertia: must have principal axes along those of its segment: an export has "
            "moments of inertia about these alone");
}

}  // namespace
}  // namespace plastica::testing
