#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"

// The probe of the largest permanent strain, against the angles and strains that shapes show,
// whether these are kept or not, alone and side by side.

namespace plastica {
namespace {

using testing::add_probe;

Scene bent(Level level, BreakMeasure measure, YieldModel yields) {
  Scene scene = testing::cantilever_scene(6);
  scene.yield_model = yields;
  scene.break_measure = measure;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 10e9;
  const double force = 1.3 * testing::yield_moment_of(scene);
  scene.loads.push_back({.force = {level == Level::Spatial ? 0.2 * force : 0.0, -force, 0.0}});
  scene.loads[0].history = History::turning_points({1.0, -1.0});
  add_probe(scene, ProbeQuantity::LargestPlasticStrain, Place::end(), Component::Y);
  return scene;
}

/// Paths and motions, as many of each that lanes take them.
std::vector<BatchCase> cases(int frames) {
  std::vector<BatchCase> all;
  const auto add = [&](Scene scene, SolverOptions options) {
    options.frames = frames;
    for (int i = 0; i < 9; ++i) {
      scene.material.yield_stress *= 1.01;
      all.push_back({std::to_string(all.size()), scene, options});
    }
  };
  for (const Level level : {Level::Planar, Level::Spatial}) {
    for (const BreakMeasure measure : {BreakMeasure::Net, BreakMeasure::Accumulated}) {
      for (const YieldModel yields : {YieldModel::PerAxis, YieldModel::Fibre}) {
        if (level == Level::Spatial && yields == YieldModel::Fibre) continue;  // slow
        add(bent(level, measure, yields), {.level = level, .steps = 12});
      }
    }
    Scene struck = testing::struck_scene(5, 40.0, YieldModel::PerAxis);
    add_probe(struck, ProbeQuantity::LargestPlasticStrain, Place::end(), Component::Y);
    SolverOptions options = testing::motion_options(Scheme::ArticulatedMidpoint, 1e-4, 8);
    options.duration = 4e-3;
    options.level = level;
    add(struck, options);
  }
  return all;
}

/// h/2 theta_p/l of the joints of `bent`, whose hardening spreads strains over them: net, of
/// bending about both axes of a square.
double largest_of(const ChainHistory& chain, std::size_t sample) {
  double largest = 0.0;
  for (std::size_t j = 0; j < chain.joints; ++j) {
    const double length = (j == 0 ? 0.5 : 1.0) / 6.0;
    const double* angle = &chain.plastic_angle[(sample * chain.joints + j) * 3];
    largest = std::max(largest, 0.01 * (std::fabs(angle[0]) + std::fabs(angle[1])) / length);
  }
  return largest;
}

TEST(LargestStrain, IsThatOfTheShapes) {
  const std::vector<BatchCase> all = cases(0);
  for (const BatchRow& row : run_batch(all)) {
    const Scene& scene = all[std::stoul(row.id)].scene;
    // Fibres stretch by the little axial force of a beam that has turned.
    const bool has_closed_form = scene.break_measure == BreakMeasure::Net &&
                                 scene.yield_model == YieldModel::PerAxis &&
                                 scene.material.hardening.law == HardeningLaw::Linear;
    ASSERT_EQ(row.response.status, Status::Completed) << row.id << row.reason;
    const ChainHistory& chain = row.response.chain;
    const std::vector<double>& probe = row.response.probes.back();
    for (std::size_t sample = 0; sample < row.response.samples; ++sample) {
      const auto begin =
          chain.plastic_strain.begin() + static_cast<std::ptrdiff_t>(sample * chain.joints);
      const auto end = begin + static_cast<std::ptrdiff_t>(chain.joints);
      EXPECT_EQ(probe[sample], *std::max_element(begin, end)) << row.id << ' ' << sample;
      if (has_closed_form) {
        EXPECT_NEAR(probe[sample], largest_of(chain, sample), 1e-15 + 1e-12 * probe[sample])
            << row.id << ' ' << sample;
      }
    }
    EXPECT_EQ(probe.front(), 0.0) << row.id;
    EXPECT_GT(probe.back(), 1e-5) << row.id;
    EXPECT_EQ(probe.back(), row.response.permanent_strain) << row.id;
  }
}

TEST(LargestStrain, IsTheSameWhereNoShapesAreKeptAndWhereABeamIsAlone) {
  const std::vector<BatchRow> shapes = run_batch(cases(0));
  const std::vector<BatchCase> few = cases(1);
  const std::vector<BatchRow> together = run_batch(few);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(together[i].response.probes, shapes[i].response.probes) << i;
    EXPECT_EQ(run_case(few[i]).response.probes, shapes[i].response.probes) << i;
  }
}

TEST(LargestStrain, CountsAllStepsInWhichWhatActsAtOnceIsPutOn) {
  // A pillar takes over after the clamp has yielded: the last of the steps is elastic.
  Scene scene = testing::cantilever_scene(20);
  scene.yield_model = YieldModel::PerAxis;
  scene.material.yield_stress = 300e6;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 10e9;
  Support pillar{.at = {0.5, {}}, .kind = SupportKind::Pillar};
  pillar.normal = {0.0, 1.0, 0.0};
  pillar.gap = 0.018;
  scene.supports.push_back(pillar);
  scene.loads.push_back({.force = {0.0, -500.0, 0.0}, .history = History::constant()});
  add_probe(scene, ProbeQuantity::LargestPlasticStrain, Place::end(), Component::Y);
  SolverOptions options{.duration = 1.0, .steps = 2};
  options.largest_rotation = 0.01;
  const Response response = testing::completed(scene, options);
  const double more = testing::last_of(response, 0);
  const ChainHistory& chain = response.chain;
  const double moment = std::fabs(chain.moment[(response.samples - 1) * chain.joints * 3]);
  EXPECT_GT(more, 1e-3);
  EXPECT_GT(moment, testing::yield_moment_of(scene));
  EXPECT_EQ(response.probes[0].front(), more);
  scene.material.break_strain = 0.5 * more;
  EXPECT_EQ(simulate(scene, options).status, Status::Broken);
}

}  // namespace
}  // namespace plastica
