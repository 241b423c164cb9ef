#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "plastica/io/scene_file.hpp"
#include "tests/support/chain_scene.hpp"

/// The files of data/scenes against the figures that the comment at their top expects. Those of the
/// report, and those that move, have tests of their own.
namespace plastica {
namespace {

using std::numbers::pi;

struct ShippedRun {
  Setup setup;
  Response response;

  std::size_t number_of(const std::string& probe) const {
    const auto& probes = setup.scene.probes;
    const auto found =
        std::ranges::find_if(probes, [&](const Probe& p) { return p.name == probe; });
    EXPECT_NE(found, probes.end()) << probe;
    return static_cast<std::size_t>(found - probes.begin());
  }
  std::vector<double> values(const std::string& probe) const {
    const auto& all = response.probes.at(number_of(probe));
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(response.samples)};
  }
  /// The last value of a probe is as expected, within a fraction of that.
  void expect_last(const std::string& probe, double expected, double within) const {
    EXPECT_NEAR(values(probe).back(), expected, within * std::fabs(expected)) << probe;
  }
};

ShippedRun run_scene(const std::string& name, Status status = Status::Completed) {
  ShippedRun run{
      io::read_scene_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml")
          .setup,
      {}};
  run.response = simulate(run.setup.scene, run.setup.solver);
  EXPECT_EQ(run.response.status, status) << name_of(run.response.status);
  return run;
}

TEST(ShippedScenes, GerberBeamHasTheMomentsOfStatics) {
  const ShippedRun run = run_scene("gerber_beam");
  run.expect_last("start", 6250.0, 1e-4);
  run.expect_last("middle", 31250.0, 1e-4);
  run.expect_last("end", 12500.0, 1e-4);
  run.expect_last("support_moment", 15000.0, 1e-4);
  run.expect_last("span_moment", -15625.0, 1e-4);
  EXPECT_NEAR(run.values("hinge_moment").back(), 0.0, 1e-6);
  // Of the overhang: the hung span's force, its own load, and what the first span lifts.
  const double bending = 210e9 * 5696e-8;
  const double sinks =
      (12500.0 * 5.0 / 3.0 + 5000.0 * 19.0 / 24.0 - 5000.0 * 64.0 / 24.0) / bending;
  run.expect_last("hinge", -sinks, 1e-2);
}

TEST(ShippedScenes, BeamOfANamedProfileCarriesItsPlasticMoment) {
  const ShippedRun run = run_scene("profile_limit_load", Status::LimitLoad);
  ASSERT_TRUE(run.response.limit);
  const double factor = 8.0 * 642.5e-6 * 235e6 / 16.0 / 90e3;
  EXPECT_NEAR(run.response.limit->below, factor, 5e-3 * factor);
  EXPECT_NEAR(run.response.limit->above, factor, 5e-3 * factor);
}

TEST(ShippedScenes, WeldedISectionBendsBothWaysAsItsSecondMomentsSay) {
  const double b = 0.2, h = 0.2, t = 0.005, inner = h - 2.0 * t;
  const double about_x = (b * std::pow(h, 3) - (b - t) * std::pow(inner, 3)) / 12.0;
  const double about_y = (2.0 * t * std::pow(b, 3) + inner * std::pow(t, 3)) / 12.0;
  const ShippedRun run = run_scene("i_section");
  run.expect_last("down", -300.0 * 27.0 / (3.0 * 210e9 * about_x), 1e-3);
  run.expect_last("aside", 30.0 * 27.0 / (3.0 * 210e9 * about_y), 1e-3);
}

TEST(ShippedScenes, SectionOfNumbersBendsAndTwistsAsTheySay) {
  const double side = 0.027 / std::sqrt(3.0);
  const double area = 1.5 * std::sqrt(3.0) * side * side;
  const double bending = 210e9 * 5.0 * std::sqrt(3.0) / 16.0 * std::pow(side, 4);
  const double torsion = 210e9 / 2.6 * 0.133 * area * 0.027 * 0.027;
  const ShippedRun run = run_scene("section_numbers");
  run.expect_last("down", -100.0 / (3.0 * bending), 1e-3);
  run.expect_last("torque", 0.02 * torsion, 1e-3);
}

TEST(ShippedScenes, HardeningTableIsFollowedThereAndBack) {
  const ShippedRun run = run_scene("hardening_table");
  const auto stress = run.values("stress");
  EXPECT_NEAR(*std::max_element(stress.begin(), stress.end()), 390e6, 1.0);
  EXPECT_NEAR(stress.back(), -300e6, 1.0);
  run.expect_last("plastic_strain", 0.025, 1e-9);
}

/// As the comment says, by the trapezoidal rule; and where it springs back from.
TEST(ShippedScenes, StruckBarStopsTheBodyWithTheStressOfItsRate) {
  const double reach = std::pow(5.0 / (0.5 * 40.4), 0.2);
  double integral = 0.0;
  constexpr int kSteps = 10000;
  for (int i = 0; i < kSteps; ++i) {
    const double u = reach * (i + 0.5) / kSteps;
    integral += std::pow(u, 9) / (1.0 + u) * reach / kSteps;
  }
  const double force = 1e-4 * 235e6;
  const double path = 5.0 * 100.0 * std::pow(0.5 * 40.4, 2) / force * integral;
  const double elastic = 235e6 / 210e9 * 0.5;
  const auto body = run_scene("struck_bar").values("body");
  EXPECT_NEAR(*std::max_element(body.begin(), body.end()), path + elastic, 5e-3 * path);
  EXPECT_LT(path, 0.6 * 100.0 * 25.0 / (2.0 * force));
}

TEST(ShippedScenes, InclinedRollerPushesAlongItsNormal) {
  const ShippedRun run = run_scene("inclined_roller");
  run.expect_last("up", 100.0, 1e-3);
  run.expect_last("along", -100.0 / std::sqrt(3.0), 1e-3);
  const double bending = 210e9 * std::pow(0.04, 4) / 12.0;
  const double thrust = 100.0 / std::sqrt(3.0);
  const double sag = 5.0 * 100.0 * 16.0 / (384.0 * bending);
  run.expect_last("middle", -sag / (1.0 - thrust * 4.0 / (pi * pi * bending)), 1e-3);
}

TEST(ShippedScenes, ElasticFoundationCarriesAsHetenyiSays) {
  const double length = 12.0, stiffness = 10e6, force = 100e3;
  const double b = length * std::pow(stiffness / (4.0 * 210e9 * 5696e-8), 0.25);
  const double below = std::sinh(b) + std::sin(b);
  const ShippedRun run = run_scene("elastic_foundation");
  run.expect_last(
      "sinks", -force * b / (2.0 * stiffness * length) * (std::cosh(b) + std::cos(b) + 2.0) / below,
      3e-3);
  run.expect_last("moment", -force * length / (4.0 * b) * (std::cosh(b) - std::cos(b)) / below,
                  3e-3);
  run.expect_last("bed", force, 1e-6);
}

/// The mass on the spring that sine_force.toml and smooth_step_force.toml are.
struct OneMass {
  double stiffness = 3.0 * 210e9 * std::pow(0.02, 4) / 12.0 / 0.125;
  double mass = 5.73 + 33.0 / 140.0 * 0.5 * 4e-4 * 7850.0;
  double rate = std::sqrt(stiffness / mass);
  double at_rest = 61.0 / stiffness;
};

TEST(ShippedScenes, SineForceMakesTheForcedVibrationOfOneMass) {
  const OneMass one;
  const double rate = 2.0 * pi / 0.08;
  const double ratio = rate / one.rate;
  const ShippedRun run = run_scene("sine_force");
  const auto body = run.values("body");
  double largest = 0.0, off = 0.0;
  for (std::size_t k = 0; k < body.size(); ++k) {
    const double t = run.response.chain.time[k];
    const double exact =
        one.at_rest * (std::sin(rate * t) - ratio * std::sin(one.rate * t)) / (1.0 - ratio * ratio);
    largest = std::max(largest, std::fabs(exact));
    off = std::max(off, std::fabs(body[k] - exact));
  }
  EXPECT_NEAR(largest, 3.54e-3, 1e-5);
  EXPECT_LT(off, 1e-2 * largest);
}

TEST(ShippedScenes, SmoothStepForceLeavesHardlyARing) {
  const OneMass one;
  const double a = one.rate * 0.12;
  const double ring = std::fabs(2.0 / a * std::sin(a / 2.0) - std::cos(a / 2.0)) * 12.0 / (a * a);
  const ShippedRun run = run_scene("smooth_step_force");
  const auto body = run.values("body");
  double low = 1.0, high = 0.0;
  for (std::size_t k = 0; k < body.size(); ++k) {
    if (run.response.chain.time[k] < 0.12) continue;
    low = std::min(low, body[k]);
    high = std::max(high, body[k]);
  }
  EXPECT_NEAR(0.5 * (high + low), one.at_rest, 2e-3 * one.at_rest);
  EXPECT_NEAR(0.5 * (high - low) / one.at_rest, ring, 0.02 * ring);
}

TEST(ShippedScenes, RecordedForceBendsTheTipByEachRow) {
  const ShippedRun run = run_scene("recorded_force");
  const std::vector<double> force{0.0, 12.0, 20.0, 15.0, -5.0, -10.0, 0.0};
  const auto tip = run.values("tip");
  ASSERT_EQ(tip.size(), force.size());
  const double stiffness = 3.0 * 210e9 * std::pow(0.02, 4) / 12.0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    EXPECT_NEAR(run.response.chain.time[k], 0.01 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(tip[k], -force[k] / stiffness, 1e-3 * std::fabs(force[k]) / stiffness + 1e-12);
  }
}

TEST(ShippedScenes, TaperedCantileverBendsAsTheUnitLoadTheoremSays) {
  const double bending = 210e9 * 0.02 * std::pow(0.03, 3) / 12.0;
  run_scene("tapered_cantilever")
      .expect_last("tip", -(8.0 * std::numbers::ln2 - 5.0) * 90.0 / bending, 1e-3);
}

}  // namespace
}  // namespace plastica
