#include "plastica/model/first_frequency.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/section.hpp"
#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using std::numbers::pi;
using testing::cantilever;

std::optional<model_detail::FirstFrequency> frequency_of(const Scene& scene,
                                                         const LevelChoice& level) {
  return model_detail::first_frequency(
      scene, level, section_properties(scene.section, scene.material.poisson_ratio),
      segment_ends(scene));
}

/// beta L of the first bending frequency of a beam with these supports.
double beta_l(const std::vector<Support>& supports) {
  Scene scene = cantilever();
  scene.supports = supports;
  const auto first = frequency_of(scene, {Level::Planar, BendingAxis::X, ""});
  const Material& m = scene.material;
  const double radius = 0.02 / std::sqrt(12.0);
  const double wave = radius * std::sqrt(m.youngs_modulus / m.density);  // sqrt(EI/(rho A))
  EXPECT_TRUE(first && first->of == model_detail::Vibration::Bending);
  return std::sqrt(2.0 * pi * first->hertz / wave);
}

TEST(FirstFrequency, IsThatOfTheBeamsEnds) {
  const auto at = [](Place place, SupportKind kind) { return Support{place, kind}; };
  using enum SupportKind;
  const Place start = Place::start();
  const Place end = Place::end();
  EXPECT_NEAR(beta_l({}), 4.7300, 1e-4);
  EXPECT_NEAR(beta_l({at(start, Clamp)}), 1.8751, 1e-4);
  EXPECT_NEAR(beta_l({at(end, Clamp)}), 1.8751, 1e-4);
  EXPECT_NEAR(beta_l({at(start, Pin)}), 3.9266, 1e-4);
  EXPECT_NEAR(beta_l({at(start, Pin), at(end, Roller)}), pi, 1e-12);
  EXPECT_NEAR(beta_l({at(start, Clamp), at(end, Roller)}), 3.9266, 1e-4);
  EXPECT_NEAR(beta_l({at(start, Clamp), at(end, Clamp)}), 4.7300, 1e-4);
  EXPECT_NEAR(beta_l({at(start, Clamp), at(end, Guide)}), 2.3650, 1e-4);
  EXPECT_NEAR(beta_l({at(start, Pin), at(end, Guide)}), pi / 2.0, 1e-12);
}

TEST(FirstFrequency, SolvesTheEquationsOfItsEnds) {
  // Each as cos, cosh, sin and sinh of beta L; the numbers are given to four places.
  const auto clamped_free = [](double b) { return std::cos(b) * std::cosh(b) + 1.0; };
  const auto free_free = [](double b) { return std::cos(b) * std::cosh(b) - 1.0; };
  const auto clamped_pinned = [](double b) { return std::tan(b) - std::tanh(b); };
  const auto clamped_guided = [](double b) { return std::tan(b) + std::tanh(b); };
  const auto changes_sign = [](const auto& f, double b) { return f(b - 1e-4) * f(b + 1e-4) < 0.0; };
  EXPECT_TRUE(changes_sign(clamped_free, beta_l({{Place::start(), SupportKind::Clamp}})));
  EXPECT_TRUE(changes_sign(free_free, beta_l({})));
  EXPECT_TRUE(changes_sign(clamped_pinned, beta_l({{Place::start(), SupportKind::Pin}})));
  EXPECT_TRUE(changes_sign(clamped_guided, beta_l({{Place::start(), SupportKind::Guide}})));
}

TEST(FirstFrequency, IsThatOfTheLongestStretchBetweenSupports) {
  const Support pin{Place::start(), SupportKind::Pin};
  const Support inner{{0.25, {}}, SupportKind::Roller};
  const Support end{Place::end(), SupportKind::Roller};
  EXPECT_NEAR(beta_l({pin, inner, end}), pi / 0.75, 1e-12);
  // An overhang is held like a cantilever.
  EXPECT_NEAR(beta_l({pin, inner}), 1.8751 / 0.75, 1e-4);
  EXPECT_NEAR(beta_l({inner, end}), pi / 0.75, 1e-12);
  // Pillars let go.
  EXPECT_NEAR(beta_l({pin, {{0.25, {}}, SupportKind::Pillar}}), 3.9266, 1e-4);
}

TEST(FirstFrequency, IsThatOfTheLevelsPlane) {
  Scene scene = cantilever();
  scene.section.width = 0.01;
  const auto about = [&](Level level, BendingAxis axis) {
    return frequency_of(scene, {level, axis, ""})->hertz;
  };
  const double about_x = about(Level::Planar, BendingAxis::X);
  EXPECT_NEAR(about(Level::Planar, BendingAxis::Y), about_x / 2.0, 1e-9);
  EXPECT_NEAR(about(Level::Spatial, BendingAxis::X), about_x / 2.0, 1e-9);
  scene.beam.segments = 1;
  EXPECT_FALSE(frequency_of(scene, {Level::Planar, BendingAxis::X, ""}));
}

TEST(FirstFrequency, OfATwistIsThatOfTorsionalWaves) {
  Scene scene = cantilever();
  scene.section = {SectionShape::Circle};
  // J is the polar moment of a circle: waves of speed sqrt(G/rho) run four lengths in a period.
  const double speed = std::sqrt(resolved_shear_modulus(scene.material) / scene.material.density);
  const auto hertz = [&] { return frequency_of(scene, {Level::Twist, {}, ""})->hertz; };
  EXPECT_NEAR(hertz(), speed / 4.0, 1e-9 * speed);
  EXPECT_EQ(frequency_of(scene, {Level::Twist, {}, ""})->of, model_detail::Vibration::Torsion);
  scene.supports.push_back({Place::end(), SupportKind::Clamp});
  EXPECT_NEAR(hertz(), speed / 2.0, 1e-9 * speed);
  scene.supports.clear();
  EXPECT_NEAR(hertz(), speed / 2.0, 1e-9 * speed);
}

}  // namespace
}  // namespace plastica
