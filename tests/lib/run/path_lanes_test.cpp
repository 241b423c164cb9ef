#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "plastica/run/batch.hpp"
#include "plastica/run/lane_program.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/lanes_like_alone.hpp"
#include "tests/support/sanitized.hpp"

/// Batches of beams at rest, whose paths are followed side by side: each has the bits that it has
/// alone, whatever the others do.
namespace plastica {
namespace {

using testing::bits_of;
using testing::expect_bits_of_alone;

Load load_at(double fraction, std::array<double, 3> force) {
  Load load;
  load.at = {fraction, {}};
  load.force = force;
  return load;
}

void probe_all(Scene& scene) {
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  testing::add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::X);
}

/// Numbers that differ from case to case.
void vary(Scene& scene, std::size_t i) {
  const double x = static_cast<double>(i);
  scene.material.youngs_modulus *= 1.0 + 0.03 * x;
  scene.material.yield_stress *= 1.0 + 0.02 * x;
  scene.section.height *= 1.0 + 0.005 * x;
}

/// A cantilever that is bent to and fro, beyond first yield.
Scene bent(std::size_t i, YieldModel model, HardeningLaw law = HardeningLaw::Linear) {
  Scene scene = testing::cantilever_scene(6);
  scene.yield_model = model;
  scene.material.hardening.law = law;
  scene.material.hardening.tangent_modulus = 20e9;
  scene.material.hardening.kinematic_fraction = 0.3;
  vary(scene, i);
  scene.loads.push_back(load_at(1.0, {0.0, -1.3 * testing::yield_moment_of(scene), 0.0}));
  scene.loads[0].history = History::turning_points({1.0, -1.0, 0.2});
  probe_all(scene);
  return scene;
}

/// The same, propped at its end and pushed half way: ideal joints hold until two of them yield.
Scene propped(std::size_t i) {
  Scene scene = bent(i, YieldModel::PerAxis, HardeningLaw::Ideal);
  scene.material.hardening = {};
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  const double first_yield = 16.0 / 3.0 * testing::yield_moment_of(scene);
  scene.loads = {load_at(0.5, {0.0, -1.08 * first_yield, 0.0})};
  scene.loads[0].history = History::turning_points({1.0, -1.0, 0.2});
  return scene;
}

/// Three-point bending to the limit of some.
Scene pressed(std::size_t i) {
  Scene scene = testing::chain_scene(8);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.yield_model = YieldModel::PerAxis;
  vary(scene, i);
  const double limit = 4.0 * testing::yield_moment_of(scene);
  scene.loads.push_back(load_at(0.5, {0.0, -(0.8 + 0.03 * static_cast<double>(i)) * limit, 0.0}));
  probe_all(scene);
  return scene;
}

/// An end that is moved and turned by its support, between springs.
Scene moved(std::size_t i) {
  Scene scene = testing::cantilever_scene(5);
  scene.yield_model = YieldModel::PerAxis;
  Support hand{.at = Place::end(), .kind = SupportKind::Clamp};
  hand.hold = HeldFreedoms{false, true, false, true, false, false};
  hand.translation = {0.0, 0.01 + 0.001 * static_cast<double>(i), 0.0};
  hand.rotation = {0.02, 0.0, 0.0};
  hand.history = History::turning_points({1.0, 0.3});
  scene.supports.push_back(hand);
  scene.supports.push_back(
      {.at = {0.6, {}}, .kind = SupportKind::Elastic, .stiffness = {0.0, 2e4, 0.0}});
  vary(scene, i);
  probe_all(scene);
  return scene;
}

/// Bent both ways and twisted by a follower, with its weight.
Scene askew(std::size_t i, YieldModel model) {
  const double x = static_cast<double>(i);
  Scene scene = testing::cantilever_scene(5);
  scene.yield_model = model;
  scene.material.density = 7850.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.loads.push_back(load_at(1.0, {150.0 + 9.0 * x, -200.0, 30.0}));
  scene.loads[0].moment = {0.0, 0.0, 40.0 + 4.0 * x};
  scene.loads[0].follows = i % 2 == 0;
  vary(scene, i);
  probe_all(scene);
  return scene;
}

/// Sixteen cases: more than lanes, so that some wait for a free one, and enough for lanes where
/// every other one has another shape (`fewest_paths`).
template <class MakeScene>
std::vector<BatchCase> sixteen(const MakeScene& make, InstructionSet level) {
  std::vector<BatchCase> cases;
  for (std::size_t i = 0; i < 16; ++i) {
    BatchCase one{std::to_string(i), make(i), {}};
    one.options.isa = level;
    one.options.steps = 3 + static_cast<int>(i % 3);
    cases.push_back(std::move(one));
  }
  // Else both sides of a comparison would run alone.
  const Model first = prepare(cases[0].scene, cases[0].options);
  std::size_t together = 0;
  for (const BatchCase& one : cases) {
    const Model model = prepare(one.scene, one.options);
    EXPECT_TRUE(has_lanes(*model.chain)) << one.id;
    if (same_lanes(*first.chain, *model.chain)) ++together;
  }
  EXPECT_GE(together, 8U);
  return cases;
}

template <class MakeScene>
void expect_lanes_like_alone(const MakeScene& make) {
  for (const InstructionSet level : testing::instruction_sets()) {
    expect_bits_of_alone(sixteen(make, level));
  }
}

TEST(PathLanes, HaveTheBitsOfLoneElasticBeams) {
  expect_lanes_like_alone([](std::size_t i) { return bent(i, YieldModel::Elastic); });
}

TEST(PathLanes, HaveTheBitsOfLoneBeamsThatYield) {
  expect_lanes_like_alone(propped);
  const Response one = testing::completed(propped(3));
  EXPECT_GT(one.permanent_strain, 1e-4);
}

TEST(PathLanes, HaveTheBitsOfLoneBeamsThatHarden) {
  expect_lanes_like_alone([](std::size_t i) { return bent(i, YieldModel::PerAxis); });
  EXPECT_GT(testing::completed(bent(3, YieldModel::PerAxis)).permanent_strain, 1e-4);
}

/// A law with three back stresses, or a table.
Scene curved(std::size_t i, HardeningLaw law, Scene scene) {
  Hardening& hardening = scene.material.hardening;
  hardening = {};
  hardening.law = law;
  if (law == HardeningLaw::Multilinear) {
    hardening.kinematic_fraction = 0.4;
    hardening.plastic_strain = {1e-4, 1e-3, 5e-3};
    hardening.flow_stress = {1.05 * scene.material.yield_stress,
                             (1.1 + 0.01 * static_cast<double>(i)) * scene.material.yield_stress,
                             1.3 * scene.material.yield_stress};
    return scene;
  }
  hardening.saturation_stress = 60e6;
  hardening.saturation_rate = 120.0;
  hardening.backstress_modulus = {30e9, 8e9 + 1e8 * static_cast<double>(i), 0.0};
  hardening.backstress_rate = {600.0, 90.0, 0.0};
  return scene;
}

TEST(PathLanes, HaveTheBitsOfLoneBeamsThatHardenAlongCurves) {
  for (const HardeningLaw law : {HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
    expect_lanes_like_alone(
        [&](std::size_t i) { return curved(i, law, bent(i, YieldModel::PerAxis)); });
    expect_lanes_like_alone(
        [&](std::size_t i) { return curved(i, law, askew(i, YieldModel::PerAxis)); });
  }
}

TEST(PathLanes, HaveTheBitsOfLoneBeamsOnTwoSupports) { expect_lanes_like_alone(pressed); }

TEST(PathLanes, HaveTheBitsOfLoneBeamsThatSupportsMove) { expect_lanes_like_alone(moved); }

TEST(PathLanes, HaveTheBitsOfLoneBeamsInSpace) {
  expect_lanes_like_alone([](std::size_t i) { return askew(i, YieldModel::Elastic); });
  expect_lanes_like_alone([](std::size_t i) { return askew(i, YieldModel::PerAxis); });
}

/// With a thin and soft region, whose end is elsewhere in each case.
Scene with_region(Scene scene, std::size_t i) {
  Region region{
      {0.13 + 0.011 * static_cast<double>(i), {}}, {0.7, {}}, scene.section, scene.material};
  region.section.height *= 0.85;
  region.section.width *= 1.1;
  region.material.youngs_modulus *= 0.7;
  scene.regions.push_back(region);
  return scene;
}

TEST(PathLanes, HaveTheBitsOfLoneBeamsWhoseRegionsEndElsewhere) {
  expect_lanes_like_alone(
      [](std::size_t i) { return with_region(bent(i, YieldModel::PerAxis), i); });
  expect_lanes_like_alone(
      [](std::size_t i) { return with_region(askew(i, YieldModel::PerAxis), i); });
}

TEST(PathLanes, LeaveTheOthersAloneWhenOneEnds) {
  std::vector<BatchCase> cases = sixteen(
      [](std::size_t i) {
        Scene scene = bent(i, YieldModel::PerAxis);
        if (i % 3 == 0) scene.material.break_strain = 2e-3;
        return scene;
      },
      InstructionSet::Auto);
  cases[4].scene.loads[0].force[1] = -1e9;
  cases[5].options.max_iterations = 2;
  std::vector<Status> statuses;
  for (const BatchRow& row : run_batch(cases)) statuses.push_back(row.response.status);
  EXPECT_GT(std::count(statuses.begin(), statuses.end(), Status::Broken), 1);
  EXPECT_GT(std::count(statuses.begin(), statuses.end(), Status::Completed), 1);
  EXPECT_NE(statuses[4], Status::Completed);
  expect_bits_of_alone(cases);
}

TEST(PathLanes, TakeShapesApartInWhateverOrder) {
  std::vector<BatchCase> cases;
  for (std::size_t i = 0; i < (testing::kSanitized ? 26 : 60); ++i) {
    const Scene scene = i % 4 == 0   ? pressed(i / 4)
                        : i % 4 == 1 ? bent(i / 4, YieldModel::PerAxis)
                        : i % 4 == 2 ? askew(i / 4, YieldModel::PerAxis)
                                     : bent(i / 4, YieldModel::Fibre);
    BatchCase one{std::to_string(i), scene, {}};
    one.options.steps = 4;
    if (i % 8 == 1) one.scene.loads[0].at = {0.4, {}};
    if (i % 12 == 0) one.scene.beam.segments = 3;
    cases.push_back(std::move(one));
  }
  std::mt19937 random(3);
  for (const int threads : {1, 3, 8}) {
    if (testing::kSanitized && threads == 8) continue;
    std::shuffle(cases.begin(), cases.end(), random);
    expect_bits_of_alone(cases, threads);
  }
}

TEST(PathLanes, EndWhereNoStepMayBeCut) {
  // Stops that differ in their last place from the first one, which the smallest step equals.
  BatchCase one{"path", bent(0, YieldModel::PerAxis, HardeningLaw::Ideal), {}};
  one.scene.material.hardening = {};
  one.scene.loads[0].force[1] *= 3.0;
  one.options.steps = 11;
  one.options.smallest_step = 1.0;
  const BatchRow alone = run_case(one);
  EXPECT_GT(alone.response.counters.cutbacks, 0);
  EXPECT_NE(alone.response.status, Status::Completed);
  const std::vector<BatchCase> many(8, one);
  for (const BatchRow& row : run_batch(many, {.threads = 1})) {
    EXPECT_TRUE(bits_of(row.response) == bits_of(alone.response));
  }
}

TEST(PathLanes, ShareTheTimeAsTheyShareTheWork) {
  std::vector<Response> responses(2);
  responses[0].counters.iterations = 4;
  responses[0].samples = 5;
  responses[1].counters.iterations = 20;
  responses[1].samples = 9;
  const std::vector<LaneCase> cases{{nullptr, nullptr, nullptr, &responses[0]},
                                    {nullptr, nullptr, nullptr, &responses[1]}};
  share_seconds(8.0, cases);
  EXPECT_EQ(responses[0].seconds, 2.0);
  EXPECT_EQ(responses[1].seconds, 6.0);
}

TEST(PathLanes, StopWhereTheyAreTold) {
  const Model model = prepare(bent(0, YieldModel::PerAxis), {});
  std::vector<Response> responses(3, make_response(model));
  std::vector<Workspace> hooks(3);
  int reported = 0;
  hooks[1].on_progress = [&](double) { return ++reported < 4; };
  std::vector<LaneCase> lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    lanes.push_back({model.chain.get(), &model.material, &hooks[i], &responses[i]});
  }
  const auto program = make_lane_program(*model.chain);
  program->run(lanes);
  EXPECT_EQ(reported, 4);
  EXPECT_EQ(responses[1].status, Status::Interrupted);
  EXPECT_EQ(responses[0].status, Status::Completed);
  EXPECT_TRUE(bits_of(responses[0]) == bits_of(responses[2]));
  // Run once more, fewer of them.
  const auto before = bits_of(responses[0]);
  program->run(std::span(lanes).first(1));
  EXPECT_TRUE(bits_of(responses[0]) == before);
}

TEST(PathLanes, RunOneModelWithManyValues) {
  const Scene scene = bent(0, YieldModel::PerAxis);
  const std::vector<std::string> parameters{"material.yield_stress"};
  const Model model = prepare(scene, {}, parameters);
  std::vector<double> values;
  for (int i = 0; i < 45; ++i) values.push_back(i == 4 ? -1.0 : 200e6 + 1e7 * i);
  const std::vector<Response> together = run_batch(model, values, values.size());
  Workspace workspace = make_workspace(model);
  for (std::size_t i = 0; i < values.size(); ++i) {
    Response alone = make_response(model);
    run(model, {&values[i], 1}, workspace, alone);
    EXPECT_TRUE(bits_of(together[i]) == bits_of(alone)) << i;
  }
  EXPECT_EQ(together[4].status, Status::InvalidParameter);
}

/// Each reason that keeps a scene out of lanes is named.
TEST(PathLanes, SayWhatRunsAlone) {
  const auto riding = [](const Scene& scene, const SolverOptions& options) {
    return riding_of(prepare(scene, options));
  };
  const std::string alone = "one by one: ";
  const SolverOptions at_rest;
  EXPECT_EQ(riding(bent(0, YieldModel::PerAxis), at_rest),
            "side by side with up to 31 others of its shape");
  EXPECT_EQ(riding(bent(0, YieldModel::Fibre), at_rest),
            alone + "it yields by several forces at once (rules.yield_model)");
  Scene propped = bent(0, YieldModel::Elastic);
  propped.supports.push_back({.at = Place::end(), .kind = SupportKind::Pillar});
  EXPECT_EQ(riding(propped, at_rest), alone + "a support lets go");
  SolverOptions motion;
  motion.analysis = Analysis::Dynamics;
  motion.time_step = 1e-3;
  for (const Scheme scheme : {Scheme::LinearlyImplicitMidpoint, Scheme::ArticulatedMidpoint}) {
    motion.scheme = scheme;
    EXPECT_EQ(riding(bent(0, YieldModel::Elastic), motion),
              "side by side with up to 7 others of its shape");
  }
  motion.scheme = Scheme::EnergyMomentum;
  Scene cut = bent(0, YieldModel::Elastic);
  cut.cuts.push_back({.at = {0.5, {}}, .time = 0.5});
  EXPECT_EQ(riding(cut, motion), alone + "joints are cut in it");
  Scene rated = bent(0, YieldModel::PerAxis);
  rated.material.rate = {.law = RateLaw::CowperSymonds, .reference_rate = 40.0, .exponent = 5.0};
  EXPECT_EQ(riding(rated, motion), alone + "its yield stress depends on the rate");
  motion.step_error = 1e-4;
  EXPECT_EQ(riding(bent(0, YieldModel::Elastic), motion),
            alone + "its steps follow their error (solver.step_error)");
  Scene coupon;
  coupon.drive.strain = {0.0, 0.01};
  EXPECT_EQ(riding(coupon, at_rest), alone + "it is a coupon");
}

}  // namespace
}  // namespace plastica
