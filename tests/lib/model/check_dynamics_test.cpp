#include <gtest/gtest.h>

#include <limits>

#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using testing::error_of;
using testing::error_of_flight;
using testing::error_of_motion;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
const std::string kNeedsDynamics = ": needs solver.analysis = \"dynamics\"";

/// A beam in free flight with an initial motion that `spoil` has changed.
std::string error_of_initial_motion(const std::function<void(InitialMotion&)>& spoil) {
  return error_of_flight([&](Scene& s, SolverOptions&) {
    InitialMotion motion;
    motion.velocity = {0.0, 1.0, 0.0};
    spoil(motion);
    s.initial_motions.push_back(motion);
  });
}

std::string error_of_cuts(
    const std::vector<Place>& places, const std::function<void(Scene&)>& change = [](Scene&) {}) {
  return error_of_motion([&](Scene& s, SolverOptions&) {
    for (const Place& at : places) s.cuts.push_back({at, 0.5});
    change(s);
  });
}

TEST(CheckStatics, RefusesWhatOnlyAMotionHas) {
  EXPECT_EQ(error_of([](Scene& s) { s.initial_motions.emplace_back(); }),
            "initial_motion[1]" + kNeedsDynamics);
  EXPECT_EQ(error_of([](Scene& s) { s.cuts.emplace_back(); }), "cut[1]" + kNeedsDynamics);
  EXPECT_EQ(error_of([](Scene& s) {
              s.supports.push_back({Place::end(), SupportKind::Pillar});
              s.supports[1].restitution = 0.5;
            }),
            "support[2].restitution = 0.5" + kNeedsDynamics);
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.damping = Damping::Stiffness; }),
            "solver.damping = stiffness" + kNeedsDynamics);
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.damping_time = 0.1; }),
            "solver.damping_time = 0.1" + kNeedsDynamics);
}

TEST(CheckStatics, RefusesProbesOfAMotion) {
  const auto probe = [](ProbeQuantity quantity, EnergyKind energy, Analysis analysis) {
    return error_of([&](Scene& s, SolverOptions& o) {
      s.probes.push_back({"p", quantity, Place::end(), Component::Y, energy});
      o.analysis = analysis;
    });
  };
  using enum ProbeQuantity;
  for (const ProbeQuantity quantity : {Velocity, Spin, Momentum, AngularMomentum}) {
    const std::string word(probe_kinds()[static_cast<std::size_t>(quantity)]);
    EXPECT_EQ(probe(quantity, EnergyKind::Elastic, Analysis::Statics),
              "probe[1].kind = " + word + kNeedsDynamics);
    EXPECT_EQ(probe(quantity, EnergyKind::Elastic, Analysis::Dynamics), "no error");
  }
  for (std::size_t i = 0; i < kEnergyKinds.size(); ++i) {
    const auto kind = static_cast<EnergyKind>(i);
    const std::string word(kEnergyKinds[i]);
    const bool at_rest =
        word == "elastic" || word == "plastic" || word == "external" || word == "residual";
    EXPECT_EQ(probe(Energy, kind, Analysis::Statics),
              at_rest ? "no error" : "probe[1].energy = " + word + kNeedsDynamics);
    EXPECT_EQ(probe(Energy, kind, Analysis::Dynamics), "no error") << word;
    // What stays unused of a probe is not looked at.
    EXPECT_EQ(probe(Displacement, kind, Analysis::Statics), "no error") << word;
  }
}

TEST(CheckStatics, IsWhatACouponIs) {
  const auto coupon = [](const std::function<void(Scene&, SolverOptions&)>& spoil) {
    return error_of([&](Scene& s, SolverOptions& o) {
      s = {};
      s.drive.strain = {0.0, 0.01};
      spoil(s, o);
    });
  };
  EXPECT_EQ(coupon([](Scene&, SolverOptions&) {}), "no error");
  EXPECT_EQ(coupon([](Scene&, SolverOptions& o) { o.analysis = Analysis::Dynamics; }),
            "solver.analysis = dynamics: must be statics in a scene with a drive, which is at rest "
            "at each strain");
  const std::string rule =
      "drive.strain: does not go with supports, loads, masses, regions, gravity, initial motions "
      "or cuts: a scene is a coupon or a chain";
  EXPECT_EQ(coupon([](Scene& s, SolverOptions&) { s.initial_motions.emplace_back(); }), rule);
  EXPECT_EQ(coupon([](Scene& s, SolverOptions&) { s.cuts.emplace_back(); }), rule);
  EXPECT_EQ(coupon([](Scene& s, SolverOptions&) { s.masses.push_back({{}, 1.0, {}}); }), rule);
  EXPECT_EQ(coupon([](Scene&, SolverOptions& o) { o.damping = Damping::Relaxation; }),
            "solver.damping = relaxation" + kNeedsDynamics);
}

TEST(CheckDynamics, PassesABeamHeldAndABeamInFreeFlight) {
  EXPECT_EQ(error_of_motion([](Scene&, SolverOptions&) {}), "no error");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion&) {}), "no error");
  EXPECT_EQ(error_of_flight([](Scene& s, SolverOptions&) { s.gravity[1] = -9.81; }), "no error");
  EXPECT_EQ(error_of_flight([](Scene& s, SolverOptions&) {
              s.loads.emplace_back();
              s.loads[0].force[0] = 1.0;
            }),
            "no error");
}

TEST(CheckDynamics, LetsSupportsLeaveTheBeamFree) {
  EXPECT_EQ(
      error_of_motion([](Scene& s, SolverOptions&) { s.supports[0].kind = SupportKind::Roller; }),
      "no error");
}

TEST(CheckDynamics, RefusesABeamThatNothingMoves) {
  const std::string rule =
      "load: is missing, and nothing else moves the beam: give a [[load]], an [[initial_motion]], "
      "gravity, or a support's translation or rotation";
  EXPECT_EQ(error_of_flight([](Scene&, SolverOptions&) {}), rule);
  const auto held = [](const std::function<void(Scene&)>& add) {
    return error_of_motion([&](Scene& s, SolverOptions& o) {
      s.loads.clear();
      o.duration = 1.0;
      add(s);
    });
  };
  EXPECT_EQ(held([](Scene&) {}), rule);
  EXPECT_EQ(held([](Scene& s) { s.cuts.push_back({{0.5, {}}, 0.1}); }), "no error");
  EXPECT_EQ(held([](Scene& s) { s.supports[0].translation[1] = 0.1; }), "no error");
}

TEST(CheckDynamics, NeedsAnEnd) {
  const std::string rule =
      "solver.duration = 0: must be above 0 where no history says when the motion ends";
  EXPECT_EQ(error_of_flight([](Scene& s, SolverOptions& o) {
              s.initial_motions.emplace_back();
              o.duration = 0.0;
            }),
            rule);
  EXPECT_EQ(
      error_of_motion([](Scene& s, SolverOptions&) { s.loads[0].history = History::constant(); }),
      rule);
  EXPECT_EQ(error_of_motion([](Scene& s, SolverOptions& o) {
              s.loads[0].history = History::constant();
              o.duration = 2.0;
            }),
            "no error");
}

TEST(CheckDynamics, GoesOnInTimeAlone) {
  const auto controlled = [](PathControl control, std::optional<Place> at = {}) {
    return error_of_motion([&](Scene&, SolverOptions& o) {
      o.control = control;
      o.control_at = at;
    });
  };
  EXPECT_EQ(controlled(PathControl::Auto), "no error");
  EXPECT_EQ(controlled(PathControl::Load), "no error");
  EXPECT_EQ(controlled(PathControl::Displacement),
            "solver.control = displacement: must be auto or load in dynamics, where time goes on "
            "by itself");
  EXPECT_EQ(controlled(PathControl::ArcLength),
            "solver.control = arc_length: must be auto or load in dynamics, where time goes on by "
            "itself");
  EXPECT_EQ(controlled(PathControl::Auto, Place::end()),
            "solver.control_at = end: is of no use in dynamics");
}

TEST(CheckDynamics, TakesADampingTimeWithDampingAlone) {
  const auto damped = [](Damping damping, double time) {
    return error_of_motion([&](Scene&, SolverOptions& o) {
      o.damping = damping;
      o.damping_time = time;
    });
  };
  EXPECT_EQ(damped(Damping::None, 0.0), "no error");
  EXPECT_EQ(damped(Damping::Stiffness, 1e-3), "no error");
  EXPECT_EQ(damped(Damping::Relaxation, 0.0),
            "solver.damping_time = 0: must be above 0 s with solver.damping");
  EXPECT_EQ(damped(Damping::None, 1e-3),
            "solver.damping_time = 0.001: is of no use with solver.damping = \"none\"");
  EXPECT_EQ(damped(Damping::Stiffness, -1.0), "solver.damping_time = -1: must be at least 0 s");
}

TEST(CheckDynamics, TakesStepsLongerThanASample) {
  EXPECT_EQ(error_of_motion([](Scene&, SolverOptions& o) { o.time_step = 10.0; }), "no error");
  EXPECT_EQ(error_of_motion([](Scene&, SolverOptions& o) { o.time_step = 0.0; }),
            "solver.time_step = 0: must be above 0 s");
}

TEST(CheckDynamics, LetsNothingThatIsHeldJump) {
  const auto moved = [](SupportKind kind, const History& history) {
    return error_of_motion([&](Scene& s, SolverOptions& o) {
      s.supports.push_back({Place::end(), kind});
      s.supports[1].stiffness[1] = kind == SupportKind::Elastic ? 1e3 : 0.0;
      s.supports[1].translation[1] = 0.01;
      s.supports[1].history = history;
      o.duration = 1.0;
    });
  };
  EXPECT_EQ(moved(SupportKind::Roller, History::ramp()), "no error");
  EXPECT_EQ(moved(SupportKind::Roller, {{0.0, 1.0}, {0.5, 1.0}}),
            "support[2].history = 0.5: is the factor at time 0 and must be 0 in dynamics: what a "
            "support holds cannot jump");
  // Springs may be strained and pillars be apart from the first.
  EXPECT_EQ(moved(SupportKind::Elastic, History::constant()), "no error");
  EXPECT_EQ(moved(SupportKind::Pillar, History::constant()), "no error");
}

TEST(CheckSupports, ReboundByARestitutionOfAPillar) {
  const auto restitution = [](SupportKind kind, double value) {
    return error_of_motion([&](Scene& s, SolverOptions&) {
      s.supports.push_back({Place::end(), kind});
      s.supports[1].restitution = value;
    });
  };
  EXPECT_EQ(restitution(SupportKind::Pillar, 1.0), "no error");
  EXPECT_EQ(restitution(SupportKind::Pillar, 1.5),
            "support[2].restitution = 1.5: must be from 0 to 1");
  EXPECT_EQ(restitution(SupportKind::Pillar, kNotANumber),
            "support[2].restitution = nan: must be finite");
  EXPECT_EQ(restitution(SupportKind::Roller, 0.5),
            "support[2].restitution = 0.5: belongs to kind = \"pillar\"");
}

TEST(CheckInitialMotion, RefusesWhatMovesNothing) {
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) {
              m.from = {0.5, {}};
              m.to = {0.0, 4};
            }),
            "initial_motion[1].to = { segment = 4 }: must lie beyond from = 0.5");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) {
              m.from = {0.5, {}};
              m.to = {0.56, {}};
            }),
            "initial_motion[1].to = 0.56: leaves no segment's middle between from = 0.5 and "
            "itself, so nothing would move");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) {
              m.from = {0.5, {}};
              m.to = {0.57, {}};
            }),
            "no error");
}

TEST(CheckInitialMotion, RefusesPlacesOffTheBeamAndWhatIsNotFinite) {
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) {
              m.from = {-0.1, {}};
            }),
            "initial_motion[1].from = -0.1: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) {
              m.to = {1.1, {}};
            }),
            "initial_motion[1].to = 1.1: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) {
              m.about = {0.0, 9};
            }),
            "initial_motion[1].about = { segment = 9 }: must be a segment from 1 to 8, or 0 for "
            "the start");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) { m.velocity[2] = kNotANumber; }),
            "initial_motion[1].velocity = nan: must be finite");
  EXPECT_EQ(error_of_initial_motion([](InitialMotion& m) { m.spin[0] = kNotANumber; }),
            "initial_motion[1].spin = nan: must be finite");
}

TEST(CheckCuts, TakeTheNearestJoint) {
  EXPECT_EQ(error_of_cuts({{0.5, {}}, {0.0, 3}, {0.01, {}}}), "no error");
  EXPECT_EQ(
      error_of_cuts({{0.5, {}}, {0.0, 4}}),
      "cut[2].at = { segment = 4 }: cut[1] cuts the nearest joint, that at segment end 4, too");
  EXPECT_EQ(error_of_cuts({{0.48, {}}, {0.55, {}}}),
            "cut[2].at = 0.55: cut[1] cuts the nearest joint, that at segment end 4, too");
  EXPECT_EQ(error_of_cuts({{1.5, {}}}),
            "cut[1].at = 1.5: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(error_of_cuts({{0.5, {}}}, [](Scene& s) { s.cuts[0].time = -1.0; }),
            "cut[1].time = -1: must be finite and not negative");
}

TEST(CheckCuts, RefuseAnEndThatNoJointHolds) {
  const std::string rule = "cut[1].at = end: is nearest to the beam's end, where no joint is: ";
  EXPECT_EQ(error_of_cuts({Place::end()}), rule + "no support holds its rotation");
  EXPECT_EQ(error_of_cuts({{0.97, {}}}),
            "cut[1].at = 0.97: is nearest to the beam's end, where no joint is: no support holds "
            "its rotation");
  EXPECT_EQ(error_of_cuts({Place::start()}), "no error");
  EXPECT_EQ(error_of_cuts({Place::end()},
                          [](Scene& s) {
                            s.supports.push_back({Place::end(), SupportKind::Guide});
                          }),
            "no error");
  EXPECT_EQ(error_of_cuts({Place::end()},
                          [](Scene& s) {
                            s.supports.push_back({Place::end(), SupportKind::Elastic});
                            s.supports[1].rotational_stiffness[0] = 1e3;
                          }),
            "no error");
  EXPECT_EQ(error_of_cuts({Place::end()},
                          [](Scene& s) {
                            s.supports.push_back({Place::end(), SupportKind::Clamp});
                            s.end_rule = EndRule::Equal;
                          }),
            rule + "it is clamped (rules.end_rule)");
}

TEST(CheckCuts, CountTheRotationsOfTheLevelAlone) {
  // A pin holds the twist about the beam's axis, which a planar level does not have.
  const auto pinned = [](std::array<double, 3> force) {
    return error_of_cuts({Place::end()}, [&](Scene& s) {
      s.supports.push_back({Place::end(), SupportKind::Pin});
      s.loads[0].force = force;
    });
  };
  EXPECT_EQ(pinned({0.0, 1.0, 0.0}),
            "cut[1].at = end: is nearest to the beam's end, where no joint is: no support holds "
            "its rotation");
  EXPECT_EQ(pinned({1.0, 1.0, 0.0}), "no error");
}

}  // namespace
}  // namespace plastica
