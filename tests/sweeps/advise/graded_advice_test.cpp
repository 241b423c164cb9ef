#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sweeps/advise/advised_scenes.hpp"

namespace plastica::sweeps {
namespace {

/// An elastic beam on a bed, so long that its ends do not matter, under a force in its middle.
Setup beam_on_a_bed() {
  return io::parse_scene_file(
             "material = 'S355'\n[beam]\nlength = '12 m'\nsegments = 96\n"
             "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
             "[rules]\nyield_model = 'elastic'\n[solver]\nsteps = 1\n"
             "[[support]]\nfrom = 'start'\nto = 'end'\nkind = 'elastic'\n"
             "stiffness = ['0 Pa', '80 kPa', '0 Pa']\n"
             "[[support]]\nat = 'start'\nkind = 'clamp'\nhold = ['z']\n"
             "[[load]]\nat = 0.5\nforce = ['0 N', '-10 N', '0 N']\n"
             "[[probe]]\nname = 'sinks'\nkind = 'displacement'\nat = 0.5\ncomponent = 'y'\n",
             "bed.toml")
      .setup;
}

TEST(GradedAdvice, IsWithinWhatWasAskedOfTheClosedForm) {
  const plastica::Setup setup = beam_on_a_bed();
  // Winkler: P b/(2 k), b = (k/(4 E I))^(1/4); shear is 0.1 % of that.
  const SectionProperties section = section_properties(setup.scene.section, 0.3);
  const double stiffness = setup.scene.material.youngs_modulus * section.second_moment_x;
  const double truth = -10.0 * std::pow(80e3 / (4.0 * stiffness), 0.25) / (2.0 * 80e3);
  for (const double within : {0.02, 0.005}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found);
    ASSERT_FALSE(advice.fractions.empty());
    ASSERT_TRUE(advice.even);
    EXPECT_LT(advice.cost, 0.8 * advice.even->cost);
    EXPECT_NEAR(end_of(setup, advice), truth, (advice.promised + 1e-3) * std::abs(truth));
    EXPECT_EQ(advice.fractions.size(), static_cast<std::size_t>(advice.setting[0]));
    // As short as can be under the force, where the curvature has a corner.
    const auto shortest = std::ranges::min_element(advice.fractions);
    double at = 0.0;
    for (auto one = advice.fractions.begin(); one != shortest; ++one) at += *one;
    EXPECT_NEAR(at, 0.5, 0.1);
  }
}

/// Where a plastic hinge spreads from the clamp: an even beam that is far finer judges.
TEST(GradedAdvice, HoldsAgainstAnEvenBeamThatIsFarFiner) {
  const plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '-600 N', '0 N']", "yield_model = 'fibre'", "steps = 20");
  const Advice advice = advise(setup, asked(0.003));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  ASSERT_FALSE(advice.fractions.empty());
  plastica::Setup fine = advised_setup(setup, advice);
  fine.scene.beam.segment_fractions.clear();
  fine.scene.beam.segments = 1000;
  fine.solver.fibres = 80;
  fine.solver.translation = JointTranslation::Elastic;
  const double truth = simulate(fine.scene, fine.solver).probes[0].back();
  EXPECT_NEAR(end_of(setup, advice), truth, advice.promised * std::abs(truth));
}

TEST(GradedAdvice, IsEvenWhereTheBendingIs) {
  const Advice advice = advise(tip_cantilever(0.02, "['0 N', '-10 N', '0 N']"), asked(0.001));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  EXPECT_TRUE(advice.fractions.empty());
}

TEST(GradedAdvice, IsFourTimesFinerInEachSegmentWhereItIsChecked) {
  const plastica::Setup setup = beam_on_a_bed();
  const Advice advice = advise(setup, asked(0.02));
  ASSERT_FALSE(advice.fractions.empty());
  const plastica::Setup finer = finer_setup(setup, advice, 0.25);
  ASSERT_EQ(finer.scene.beam.segment_fractions.size(), 4 * advice.fractions.size());
  EXPECT_DOUBLE_EQ(finer.scene.beam.segment_fractions[5], 0.25 * advice.fractions[1]);
}

TEST(GradedAdvice, IsNotTriedWhereFewerThanFourSegmentsWouldHaveToDo) {
  const Advice advice = advise(tip_cantilever(0.02, "['0 N', '-1 N', '0 N']"), asked(0.05));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  ASSERT_LE(advice.setting[0], 5.0);
  for (const TriedSetting& one : advice.tried) EXPECT_TRUE(one.fractions.empty());
}

}  // namespace
}  // namespace plastica::sweeps
