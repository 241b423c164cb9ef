#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;
using testing::last_of;

constexpr double kYield = 250e6;
constexpr double kYoung = 200e9;

/// Mild steel of Cowper and Symonds.
const RateDependence kSteel{RateLaw::CowperSymonds, 40.4, 5.0, {}, {}};

double factor_at(double rate) { return 1.0 + std::pow(rate / 40.4, 0.2); }

/// A cantilever so light that its inertia does not count.
Scene light(int segments, YieldModel model) {
  Scene scene = testing::cantilever_scene(segments);
  scene.material.density = 0.01;
  scene.material.rate = kSteel;
  scene.yield_model = model;
  return scene;
}

SolverOptions in_motion(Level level, double duration, int steps,
                        Scheme scheme = Scheme::GeneralizedAlpha) {
  return {.level = level,
          .analysis = Analysis::Dynamics,
          .duration = duration,
          .steps = 10,
          .scheme = scheme,
          .time_step = duration / steps,
          .rho_infinity = 0.0};
}

/// Its end is turned evenly, and free otherwise: it bends to an arc, or twists.
Scene turned(int segments, YieldModel model, std::array<double, 3> rotation, double duration) {
  Scene scene = light(segments, model);
  Support hand{.at = Place::end(), .kind = SupportKind::Clamp};
  hand.hold = HeldFreedoms{};
  for (std::size_t k = 0; k < 3; ++k) (*hand.hold)[3 + k] = rotation[2] != 0.0 || k == 0;
  hand.rotation = rotation;
  hand.history = {{0.0, duration}, {0.0, 1.0}};
  scene.supports.push_back(hand);
  return scene;
}

/// Pulled at an even speed: the stress of its rate, in each model and direction.
TEST(Rates, PullsAsTheRateSays) {
  for (const YieldModel model : {YieldModel::PerAxis, YieldModel::Interaction, YieldModel::Fibre}) {
    for (const double speed : {0.02, 20.0}) {
      const double duration = 0.05 / speed;
      Scene scene = light(4, model);
      scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
      scene.supports[1].translation = {0.0, 0.0, speed * duration};
      scene.supports[1].history = {{0.0, duration}, {0.0, 1.0}};
      add_probe(scene, ProbeQuantity::Force, {0.5, {}}, Component::Z);
      SolverOptions options = in_motion(Level::Planar, duration, 400);
      options.translation = JointTranslation::Elastic;
      const double exact = kYield * 4e-4 * factor_at(speed);
      EXPECT_NEAR(std::fabs(last_of(completed(scene, options), 0)), exact, 1e-3 * exact)
          << static_cast<int>(model) << " " << speed;
    }
  }
}

/// First yield: the extreme fibre's rate is that of the curvature times the half depth.
TEST(Rates, BendsAsTheRateOfTheExtremeFibreSays) {
  const double duration = 0.05;
  const double exact = kYield * std::pow(0.02, 3) / 6.0 * factor_at(1.0 / duration * 0.01);
  for (const YieldModel model :
       {YieldModel::PerAxis, YieldModel::Interaction, YieldModel::Conservative}) {
    for (const Level level : {Level::Planar, Level::Spatial}) {
      Scene scene = turned(4, model, {1.0, 0.0, 0.0}, duration);
      add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::X);
      const Response response = completed(scene, in_motion(level, duration, 200));
      EXPECT_NEAR(std::fabs(last_of(response, 0)), exact, 1e-3 * exact)
          << static_cast<int>(model) << " " << static_cast<int>(level);
    }
  }
}

TEST(Rates, TwistAsTheEquivalentRateSays) {
  const double duration = 0.05;
  Scene scene = turned(4, YieldModel::Interaction, {0.0, 0.0, 1.0}, duration);
  scene.section.shape = SectionShape::Circle;
  scene.section.radius = 0.01;
  add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::Z);
  const double rate = 1.0 / duration * 0.01 / std::sqrt(3.0);
  const double exact = kYield / std::sqrt(3.0) * M_PI * std::pow(0.01, 3) / 2.0 * factor_at(rate);
  const Response response = completed(scene, in_motion(Level::Spatial, duration, 200));
  EXPECT_NEAR(std::fabs(last_of(response, 0)), exact, 1e-3 * exact);
}

/// Stress of a fibre that is strained evenly from nothing: s' = E (rate - C ((s - Y)/Y)^5), by
/// small explicit steps.
double fibre_stress(double rate, double duration) {
  constexpr int kSteps = 10000;
  double stress = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double over = std::max(0.0, stress / kYield - 1.0);
    stress += kYoung * (rate - 40.4 * std::pow(over, 5.0)) * duration / kSteps;
  }
  return stress;
}

TEST(Rates, BendFibresEachAtItsOwnRate) {
  const double duration = 0.05, angle = 1.0;
  double exact = 0.0;  // both halves, midpoints
  constexpr int kPoints = 60;
  for (int i = 0; i < kPoints; ++i) {
    const double y = 0.01 * (i + 0.5) / kPoints;
    exact += 2.0 * 0.02 * y * fibre_stress(angle / duration * y, duration) * 0.01 / kPoints;
  }
  // Beams of ideal plasticity have 2P/(2P + 1) of the extreme fibre's factor (Perrone 1965).
  const double plastic = kYield * std::pow(0.02, 3) / 4.0;
  EXPECT_NEAR(exact / plastic, 1.0 + 10.0 / 11.0 * (factor_at(angle / duration * 0.01) - 1.0),
              0.01);
  for (const Level level : {Level::Planar, Level::Spatial}) {
    Scene scene = turned(2, YieldModel::Fibre, {angle, 0.0, 0.0}, duration);
    add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::X);
    SolverOptions options = in_motion(level, duration, 100);
    options.fibres = level == Level::Spatial ? 16 : 40;
    EXPECT_NEAR(std::fabs(last_of(completed(scene, options), 0)), exact, 2e-3 * exact)
        << static_cast<int>(level);
  }
}

/// A push of 5 ms, three times what the beam carries at rest, and what is left of it.
Scene pushed(const RateDependence& rate) {
  Scene scene = testing::cantilever_scene(6);
  scene.yield_model = YieldModel::Interaction;
  scene.material.rate = rate;
  const double carried = kYield * std::pow(0.02, 3) / 6.0;
  scene.loads = {{.at = Place::end(), .force = {0.0, 3.0 * carried, 0.0}}};
  scene.loads[0].history = {{0.0, 0.005, 0.006}, {1.0, 1.0, 0.0}};
  add_probe(scene, ProbeQuantity::PlasticAngle, Place::start(), Component::X);
  return scene;
}

double hinge_after(const RateDependence& rate, Scheme scheme, int steps) {
  return std::fabs(
      last_of(completed(pushed(rate), in_motion(Level::Planar, 0.02, steps, scheme)), 0));
}

TEST(Rates, EverySchemeComesToTheSameEnd) {
  const double end = hinge_after(kSteel, Scheme::EnergyMomentum, 3200);
  EXPECT_LT(end, 0.9 * hinge_after({}, Scheme::EnergyMomentum, 800));  // harder
  for (const Scheme scheme : {Scheme::LinearlyImplicitEuler, Scheme::LinearlyImplicitMidpoint,
                              Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    const double error = std::fabs(hinge_after(kSteel, scheme, 1600) / end - 1.0);
    EXPECT_LT(error, scheme == Scheme::LinearlyImplicitEuler ? 0.03 : 2e-3)
        << static_cast<int>(scheme);
  }
}

/// What came in is stored, dissipated or still moves: the scheme keeps energy.
TEST(Rates, KeepsEnergyBalanced) {
  for (const int steps : {400, 1600}) {
    const Response response =
        completed(pushed(kSteel), in_motion(Level::Planar, 0.02, steps, Scheme::EnergyMomentum));
    const Energies& energy = response.chain.energy.at(response.samples - 1);
    EXPECT_GT(energy.plastic, 0.3 * energy.external);
    EXPECT_NEAR(energy.kinetic + energy.elastic + energy.plastic, energy.external,
                1e-6 * energy.external);
  }
}

/// At rest a rate that all has is a larger yield stress; so in a motion, with any scheme.
TEST(Rates, OfAllAreALargerYieldStress) {
  Scene rated = testing::cantilever_scene(6);
  rated.yield_model = YieldModel::PerAxis;
  add_probe(rated, ProbeQuantity::Displacement, Place::end(), Component::Y);
  Scene raised = rated;
  rated.material.rate = kSteel;
  rated.material.rate.strain_rate = 10.0;
  raised.material.yield_stress *= factor_at(10.0);
  const double carried = testing::yield_moment_of(raised);
  rated.loads = {{.at = Place::end(), .moment = {1.001 * carried, 0.0, 0.0}}};
  EXPECT_EQ(simulate(rated, {}).status, Status::LimitLoad);
  rated.loads[0].moment[0] = 0.999 * carried;
  EXPECT_EQ(simulate(rated, {}).status, Status::Completed);
  rated.loads[0].moment[0] = 1.1 * carried;
  raised.loads = rated.loads;
  const SolverOptions options = in_motion(Level::Planar, 0.02, 2000, Scheme::ArticulatedMidpoint);
  const double end = last_of(completed(raised, options), 0);
  EXPECT_NEAR(last_of(completed(rated, options), 0), end, 1e-9 * std::fabs(end));
}

std::string refusal(const Scene& scene, const SolverOptions& options) {
  return testing::message_of([&] { prepare(scene, options); });
}

TEST(Rates, RefusesARateLawWhereThereIsNoRate) {
  Scene scene = light(4, YieldModel::Interaction);
  scene.loads = {{.at = Place::end(), .force = {0.0, 1.0, 0.0}}};
  EXPECT_EQ(refusal(scene, {}),
            "material.rate.strain_rate: is missing: a scene at rest, or a coupon, knows no time; "
            "the rate law needs a rate that all has");
  EXPECT_EQ(refusal(scene, in_motion(Level::Planar, 1.0, 10, Scheme::ArticulatedEuler)),
            "material.rate.strain_rate: is missing: an articulated scheme has no rates of joints; "
            "the rate law needs a rate that all has");
  SolverOptions rough = in_motion(Level::Planar, 1.0, 10);
  rough.precision = Precision::Float;
  EXPECT_EQ(refusal(scene, rough),
            "material.rate.strain_rate: is missing: solver.precision = \"float\" has no rates of "
            "joints; the rate law needs a rate that all has");
  scene.material.rate.exponent.reset();
  EXPECT_EQ(refusal(scene, {}),
            "material.rate.exponent: is missing: material.rate.law = \"cowper_symonds\" needs it");
  scene.material.rate.exponent = 0.5;
  EXPECT_EQ(refusal(scene, {}), "material.rate.exponent = 0.5: must be at least 1");
  scene.material.rate = {};
  scene.regions = {{Place::start(), {0.5, {}}, scene.section, scene.material}};
  scene.regions[0].material.rate = kSteel;
  EXPECT_EQ(refusal(scene, in_motion(Level::Planar, 1.0, 10)),
            "region[1].material.rate.law = cowper_symonds: must be that of the rest of the beam, "
            "none");
  // The law is one for all, and so is whether each joint has its own rate.
  scene.material.rate = kSteel;
  scene.regions[0].material.rate.strain_rate = 1.0;
  EXPECT_EQ(refusal(scene, in_motion(Level::Planar, 1.0, 10)),
            "region[1].material.rate.strain_rate: is said, but the rest of the beam has rates of "
            "its joints");
  std::swap(scene.material.rate.strain_rate, scene.regions[0].material.rate.strain_rate);
  EXPECT_EQ(refusal(scene, in_motion(Level::Planar, 1.0, 10)),
            "region[1].material.rate.strain_rate: is missing: the rest of the beam has a rate that "
            "all has");
}

}  // namespace
}  // namespace plastica
