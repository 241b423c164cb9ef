#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"

/// Round shafts that buckle under torque, against critical loads of theory.
namespace plastica {
namespace {

using std::numbers::pi;

/// Loads end at this times the critical one.
constexpr double kBeyond = 1.3;

Scene round_scene(int segments) {
  Scene scene = testing::chain_scene(segments);
  scene.section.shape = SectionShape::Circle;
  scene.section.radius = 0.01;
  return scene;
}

/// EI over GJ.
double bending_over_torsion(const Scene& scene) {
  const SectionProperties properties = testing::properties_of(scene);
  return 2.0 * (1.0 + scene.material.poisson_ratio) * properties.second_moment_x /
         properties.torsion_constant;
}

double first_bifurcation(const Scene& scene, const SolverOptions& options) {
  const Response response = simulate(scene, options);
  EXPECT_EQ(response.status, Status::Unstable) << name_of(response.status);
  return response.critical ? response.critical->factor.front() * kBeyond : 0.0;
}

/// What is zero where a shaft of the length 1 and EI = 1 between clamps, of which one slides,
/// buckles under a thrust P and a torque T. Its deflections w = u + i v obey
/// w'''' - i T w''' + P w'' = 0, so that w = A + B z + C e^(iaz) + D e^(ibz) with a, b from
/// k^2 - T k - P = 0; w = w' = 0 at both ends leaves this.
double shaft_determinant(double torque, double thrust) {
  const double root = std::sqrt(torque * torque + 4.0 * thrust);
  const double a = 0.5 * (torque + root);
  const double b = 0.5 * (torque - root);
  return 2.0 * (b - a) * std::sin(0.5 * a) * std::sin(0.5 * b) - a * b * std::sin(0.5 * (b - a));
}

TEST(Buckling, OfAShaftUnderTorqueAndThrustIsWhereItsDeterminantVanishes) {
  for (const double fraction : {0.25, 0.5, 0.75}) {  // of the thrust without torque
    const double thrust = fraction * 4.0 * pi * pi;
    double low = 0.0;
    double high = 8.986818915818128;  // that without thrust
    ASSERT_LT(shaft_determinant(low, thrust) * shaft_determinant(high, thrust), 0.0);
    while (high - low > 1e-12) {
      const double middle = 0.5 * (low + high);
      const bool same = shaft_determinant(low, thrust) * shaft_determinant(middle, thrust) > 0.0;
      (same ? low : high) = middle;
    }
    double error[2];
    int k = 0;
    for (const int segments : {16, 64}) {
      Scene scene = round_scene(segments);
      scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
      scene.supports.push_back({.at = Place::end(),
                                .kind = SupportKind::Clamp,
                                .hold = HeldFreedoms{true, true, false, true, true, true}});
      scene.supports.back().rotation = {0.0, 0.0, kBeyond * low * bending_over_torsion(scene)};
      const double ei = testing::bending_stiffness_of(scene);
      scene.loads.push_back({.force = {0.0, 0.0, -kBeyond * thrust * ei}});
      error[k++] = std::fabs(first_bifurcation(scene, {.level = Level::Spatial}) - 1.0);
    }
    EXPECT_LE(error[1], 0.002) << fraction;
    EXPECT_GE(std::log(error[0] / error[1]) / std::log(4.0), 1.8) << fraction;
  }
}

/// A straight rod bent to a ring, whose ends then are turned against each other: it leaves its
/// plane at 2 pi sqrt(3) EI/GJ (Michell 1889; Zajac, J. Appl. Mech. 29, 1962, 136), in two ways at
/// once, since its waves may be anywhere on it.
Scene twisted_ring(int segments) {
  Scene scene = round_scene(segments);
  scene.section.radius = 0.0005;
  const double twist = kBeyond * 2.0 * pi * std::sqrt(3.0) * bending_over_torsion(scene);
  scene.supports.push_back({.at = Place::start(),
                            .kind = SupportKind::Clamp,
                            .rotation = {0.0, 0.0, twist},
                            .history = {{0.0, 1.0, 2.0}, {0.0, 0.0, 1.0}}});
  // Its end goes where that of an arc of the angle 2 pi t goes.
  History along{{0.0}, {0.0}};
  History across{{0.0}, {0.0}};
  for (int k = 1; k <= 40; ++k) {
    const double t = k / 40.0;
    along.time.push_back(t);
    across.time.push_back(t);
    along.factor.push_back(1.0 - std::sin(2.0 * pi * t) / (2.0 * pi * t));
    across.factor.push_back((1.0 - std::cos(2.0 * pi * t)) / (2.0 * pi * t));
  }
  const auto hold = [&](HeldFreedoms held, const History& history,
                        std::array<double, 3> displacement, std::array<double, 3> turn) {
    scene.supports.push_back({.at = Place::end(),
                              .kind = SupportKind::Clamp,
                              .hold = held,
                              .translation = displacement,
                              .rotation = turn,
                              .history = history});
  };
  hold({true, false, false, true, true, true}, {{0.0, 1.0}, {0.0, 1.0}}, {}, {2.0 * pi, 0.0, 0.0});
  hold({false, true, false, false, false, false}, across, {0.0, -1.0, 0.0}, {});
  hold({false, false, true, false, false, false}, along, {0.0, 0.0, -1.0}, {});
  return scene;
}

TEST(Buckling, OfATwistedRingIsFoundAtMichellsAngle) {
  // It is stretched by (radius/ring)^2, 1e-5.
  for (const int steps : {80, 120}) {
    if (testing::kSanitized && steps > 80) continue;
    double error[2];
    int k = 0;
    for (const int segments : {32, 64}) {
      const SolverOptions options{.level = Level::Spatial,
                                  .translation = JointTranslation::Elastic,
                                  .duration = 2.0,
                                  .steps = steps,
                                  .buckling = 2};
      const Response response = simulate(twisted_ring(segments), options);
      EXPECT_EQ(response.status, Status::Unstable) << name_of(response.status);
      ASSERT_TRUE(response.critical.has_value());
      // Both ways, as nearly at once as the chain's corners let them.
      ASSERT_TRUE(response.buckling && response.buckling->factor.size() == 2);
      const double at = response.critical->factor.front();
      EXPECT_NEAR(response.buckling->factor[0] / at, 1.0, 1e-3);
      EXPECT_NEAR(response.buckling->factor[1] / at, 1.0, 1e-3);
      error[k++] = std::fabs(kBeyond * response.critical->factor.front() - 1.0);
    }
    EXPECT_LE(error[1], 0.002);
    EXPECT_GE(std::log2(error[0] / error[1]), 1.8);
  }
}

}  // namespace
}  // namespace plastica
