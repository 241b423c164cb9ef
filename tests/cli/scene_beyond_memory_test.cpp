#include <gtest/gtest.h>

#include "tests/cli/command.hpp"
#include "tests/support/has.hpp"

/// Scenes whose response no machine has memory for.
namespace plastica::testing {
namespace {

/// 1.6 GB of shapes a segment.
std::string beam(const std::string& segments) {
  return "[beam]\nlength = '4 m'\nsegments = " + segments +
         "\nsection = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
         "[material]\nname = 'S355'\n"
         "[[support]]\nat = 'start'\nkind = 'clamp'\n"
         "[[load]]\nat = 'end'\nforce = ['0 N', '-100 N', '0 N']\nhistory = 'ramp'\n"
         "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = 'y'\n"
         "[solver]\nsteps = 10000000\n";
}

TEST(SceneBeyondMemory, IsForetoldWithoutTakingIt) {
  const Workplace place;
  place.write("beam.toml", beam("10000"));
  const CommandResult result = place.run({"simulate", "beam.toml", "--dry-run"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.out,
                  "10000 segments, 1 support, 1 load, 10000001 samples, 1 probe, "
                  "about 16"))
      << result.out;
  EXPECT_TRUE(has(result.out, "a run is refused: beam.segments = 10000: takes 16 TB"))
      << result.out;
}

TEST(SceneBeyondMemory, IsRefusedBeforeItRuns) {
  const Workplace place;
  place.write("beam.toml", beam("10000"));
  const CommandResult result = place.run({"simulate", "beam.toml", "-o", "beam.h5"});
  EXPECT_EQ(result.code, 2) << result.err;
  EXPECT_TRUE(
      has(result.err, "plastica: beam.toml:3: beam.segments = 10000: takes 16 TB of memory"))
      << result.err;
  EXPECT_TRUE(has(result.err, "fewer segments, solver.steps or solver.frames take less\n"));
  EXPECT_EQ(lines_of(result.err), 1U);
  EXPECT_FALSE(place.has("beam.h5"));
}

TEST(SceneBeyondMemory, IsRefusedInASweepToo) {
  const Workplace place;
  place.write("beam.toml", beam("4"));
  place.write("sweep.toml",
              "scene = 'beam.toml'\n[[axis]]\nfield = 'beam.segments'\nvalues = [4, 10000]\n"
              "[error]\nprobe = 'tip'\n");
  const CommandResult foretold = place.run({"sweep", "sweep.toml", "--dry-run"});
  EXPECT_EQ(foretold.code, 0) << foretold.err;
  EXPECT_TRUE(has(foretold.out, "its run takes about 16")) << foretold.out;
  const CommandResult result = place.run({"sweep", "sweep.toml", "-o", "out.h5"});
  EXPECT_EQ(result.code, 2) << result.err;
  EXPECT_TRUE(has(result.err, "beam.segments = 10000: takes 16 TB")) << result.err;
  EXPECT_FALSE(place.has("out.h5"));
}

}  // namespace
}  // namespace plastica::testing
