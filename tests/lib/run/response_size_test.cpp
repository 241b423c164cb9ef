#include "plastica/run/response_size.hpp"

#include <gtest/gtest.h>

#include <string>

#include "plastica/base/check.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/scene.hpp"

namespace plastica {
namespace {

using testing::add_probe;

/// Bytes of the numbers that a response really has.
std::size_t bytes_of(const Response& response) {
  const ChainHistory& chain = response.chain;
  const auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
  std::size_t bytes = 0;
  for (const auto& probe : response.probes) bytes += of(probe);
  return bytes + of(chain.time) + of(chain.factor) + of(chain.energy) + of(chain.iterations) +
         of(chain.frame_sample) + of(chain.position) + of(chain.moment) + of(chain.force) +
         of(chain.angle) + of(chain.plastic_angle) + of(chain.rotation) + of(chain.velocity) +
         of(chain.spin) + of(chain.plastic_strain) + of(chain.stress) + of(chain.reaction);
}

void expect_size(const Scene& scene, const SolverOptions& options, Level level) {
  const Model model = prepare(scene, options);
  ASSERT_EQ(model.level, level);
  const ResponseSize size = response_size(scene, options);
  EXPECT_EQ(size, response_size(model));
  const Response response = make_response(model);
  EXPECT_EQ(size.bytes(), bytes_of(response));
  EXPECT_GT(size.bytes(), 0U);
  EXPECT_EQ(size.probes, response.probes.size());
  EXPECT_EQ(size.frames, response.chain.frame_sample.size());
  EXPECT_EQ(size.segments + (scene.is_coupon() ? 0 : 1), response.chain.joints);
}

Load pull(std::array<double, 3> force) {
  Load load;
  load.at = Place::end();
  load.force = force;
  return load;
}

Scene of_level(Level level) {
  Scene scene = testing::cantilever_scene(7);
  if (level == Level::Twist) {
    scene.loads.push_back(pull({}));
    scene.loads[0].moment = {0.0, 0.0, 1.0};
  } else {
    scene.loads.push_back(pull({level == Level::Spatial ? 0.5 : 0.0, 1.0, 0.0}));
  }
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Elastic});
  scene.supports.back().stiffness = {0.0, 10.0, 0.0};
  if (level == Level::Twist) scene.supports.pop_back();
  add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::X);
  return scene;
}

TEST(ResponseSize, IsThatOfTheResponseThatIsLaidOut) {
  expect_size(testing::coupon_scene(Deformation::Tension, {0.0, 0.01, 0.02}), {}, Level::Coupon);
  for (const Level level : {Level::Twist, Level::Planar, Level::Spatial}) {
    SolverOptions options;
    for (const int frames : {0, 1, 3, 500}) {
      options.frames = frames;
      options.steps = 13;
      expect_size(of_level(level), options, level);
    }
  }
}

TEST(ResponseSize, OfAMotionCountsItsFrames) {
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::ArticulatedEuler}) {
    for (const int frames : {0, 1, 10, 25}) {
      SolverOptions options = testing::motion_options(scheme, 1e-4, 25);
      options.frames = frames;
      Scene scene = testing::struck_scene(9, 1.0, YieldModel::Elastic);
      expect_size(scene, options, Level::Planar);
      add_probe(scene, ProbeQuantity::Velocity, Place::end(), Component::Y);
      add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::Y);
      expect_size(scene, options, Level::Planar);
    }
  }
}

TEST(ResponseSize, OfSegmentsOfAnyLengthCountsThem) {
  Scene scene = of_level(Level::Planar);
  scene.beam.segments = 4;
  scene.beam.segment_fractions = {0.1, 0.2, 0.3, 0.4};
  expect_size(scene, {}, Level::Planar);
}

TEST(CheckMemory, RefusesWhatDoesNotFitAndSaysWhatHelps) {
  Scene scene = of_level(Level::Planar);
  scene.beam.segments = 10'000'000;
  SolverOptions options;
  options.steps = 1000;
  EXPECT_NO_THROW(check_memory(scene, options, std::size_t{1} << 50));
  try {
    check_memory(scene, options, 24'000'000'000);
    FAIL() << "1.6 TB in 24 GB";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "beam.segments = 10000000: takes 1.62 TB of memory, and the machine has 24 GB: "
              "1001 samples, the shape of 1001 kept; fewer segments, solver.steps or "
              "solver.frames take less");
  }
  options.frames = 1;
  EXPECT_NO_THROW(check_memory(scene, options, 24'000'000'000));
  const std::vector<double> strain(1000, 0.01);
  EXPECT_THROW(check_memory(testing::coupon_scene(Deformation::Tension, strain), {}, 7999),
               InputError);
}

TEST(CheckMemory, AddsUpTheLargestThatMayMeet) {
  EXPECT_NO_THROW(check_memory({3, 50, 7, 40}, 2, 90));
  EXPECT_NO_THROW(check_memory({3, 50, 7, 40}, 8, 100));
  EXPECT_NO_THROW(check_memory({}, 4, 0));
  try {
    check_memory({3'000'000, 50'000'000, 7'000'000, 40'000'000}, 2, 89'000'000);
    FAIL() << "90 MB in 89 MB";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "threads = 2: so many of the largest cases take 90 MB of memory, and the machine has "
              "89 MB: run fewer side by side, or smaller ones");
  }
}

TEST(CheckMemory, HasTheMachinesWhereNoneIsGiven) {
  EXPECT_GT(machine_memory(), std::size_t{1} << 26);
  Scene scene = of_level(Level::Planar);
  scene.beam.segments = 10'000'000;
  SolverOptions options;
  options.steps = 10'000'000;
  EXPECT_THROW(check_memory(scene, options), InputError);
  EXPECT_THROW(simulate(scene, options), InputError);
}

TEST(BytesText, HasThreeDigitsAndAUnit) {
  EXPECT_EQ(bytes_text(0), "0 B");
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(3'360'000'000), "3.36 GB");
  EXPECT_EQ(bytes_text(999'600), "1 MB");
  EXPECT_EQ(bytes_text(25'000'000'000'000), "25 TB");
}

}  // namespace
}  // namespace plastica
