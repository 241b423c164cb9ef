#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/run/axial_warning.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "tests/support/chain_scene.hpp"

// Beams with a hinge of their own against statics and beam theory (Gerber's beam; two cantilevers
// that meet in a hinge). Loads are small.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::completed;
using testing::last_of;

void add_hinge(Scene& scene, double at) {
  scene.supports.push_back({.at = {at, {}}, .kind = SupportKind::Hinge});
}

/// 1 m, clamped at the start, on a roller at the end, with a hinge between.
Scene gerber_beam(int segments, double hinge) {
  Scene scene = testing::cantilever_scene(segments);
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  add_hinge(scene, hinge);
  return scene;
}

void expect_hinge_errors_fall(const std::function<double(int)>& error, double largest) {
  const double coarse = std::fabs(error(16));
  const double middle = std::fabs(error(64));
  const double fine = std::fabs(error(256));
  EXPECT_LT(coarse, largest);
  EXPECT_NEAR(std::log(coarse / middle) / std::log(4.0), 2.0, 0.1);
  EXPECT_NEAR(std::log(middle / fine) / std::log(4.0), 2.0, 0.1);
}

/// Under an even load q the hung span is a simple beam, half of whose load the cantilever carries.
TEST(Hinge, OfAGerberBeamLetsItHangAsStaticsSays) {
  constexpr double kHinge = 0.5;
  constexpr double kLoad = 0.01;  // [N/m]
  for (const auto level : {Level::Planar, Level::Spatial}) {
    const auto error_at = [&](std::size_t probe) {
      return [&, probe](int segments) {
        Scene scene = gerber_beam(segments, kHinge);
        scene.loads.push_back(
            {.at = Place::start(), .to = Place::end(), .force = {0.0, kLoad, 0.0}});
        add_probe(scene, ProbeQuantity::Displacement, {kHinge, {}}, Component::Y);
        add_probe(scene, ProbeQuantity::Displacement, {0.5 * (kHinge + 1.0), {}}, Component::Y);
        add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
        add_probe(scene, ProbeQuantity::Moment, {kHinge, {}}, Component::X);
        const Response response = completed(scene, {.level = level, .steps = 1});
        const double span = 1.0 - kHinge;
        EXPECT_NEAR(last_of(response, 2), -0.5 * kLoad * span, 1e-9 * kLoad);
        EXPECT_NEAR(last_of(response, 3), 0.0, 1e-12 * kLoad);
        const double stiffness = bending_stiffness_of(scene);
        const double sunk =
            (0.5 * kLoad * span * std::pow(kHinge, 3) / 3.0 + kLoad * std::pow(kHinge, 4) / 8.0) /
            stiffness;
        const double hung = 5.0 / 384.0 * kLoad * std::pow(span, 4) / stiffness + 0.5 * sunk;
        return last_of(response, probe) / (probe == 0 ? sunk : hung) - 1.0;
      };
    };
    expect_hinge_errors_fall(error_at(0), 1.2e-2);
    expect_hinge_errors_fall(error_at(1), 1.2e-2);
  }
}

/// Both ways and seen from either end it is the same beam, and a torque goes through the hinge.
TEST(Hinge, LetsBothBendingsGoAndCarriesTorque) {
  Scene scene = testing::cantilever_scene(10);
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  add_hinge(scene, 0.4);
  scene.loads.push_back({.at = {0.7, {}}, .force = {0.1, 0.1, 0.0}});
  scene.loads.push_back({.at = Place::end(), .moment = {0.0, 0.0, 1e-4}});
  add_probe(scene, ProbeQuantity::Displacement, {0.4, {}}, Component::X);
  add_probe(scene, ProbeQuantity::Displacement, {0.4, {}}, Component::Y);
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
  const Response response = completed(scene, {.level = Level::Spatial, .steps = 1});
  EXPECT_NEAR(last_of(response, 0), last_of(response, 1), 1e-6 * last_of(response, 1));
  const double shear = scene.material.youngs_modulus / 2.6;
  const double twist = 1e-4 / (shear * testing::properties_of(scene).torsion_constant);
  EXPECT_NEAR(last_of(response, 2), twist, 1e-4 * twist);
}

TEST(Hinge, SeenFromTheOtherEndIsTheSame) {
  const auto sunk = [](bool mirrored) {
    const auto at = [&](double fraction) {
      return Place{mirrored ? 1.0 - fraction : fraction, {}};
    };
    Scene scene = testing::chain_scene(12);
    scene.supports.push_back({.at = at(0.0), .kind = SupportKind::Clamp});
    scene.supports.push_back({.at = at(1.0), .kind = SupportKind::Roller});
    add_hinge(scene, at(0.25).fraction);
    scene.loads.push_back({.at = at(0.5), .force = {0.0, 100.0, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, at(0.25), Component::Y);
    return last_of(completed(scene, {.level = Level::Planar, .steps = 4}), 0);
  };
  EXPECT_NEAR(sunk(true), sunk(false), 1e-9 * std::fabs(sunk(false)));
}

/// Clamped at both ends with a hinge in the middle: in its first mode neither moment nor shear is
/// there, and each half swings as a cantilever, (1.8751/l)^2 sqrt(E I/rho A).
TEST(Hinge, BetweenTwoCantileversHasTheirFrequency) {
  expect_hinge_errors_fall(
      [](int segments) {
        Scene scene = testing::cantilever_scene(segments);
        scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
        add_hinge(scene, 0.5);
        scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
        const double mass = scene.material.density * testing::properties_of(scene).area;
        const double exact = std::pow(1.8751040687 / 0.5, 2) *
                             std::sqrt(bending_stiffness_of(scene) / mass) /
                             (2.0 * std::numbers::pi);
        const auto found = unloaded_frequencies(
            prepare(scene, {.level = Level::Planar, .rotary_inertia = RotaryInertia::Off}), 1);
        return found.at(0) / exact - 1.0;
      },
      2e-2);
}

/// The plastic hinge at the clamp is the only one that the collapse needs, at P = M_p/a. Beyond it
/// the arm turns until it is short enough: P a cos(turn) = M_p.
TEST(Hinge, LeavesACantileverItsLimitLoad) {
  const auto sunk = [](double fraction) {
    Scene scene = gerber_beam(32, 0.5);
    scene.yield_model = YieldModel::Interaction;
    scene.yield_cap = YieldCap::FullyPlastic;
    const double plastic = 1.5 * testing::yield_moment_of(scene);
    scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, fraction * plastic / 0.5, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
    const double elastic = fraction * plastic * 0.25 / (3.0 * bending_stiffness_of(scene));
    return last_of(completed(scene, {.level = Level::Planar}), 0) / elastic;
  };
  EXPECT_NEAR(sunk(0.99), 1.0, 5e-3);
  EXPECT_GT(sunk(1.01), 3.0);
}

std::string refusal_of(const std::function<void(Scene&)>& change) {
  Scene scene = gerber_beam(8, 0.5);
  scene.loads.push_back({.at = {0.25, {}}, .force = {0.0, 1.0, 0.0}});
  change(scene);
  try {
    (void)simulate(scene, {.level = Level::Planar, .steps = 1});
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Hinge, IsRefusedWhereItMakesNoSense) {
  EXPECT_EQ(refusal_of([](Scene&) {}), "none");
  EXPECT_EQ(refusal_of([](Scene& s) { s.supports.erase(s.supports.begin() + 1); }),
            "support: the supports together leave the beam free to rotate about x beside a hinge "
            "(level planar)");
  EXPECT_EQ(refusal_of([](Scene& s) { add_hinge(s, 0.75); }),
            "support: the supports together leave the beam free to rotate about x beside a hinge "
            "(level planar)");
  EXPECT_EQ(refusal_of([](Scene& s) { s.supports[2].at = Place::end(); }),
            "support[3].at = end: a hinge must be within the beam; at an end, a pin lets it turn");
  EXPECT_EQ(refusal_of([](Scene& s) { add_hinge(s, 0.5); }),
            "support[4].at = 0.5: support[3] is a hinge at the same place");
  EXPECT_EQ(refusal_of([](Scene& s) {
              s.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Guide});
            }),
            "support[4].at = 0.5: a rotation is held at a hinge (support[3] is at the same place): "
            "give it a place beside the hinge");
  EXPECT_EQ(refusal_of([](Scene& s) {
              s.loads.push_back({.at = {0.5, {}}, .moment = {1.0, 0.0, 0.0}});
            }),
            "load[2].moment: acts at a hinge: give it a place beside the hinge");
  EXPECT_EQ(refusal_of([](Scene& s) {
              s.loads.push_back({.at = {0.5, {}}, .force = {0.0, 1.0, 0.0}, .follows = true});
            }),
            "load[2].follows = true: would follow one of the two sides of a hinge: give it a place "
            "beside the hinge");
  EXPECT_EQ(refusal_of([](Scene& s) {
              s.masses.push_back({.at = {0.5, {}}, .mass = 1.0, .inertia = {1.0, 1.0, 1.0}});
            }),
            "mass[1].inertia: turns with one of the two sides of a hinge: give it a place beside "
            "the hinge");
  EXPECT_EQ(refusal_of([](Scene& s) {
              add_probe(s, ProbeQuantity::Strain, {0.5, {}}, Component::X);
            }),
            "probe[1].kind = strain: is none where the beam turns freely, at a hinge: \"angle\" is "
            "by how much");
  EXPECT_EQ(refusal_of([](Scene& s) {
              add_probe(s, ProbeQuantity::Reaction, {0.5, {}}, Component::Y);
            }),
            "probe[1].kind = reaction: is none at a hinge, which holds nothing to the ground: "
            "\"force\" is what goes through it");
  EXPECT_EQ(refusal_of([](Scene& s) { s.supports[2].hold = HeldFreedoms{true}; }),
            "support[3].hold: a hinge lets go; what holds the beam there is another support");
  EXPECT_EQ(refusal_of([](Scene& s) {
              s.beam.segment_fractions.assign(8, 0.125);
              s.supports[2].at = {0.3, {}};
            }),
            "support[3].at = 0.3: a hinge must be at a segment's end");
}

/// The same beam along another axis of the world: bending is what turns it across that.
TEST(Hinge, KnowsTorqueFromBendingWhereverTheBeamPoints) {
  const auto refused = [](const std::array<double, 3>& end, const std::array<double, 3>& moment) {
    Scene scene = testing::cantilever_scene(8);
    scene.beam.shape = BeamShape::Polyline;
    scene.beam.points = {{0.0, 0.0, 0.0}, end};
    add_hinge(scene, 0.5);
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Pin});
    scene.loads.push_back({.at = {0.5, {}}, .moment = moment});
    try {
      check_scene(scene, {.level = Level::Spatial});
    } catch (const InputError& error) {
      return std::string(error.what()).find("acts at a hinge") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(refused({0.0, 1.0, 0.0}, {0.0, 5.0, 0.0}));
  EXPECT_TRUE(refused({0.0, 1.0, 0.0}, {0.0, 0.0, 5.0}));
  EXPECT_TRUE(refused({0.0, 1.0, 0.0}, {0.0, 5.0, 1e-3}));
  EXPECT_FALSE(refused({0.6, 0.0, 0.8}, {3.0, 0.0, 4.0}));
  EXPECT_TRUE(refused({0.6, 0.0, 0.8}, {4.0, 0.0, -3.0}));
}

/// Held by the clamp alone, and the hinge lets the outer part go: nothing keeps it in the plane.
TEST(Hinge, UnderThrustLeavesTheBeamFreeToLeaveItsPlaneAndThatIsSaid) {
  for (const bool held : {false, true}) {
    Scene scene = gerber_beam(16, 0.5);
    scene.yield_model = YieldModel::Elastic;
    if (held) scene.supports[1].hold = HeldFreedoms{true, true, false, false, false, false};
    if (!held) scene.supports[1].hold = HeldFreedoms{false, true, false, false, false, false};
    scene.loads.push_back({.at = {0.25, {}}, .force = {0.0, 100.0, 0.0}});
    EXPECT_FALSE(simulate(scene, {.level = Level::Planar}).unheld_thrust);
    scene.loads.push_back({.at = Place::end(), .force = {0.0, 0.0, -600.0}});
    const Response response = simulate(scene, {.level = Level::Planar});
    EXPECT_EQ(response.unheld_thrust, !held);
    EXPECT_EQ(axial_warnings(scene, {}, response).size(), held ? 0U : 1U);
  }
}

}  // namespace
}  // namespace plastica
