#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"

/// Where paths lose their stability, without any imperfection, against critical loads of theory.
namespace plastica {
namespace {

using std::numbers::pi;

/// Loads end at this times the critical one.
constexpr double kBeyond = 1.6;

HeldFreedoms sliding_clamp() { return {true, true, false, true, true, true}; }

/// A column along z under a thrust at its end.
Scene column(int segments, SupportKind start, const std::function<void(Scene&)>& hold_end,
             double coefficient) {
  Scene scene = testing::chain_scene(segments);
  scene.supports.push_back({.at = Place::start(), .kind = start});
  hold_end(scene);
  const double thrust = coefficient * testing::bending_stiffness_of(scene);
  scene.loads.push_back({.force = {0.0, 0.0, -kBeyond * thrust}});
  return scene;
}

void leave_free(Scene& /*scene*/) {}
void hold_by_roller(Scene& scene) {
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
}
void hold_by_sliding_clamp(Scene& scene) {
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Clamp, .hold = sliding_clamp()});
}

/// A strip on edge, 100 mm x 0.1 mm: in its plane it is a million times as stiff as across, so that
/// its deflection before it buckles, which theory leaves out, matters by 1e-6.
Scene strip(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.section.width = 1e-4;
  scene.section.height = 0.1;
  return scene;
}

/// sqrt(E I_y G J).
double lateral_stiffness_of(const Scene& scene) {
  const SectionProperties properties = testing::properties_of(scene);
  const double e = scene.material.youngs_modulus;
  const double g = e / (2.0 * (1.0 + scene.material.poisson_ratio));
  return std::sqrt(e * properties.second_moment_y * g * properties.torsion_constant);
}

/// The first bifurcation's fraction of the critical load of theory.
double first_bifurcation(const Scene& scene, const SolverOptions& options = {}) {
  const Response response = simulate(scene, options);
  EXPECT_EQ(response.status, Status::Unstable) << name_of(response.status);
  EXPECT_TRUE(response.critical.has_value());
  return response.critical ? response.critical->factor.front() * kBeyond : 0.0;
}

struct Case {
  const char* name;
  std::function<Scene(int)> scene;
};

std::vector<Case> cases() {
  using enum SupportKind;
  return {
      // Euler's columns: coefficient of E I/L^2.
      {"free", [](int n) { return column(n, Clamp, leave_free, 0.25 * pi * pi); }},
      {"pinned", [](int n) { return column(n, Pin, hold_by_roller, pi * pi); }},
      // tan x = x at 4.493409457909064.
      {"clamped and pinned",
       [](int n) { return column(n, Clamp, hold_by_roller, std::pow(4.493409457909064, 2)); }},
      {"clamped", [](int n) { return column(n, Clamp, hold_by_sliding_clamp, 4.0 * pi * pi); }},
      // Greenhill (1881): q L^3/EI = 9/4 j^2, j = 1.866350859 the first zero of J_-1/3.
      {"own weight",
       [](int n) {
         Scene scene = testing::cantilever_scene(n);
         const double area = scene.section.width * scene.section.height;
         const double weight = 7.837347 * testing::bending_stiffness_of(scene);
         scene.gravity = {0.0, 0.0, -kBeyond * weight / (scene.material.density * area)};
         return scene;
       }},
      // Prandtl (1899): P L^2/sqrt(EI GJ) = 2 j, j = 2.0062997 the first zero of J_-1/4.
      {"strip with a force at its tip",
       [](int n) {
         Scene scene = strip(n);
         scene.loads.push_back(
             {.force = {0.0, -kBeyond * 4.0125993 * lateral_stiffness_of(scene), 0.0}});
         return scene;
       }},
      // With x from the tip, phi'' + (q^2 x^4/(4 EI GJ)) phi = 0, phi'(0) = phi(L) = 0, so that
      // q L^3/sqrt(EI GJ) = 6 j, j = 2.1422939 the first zero of J_-1/6; 12.85 in Timoshenko &
      // Gere,
      // Theory of Elastic Stability, 6.3.
      {"strip under its weight",
       [](int n) {
         Scene scene = strip(n);
         const double area = scene.section.width * scene.section.height;
         const double weight = 12.8537633 * lateral_stiffness_of(scene);
         scene.gravity = {0.0, -kBeyond * weight / (scene.material.density * area), 0.0};
         return scene;
       }},
  };
}

TEST(Buckling, IsFoundAtTheLoadsOfTheoryWithOrderTwo) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    double error[2];
    int k = 0;
    for (const int segments : {16, 64}) {
      error[k++] = std::fabs(first_bifurcation(one.scene(segments), {.steps = 10}) - 1.0);
    }
    EXPECT_LE(error[1], 0.002);
    EXPECT_GE(std::log(error[0] / error[1]) / std::log(4.0), 1.85);
  }
}

TEST(Buckling, IsFoundAlikeInAnyNumberOfSteps) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const double truth = first_bifurcation(one.scene(16), {.steps = 40});
    for (const int steps : {1, 2, 5, 10, 20, 50}) {
      if (testing::kSanitized && steps != 5) continue;
      EXPECT_NEAR(first_bifurcation(one.scene(16), {.steps = steps}), truth, 1e-5) << steps;
    }
  }
}

TEST(Buckling, IsFoundInSpaceAsInThePlane) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const Scene scene = one.scene(16);
    EXPECT_NEAR(first_bifurcation(scene, {.level = Level::Spatial}),
                first_bifurcation(scene, {.level = Level::Planar}), 1e-5);
  }
}

TEST(Buckling, OfATwistedShaftIsFoundAtGreenhillsTorque) {
  // Clamped at both ends, of which one slides: T L/EI = 8.986819, tan(x/2) = x/2 (Timoshenko &
  // Gere, Theory of Elastic Stability, 2.21). The torque comes from the turn of the end.
  for (const int steps : {10, 40}) {
    double error[2];
    int k = 0;
    for (const int segments : {16, 64}) {
      Scene scene = testing::chain_scene(segments);
      scene.section.shape = SectionShape::Circle;
      scene.section.radius = 0.01;
      const SectionProperties properties = testing::properties_of(scene);
      const double e = scene.material.youngs_modulus;
      const double g = e / (2.0 * (1.0 + scene.material.poisson_ratio));
      const double twist =
          8.986818915818128 * e * properties.second_moment_x / (g * properties.torsion_constant);
      scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
      hold_by_sliding_clamp(scene);
      scene.supports.back().rotation = {0.0, 0.0, kBeyond * twist};
      error[k++] =
          std::fabs(first_bifurcation(scene, {.level = Level::Spatial, .steps = steps}) - 1.0);
    }
    EXPECT_LE(error[1], 0.002);
    EXPECT_GE(std::log(error[0] / error[1]) / std::log(4.0), 1.9);
  }
}

TEST(Buckling, OfAPinnedChainIsThatOfItsSegments) {
  // N equal segments on joints of E I/l: P_m = 2 E I/l^2 (1 - cos(m pi/N)), exactly.
  constexpr int kSegments = 12;
  Scene scene = column(kSegments, SupportKind::Pin, hold_by_roller, 24.0 * pi * pi / kBeyond);
  scene.section.width = 0.03;  // out of the plane it is stiffer by the cube of 1.5
  const Response response = simulate(scene, {.level = Level::Planar});
  ASSERT_TRUE(response.critical.has_value());
  const CriticalPoints& critical = *response.critical;
  const double stiffness = testing::bending_stiffness_of(scene) / 1.5;  // as the load's
  std::size_t in_plane = 0;
  for (std::size_t i = 0; i < critical.factor.size(); ++i) {
    if (critical.out_of_plane[i] != 0) continue;
    const double m = static_cast<double>(++in_plane);
    const double n = kSegments;
    const double exact = 1.5 * stiffness * 2.0 * n * n * (1.0 - std::cos(m * pi / n));
    EXPECT_NEAR(critical.factor[i] * -scene.loads[0].force[2] / exact, 1.0, 2e-5) << m;
    // What the determinant's bend leaves in a step of 1/1000 is a few times its square.
    // The mode is a sine, with its largest translation 1.
    for (std::size_t node = 0; node <= kSegments; ++node) {
      const double sine = std::sin(m * pi * static_cast<double>(node) / n);
      const double displacement = critical.mode[(i * (kSegments + 1) + node) * 3 + 1];
      EXPECT_NEAR(std::fabs(displacement), std::fabs(sine) / (m == 4.0 ? std::sin(pi / 3.0) : 1.0),
                  1e-6)
          << m << ' ' << node;
    }
  }
  EXPECT_EQ(in_plane, 4U);
}

TEST(Buckling, IsPassedOnTheStableSideByAnImperfectColumn) {
  // Twice Euler's load and a thousandth of it across: all steps lead to one stable equilibrium.
  double bow = 0.0;
  for (const int steps : {50, 20, 10, 5, 2, 1}) {
    if (testing::kSanitized && steps < 50 && steps > 1) continue;
    Scene scene = column(32, SupportKind::Pin, hold_by_roller, 2.0 * pi * pi / kBeyond);
    const double thrust = -scene.loads[0].force[2];
    scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 1e-3 * thrust, 0.0}});
    const Response response = testing::completed(scene, {.level = Level::Planar, .steps = steps});
    const double middle = testing::last_position(response, 16)[1];
    if (steps == 50) bow = middle;
    EXPECT_GT(middle, 0.3);  // to the side of the load
    EXPECT_NEAR(middle, bow, 1e-7) << steps;
  }
}

TEST(Buckling, OfAStripIsToldInThePlaneInAnyNumberOfSteps) {
  Scene scene = strip(16);
  scene.loads.push_back({.force = {0.0, -3.0 * 4.0125993 * lateral_stiffness_of(scene), 0.0}});
  for (const int steps : {1, 2, 5, 10, 20, 50}) {
    if (testing::kSanitized && steps > 5) continue;
    const Response response = simulate(scene, {.steps = steps});
    EXPECT_EQ(response.status, Status::Unstable);
    ASSERT_TRUE(response.critical.has_value());
    EXPECT_EQ(response.critical->out_of_plane.front(), 1);
    EXPECT_NEAR(3.0 * response.critical->factor.front(), 1.0, 0.01) << steps;
    // It goes to the side, nowhere else.
    for (std::size_t node = 0; node <= 16; ++node) {
      EXPECT_NEAR(response.critical->mode[3 * node + 1], 0.0, 1e-6);
      EXPECT_NEAR(response.critical->mode[3 * node + 2], 0.0, 1e-6);
    }
    EXPECT_NEAR(std::fabs(response.critical->mode[3 * 16]), 1.0, 1e-12);
  }
}

TEST(Buckling, IsSeenInBatchesAsAlone) {
  for (const Level level : {Level::Planar, Level::Spatial}) {
    std::vector<BatchCase> cases;
    for (int i = 0; i < 12; ++i) {
      const double coefficient = (0.6 + 0.1 * i) * pi * pi / kBeyond;
      cases.push_back({.id = std::to_string(i),
                       .scene = column(8, SupportKind::Pin, hold_by_roller, coefficient),
                       .options = {.level = level, .steps = 7 + i % 3}});
      if (i % 4 == 1) {
        cases.back().scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 2.0, 0.0}});
      }
    }
    std::size_t unstable = 0;
    const std::vector<BatchRow> rows = run_batch(cases, {.threads = 1});
    for (std::size_t i = 0; i < cases.size(); ++i) {
      SCOPED_TRACE(i);
      const Response alone = simulate(cases[i].scene, cases[i].options);
      const Response& row = rows[i].response;
      EXPECT_EQ(row.status, alone.status);
      ASSERT_EQ(row.critical.has_value(), alone.critical.has_value());
      if (!row.critical) continue;
      ++unstable;
      EXPECT_EQ(row.critical->factor, alone.critical->factor);
      EXPECT_EQ(row.critical->unstable_modes, alone.critical->unstable_modes);
    }
    EXPECT_GT(unstable, 4U);
    EXPECT_LT(unstable, cases.size());
  }
}

/// Two rigid bars of a length a at an angle of 0.2 rad to the ground, joined by the stiffness c of
/// a beam's joint, between a pin and a spring K along the ground; a force F at the top. From V = 2
/// c (t0 - t)^2 + 2 K a^2 (cos t - cos t0)^2 + F a sin t, F(t) = (4 c (t0 - t) + 4 K a^2 (cos t -
/// cos t0) sin t)/(a cos t), whose top is the limit load.
TEST(Buckling, OfAShallowArchIsItsLimitLoadInAnyNumberOfSteps) {
  constexpr double kAngle = 0.2;
  constexpr double kBar = 0.5;
  Scene scene = testing::chain_scene(2);
  scene.beam.shape = BeamShape::Polyline;
  const double rise = kBar * std::sin(kAngle);
  const double span = 2.0 * kBar * std::cos(kAngle);
  scene.beam.points = {{0.0, 0.0, 0.0}, {0.0, rise, 0.5 * span}, {0.0, 0.0, span}};
  const double joint = testing::bending_stiffness_of(scene) / kBar;
  const double spring = 1000.0 * joint / (kBar * kBar);
  double top = 0.0;
  for (double t = 0.0; t < kAngle; t += 1e-6) {
    const double force =
        (4.0 * joint * (kAngle - t) +
         4.0 * spring * kBar * kBar * (std::cos(t) - std::cos(kAngle)) * std::sin(t)) /
        (kBar * std::cos(t));
    top = std::max(top, force);
  }
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Elastic, .stiffness = {0.0, 0.0, spring}});
  // Else it tips out of its plane at a tenth of that.
  scene.supports.push_back(
      {.at = {0.5, {}}, .hold = HeldFreedoms{true, false, false, false, false, false}});
  for (const double beyond : {1.3, 3.0, 20.0}) {
    scene.loads = {{.at = {0.5, {}}, .force = {0.0, -beyond * top, 0.0}}};
    for (const int steps : {1, 2, 5, 10, 20, 30, 50}) {
      if (testing::kSanitized && steps > 5) continue;
      SCOPED_TRACE(::testing::Message() << beyond << ' ' << steps);
      const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
      EXPECT_EQ(response.status, Status::LimitLoad) << name_of(response.status);
      if (!response.limit) continue;
      EXPECT_NEAR(beyond * response.limit->below, 1.0, 2e-4);
      EXPECT_GE(beyond * response.limit->above, 1.0 - 1e-6);
      // The top goes down, and the end along its spring by as much as the bars turn: both by a/2.
      const std::vector<double>& mode = response.limit->mode;
      ASSERT_EQ(mode.size(), 9U);
      EXPECT_NEAR(mode[4], 1.0, 1e-12);
      EXPECT_NEAR(mode[5], 0.5 * mode[8], 1e-9);
    }
  }
}

}  // namespace
}  // namespace plastica
