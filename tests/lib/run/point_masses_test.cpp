#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "plastica/run/natural_frequencies.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/tolerance.hpp"

// Point masses at rest and about rest, against the equations of beams that carry them.

namespace plastica {
namespace {

using std::numbers::pi;
using testing::add_probe;
using testing::cantilever_scene;
using testing::chain_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

constexpr double kGravity = 9.81;

constexpr SolverOptions kThin{.level = Level::Planar,
                              .analysis = Analysis::Dynamics,
                              .duration = 1.0,
                              .rotary_inertia = RotaryInertia::Off};

double line_mass_of(const Scene& scene) {
  return scene.material.density * testing::properties_of(scene).area;
}

/// The n-th root of an equation, n from 1, by steps that are shorter than its roots' distance.
double root_of(const std::function<double(double)>& equation, int number) {
  constexpr double kStep = 0.01;
  double low = kStep;
  for (int found = 0;; low += kStep) {
    if (equation(low) * equation(low + kStep) > 0.0) continue;
    if (++found == number) break;
  }
  double high = low + kStep;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (equation(low) * equation(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The frequency of an Euler-Bernoulli beam of which b = beta L [Hz].
double hertz_of(double b, const Scene& scene) {
  return b * b * std::sqrt(testing::bending_stiffness_of(scene) / line_mass_of(scene)) / (2.0 * pi);
}

/// A cantilever whose tip carries M = mu m L and J = nu m L^3: with w = A (cosh - cos) +
/// B (sinh - sin) the conditions E I w'' = J omega^2 w', E I w''' = -M omega^2 w at the tip have a
/// solution where this determinant vanishes.
double tip_determinant(double b, double mu, double nu) {
  const double plus = std::cosh(b) + std::cos(b);
  const double minus = std::cosh(b) - std::cos(b);
  const double odd_plus = std::sinh(b) + std::sin(b);
  const double odd_minus = std::sinh(b) - std::sin(b);
  const double turn = nu * b * b * b;
  return (plus - turn * odd_plus) * (plus + mu * b * odd_minus) -
         (odd_plus - turn * minus) * (odd_minus + mu * b * minus);
}

struct TipBody {
  const char* name;
  double mu;  ///< its mass over the beam's
  double nu;  ///< its inertia over m L^3
};

class TipMass : public ::testing::TestWithParam<TipBody> {
 protected:
  static Scene scene(int segments) {
    Scene scene = cantilever_scene(segments);
    const double mass = line_mass_of(scene) * scene.beam.length;
    const double inertia = GetParam().nu * mass * scene.beam.length * scene.beam.length;
    scene.masses.push_back({Place::end(), GetParam().mu * mass, {inertia, 0.0, 0.0}});
    scene.gravity = {0.0, -kGravity, 0.0};
    return scene;
  }

  /// Of the first three frequencies, relative.
  static std::array<double, 3> errors(int segments) {
    const Scene made = scene(segments);
    const auto found = unloaded_frequencies(made, kThin, 3);
    std::array<double, 3> errors{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double b =
          root_of([](double x) { return tip_determinant(x, GetParam().mu, GetParam().nu); },
                  static_cast<int>(k) + 1);
      errors[k] = found[k] / hertz_of(b, made) - 1.0;
    }
    return errors;
  }
};

INSTANTIATE_TEST_SUITE_P(Bodies, TipMass,
                         ::testing::Values(TipBody{"Light", 0.1, 0.0}, TipBody{"Alike", 1.0, 0.0},
                                           TipBody{"Heavy", 20.0, 0.0}, TipBody{"Wide", 0.5, 0.1},
                                           TipBody{"Wheel", 2.0, 1.0},
                                           TipBody{"InertiaAlone", 0.0, 0.05}),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(TipDeterminant, IsTheKnownEquationWithoutInertia) {
  for (const double mu : {0.0, 0.3, 5.0}) {
    for (const double b : {0.4, 1.7, 4.2}) {
      const double known = 1.0 + std::cos(b) * std::cosh(b) +
                           b * mu * (std::cos(b) * std::sinh(b) - std::sin(b) * std::cosh(b));
      EXPECT_NEAR(tip_determinant(b, mu, 0.0), 2.0 * known, tolerance(1e-12) * std::cosh(b) * 100);
    }
  }
}

TEST_P(TipMass, HasTheBeamsFrequenciesToSecondOrder) {
  const auto coarse = errors(32);
  const auto fine = errors(128);
  for (std::size_t k = 0; k < 3; ++k) {
    RecordProperty("error" + std::to_string(k), std::to_string(fine[k]));
    EXPECT_LT(std::fabs(fine[k]), 5e-4) << k;
    EXPECT_NEAR(std::log2(coarse[k] / fine[k]) / 2.0, 2.0, 0.2) << k;
  }
}

// At the middle of a pinned beam, antisymmetric: half of J turns each half of the beam, with
// w = A sin + B sinh, w = 0 and E I w'' = J omega^2 w'/2 there.
double middle_equation(double b, double nu) {
  const double a = 0.5 * b;
  const double turn = 0.5 * nu * b * b * b;
  return std::sin(a) * (std::sinh(a) - turn * std::cosh(a)) -
         std::sinh(a) * (-std::sin(a) - turn * std::cos(a));
}

/// The first such frequency of a chain over that of the beam, less one.
/// @param segments  odd: in the middle of one; even: at a joint
double middle_error(int segments) {
  constexpr double kNu = 0.05;
  Scene scene = chain_scene(segments);
  if (segments % 2 == 1) {
    scene.beam.segment_fractions.assign(static_cast<std::size_t>(segments), 1.0 / segments);
  }
  scene.supports = {{.at = Place::start(), .kind = SupportKind::Pin},
                    {.at = Place::end(), .kind = SupportKind::Roller}};
  scene.masses.push_back({{0.5, {}}, 0.0, {kNu * line_mass_of(scene), 0.0, 0.0}});
  scene.gravity = {0.0, -kGravity, 0.0};
  const double exact =
      hertz_of(root_of([](double b) { return middle_equation(b, kNu); }, 1), scene);
  // Symmetric modes, which do not turn the middle, are among the others.
  double nearest = 1.0;
  for (const double found : unloaded_frequencies(scene, kThin, 4)) {
    const double off = found / exact - 1.0;
    if (std::fabs(off) < std::fabs(nearest)) nearest = off;
  }
  return nearest;
}

TEST(InnerMass, TurnsInTheMiddleOfASegmentToSecondOrder) {
  const double fine = middle_error(63);
  EXPECT_LT(std::fabs(fine), 2e-3);
  EXPECT_NEAR(std::log(middle_error(21) / fine) / std::log(3.0), 2.0, 0.2);
}

// The compliance l/4EI of L/12EI that the inertia feels here is missing.
TEST(InnerMass, TurnsAtAJointToFirstOrder) {
  const double fine = middle_error(64);
  EXPECT_NEAR(fine, 1.0 / std::sqrt(1.0 - 0.25 / 64.0 * 12.0) - 1.0, 6e-3);
  EXPECT_NEAR(std::log2(middle_error(32) / fine), 1.0, 0.1);
}

// Without inertia, symmetric: the shear force is M omega^2 w/2 there, and w' = 0.
TEST(InnerMass, MovesAtAJointToSecondOrder) {
  constexpr double kMu = 2.0;
  const auto equation = [](double b) {
    // w = A sin + B sinh with A cos a + B cosh a = 0.
    const double a = 0.5 * b;
    const double first = std::cosh(a);
    const double second = -std::cos(a);
    return -first * std::cos(a) + second * std::cosh(a) +
           0.5 * kMu * b * (first * std::sin(a) + second * std::sinh(a));
  };
  const auto error = [&](int segments) {
    Scene scene = chain_scene(segments);
    scene.supports = {{.at = Place::start(), .kind = SupportKind::Pin},
                      {.at = Place::end(), .kind = SupportKind::Roller}};
    scene.masses.push_back({{0.5, {}}, kMu * line_mass_of(scene), {}});
    scene.gravity = {0.0, -kGravity, 0.0};
    return unloaded_frequencies(scene, kThin, 1)[0] / hertz_of(root_of(equation, 1), scene) - 1.0;
  };
  const double fine = error(64);
  EXPECT_LT(std::fabs(fine), 1e-3);
  EXPECT_GT(std::log2(error(32) / fine), 1.8);
}

// b tan b = m_polar L/J_tip of a clamped shaft.
TEST(TipMass, TwistsAShaftAsAFlywheelDoes) {
  std::array<double, 2> error{};
  for (const int segments : {16, 64}) {
    Scene scene = cantilever_scene(segments);
    const SectionProperties p = testing::properties_of(scene);
    const double polar = scene.material.density * (p.second_moment_x + p.second_moment_y);
    scene.masses.push_back({Place::end(), 3.0, {0.0, 0.0, 2.0 * polar}});
    scene.loads.push_back({.at = {0.5, {}}, .moment = {0.0, 0.0, 1.0}});
    SolverOptions options = kThin;
    options.level = Level::Twist;
    const double found = unloaded_frequencies(scene, options, 1)[0];
    const double b = root_of([](double x) { return x * std::sin(x) - 0.5 * std::cos(x); }, 1);
    const double speed =
        std::sqrt(resolved_shear_modulus(scene.material) * p.torsion_constant / polar);
    error[segments == 16 ? 0 : 1] = found / (b * speed / (2.0 * pi)) - 1.0;
  }
  EXPECT_LT(std::fabs(error[1]), 1e-3);
  EXPECT_NEAR(std::log2(error[0] / error[1]) / 2.0, 2.0, 0.2);
}

// A wire's frequencies under a pull, and a heavy column's: what acts stiffens or softens.
TEST(LoadedMass, OnAMasslessCantileverFallsWithItsThrust) {
  // A tip mass that hardly turns on a light beam under a thrust P < P_E: the lateral stiffness of
  // the beam-column is P k/(tan kL - kL), k = sqrt(P/E I).
  Scene scene = cantilever_scene(64);
  scene.material.density = 1e-3;
  scene.masses.push_back({Place::end(), 2.0, {}});
  const double stiffness = testing::bending_stiffness_of(scene);
  const double thrust = 0.5 * pi * pi / 4.0 * stiffness;
  scene.loads.push_back({.force = {0.0, 0.0, -thrust}});
  const SolverOptions options{.level = Level::Planar};
  const LoadedFrequencies loaded = natural_frequencies(scene, options, 1);
  ASSERT_EQ(loaded.status, Status::Completed);
  const double k = std::sqrt(thrust / stiffness);
  const double exact = std::sqrt(thrust * k / (std::tan(k) - k) / 2.0) / (2.0 * pi);
  EXPECT_NEAR(loaded.frequency[0] / exact, 1.0, 5e-4);
}

TEST(MassAtRest, SagsByItsWeightAlone) {
  struct Case {
    int segments;
    double at;
    bool pinned;
  };
  for (const auto& [segments, at, pinned] :
       {Case{64, 1.0, false}, Case{61, 0.37, false}, Case{64, 0.5, true}}) {
    if (testing::kSanitized && segments == 64) continue;
    Scene scene = pinned ? chain_scene(segments) : cantilever_scene(segments);
    if (pinned) {
      scene.supports = {{.at = Place::start(), .kind = SupportKind::Pin},
                        {.at = Place::end(), .kind = SupportKind::Roller}};
    }
    scene.material.density = 1e-6;
    scene.masses.push_back({{at, {}}, 0.2, {1.0, 2.0, 3.0}});
    scene.gravity = {0.0, -kGravity, 0.0};
    add_probe(scene, ProbeQuantity::Displacement, {at, {}}, Component::Y);
    const double weight = 0.2 * kGravity;
    const double exact =
        weight * (pinned ? 1.0 / 48.0 : at * at * at / 3.0) / testing::bending_stiffness_of(scene);
    const SectionProperties p = testing::properties_of(scene);
    const double sheared =
        weight * (pinned ? 0.25 : at) /
        (p.shear_coefficient_y * resolved_shear_modulus(scene.material) * p.area);
    for (const Level level : {Level::Planar, Level::Spatial}) {
      for (const JointTranslation translation :
           {JointTranslation::Rigid, JointTranslation::Elastic}) {
        SolverOptions options{.level = level, .translation = translation};
        const Response response = completed(scene, options);
        const bool shears = translation == JointTranslation::Elastic;
        EXPECT_NEAR(last_of(response, 0) / -(exact + (shears ? sheared : 0.0)), 1.0, 2e-3) << at;
      }
    }
  }
}

TEST(MassAtRest, WeighsWhereItIsWithinASegmentToo) {
  Scene scene = cantilever_scene(4);
  scene.beam.segment_fractions = {0.25, 0.25, 0.25, 0.25};
  scene.masses.push_back({{0.6, {}}, 0.5, {}});
  scene.gravity = {0.0, -kGravity, 0.0};
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::X);
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  const Response response = completed(scene, {.level = Level::Planar});
  const double line = line_mass_of(scene);
  EXPECT_NEAR(std::fabs(last_of(response, 0)) / ((0.5 * 0.6 + 0.5 * line) * kGravity), 1.0, 1e-4);
  EXPECT_NEAR(last_of(response, 1) / ((0.5 + line) * kGravity), 1.0, 1e-9);
}

/// The same beam read from its other end.
Scene mirrored(Scene scene) {
  for (Region& region : scene.regions) {
    region.from.fraction = 1.0 - region.from.fraction;
    region.to.fraction = 1.0 - region.to.fraction;
    std::swap(region.from, region.to);
  }
  for (Support& support : scene.supports) support.at.fraction = 1.0 - support.at.fraction;
  for (PointMass& mass : scene.masses) mass.at.fraction = 1.0 - mass.at.fraction;
  for (Probe& probe : scene.probes) probe.at.fraction = 1.0 - probe.at.fraction;
  return scene;
}

/// Pinned, stepped at a joint that carries a body, with bodies at both ends.
/// @param overhang  of both ends beyond the supports, over the length
Scene stepped(double overhang) {
  Scene scene = chain_scene(20);
  scene.supports = {{.at = {overhang, {}}, .kind = SupportKind::Pin},
                    {.at = {1.0 - overhang, {}}, .kind = SupportKind::Roller}};
  Region thin{{0.4, {}}, {1.0, {}}, scene.section, scene.material};
  thin.section.height = 0.012;
  scene.regions.push_back(thin);
  scene.masses = {{{0.4, {}}, 1.0, {0.02, 0.03, 0.01}},
                  {Place::start(), 0.5, {0.01, 0.0, 0.0}},
                  {Place::end(), 0.3, {0.0, 0.004, 0.002}}};
  scene.gravity = {0.0, -kGravity, 0.0};
  add_probe(scene, ProbeQuantity::Displacement, {0.4, {}}, Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, {0.7, {}}, Component::Y);
  return scene;
}

TEST(MirrorImage, HasTheSameFrequenciesAndDeflection) {
  for (const JointTranslation translation : {JointTranslation::Rigid, JointTranslation::Elastic}) {
    // What supports within the beam add to stretch and shear is of first order, and not mirrored.
    const Scene scene = stepped(translation == JointTranslation::Rigid ? 0.2 : 0.0);
    SolverOptions options{.level = Level::Planar, .translation = translation};
    const auto found = unloaded_frequencies(scene, options, 5);
    const auto image = unloaded_frequencies(mirrored(scene), options, 5);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(found[k] / image[k], 1.0, 1e-8) << k;
    const Response still = completed(scene, options);
    const Response there = completed(mirrored(scene), options);
    for (std::size_t p = 0; p < 2; ++p) {
      EXPECT_NEAR(last_of(still, p) / last_of(there, p), 1.0, tolerance(1e-8)) << p;
    }
  }
}

// In the frame of a bent beam's segments the inertia has products, and planes stay planes.
TEST(PlanarAndSpatial, HaveTheSameFrequenciesInThePlane) {
  Scene scene = cantilever_scene(12);
  scene.section.width = 0.5;  // stiff out of the plane
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.2;
  scene.beam.arc_towards = {0.0, 1.0, 0.0};
  scene.masses = {{{0.5, {}}, 2.0, {0.3, 0.2, 0.05}}, {Place::end(), 1.0, {0.05, 0.3, 0.1}}};
  scene.gravity = {0.0, -kGravity, 0.0};
  const auto planar = unloaded_frequencies(scene, {.level = Level::Planar}, 3);
  const auto spatial = unloaded_frequencies(scene, {.level = Level::Spatial}, 8);
  for (const double frequency : planar) {
    double nearest = 1.0;
    for (const double other : spatial) {
      nearest = std::min(nearest, std::fabs(other / frequency - 1.0));
    }
    EXPECT_LT(nearest, 1e-8) << frequency;
  }
}

TEST(PlanarAndSpatial, SagAlikeUnderMasses) {
  Scene scene = stepped(0.2);
  scene.section.width = 0.025;
  const Response planar = completed(scene, {.level = Level::Planar});
  const Response spatial = completed(scene, {.level = Level::Spatial});
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_NEAR(last_of(planar, p) / last_of(spatial, p), 1.0, tolerance(1e-8));
  }
}

}  // namespace
}  // namespace plastica
