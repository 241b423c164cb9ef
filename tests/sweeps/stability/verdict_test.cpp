#include "sweeps/stability/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plastica/run/simulate.hpp"
#include "tests/support/motion_scene.hpp"

namespace plastica::sweeps::stability {
namespace {

using enum Validity;

/// A cantilever under a tip force whose run is valid, and what is known of it.
struct Bent {
  Setup setup;
  Response response;
  Expectation expected;
};

Bent bent() {
  Bent made;
  made.setup.scene = testing::cantilever_scene(8);
  made.setup.scene.loads.push_back({.force = {0.0, -10.0, 0.0}});
  testing::add_probe(made.setup.scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  made.setup.solver.frames = 1;
  made.response = testing::completed(made.setup.scene, made.setup.solver);
  const double tip = testing::last_of(made.response, 0);
  made.expected.references = {{.what = "tip", .probe = 0, .value = tip, .continuum = tip}};
  return made;
}

Validity class_of(const Bent& made) {
  return judge(made.setup, made.response, made.expected).validity;
}

TEST(Verdict, CallsARunValidThatMeetsAllThatIsKnown) { EXPECT_EQ(class_of(bent()), Valid); }

TEST(Verdict, CallsARunFailedThatSaysSo) {
  Bent made = bent();
  made.response.status = Status::NotConverged;
  EXPECT_EQ(class_of(made), Failed);
}

TEST(Verdict, CallsANumberThatIsNotFiniteAnUndetectedError) {
  Bent made = bent();
  made.response.chain.moment[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(class_of(made), Undetected);
}

TEST(Verdict, CallsABeamThatIsOutOfBalanceAnUndetectedError) {
  Bent made = bent();
  // The moment of a joint about x in the last frame.
  made.response.chain.moment[made.response.chain.moment.size() - 12] *= 1.0 + 1e-3;
  EXPECT_EQ(class_of(made), Undetected);
  made = bent();
  for (double& force : made.response.chain.reaction) force *= 1.001;
  EXPECT_EQ(class_of(made), Undetected);
}

TEST(Verdict, CallsAStretchedSegmentAnUndetectedError) {
  Bent made = bent();
  made.response.chain.position.back() += 1e-3;
  EXPECT_EQ(class_of(made), Undetected);
}

TEST(Verdict, CallsAJointBeyondItsCapAnUndetectedError) {
  Bent made = bent();
  made.setup.scene.yield_model = YieldModel::Interaction;
  EXPECT_EQ(class_of(made), Valid);
  made.setup.scene.material.yield_stress = 1e6;
  EXPECT_EQ(class_of(made), Undetected);
}

TEST(Verdict, TellsAMissOfTheChainFromOneOfTheBeam) {
  Bent made = bent();
  const double tip = made.expected.references[0].value;
  made.expected.references[0].continuum = 1.02 * tip;
  EXPECT_EQ(class_of(made), Inaccurate);
  made.expected.references[0].value = 1.02 * tip;
  EXPECT_EQ(class_of(made), Undetected);
}

TEST(Verdict, WantsTheLimitLoadAndTheBreakThatAreKnown) {
  Bent made = bent();
  made.expected.limit = 0.5;
  EXPECT_EQ(class_of(made), Undetected);
  made = bent();
  made.expected.breaks = true;
  EXPECT_EQ(class_of(made), Undetected);
}

/// A beam in free flight.
Bent flying(Scheme scheme) {
  Bent made;
  made.setup.scene = testing::flying_scene(4, false);
  testing::add_probe(made.setup.scene, ProbeQuantity::Momentum, Place::end(), Component::Y);
  made.setup.solver = testing::motion_options(scheme, 1e-4, 50);
  made.response = testing::completed(made.setup.scene, made.setup.solver);
  made.expected.kept = {{"momentum", 0, std::fabs(made.response.probes[0][0]), 1e-9}};
  return made;
}

TEST(Verdict, HoldsAMotionToWhatItMustKeep) {
  Bent made = flying(Scheme::EnergyMomentum);
  EXPECT_EQ(class_of(made), Valid);
  made.response.probes[0].back() *= 1.001;
  EXPECT_EQ(class_of(made), Undetected);
}

TEST(Verdict, CallsAMotionInaccurateThatSaysSo) {
  Bent made = flying(Scheme::EnergyMomentum);
  made.response.energy_balance_error = 0.02;
  EXPECT_EQ(class_of(made), Inaccurate);
  made.response.status = Status::NotBalanced;
  EXPECT_EQ(class_of(made), Inaccurate);
  made = flying(Scheme::EnergyMomentum);
  made.response.momentum_error = 0.02;
  made.response.status = Status::NotBalanced;
  EXPECT_EQ(class_of(made), Inaccurate);
  made = flying(Scheme::EnergyMomentum);
  Energies& last = made.response.chain.energy.back();
  last.numerical_dissipation = 0.02 * last.external;
  EXPECT_EQ(class_of(made), Inaccurate);
  // Energy that the scheme has made and the energy balance error does not show.
  last.numerical_dissipation = -0.02 * last.external;
  EXPECT_EQ(class_of(made), Undetected);
}

}  // namespace
}  // namespace plastica::sweeps::stability
