#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "tests/sweeps/advise/advised_scenes.hpp"

// Advice where a run and a finer one are alike, and both wrong.

namespace plastica::sweeps {
namespace {

/// Within a segment a probe is off by what hangs on where it lies there, which a finer run does not
/// show that has it at a segment's end.
TEST(Advice, KeepsSegmentsThatEndAtProbesWhereWordsChange) {
  const plastica::Setup setup =
      io::parse_scene_file(
          "material = 'S355'\n[beam]\nlength = '1 m'\nsegments = 10\n"
          "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
          "[rules]\nyield_model = 'fibre'\n"
          "[[support]]\nat = 'start'\nkind = 'clamp'\n"
          "[[support]]\nat = 'end'\nkind = 'guide'\nhold = ['y', 'rx']\n"
          "[[load]]\nfrom = 0.2\nto = 0.8\nforce = ['0 N/m', '-6227.77 N/m', '0 N/m']\n"
          "history = { turning_points = [1, 0] }\n"
          "[[probe]]\nkind = 'displacement'\nname = 'd'\nat = 0.37\n",
          "guided.toml")
          .setup;
  plastica::Setup fine = setup;
  fine.scene.beam.segments = 800;
  fine.solver.translation = JointTranslation::Elastic;
  const auto truth = simulate(fine.scene, fine.solver).probes[0];
  for (const double within : {0.0042, 0.007, 0.01}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
    const plastica::Setup advised = advised_setup(setup, advice);
    const auto probe = simulate(advised.scene, advised.solver).probes[0];
    ASSERT_EQ(probe.size(), truth.size());
    double off = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      off += std::pow(probe[i] - truth[i], 2.0);
      all += std::pow(truth[i], 2.0);
    }
    EXPECT_LE(std::sqrt(off / all), advice.promised) << within;
  }
}

/// A moment m of first yield bends a rectangle by 1/sqrt(3 - 2 m) of first yield's curvature
/// (Prager and Hodge); taken off, it takes m of these with it. Four fibres, and eight, stay elastic
/// up to m = 1.27 and 1.12, so that they agree.
TEST(Advice, IsNotTakenInByFewFibresThatStayElastic) {
  for (const double m : {1.05, 1.09, 1.11, 1.2}) {
    plastica::Setup setup =
        tip_cantilever(0.02, "['0 N', '0 N', '0 N']", "yield_model = 'fibre'", "steps = 20");
    const Material& material = setup.scene.material;
    const SectionProperties s = section_properties(setup.scene.section, material.poisson_ratio);
    Load& load = setup.scene.loads[0];
    load.moment = {m * s.section_modulus_x * material.yield_stress, 0.0, 0.0};
    load.history = History::turning_points({1.0, 0.0});
    const double within = 0.005;
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
    const plastica::Setup advised = advised_setup(setup, advice);
    const auto probe = simulate(advised.scene, advised.solver).probes[0];
    const double first =
        material.yield_stress * s.section_modulus_x / (material.youngs_modulus * s.second_moment_x);
    const double bent = first / std::sqrt(3.0 - 2.0 * m);
    const auto tip = [](double curvature) { return (1.0 - std::cos(curvature)) / curvature; };
    const double largest = tip(bent);
    const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    EXPECT_NEAR(std::abs(*std::ranges::max_element(probe, size)), largest, within * largest) << m;
    EXPECT_NEAR(std::abs(probe.back()), tip(bent - m * first), within * largest) << m;
  }
}

/// Of thin walls two to eight fibres are the same.
TEST(Advice, IsNotTakenInByFibresThatAreTheSame) {
  for (const double m : {1.13, 1.18}) {
    plastica::Setup setup =
        tip_cantilever(0.04, "['0 N', '0 N', '0 N']", "yield_model = 'fibre'", "steps = 20");
    setup.scene.section = {.shape = SectionShape::RectangularTube,
                           .width = 0.03,
                           .height = 0.04,
                           .inner_width = 0.026,
                           .inner_height = 0.036};
    const Material& material = setup.scene.material;
    const SectionProperties s = section_properties(setup.scene.section, material.poisson_ratio);
    Load& load = setup.scene.loads[0];
    load.moment = {m * s.section_modulus_x * material.yield_stress, 0.0, 0.0};
    load.history = History::turning_points({1.0, 0.0});
    const Advice advice = advise(setup, asked(0.01));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
    plastica::Setup fine = setup;
    fine.scene.beam.segments = 100;
    fine.solver.fibres = 1000;
    const auto truth = simulate(fine.scene, fine.solver).probes[0];
    const plastica::Setup advised = advised_setup(setup, advice);
    const auto probe = simulate(advised.scene, advised.solver).probes[0];
    const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const double largest = *std::ranges::max_element(truth, size);
    EXPECT_NEAR(*std::ranges::max_element(probe, size), largest, 0.01 * std::abs(largest)) << m;
    EXPECT_NEAR(probe.back(), truth.back(), 0.01 * std::abs(largest)) << m;
  }
}

/// Six per cent of elastic strain, of a Young's modulus in MPa that was taken for Pa: no choice of
/// segments or words mends that.
TEST(Advice, WarnsOfTheSettingAsARunDoes) {
  plastica::Setup setup = tip_cantilever(0.1, "['0 N', '-2000 N', '0 N']");
  EXPECT_TRUE(advise(setup, asked(0.01)).warnings.empty());
  setup.scene.material.youngs_modulus = 210e6;
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  ASSERT_FALSE(advice.warnings.empty());
  EXPECT_NE(advice_text(advice, asked(0.01), "bar.toml").find("warning: "), std::string::npos);
}

}  // namespace
}  // namespace plastica::sweeps
