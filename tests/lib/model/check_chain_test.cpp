#include <gtest/gtest.h>

#include <limits>

#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using testing::curve;
using testing::error_of;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CheckChain, PassesACantilever) {
  EXPECT_EQ(error_of([](Scene&) {}), "no error");
}

TEST(CheckChain, RefusesAChainInACoupon) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.drive.strain = {0.0, 0.1};
            }),
            "drive.strain: does not go with supports, loads, masses, regions, gravity, initial "
            "motions or cuts: a scene is a coupon or a chain");
}

TEST(CheckChain, RefusesSegmentAndJointLengthsThatDoNotFitTheBeam) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segment_fractions = {0.5, 0.5};
            }),
            "beam.segment_lengths = 2 values: must be 8 for the beam's segments");
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segments = 2;
              s.beam.segment_fractions = {0.5, 0.25};
            }),
            "beam.segment_lengths = 0.75: is the sum of the fractions and must be 1");
  EXPECT_EQ(error_of([](Scene& s) {
              s.beam.segments = 2;
              s.beam.segment_fractions = {1.5, -0.5};
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
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}});
            }),
            "beam.points[2]: runs straight against z, along which the beam starts");
  EXPECT_EQ(error_of([](Scene& s) {
              curve(s, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}});
            }),
            "beam.length = 1: must be the sum over beam.points, 0.5 m");
}

TEST(CheckChain, RefusesARegionThatIsEmptyOrInvalid) {
  const auto region = [](Place from, Place to, double width) {
    return error_of([&](Scene& s) {
      s.regions.push_back({from, to, s.section, s.material});
      s.regions[0].section.width = width;
    });
  };
  EXPECT_EQ(region({0.5, {}}, Place::end(), 0.1), "no error");
  EXPECT_EQ(region({0.5, {}}, {0.0, 4}, 0.1),
            "region[1].to = { segment = 4 }: must lie beyond from = 0.5");
  EXPECT_EQ(region({0.0, 9}, Place::end(), 0.1),
            "region[1].from = { segment = 9 }: must be a segment from 1 to 8, or 0 for the start");
  EXPECT_EQ(region(Place::start(), Place::end(), 0.0),
            "region[1].section.width = 0: must be positive and finite");
}

TEST(CheckActions, RefuseALineOfOnePoint) {
  EXPECT_EQ(error_of([](Scene& s) {
              s.loads[0].history = {{0.0}, {1.0}, true};
            }),
            "load[1].history = 1 times: must be at least 2 to go on along a line after the last");
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
              "rules.yield_model: must be per_axis (or elastic) with Wendelius' formulas, which "
              "clip each moment on its own");
  }
  EXPECT_EQ(report([](Scene& s) { s.material.hardening.law = HardeningLaw::Linear; }),
            "material.hardening.law: must be ideal with Wendelius' formulas, which have no "
            "hardening");
  EXPECT_EQ(
      report([](Scene& s) { s.end_rule = EndRule::HalfJoint; }),
      "rules.end_rule = half_joint: Wendelius' report clamps its ends rigidly: equal, half or "
      "three_halves");
  EXPECT_EQ(report([](Scene& s) { s.hinge_length = 0.05; }),
            "rules.hinge_length = 0.05: must be 0 or unset with Wendelius' formulas, whose "
            "strain is over a joint's own length");
  EXPECT_EQ(report([](Scene& s) {
              s.regions.push_back({Place::start(), Place::end(), s.section, s.material});
              s.regions[0].section.shape = SectionShape::RoundTube;
            }),
            "rules.formulas = report: Wendelius' report has formulas for rectangles and circles, "
            "none for "
            "round_tube");
  EXPECT_EQ(report([](Scene& s) { s.yield_cap = YieldCap::FullyPlastic; }),
            "rules.yield_cap = fully_plastic: Wendelius' caps are at first yield");
  EXPECT_EQ(report([](Scene& s) { s.beam.segments = 1; }),
            "beam.segments = 1: must be at least 2 where ends are clamped: there is no joint");
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
              s.beam.segment_fractions.assign(8, 0.125);
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
            "solver.control_at = { segment = 9 }: must be a segment from 1 to 8, or 0 for the "
            "start");
  EXPECT_EQ(error_of([](Scene& s, SolverOptions&) { s.loads[0].history = History::constant(); }),
            "solver.duration = 0: must be above 0 where every history is constant");
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              s.loads[0].history = History::constant();
              o.duration = 1.0;
            }),
            "no error");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.steps = 0; }),
            "solver.steps = 0: must be from 1 to 1e+07");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.largest_rotation = 0.0; }),
            "solver.largest_rotation = 0: must be above 0 rad");
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
  EXPECT_EQ(probe(ProbeQuantity::ReactionMoment, {0.0, 3}),
            "probe[1].at = { segment = 3 }: has no support");
}

}  // namespace
}  // namespace plastica
