#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/lib/model/chain_scenes.hpp"
#include "tests/support/message.hpp"

namespace plastica {
namespace {

using testing::cantilever;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The error of a cantilever that `spoil` has changed.
std::string error_of(const std::function<void(Scene&, SolverOptions&)>& spoil) {
  Scene scene = cantilever();
  scene.beam.segments = 8;
  SolverOptions options;
  spoil(scene, options);
  return testing::message_of([&] { check_scene(scene, options); });
}

std::string error_of(const std::function<void(Scene&)>& spoil) {
  return error_of([&](Scene& scene, SolverOptions&) { spoil(scene); });
}

void add_support(Scene& scene, Place at, SupportKind kind) { scene.supports.push_back({at, kind}); }

void curve(Scene& scene, std::vector<std::array<double, 3>> points) {
  scene.beam.shape = BeamShape::Polyline;
  scene.beam.points = std::move(points);
}

TEST(CheckChain, PassesACantilever) {
  EXPECT_EQ(error_of([](Scene&) {}), "no error");
}

TEST(CheckChain, RefusesAChainInACoupon) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.drive.strain = {0.0, 0.1};
            }),
            "drive.strain: does not go with supports, loads, regions or gravity: a scene is a "
            "coupon or a chain");
}

TEST(CheckChain, RefusesSegmentAndJointLengthsThatDoNotFitTheBeam) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segment_shares = {0.5, 0.5};
            }),
            "beam.segment_lengths = 2 values: must be 8 for the beam's segments");
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segments = 2;
              s.beam.segment_shares = {0.5, 0.25};
            }),
            "beam.segment_lengths = 0.75: is the sum of the shares and must be 1");
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segments = 2;
              s.beam.segment_shares = {1.5, -0.5};
            }),
            "beam.segment_lengths[2] = -0.5: must be positive and finite");
  EXPECT_EQ(error_of([](Scene& s) { s.beam.joint_lengths = {0.1}; }),
            "beam.joint_lengths = 1 values: must be 7 for the beam's segments");
  EXPECT_EQ(error_of([](Scene& s) { s.beam.joint_lengths.assign(7, kNan); }),
            "beam.joint_lengths[1] = nan: must be positive and finite");
}

TEST(CheckChain, RefusesAnArcThatIsNone) {
  const auto arc = [](double angle, std::array<double, 3> towards) {
    return error_of([&](Scene& s) {
      s.beam.shape = BeamShape::Arc;
      s.beam.arc_angle = angle;
      s.beam.arc_towards = towards;
    });
  };
  EXPECT_EQ(arc(0.5, {0.0, 1.0, 0.0}), "no error");
  EXPECT_EQ(arc(0.0, {0.0, 1.0, 0.0}),
            "beam.arc_angle = 0: must be above 0 and at most a full turn, 2 pi rad");
  EXPECT_EQ(arc(6.3, {0.0, 1.0, 0.0}),
            "beam.arc_angle = 6.3: must be above 0 and at most a full turn, 2 pi rad");
  EXPECT_EQ(arc(0.5, {0.0, 2.0, 0.0}), "beam.arc_towards = 2: is the vector's size and must be 1");
  EXPECT_EQ(arc(0.5, {0.0, 0.8, 0.6}),
            "beam.arc_towards = 0.6: is its z component and must be 0: the beam starts along z");
}

TEST(CheckChain, RefusesAPolylineThatIsNone) {
  EXPECT_EQ(error_of([](Scene& s) { curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.6, 0.8}}); }), "no error");
  EXPECT_EQ(error_of([](Scene& s) {
              curve(s, {{0.0, 0.0, 0.0}});
            }),
            "beam.points = 1 points: must be at least 2");
  EXPECT_EQ(error_of([](Scene& s) {
              curve(s, {{0.0, 0.0, 1.0}, {0.0, 0.0, 2.0}});
            }),
            "beam.points[1]: must be the origin, where a beam starts");
  EXPECT_EQ(error_of([](Scene& s) {
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
            }),
            "beam.points[2]: is the same as the one before");
  EXPECT_EQ(error_of([](Scene& s) {
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.75}, {0.0, 0.0, 0.5}});
            }),
            "beam.points[3]: turns straight back at the point before");
  EXPECT_EQ(error_of([](Scene& s) {
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}});
            }),
            "beam.length = 1: must be the sum over beam.points, 0.5 m");
}

TEST(CheckChain, RefusesARegionThatIsEmptyOrUnsound) {
  const auto region = [](Place from, Place to, double width) {
    return error_of([&](Scene& s) {
      s.regions.push_back({from, to, s.section, s.material});
      s.regions[0].section.width = width;
    });
  };
  EXPECT_EQ(region({0.5, {}}, Place::end(), 0.1), "no error");
  EXPECT_EQ(region({0.5, {}}, {0.0, 4}, 0.1), "region[1].to = 4: must lie beyond from = 0.5");
  EXPECT_EQ(region({0.0, 9}, Place::end(), 0.1),
            "region[1].from = 9: must be the number of a segment, 0 (the start) to 8; a fraction "
            "of the length has a point");
  EXPECT_EQ(region(Place::start(), Place::end(), 0.0),
            "region[1].section.width = 0: must be positive and finite");
}

TEST(CheckSupports, RefusePlacesOffTheBeam) {
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {1.2, {}}, SupportKind::Roller);
            }),
            "support[2].at = 1.2: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.0, -1}, SupportKind::Roller);
            }),
            "support[2].at = -1: must be the number of a segment, 0 (the start) to 8; a fraction "
            "of the length has a point");
}

TEST(CheckSupports, HoldRotationsAtSegmentEndsAlone) {
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.3, {}}, SupportKind::Clamp);
            }),
            "support[2].at = 0.3: a clamp that holds rotation (rx) must be at a segment's end; the "
            "nearest are 0.25 and 0.375");
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.3, {}}, SupportKind::Pin);
            }),
            "support[2].at = 0.3: a pin that holds rotation (rz) must be at a segment's end; the "
            "nearest are 0.25 and 0.375");
  EXPECT_EQ(error_of([](Scene& s) { add_support(s, {0.3, {}}, SupportKind::Roller); }), "no error");
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.375, {}}, SupportKind::Clamp);
            }),
            "no error");
}

TEST(CheckSupports, HoldOrSpringOrPushButOneOfThese) {
  const auto elastic = [](std::array<double, 3> stiffness, std::optional<HeldFreedoms> hold = {}) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Elastic);
      s.supports[1].stiffness = stiffness;
      s.supports[1].hold = hold;
    });
  };
  EXPECT_EQ(elastic({0.0, 1e3, 0.0}), "no error");
  EXPECT_EQ(elastic({0.0, -1e3, 0.0}),
            "support[2].stiffness = -1000: must be finite and not negative");
  EXPECT_EQ(elastic({}), "support[2]: an elastic support needs stiffness or rotational_stiffness");
  EXPECT_EQ(elastic({0.0, 1e3, 0.0}, HeldFreedoms{false, true}),
            "support[2].hold = y: has a spring, too");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].rotational_stiffness[0] = 1.0; }),
            "support[1].stiffness: belongs to an elastic support");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].hold = HeldFreedoms{}; }),
            "support[1].hold = []: must hold something");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].gap = 0.1; }),
            "support[1].gap = 0.1: belongs to a pillar");
}

TEST(CheckSupports, ArePillarsOnlyIfTheyPush) {
  const auto pillar = [](const std::function<void(Support&)>& spoil) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Pillar);
      spoil(s.supports[1]);
    });
  };
  EXPECT_EQ(pillar([](Support&) {}), "no error");
  EXPECT_EQ(pillar([](Support& p) { p.gap = -0.1; }),
            "support[2].gap = -0.1: must be finite and not negative");
  EXPECT_EQ(pillar([](Support& p) {
              p.normal = {0.0, 2.0, 0.0};
            }),
            "support[2].normal = 2: is the vector's size and must be 1");
  EXPECT_EQ(pillar([](Support& p) { p.hold = HeldFreedoms{true}; }),
            "support[2].hold: a pillar only pushes; what holds is another support");
  EXPECT_EQ(pillar([](Support& p) { p.translation[1] = 0.1; }),
            "support[2].translation = 0.1: moves y, which the support does not hold");
}

TEST(CheckSupports, MoveWhatTheyHold) {
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, Place::end(), SupportKind::Roller);
              s.supports[1].rotation[0] = 0.2;
            }),
            "support[2].rotation = 0.2: moves rx, which the support does not hold");
  EXPECT_EQ(error_of([](Scene& s) { s.supports[0].translation[0] = kNan; }),
            "support[1].translation = nan: must be finite");
  EXPECT_EQ(error_of([](Scene& s) {
              s.supports[0].translation[1] = 0.1;
              s.supports[0].history = {{0.0, 2.0, 2.0}, {0.0, 1.0, 0.0}};
            }),
            "support[1].history.time = 2: must rise from one to the next");
}

TEST(CheckSupports, ShareAPlaceIfEachTakesFreedomsOfItsOwn) {
  EXPECT_EQ(error_of([](Scene& s) {
              add_support(s, {0.0, 0}, SupportKind::Roller);
            }),
            "support[2].at = 0: support[1] holds x at the same place");
  const auto at_the_end = [](HeldFreedoms first, HeldFreedoms second) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Roller);
      add_support(s, {0.0, 8}, SupportKind::Roller);
      s.supports[1].hold = first;
      s.supports[2].hold = second;
    });
  };
  EXPECT_EQ(at_the_end({false, true}, {true}), "no error");
  EXPECT_EQ(at_the_end({false, true}, {true, true}),
            "support[3].at = 8: support[2] holds y at the same place");
  const auto pillars = [](double second) {
    return error_of([&](Scene& s) {
      add_support(s, Place::end(), SupportKind::Pillar);
      add_support(s, Place::end(), SupportKind::Pillar);
      s.supports[2].normal[1] = second;
    });
  };
  EXPECT_EQ(pillars(-1.0), "no error");
  EXPECT_EQ(pillars(1.0), "support[3].at = end: support[2] holds y at the same place");
}

TEST(CheckActions, RefuseLoadsThatAreNone) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads[0].at = {-0.1, {}};
            }),
            "load[1].at = -0.1: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(error_of([](Scene& s) { s.loads[0].to = Place::end(); }),
            "load[1].to = end: must lie beyond at = end");
  EXPECT_EQ(error_of([](Scene& s) { s.loads[0].force[0] = kNan; }),
            "load[1].force = nan: must be finite");
  EXPECT_EQ(error_of([](Scene& s) { s.loads[0].moment[2] = kNan; }),
            "load[1].moment = nan: must be finite");
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads[0].history = {{0.0}, {}};
            }),
            "load[1].history = 1 times, 0 factors: must be as many of one as of the other, and at "
            "least one");
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads[0].history = {{-1.0}, {1.0}};
            }),
            "load[1].history.time = -1: must not begin before 0");
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads[0].history = {{0.0}, {kNan}};
            }),
            "load[1].history.factor = nan: must be finite");
  EXPECT_EQ(error_of([](Scene& s) { s.gravity[1] = kNan; }), "gravity.y = nan: must be finite");
}

TEST(CheckActions, RefuseABeamThatNothingActsOn) {
  const std::string rule =
      "load: is missing: give a [[load]], gravity, or a support's translation or rotation";
  EXPECT_EQ(error_of([](Scene& s) { s.loads.clear(); }), rule);
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads.clear();
              s.gravity[1] = -9.81;
            }),
            "no error");
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads.clear();
              s.supports[0].rotation[0] = 0.1;
            }),
            "no error");
}

TEST(CheckRules, RefuseWhatTheReportDoesNotHave) {
  const auto report = [](const std::function<void(Scene&)>& spoil) {
    return error_of([&](Scene& s) {
      s.formulas = Formulas::Report;
      s.yield_model = YieldModel::PerAxis;
      spoil(s);
    });
  };
  EXPECT_EQ(report([](Scene&) {}), "no error");
  EXPECT_EQ(report([](Scene& s) { s.hinge_length = 0.0; }), "no error");
  for (const YieldModel model :
       {YieldModel::Interaction, YieldModel::Conservative, YieldModel::Fibre}) {
    EXPECT_EQ(report([&](Scene& s) { s.yield_model = model; }),
              "rules.yield_model: must be per_axis (or elastic) with the report's formulas, which "
              "clip each moment on its own");
  }
  EXPECT_EQ(report([](Scene& s) { s.material.hardening.law = HardeningLaw::Linear; }),
            "material.hardening.law: must be ideal with the report's formulas, which have no "
            "hardening");
  EXPECT_EQ(report([](Scene& s) { s.end_rule = EndRule::HalfJoint; }),
            "rules.end_rule = half_joint: the report welds its ends: equal, half or three_halves");
  EXPECT_EQ(report([](Scene& s) { s.hinge_length = 0.05; }),
            "rules.hinge_length = 0.05: must be 0 or unset with the report's formulas, whose "
            "strain is over a joint's own length");
  EXPECT_EQ(report([](Scene& s) {
              s.regions.push_back({Place::start(), Place::end(), s.section, s.material});
              s.regions[0].section.shape = SectionShape::RoundTube;
            }),
            "rules.formulas = report: the report has no formulas for tubes");
  EXPECT_EQ(report([](Scene& s) { s.yield_cap = YieldCap::FullyPlastic; }),
            "rules.yield_cap = fully_plastic: the report's caps are at first yield");
  EXPECT_EQ(report([](Scene& s) { s.beam.segments = 1; }),
            "beam.segments = 1: must be at least 2 where ends are welded: there is no joint");
}

TEST(CheckRules, RefuseContradictions) {
  const auto capped = [](YieldModel model) {
    return error_of([&](Scene& s) {
      s.yield_cap = YieldCap::FullyPlastic;
      s.yield_model = model;
    });
  };
  EXPECT_EQ(capped(YieldModel::Interaction), "no error");
  EXPECT_EQ(capped(YieldModel::Conservative),
            "rules.yield_cap = fully_plastic: the conservative surface is one of first yield");
  EXPECT_EQ(capped(YieldModel::Fibre),
            "rules.yield_cap = fully_plastic: a fibre section yields fibre by fibre and has no "
            "cap");
  EXPECT_EQ(error_of([](Scene& s) {
              s.yield_model = YieldModel::Elastic;
              s.break_limit_y = 0.1;
            }),
            "rules.yield_model = elastic: leaves no permanent strain that a break limit could be "
            "held against");
  EXPECT_EQ(error_of([](Scene& s) { s.break_limit_z = 0.0; }),
            "rules.break_limit_z = 0: must be above 0");
  EXPECT_EQ(error_of([](Scene& s) {
              s.end_rule = EndRule::Half;
              s.beam.segment_shares.assign(8, 0.125);
            }),
            "rules.end_rule = half: sets the segment lengths itself");
  EXPECT_EQ(error_of([](Scene& s) {
              s.end_rule = EndRule::ThreeHalves;
              s.beam.joint_lengths.assign(7, 0.125);
            }),
            "rules.end_rule = three_halves: sets the joint lengths itself");
}

TEST(CheckSolver, RefusesAPathThatCannotBeFollowed) {
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              o.control = PathControl::Displacement;
              s.loads.clear();
              s.gravity[1] = -9.81;
            }),
            "solver.control_at: is missing: no load says which point displacement control should "
            "watch");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) {
              o.control = PathControl::Load;
              o.control_at = Place::end();
            }),
            "solver.control_at = end: is of no use with load control");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) {
              o.control_at = Place{0.0, 9};
            }),
            "solver.control_at = 9: must be the number of a segment, 0 (the start) to 8; a "
            "fraction of the length has a point");
  EXPECT_EQ(error_of([](Scene& s, SolverOptions&) { s.loads[0].history = History::constant(); }),
            "solver.duration = 0: must be above 0 where every history is constant");
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              s.loads[0].history = History::constant();
              o.duration = 1.0;
            }),
            "no error");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.steps = 0; }),
            "solver.steps = 0: must be from 1 to 1e+07");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.largest_turn = 0.0; }),
            "solver.largest_turn = 0: must be above 0 rad");
}

TEST(CheckProbes, RefuseWhatTheChainDoesNotHave) {
  const auto probe = [](ProbeQuantity quantity, Place at) {
    return error_of([&](Scene& s) { s.probes.push_back({"p", quantity, at}); });
  };
  EXPECT_EQ(probe(ProbeQuantity::Moment, {0.0, 3}), "no error");
  EXPECT_EQ(probe(ProbeQuantity::Load, Place::end()),
            "probe[1].kind = load: is recorded of a coupon alone");
  EXPECT_EQ(probe(ProbeQuantity::Dissipation, Place::end()),
            "probe[1].kind = dissipation: is recorded of a coupon alone");
  EXPECT_EQ(probe(ProbeQuantity::Moment, {1.1, {}}),
            "probe[1].at = 1.1: must be a fraction of the length, 0 to 1");
  EXPECT_EQ(probe(ProbeQuantity::Reaction, Place::start()), "no error");
  EXPECT_EQ(probe(ProbeQuantity::Reaction, Place::end()), "probe[1].at = end: has no support");
  EXPECT_EQ(probe(ProbeQuantity::ReactionMoment, {0.0, 3}), "probe[1].at = 3: has no support");
}

/// Supports that leave the beam a freedom.
std::string free_by(std::vector<Support> supports, std::array<double, 3> force) {
  return error_of([&](Scene& s) {
    s.supports = std::move(supports);
    s.loads[0].force = force;
  });
}

std::string free_to(const std::string& motion, const std::string& level) {
  return "support: the supports together leave the beam free to " + motion + " (level " + level +
         ")";
}

TEST(FreeMotion, IsNamedInThePlane) {
  const std::array<double, 3> down{0.0, -1.0, 0.0};
  const Support pin{Place::start(), SupportKind::Pin};
  const Support roller{Place::end(), SupportKind::Roller};
  EXPECT_EQ(free_by({pin, roller}, down), "no error");
  EXPECT_EQ(free_by({pin}, down), free_to("rotate about x", "planar"));
  EXPECT_EQ(free_by({roller}, down), free_to("move along z", "planar"));
  EXPECT_EQ(free_by({{Place::start(), SupportKind::Roller}, roller}, down),
            free_to("move along z", "planar"));
  EXPECT_EQ(
      free_by({{Place::start(), SupportKind::Pillar}, {Place::end(), SupportKind::Pillar}}, down),
      free_to("move along z", "planar"));
  EXPECT_EQ(free_by({{Place::start(), SupportKind::Guide}}, down),
            free_to("move along y", "planar"));
  EXPECT_EQ(free_by({pin}, {1.0, 0.0, 0.0}), free_to("rotate about y", "planar"));
}

TEST(FreeMotion, IsNamedInSpaceAndInTwist) {
  const Support pin{Place::start(), SupportKind::Pin};
  const Support roller{Place::end(), SupportKind::Roller};
  const std::array<double, 3> skew{1.0, 1.0, 0.0};
  EXPECT_EQ(free_by({pin, roller}, skew), "no error");
  Support no_fork = pin;
  no_fork.hold = HeldFreedoms{true, true, true};
  EXPECT_EQ(free_by({no_fork, roller}, skew), free_to("rotate about z", "spatial"));
  Support one_way = roller;
  one_way.hold = HeldFreedoms{false, true};
  EXPECT_EQ(free_by({pin, one_way}, skew), free_to("rotate about y", "spatial"));
  EXPECT_EQ(error_of([&](Scene& s) {
              s.supports = {no_fork};
              s.loads[0].force = {};
              s.loads[0].moment = {0.0, 0.0, 1.0};
            }),
            free_to("rotate about z", "twist"));
}

TEST(FreeMotion, KnowsSpringsAndTheShapeOfTheBeam) {
  const std::array<double, 3> down{0.0, -1.0, 0.0};
  Support spring{Place::end(), SupportKind::Elastic};
  spring.stiffness = {0.0, 1.0, 0.0};
  const Support pin{Place::start(), SupportKind::Pin};
  EXPECT_EQ(free_by({pin, spring}, down), "no error");
  spring.stiffness = {0.0, 0.0, 1.0};
  EXPECT_EQ(free_by({pin, spring}, down), free_to("rotate about x", "planar"));
  // The same spring along z holds a beam that rises to its side.
  EXPECT_EQ(error_of([&](Scene& s) {
              s.supports = {pin, spring};
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.6, 0.8}});
            }),
            "no error");
}

}  // namespace
}  // namespace plastica
