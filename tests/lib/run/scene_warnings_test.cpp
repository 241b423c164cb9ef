#include "plastica/run/scene_warnings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

#include "tests/lib/run/warnings_of.hpp"

namespace plastica {
namespace {

using testing::cantilever;

TEST(SceneWarnings, AreNoneForASlenderBeamOfShortSegments) {
  EXPECT_EQ(warnings_of([](Scene&) {}), std::vector<std::string>{});
}

TEST(SceneWarnings, AreNoneForACoupon) {
  Scene scene;
  scene.drive.strain = {0.0, 0.01};
  EXPECT_EQ(scene_warnings(prepare(scene, {})), std::vector<std::string>{});
}

// Gauss points of the outer interval: at 1/2 + 1/(2 sqrt 3) = 0.789 of its width.
TEST(SceneWarnings, SayThatFewFibresYieldLate) {
  const auto with = [](int fibres, YieldModel yields) {
    Scene scene = cantilever();
    scene.yield_model = yields;
    SolverOptions options;
    options.fibres = fibres;
    return scene_warnings(prepare(scene, options));
  };
  // The outermost of four lie at 0.789 of the half depth, of eight at 0.894, of twelve at 0.930.
  EXPECT_TRUE(
      warns(with(4, YieldModel::Fibre), "solver.fibres = 4: the outermost fibres yield at 1.27"));
  EXPECT_TRUE(warns(with(8, YieldModel::Fibre), "the outermost fibres yield at 1.12"));
  EXPECT_FALSE(warns(with(12, YieldModel::Fibre), "outermost"));
  EXPECT_FALSE(warns(with(4, YieldModel::Interaction), "outermost"));
}

TEST(SceneWarnings, SayThatAShortStretchBetweenSupportsDoesNotBend) {
  const auto propped_at = [](double at) {
    return warns(warnings_of([&](Scene& s) {
                   s.supports.push_back({.at = {at, {}}, .kind = SupportKind::Roller});
                 }),
                 "between support[1] and support[2] is one segment");
  };
  EXPECT_TRUE(propped_at(0.01) && propped_at(1.0 / cantilever().beam.segments));
  EXPECT_FALSE(propped_at(0.5));
}

TEST(SceneWarnings, TakeTheDepthInThePlaneOfBending) {
  EXPECT_FALSE(warns(warnings_of([](Scene& s) { s.section.width = 0.2; }), "as long as deep"));
  EXPECT_TRUE(warns(warnings_of([](Scene& s) {
                      s.section.width = 0.2;
                      s.loads[0].force = {1.0, 0.0, 0.0};
                    }),
                    "5 times as long as deep"));
}

/// Segments longer than the section is deep cost nothing of their own: docs/accuracy.md.
TEST(SceneWarnings, AreNoneForSegmentsLongerThanTheSectionIsDeep) {
  for (const int segments : {2, 8, 49}) {
    EXPECT_EQ(warnings_of([&](Scene& s) { s.beam.segments = segments; }),
              std::vector<std::string>{});
  }
}

TEST(SceneWarnings, SayWhatJointsLongerThanTheHingeDoToABreak) {
  const auto breaking = [](YieldModel model) {
    return [model](Scene& s) {
      s.beam.segments = 10;
      s.break_limit_x = 0.1;
      s.yield_model = model;
    };
  };
  EXPECT_TRUE(
      warns(warnings_of(breaking(YieldModel::Interaction)),
            "joints that can break stand for 0.1 m, more than the hinge length of 0.02 m: "
            "where one of them yields alone under an even moment, its strain is up to 5 times too "
            "large; 50 equal segments would do"));
  EXPECT_TRUE(warns(warnings_of(breaking(YieldModel::Fibre)),
                    "where less than such a length yields, its strain is up to 5 times too small"));
  EXPECT_FALSE(warns(warnings_of([](Scene& s) {
                       s.beam.segments = 50;
                       s.material.break_strain = 0.1;
                     }),
                     "hinge"));
  EXPECT_FALSE(warns(warnings_of([](Scene& s) { s.beam.segments = 10; }), "hinge"));
}

TEST(SceneWarnings, SayThatATableThatFallsDependsOnTheSegments) {
  const auto table = [](double stress) {
    return [stress](Scene& s) {
      s.material.hardening.law = HardeningLaw::Multilinear;
      s.material.hardening.plastic_strain[0] = 0.1;
      s.material.hardening.flow_stress[0] = stress;
      s.yield_model = YieldModel::Interaction;
    };
  };
  const double yield = cantilever().material.yield_stress;
  EXPECT_TRUE(warns(warnings_of(table(0.9 * yield)), "the table of material.hardening falls"));
  EXPECT_FALSE(warns(warnings_of(table(yield)), "the table of material.hardening falls"));
}

/// Numbers do not say how stiffly a section shears: no percentage can be given.
TEST(SceneWarnings, OfShearDoNotMakeUpWhatNumbersDoNotTell) {
  const auto warnings = warnings_of([](Scene& s) {
    const SectionProperties p = section_properties({.width = 0.2, .height = 0.2}, 0.3);
    s.section.shape = SectionShape::Numbers;
    s.section.numbers = {p.area,
                         p.second_moment_x,
                         p.second_moment_y,
                         p.section_modulus_x,
                         p.section_modulus_y,
                         p.plastic_section_modulus_x,
                         p.plastic_section_modulus_y,
                         p.torsion_constant,
                         p.torsion_modulus,
                         p.plastic_torsion_modulus};
  });
  EXPECT_TRUE(warns(warnings,
                    "shear, which rigid joints leave out, may count; with "
                    "section.shear_coefficient"));
  EXPECT_FALSE(warns(warnings, "nan"));
}

/// The joint beside an end that a moment turns, and that of three halves, stand for 3L/2N.
TEST(SceneWarnings, NameAsManySegmentsAsBringTheLongestJointDownToTheHinge) {
  struct Case {
    std::string longest;
    std::string wanted;
    std::function<void(Scene&)> change;
  };
  const std::array<Case, 4> cases{
      {{"0.03 m", "75",
        [](Scene& s) {
          s.loads[0].moment = {1.0, 0.0, 0.0};
        }},
       {"0.03 m", "75", [](Scene& s) { s.end_rule = EndRule::ThreeHalves; }},
       {"0.0204 m", "51", [](Scene& s) { s.end_rule = EndRule::Half; }},
       {"0.0204 m", "50", [](Scene& s) { s.beam.segments = 49; }}}};
  for (const Case& one : cases) {
    Scene scene = cantilever();
    scene.beam.segments = 50;
    scene.break_limit_x = 0.1;
    one.change(scene);
    const auto warnings = scene_warnings(prepare(scene, {}));
    EXPECT_TRUE(warns(warnings, "joints that can break stand for " + one.longest)) << one.longest;
    EXPECT_TRUE(warns(warnings, one.wanted + " equal segments would do")) << one.wanted;
    scene.beam.segments = std::stoi(one.wanted);
    EXPECT_FALSE(warns(scene_warnings(prepare(scene, {})), "hinge")) << one.wanted;
    --scene.beam.segments;
    EXPECT_TRUE(warns(scene_warnings(prepare(scene, {})), "hinge")) << one.wanted;
  }
}

/// At a support's turned end the next joint stands for 3L/2N; a hinge there has no law that breaks.
TEST(SceneWarnings, LeaveOutJointsThatNothingResists) {
  const auto hinged = [](double at) {
    return [at](Scene& s) {
      s.end_rule = EndRule::ThreeHalves;
      s.beam.segments = 50;
      s.break_limit_x = 0.1;
      s.hinge_length = 0.025;
      s.supports[0].kind = SupportKind::Pin;
      s.supports.push_back({Place::end(), SupportKind::Roller});
      s.supports.push_back({{at, {}}, SupportKind::Hinge});
      s.supports.push_back({{0.5, {}}, SupportKind::Roller});
    };
  };
  EXPECT_TRUE(warns(warnings_of(hinged(0.3)), "joints that can break stand for 0.03 m"));
  const auto first = [&](Scene& s) {
    hinged(0.02)(s);
    s.supports.push_back({{0.98, {}}, SupportKind::Hinge});
    s.supports.push_back({{0.25, {}}, SupportKind::Roller});
    s.supports.push_back({{0.75, {}}, SupportKind::Roller});
  };
  EXPECT_FALSE(warns(warnings_of(first), "hinge length"));
}

/// Half of the beam is five times as deep: its joints have five times the hinge length, and the
/// mean depth and the stiffness of each segment say what shear is.
TEST(SceneWarnings, AskEachRegionForItsSection) {
  const auto thick = [](double from, double to, int segments) {
    return [=](Scene& s) {
      s.beam.segments = segments;
      s.material.break_strain = 0.1;
      Region region{
          .from = {from, {}}, .to = {to, {}}, .section = s.section, .material = s.material};
      region.section.height = 0.1;
      s.regions.push_back(region);
    };
  };
  EXPECT_TRUE(warns(warnings_of(thick(0.5, 1.0, 20)),
                    "stand for 0.05 m, more than the hinge "
                    "length of 0.02 m"));
  EXPECT_FALSE(warns(warnings_of(thick(0.0, 1.0, 20)), "hinge length"));
  EXPECT_FALSE(warns(warnings_of(thick(0.0, 1.0, 20)), "as long as deep"));
  const auto short_of = [&](double from) {
    return warnings_of([&](Scene& s) {
      thick(from, 1.0, 16)(s);
      s.regions[0].section.height = 0.2;
    });
  };
  // All of it: as for a beam of that section. Half, from the middle on: mean depth 0.11 m, and with
  // E/G = 2.6, kappa G A and I_0 = b h^3/12 of h = 0.02 m and 0.2 m
  //   phi = 2.6/0.85 (50 + 5)/2/(7/24 * 12 50^3 + 1/24 * 12 5^3) 1/m^2 = 1.923e-4.
  EXPECT_TRUE(warns(short_of(0.0), "is 5 times as long as deep"));
  EXPECT_TRUE(warns(short_of(0.0), "is about 2.97 % of"));
  EXPECT_TRUE(warns(short_of(0.5), "is 9.09 times as long as deep"));
  EXPECT_TRUE(warns(short_of(0.5), "is about 0.0192 % of"));
}

TEST(SceneWarnings, SayWhatAClampWithinTheBeamLeavesOut) {
  const auto held_at = [](double at, bool breaks) {
    return warnings_of([=](Scene& s) {
      s.supports.push_back({{at, {}}, SupportKind::Clamp});
      if (breaks) s.material.break_strain = 0.02;
    });
  };
  const std::string text = "support[2] holds rotations within the beam";
  EXPECT_TRUE(warns(held_at(0.5, false), text));
  EXPECT_FALSE(warns(held_at(0.5, false), "do not break"));
  EXPECT_TRUE(warns(held_at(0.5, true), "they do not break"));
  EXPECT_FALSE(warns(held_at(1.0, true), text));
  EXPECT_FALSE(warns(warnings_of([](Scene& s) {
                       s.supports.push_back({{0.5, {}}, SupportKind::Roller});
                     }),
                     "holds rotations"));
}

/// Ten samples over four seconds keep the turn at 2 s, and not those at 1 s and 3 s.
TEST(SceneWarnings, SayThatTurningPointsLieBetweenSamples) {
  const auto turned = [](int steps) {
    Scene scene = cantilever();
    scene.loads[0].history = History::turning_points({1.0, -1.0, 1.0, 0.0});
    check_scene(scene, {});
    return scene_warnings(prepare(scene, {.steps = steps}));
  };
  EXPECT_TRUE(warns(turned(10), "histories turn between two samples, 2 times, first at 1 s"));
  EXPECT_FALSE(warns(turned(12), "histories turn"));
}

TEST(SceneWarnings, SayThatABreakWithoutHingeLengthDependsOnTheSegments) {
  const std::string text = "without a hinge length a break depends on the segments";
  EXPECT_TRUE(warns(warnings_of([](Scene& s) {
                      s.material.break_strain = 0.1;
                      s.hinge_length = 0.0;
                    }),
                    text));
  EXPECT_TRUE(warns(warnings_of([](Scene& s) {
                      s.material.break_strain = 0.1;
                      s.formulas = Formulas::Report;
                      s.yield_model = YieldModel::PerAxis;
                    }),
                    text));
}

TEST(SceneWarnings, SayWhatACapDoesToABeamThatIsLetGo) {
  const auto let_go = [](YieldCap cap, SectionShape shape) {
    return [=](Scene& s) {
      s.loads[0].history = History::turning_points({1.0, 0.0});
      s.yield_cap = cap;
      s.section.shape = shape;
    };
  };
  EXPECT_TRUE(
      warns(warnings_of(let_go(YieldCap::FirstYield, SectionShape::Rectangle)),
            "turns freely from there on, where the section carries up to 1.5 times as much"));
  EXPECT_TRUE(warns(warnings_of(let_go(YieldCap::FullyPlastic, SectionShape::Rectangle)),
                    "is elastic up to 1.5 times first yield, and below that keeps nothing"));
  // 16/(3 pi) of a circle.
  EXPECT_TRUE(
      warns(warnings_of(let_go(YieldCap::FullyPlastic, SectionShape::Circle)), "1.7 times"));
  for (const YieldModel model : {YieldModel::Fibre, YieldModel::Elastic}) {
    EXPECT_FALSE(warns(warnings_of([&](Scene& s) {
                         s.loads[0].history = History::turning_points({1.0, 0.0});
                         s.yield_model = model;
                       }),
                       "let go"));
  }
}

TEST(SceneWarnings, NameFibresToABeamThatIsLetGoWhetherItBendsOrTwists) {
  const auto let_go = [](std::array<double, 3> force, double torque) {
    return warnings_of([&](Scene& s) {
      s.loads[0].force = force;
      s.loads[0].moment = {0.0, 0.0, torque};
      s.loads[0].history = History::turning_points({1.0, 0.0});
      s.section.shape = SectionShape::Circle;
    });
  };
  const std::string fibres = " times as much; rules.yield_model = \"fibre\" follows the section";
  EXPECT_TRUE(warns(let_go({0.0, 1.0, 0.0}, 0.0), "1.7" + fibres));   // 16/(3 pi)
  EXPECT_TRUE(warns(let_go({0.0, 0.0, 0.0}, 1.0), "1.33" + fibres));  // 4/3 of a circle's torque
  EXPECT_TRUE(warns(let_go({1.0, 1.0, 0.0}, 1.0), "1.7" + fibres));
}

TEST(SceneWarnings, TakeALoadBackThatGrowsForOneThatDoesNotLetGo) {
  const auto with = [](const History& history) {
    return warns(warnings_of([&](Scene& s) { s.loads[0].history = history; }), "let go");
  };
  EXPECT_FALSE(with(History::ramp()));
  EXPECT_FALSE(with({{0.0, 1.0}, {1.0, 1.0}}));
  EXPECT_FALSE(with(History::turning_points({-1.0, -2.0})));
  EXPECT_TRUE(with(History::turning_points({-1.0, -0.5})));
  EXPECT_TRUE(with(History::turning_points({1.0, -2.0})));
}

TEST(SceneWarnings, SayThatPerAxisCapsLeaveOutTorsionBesideBending) {
  const auto of = [](YieldModel model, double torque) {
    return warnings_of([&](Scene& s) {
      s.yield_model = model;
      s.loads[0].moment = {0.0, 0.0, torque};
    });
  };
  EXPECT_TRUE(warns(of(YieldModel::PerAxis, 1.0), "bending and torsion"));
  EXPECT_FALSE(warns(of(YieldModel::PerAxis, 0.0), "bending and torsion"));
  EXPECT_FALSE(warns(of(YieldModel::Interaction, 1.0), "bending and torsion"));
}

TEST(SceneWarnings, SayHowFarPerAxisCapsExceedTheSection) {
  const auto skew = [](SectionShape shape, YieldCap cap) {
    return [=](Scene& s) {
      s.loads[0].force = {1.0, 1.0, 0.0};
      s.yield_model = YieldModel::PerAxis;
      s.section.shape = shape;
      s.yield_cap = cap;
    };
  };
  EXPECT_TRUE(
      warns(warnings_of(skew(SectionShape::Rectangle, YieldCap::FirstYield)), "100 % more"));
  EXPECT_TRUE(
      warns(warnings_of(skew(SectionShape::Rectangle, YieldCap::FullyPlastic)), "50 % more"));
  EXPECT_TRUE(warns(warnings_of(skew(SectionShape::Circle, YieldCap::FirstYield)), "41 % more"));
  EXPECT_FALSE(
      warns(warnings_of([](Scene& s) { s.yield_model = YieldModel::PerAxis; }), "both axes"));
}

TEST(SceneWarnings, SayWhenAPolylineHasACornerInsideOfASegment) {
  const auto bent = [](double first) {
    return [first](Scene& s) {
      s.beam.shape = BeamShape::Polyline;
      s.beam.points = {{0.0, 0.0, 0.0}, {0.0, 0.0, first}, {0.0, 1.0 - first, first}};
      s.beam.segments = 50;
    };
  };
  EXPECT_FALSE(warns(warnings_of(bent(0.5)), "corner"));
  EXPECT_FALSE(warns(warnings_of(bent(0.51)), "corner"));  // a segment ends there
  // A right angle in the middle of a 20 mm segment is 10/sqrt(2) mm off its chord.
  EXPECT_TRUE(warns(warnings_of([&](Scene& s) {
                      bent(0.51)(s);
                      s.beam.segment_fractions.assign(50, 0.02);
                    }),
                    "misses it by 0.00707 m"));
}

TEST(SceneWarnings, SayWhatActsInsideOfASegmentThatTheSceneMeasures) {
  const auto loaded = [](bool lengths) {
    return [lengths](Scene& s) {
      s.beam.segments = 10;
      if (lengths) s.beam.segment_fractions.assign(10, 0.1);
      s.loads.push_back({.at = {0.35, {}}, .force = {0.0, 1.0, 0.0}});
    };
  };
  EXPECT_FALSE(warns(warnings_of(loaded(false)), "inside of a segment"));
  EXPECT_TRUE(warns(warnings_of(loaded(true)), "at = 0.35 lies inside of a segment"));
  const auto massive = [](Scene& s) {
    s.beam.segments = 10;
    s.beam.segment_fractions.assign(10, 0.1);
    s.masses.push_back({{0.35, {}}, 1.0, {}});
  };
  EXPECT_TRUE(warns(warnings_of(massive), "mass[1].at = 0.35 lies inside of a segment"));
}

}  // namespace
}  // namespace plastica
