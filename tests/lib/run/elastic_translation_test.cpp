#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "plastica/run/natural_frequencies.hpp"
#include "tests/lib/run/sheared_beam.hpp"

// Beams that stretch and shear: solver.translation = "elastic".

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::chain_scene;
using testing::completed;
using testing::elastic;
using testing::expect_second_order;
using testing::kPullForce;
using testing::last_of;
using testing::properties_of;
using testing::shear_stiffness_of;
using testing::tolerance;
using testing::value_of;

TEST(ElasticTranslation, StretchesABarByItsWholeLength) {
  for (const int segments : {1, 2, 3, 16}) {
    Scene scene = cantilever_scene(segments);
    scene.loads.push_back({.force = {0.0, 0.0, kPullForce}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Z);
    const double exact = kPullForce / (scene.material.youngs_modulus * properties_of(scene).area);
    // Coordinates of a metre have 1e-16.
    EXPECT_NEAR(value_of(scene), exact, tolerance(1e-15)) << segments;
  }
}

TEST(ElasticTranslation, StretchesABarByItsOwnWeight) {
  // rho g L^2/2E, and that is what equal segments give: the errors of both ends cancel.
  Scene scene = cantilever_scene(16);
  scene.gravity = {0.0, 0.0, 1e4};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Z);
  const double exact = scene.material.density * 1e4 / (2.0 * scene.material.youngs_modulus);
  EXPECT_NEAR(value_of(scene) / exact, 1.0, tolerance(1e-9));
}

TEST(ElasticTranslation, MovesAPointWithinByTheMeanOfBothSidesOfItsJoint) {
  // Half way down 3/4 of the elongation by its own weight, of order two.
  expect_second_order(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        scene.gravity = {0.0, 0.0, 1e4};
        add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Z);
        const double exact = scene.material.density * 1e4 / (2.0 * scene.material.youngs_modulus);
        return value_of(scene) / (0.75 * exact) - 1.0;
      },
      2.0);
}

TEST(ElasticTranslation, StretchesAStretchedBarByALoadWithin) {
  // The bar is pulled up to the load alone; its joint takes both sides' forces over their lengths.
  for (const int segments : {4, 10, 13}) {
    Scene scene = cantilever_scene(segments);
    scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 0.0, 1e3}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Z);
    const double exact = 0.5e3 / (scene.material.youngs_modulus * properties_of(scene).area);
    EXPECT_NEAR(value_of(scene) / exact, 1.0, tolerance(1e-9)) << segments;
  }
}

TEST(ElasticTranslation, BendsAndShearsATimoshenkoCantilever) {
  // P L^3/3EI + P L/kappa G A; the shear is exact, the bending 1/2N^2 of itself off.
  expect_second_order(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        scene.section.height = 0.4;
        scene.loads.push_back({.force = {0.0, kPullForce, 0.0}});
        add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
        const double exact = kPullForce / (3.0 * bending_stiffness_of(scene)) +
                             kPullForce / shear_stiffness_of(scene);
        return value_of(scene) / exact - 1.0;
      },
      0.55);
}

/// The determinant of the free end's moment and shear force over frequency, of Timoshenko's
/// cantilever: w' = V/S - phi, phi' = M/B, M' = V - rho I omega^2 phi, V' = -rho A omega^2 w,
/// integrated from the clamp by the classical Runge-Kutta method.
struct TimoshenkoCantilever {
  double bending, shear, line_mass, line_inertia;

  using State = std::array<double, 4>;  // w, phi, M, V

  State rate(const State& s, double omega2) const {
    return {s[3] / shear - s[1], s[2] / bending, s[3] - line_inertia * omega2 * s[1],
            -line_mass * omega2 * s[0]};
  }

  double determinant(double omega) const {
    constexpr int kSteps = 400;
    const double h = 1.0 / kSteps;
    std::array<State, 2> ends;
    for (std::size_t e = 0; e < 2; ++e) {
      State s{};
      s[2 + e] = 1.0;
      for (int i = 0; i < kSteps; ++i) {
        const auto at = [&](const State& k, double part) {
          State moved = s;
          for (std::size_t c = 0; c < 4; ++c) moved[c] += part * k[c];
          return moved;
        };
        const double o2 = omega * omega;
        const State k1 = rate(s, o2);
        const State k2 = rate(at(k1, 0.5 * h), o2);
        const State k3 = rate(at(k2, 0.5 * h), o2);
        const State k4 = rate(at(k3, h), o2);
        for (std::size_t c = 0; c < 4; ++c) {
          s[c] += h / 6.0 * (k1[c] + 2.0 * k2[c] + 2.0 * k3[c] + k4[c]);
        }
      }
      ends[e] = s;
    }
    return ends[0][2] * ends[1][3] - ends[0][3] * ends[1][2];
  }

  /// The first root above 0 [Hz].
  double first_frequency(double guess) const {
    double low = 0.2 * guess;
    double high = low;
    const bool sign = determinant(low) > 0.0;
    while ((determinant(high) > 0.0) == sign) high *= 1.1;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      ((determinant(middle) > 0.0) == sign ? low : high) = middle;
    }
    return 0.5 * (low + high) / (2.0 * std::numbers::pi);
  }
};

TEST(ElasticTranslation, VibratesAsATimoshenkoCantilever) {
  expect_second_order(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        scene.section.height = 0.4;
        scene.loads.push_back({.force = {0.0, kPullForce, 0.0}});
        const SectionProperties p = properties_of(scene);
        const double rho = scene.material.density;
        const double ei = bending_stiffness_of(scene);
        const TimoshenkoCantilever exact{ei, shear_stiffness_of(scene), rho * p.area,
                                         rho * p.second_moment_x};
        const double slender = 3.516 * std::sqrt(ei / (rho * p.area));
        SolverOptions options = elastic();
        options.level = Level::Planar;
        options.analysis = Analysis::Dynamics;
        options.duration = 1.0;
        const auto found = unloaded_frequencies(prepare(scene, options), 1);
        return found.front() / exact.first_frequency(slender) - 1.0;
      },
      1.0, {8, 16, 64});
}

TEST(ElasticTranslation, IsAlikeAtStartAndEnd) {
  for (const YieldModel model : {YieldModel::Elastic, YieldModel::Fibre}) {
    const auto scene_of = [&](bool turned) {
      Scene scene = chain_scene(9);
      scene.section.height = 0.2;
      scene.yield_model = model;
      const Place clamp = turned ? Place::end() : Place::start();
      const Place prop = turned ? Place::start() : Place::end();
      scene.supports.push_back({.at = clamp, .kind = SupportKind::Clamp});
      scene.supports.push_back({.at = prop, .kind = SupportKind::Roller});
      const double pull = turned ? -2e5 : 2e5;
      scene.loads.push_back({.at = prop, .force = {0.0, 0.0, pull}});
      scene.loads.push_back(
          {.at = Place::start(), .to = Place::end(), .force = {0.0, -3.2e5, 0.0}});
      add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
      add_probe(scene, ProbeQuantity::Reaction, clamp, Component::Y);
      add_probe(scene, ProbeQuantity::ReactionMoment, clamp, Component::X);
      add_probe(scene, ProbeQuantity::Energy, clamp, Component::X);
      scene.probes.back().energy = EnergyKind::Elastic;
      add_probe(scene, ProbeQuantity::Energy, clamp, Component::X);
      scene.probes.back().energy = EnergyKind::Plastic;
      return scene;
    };
    SolverOptions options = elastic(10);
    options.tolerance = 1e-12;
    const Response one = completed(scene_of(false), options);
    const Response other = completed(scene_of(true), options);
    for (std::size_t p = 0; p < one.probes.size(); ++p) {
      const double a = last_of(one, p);
      const double b = last_of(other, p);
      EXPECT_NEAR(std::fabs(a), std::fabs(b), tolerance(1e-10) * std::fabs(a)) << p;
    }
  }
}

TEST(ElasticTranslation, LeavesASymmetricArchSymmetric) {
  // Pinned at both feet, pushed at its crown: the crown goes straight down.
  Scene scene = chain_scene(16);
  scene.section.height = 0.05;
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 2.0;
  for (const Place& foot : {Place::start(), Place::end()}) {
    scene.supports.push_back({.at = foot, .kind = SupportKind::Pin});
  }
  // The chord from foot to foot stands at half the arc's angle to z.
  const double along_y = -std::cos(1.0);
  const double along_z = std::sin(1.0);
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 1e4 * along_y, 1e4 * along_z}});
  // Points in the middle of segments that mirror each other.
  for (const double at : {0.46875, 0.53125}) {
    add_probe(scene, ProbeQuantity::Displacement, {at, {}}, Component::Y);
    add_probe(scene, ProbeQuantity::Displacement, {at, {}}, Component::Z);
  }
  const Response response = completed(scene, elastic(5));
  const double y = last_of(response, 0) + last_of(response, 2);
  const double z = last_of(response, 1) + last_of(response, 3);
  const double down = std::fabs(y * along_y + z * along_z);
  const double aside = std::fabs(-y * along_z + z * along_y);
  EXPECT_GT(down, 1e-4);
  EXPECT_LT(aside, tolerance(1e-9) * down);
}

TEST(ElasticTranslation, MovesWithARollerAtTheStartAndAClampAtTheEnd) {
  // The same beam with its ends exchanged moves alike; neither is held twice.
  const auto moved = [](bool turned) {
    Scene scene = chain_scene(6);
    scene.section.height = 0.2;
    scene.supports.push_back(
        {.at = turned ? Place::end() : Place::start(), .kind = SupportKind::Clamp});
    scene.supports.push_back(
        {.at = turned ? Place::start() : Place::end(), .kind = SupportKind::Roller});
    scene.loads.push_back({.at = Place::start(), .to = Place::end(), .force = {0.0, -1e4, 0.0}});
    scene.loads[0].history = {{0.0}, {1.0}};
    add_probe(scene, ProbeQuantity::Displacement, {7.0 / 12.0, {}}, Component::Y);
    scene.probes.back().at = {turned ? 5.0 / 12.0 : 7.0 / 12.0, {}};
    SolverOptions options = elastic(20);
    options.analysis = Analysis::Dynamics;
    options.duration = 2e-3;
    options.time_step = 1e-4;
    return last_of(completed(scene, options), 0);
  };
  const double one = moved(false);
  EXPECT_GT(std::fabs(one), 1e-7);
  EXPECT_NEAR(moved(true) / one, 1.0, tolerance(1e-8));
}

}  // namespace
}  // namespace plastica
