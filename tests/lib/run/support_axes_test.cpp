#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

/// Rotations that supports hold or spring, and moments beside them: about the world's axes,
/// whatever the beam's are.
namespace plastica {
namespace {

using testing::message_of;
using testing::tolerance;

constexpr double kE = 210e9, kG = kE / 2.6, kLength = 0.8;
constexpr double kAboutLong = 0.02 * 0.03 * 0.03 * 0.03 / 12.0;  // bending of 20 x 30 mm about x
constexpr double kAboutShort = 0.03 * 0.02 * 0.02 * 0.02 / 12.0;

/// A straight beam of 20 x 30 mm from the origin to a point, clamped there, and what else is said.
Response run_beam(
    const std::string& to, const std::string& more, int segments = 8,
    const std::string& section = "shape = 'rectangle', width = '20 mm', height = '30 mm'") {
  const io::SceneFile file =
      io::parse_scene_file("[beam]\nshape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], " + to +
                               "]\nsegments = " + std::to_string(segments) +
                               "\nmaterial = 'S355'\nsection = { " + section +
                               " }\n[rules]\nyield_model = 'elastic'\n[solver]\nsteps = "
                               "1\n[[support]]\nat = 'start'\nkind = 'clamp'\n" +
                               more,
                           "s.toml");
  return simulate(file.setup.scene, file.setup.solver);
}

std::string probe(const std::string& kind, const std::string& component, const std::string& at) {
  static int number = 0;
  return "[[probe]]\nname = 'p" + std::to_string(++number) + "'\nkind = '" + kind +
         "'\ncomponent = '" + component + "'\nat = " + at + "\n";
}

/// The end turns by M/(k + stiffness), with that of the beam about each of the world's axes: along
/// y its own z is the world's y, and its own y the world's z.
TEST(SupportAxes, OfSpringsAreTheWorldsAlongY) {
  constexpr double kSpring = 500.0, kMoment = 3.0;
  const double torsion =
      kG *
      section_properties({.shape = SectionShape::Rectangle, .width = 0.02, .height = 0.03}, 0.3)
          .torsion_constant;
  const double stiffness[3] = {kE * kAboutLong, torsion, kE * kAboutShort};
  const char* axes[3] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    std::string springs = "['0 N m/rad', '0 N m/rad', '0 N m/rad']";
    std::string moment = "['0 N m', '0 N m', '0 N m']";
    // The k-th of the zeros.
    std::size_t at = 0, of_moment = 0;
    for (std::size_t i = 0; i <= k; ++i) {
      at = springs.find("'0 ", at) + 1;
      of_moment = moment.find("'0 ", of_moment) + 1;
    }
    springs.replace(at, 1, "500");
    moment.replace(of_moment, 1, "3");
    const Response response = run_beam(
        "['0 m', '0.8 m', '0 m']",
        "[[support]]\nat = 'end'\nkind = 'elastic'\nrotational_stiffness = " + springs +
            "\n[[load]]\nat = 'end'\nmoment = " + moment + "\n" +
            probe("rotation", axes[k], "'end'") + probe("reaction_moment", axes[k], "'end'"));
    const double turn = kMoment / (kSpring + stiffness[k] / kLength);
    EXPECT_NEAR(response.probes[0][1] / turn, 1.0, 1e-3) << axes[k];
    EXPECT_NEAR(response.probes[1][1] / (-kSpring * turn), 1.0, 1e-3) << axes[k];
  }
}

/// Held about y alone, the twist of a beam along y; it still bends.
TEST(SupportAxes, OfHeldRotationsAreTheWorlds) {
  const Response response =
      run_beam("['0 m', '0.8 m', '0 m']",
               "[[support]]\nat = 'end'\nkind = 'clamp'\nhold = ['ry']\n"
               "[[load]]\nat = 'end'\nforce = ['0 N', '0 N', '1 N']\nmoment = ['0 N m', '2 N m', "
               "'0 N m']\n" +
                   probe("rotation", "y", "'end'") + probe("displacement", "z", "'end'"),
               32);
  EXPECT_NEAR(response.probes[0][1], 0.0, 1e-9);
  EXPECT_NEAR(response.probes[1][1] / (std::pow(kLength, 3) / (3.0 * kE * kAboutLong)), 1.0, 1e-3);
}

/// About its own axis a prescribed rotation comes through; where axes lie skew it is refused.
TEST(SupportAxes, ThatLieSkewAreRefused) {
  const std::string skew = "['0 m', '0.6 m', '0.5 m']";
  const std::string round = "shape = 'circle', radius = '10 mm'";
  // In a plane stability out of it would see half of what is held.
  EXPECT_TRUE(message_of([&] {
                (void)run_beam("['0 m', '0.6 m', '0.6 m']",
                               "[[support]]\nat = 'end'\nkind = 'clamp'\nhold = ['x', 'ry']\n"
                               "[[load]]\nat = 'end'\nforce = ['0 N', '-1 N', '0 N']\n");
              }).find("lie skew") != std::string::npos);
  const std::string out = "[[load]]\nat = 'end'\nforce = ['1 N', '0 N', '0 N']\n";
  const auto refusal = [&](const std::string& support) {
    return message_of(
        [&] { (void)run_beam(skew, "[[support]]\nat = 'end'\n" + support + out, 8, round); });
  };
  EXPECT_EQ(
      refusal("kind = 'clamp'\nhold = ['ry']\n"),
      "support[2].hold: is about axes of the world that lie skew to the beam's own there, about "
      "which joints turn: hold rx, ry and rz, or none");
  EXPECT_EQ(
      refusal("kind = 'elastic'\n"
              "rotational_stiffness = ['0 N m/rad', '9 N m/rad', '0 N m/rad']\n"),
      "support[2].rotational_stiffness: is about axes of the world that lie skew to the beam's "
      "own there, about which joints turn: give all three the same, or turn the beam");
  // About x, out of the plane in which it is tilted, nothing is skew, nor is what is the same about
  // all axes.
  EXPECT_EQ(refusal("kind = 'clamp'\nhold = ['rx']\n"), "no error");
  EXPECT_EQ(refusal("kind = 'elastic'\n"
                    "rotational_stiffness = ['9 N m/rad', '9 N m/rad', '9 N m/rad']\n"),
            "no error");
}

/// theta = M/(k + EI/a) at the spring, so the tip moves by -theta (a/2 + L - a), and the clamp has
/// EI/a theta: the chain has it whatever its segments.
TEST(SupportAxes, AMomentAtASpringActsOnTheNodeThatItHolds) {
  const std::string loaded = "[[load]]\nat = 0.5\nmoment = ['7 N m', '0 N m', '0 N m']\n" +
                             probe("displacement", "y", "'end'") +
                             probe("reaction_moment", "x", "'start'") +
                             probe("reaction_moment", "x", "0.5");
  for (const double spring : {1e3, 2e4, 1e6}) {
    for (const int segments : {2, 10, 40}) {
      const Response response =
          run_beam("['0 m', '0 m', '0.8 m']",
                   "[[support]]\nat = 0.5\nkind = 'elastic'\nrotational_stiffness = ['" +
                       std::to_string(spring) + " N m/rad', '0 N m/rad', '0 N m/rad']\n" + loaded,
                   segments);
      const double beam = kE * kAboutLong / (0.5 * kLength);
      const double turn = 7.0 / (spring + beam);
      EXPECT_NEAR(response.probes[0][1] / (-turn * 0.75 * kLength), 1.0, tolerance(1e-5));
      EXPECT_NEAR(response.probes[1][1] / (-beam * turn), 1.0, tolerance(1e-5));
      EXPECT_NEAR(response.probes[2][1] / (-spring * turn), 1.0, tolerance(1e-5));
    }
  }
}

/// A twist likewise, and between unlike regions.
TEST(SupportAxes, MomentsAtSpringsAreSharedAboutEachAxisAndBetweenRegions) {
  const std::string half =
      "[[support]]\nat = 0.5\nkind = 'elastic'\n"
      "rotational_stiffness = ['600 N m/rad', '0 N m/rad', '800 N m/rad']\n";
  const std::string region =
      "[[region]]\nfrom = 0.5\nto = 1.0\nsection = { width = '30 mm', height = '45 mm' }\n";
  const std::string loads = "[[load]]\nat = 0.5\nmoment = ['2 N m', '0 N m', '5 N m']\n" +
                            probe("reaction_moment", "x", "'start'") +
                            probe("reaction_moment", "z", "'start'");
  const double torsion =
      kG *
      section_properties({.shape = SectionShape::Rectangle, .width = 0.02, .height = 0.03}, 0.3)
          .torsion_constant;
  const double a = 0.5 * kLength;
  for (const std::string& more : {std::string(), region}) {
    const Response response = run_beam("['0 m', '0 m', '0.8 m']", more + half + loads);
    const double bend = kE * kAboutLong / a, twist = torsion / a;
    EXPECT_NEAR(response.probes[0][1] / (-2.0 * bend / (bend + 600.0)), 1.0, tolerance(1e-5));
    EXPECT_NEAR(response.probes[1][1] / (-5.0 * twist / (twist + 800.0)), 1.0, tolerance(1e-5));
  }
}

/// The spring's share of a moment would stand still while the rest follows.
TEST(SupportAxes, AMomentThatFollowsAtASpringIsRefused) {
  const auto with = [](const std::string& at) {
    return message_of([&] {
      (void)run_beam("['0 m', '0 m', '0.8 m']",
                     "[[support]]\nat = 0.5\nkind = 'elastic'\n"
                     "rotational_stiffness = ['9 N m/rad', '0 N m/rad', '0 N m/rad']\n"
                     "[[load]]\nat = " +
                         at + "\nmoment = ['1 N m', '0 N m', '0 N m']\nfollows = true\n");
    });
  };
  EXPECT_EQ(
      with("0.5"),
      "load[1].moment: follows the beam where a rotational spring holds it within: the spring "
      "takes a share of the moment that does not follow; move one of them by a segment");
  EXPECT_EQ(with("0.625"), "no error");
}

/// A pin holds the twist of the beam, wherever it goes, by each end rule, and alone keeps none of
/// its own motions from being found free.
TEST(SupportAxes, APinsTwistIsAboutTheBeam) {
  const std::string pinned =
      "[[support]]\nat = 'end'\nkind = 'pin'\n"
      "[[load]]\nat = 0.5\nforce = ['1 N', '0 N', '0 N']\n";
  const auto middle = [&](const std::string& to, const std::string& rule) {
    const io::SceneFile file = io::parse_scene_file(
        "[beam]\nshape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], " + to +
            "]\nsegments = 8\nmaterial = 'S355'\nsection = { shape = 'circle', radius = '10 mm' }\n"
            "[rules]\nyield_model = 'elastic'\nend_rule = '" +
            rule +
            "'\n[solver]\nsteps = 1\ntranslation = 'elastic'\n"
            "[[support]]\nat = 'start'\nkind = 'clamp'\n" +
            pinned + probe("displacement", "x", "0.5"),
        "s.toml");
    return simulate(file.setup.scene, file.setup.solver).probes[0][1];
  };
  for (const char* rule : {"half_joint", "equal"}) {
    const double along_z = middle("['0 m', '0 m', '0.8 m']", rule);
    EXPECT_GT(along_z, 1e-6);
    EXPECT_NEAR(middle("['0 m', '0.8 m', '0 m']", rule) / along_z, 1.0, 1e-9) << rule;
  }
  const auto start_pinned = [](const std::string& to) {
    return message_of([&] {
      const io::SceneFile file = io::parse_scene_file(
          "[beam]\nshape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], " + to +
              "]\nsegments = 8\nmaterial = 'S355'\n[[support]]\nat = 'start'\nkind = 'pin'\n"
              "[[support]]\nat = 'end'\nkind = 'clamp'\nhold = ['x', 'y', 'z']\n"
              "[[load]]\nat = 0.5\nforce = ['1 N', '0 N', '0 N']\n",
          "s.toml");
      (void)simulate(file.setup.scene, file.setup.solver);
    });
  };
  EXPECT_EQ(start_pinned("['0 m', '0 m', '0.8 m']"), "no error");
  EXPECT_EQ(start_pinned("['0 m', '0.8 m', '0 m']"), "no error");
  // And who holds it once more is refused.
  EXPECT_EQ(message_of([&] {
              (void)run_beam("['0 m', '0.8 m', '0 m']",
                             pinned + "[[support]]\nat = 'end'\nkind = 'clamp'\nhold = ['ry']\n");
            }),
            "s.toml:21: support[3].at = end: support[2] holds ry at the same place");
}

/// Springs at the start add up: about x by one support, about z by another.
TEST(SupportAxes, SpringsAtTheStartAddUp) {
  const auto tip = [](const std::string& supports) {
    const io::SceneFile file = io::parse_scene_file(
        "[beam]\nlength = '0.8 m'\nsegments = 8\nmaterial = 'S355'\nsection = { shape = "
        "'rectangle', width = '20 mm', height = '30 mm' }\n[rules]\nyield_model = 'elastic'\n"
        "[solver]\nlevel = 'spatial'\nsteps = 1\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
        "hold = ['x', 'y', 'z']\n" +
            supports +
            "[[load]]\nat = 'end'\nforce = ['0.5 N', '1 N', '0 N']\n[[probe]]\nkind = "
            "'displacement'\n",
        "s.toml");
    return simulate(file.setup.scene, file.setup.solver).probes[0][1];
  };
  const std::string spring = "[[support]]\nat = 'start'\nkind = 'elastic'\nrotational_stiffness = ";
  const double apart = tip(spring + "['900 N m/rad', '0 N m/rad', '0 N m/rad']\n" + spring +
                           "['0 N m/rad', '700 N m/rad', '800 N m/rad']\n");
  EXPECT_EQ(apart, tip(spring + "['900 N m/rad', '700 N m/rad', '800 N m/rad']\n"));
  const double exact = std::pow(kLength, 3) / (3.0 * kE * kAboutLong) + kLength * kLength / 900.0;
  EXPECT_NEAR(apart / exact, 1.0, 0.01);
}

/// What a fit moves would move the shares.
TEST(SupportAxes, SharedMomentsTakeNoStiffnessAsAParameter) {
  const io::SceneFile file = io::parse_scene_file(
      "[beam]\nlength = '1 m'\nsegments = 4\nmaterial = 'S355'\n"
      "[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[[support]]\nat = 0.5\nkind = 'elastic'\n"
      "rotational_stiffness = ['9 N m/rad', '0 N m/rad', '0 N m/rad']\n"
      "[[load]]\nat = 0.5\nmoment = ['1 N m', '0 N m', '0 N m']\n",
      "s.toml");
  const std::string modulus = "material.youngs_modulus", yield = "material.yield_stress";
  EXPECT_EQ(
      message_of(
          [&] { (void)prepare(file.setup.scene, file.setup.solver, std::span(&modulus, 1)); }),
      "material.youngs_modulus: cannot be a parameter where a moment acts at a rotational spring "
      "within the beam: both share it by the beam's stiffness, as the scene is laid out");
  EXPECT_NO_THROW((void)prepare(file.setup.scene, file.setup.solver, std::span(&yield, 1)));
}

/// A load that has stopped growing says nothing of the limit: M_p = (F_2 L + F_1 L/2).
TEST(LimitLoad, IsTheFactorOfWhatGrowsThere) {
  const std::string first =
      "[[load]]\nat = 0.5\nforce = ['0 N', '-50 N', '0 N']\n"
      "history = { time = ['0 s', '1 s'], factor = [0, 1] }\n";
  const std::string second =
      "[[load]]\nat = 'end'\nforce = ['0 N', '-4 kN', '0 N']\n"
      "history = { time = ['0 s', '1 s', '3 s'], factor = [0, 0, 2] }\n";
  for (const std::string& loads : {first + second, second + first}) {
    const io::SceneFile file = io::parse_scene_file(
        "[beam]\nlength = '0.3 m'\nsegments = 10\nmaterial = 'S355'\n"
        "section = { shape = 'rectangle', width = '20 mm', height = '30 mm' }\n"
        "[rules]\nyield_cap = 'fully_plastic'\n[solver]\nsteps = 100\nduration = '3 s'\n"
        "[[support]]\nat = 'start'\nkind = 'clamp'\n" +
            loads,
        "s.toml");
    const Response response = simulate(file.setup.scene, file.setup.solver);
    ASSERT_TRUE(response.limit);
    const double moment = 355e6 * 0.02 * 0.03 * 0.03 / 4.0;
    // The hinge is half a segment's joint away from the clamp at most.
    EXPECT_NEAR(response.limit->below, (moment - 50.0 * 0.15) / (4000.0 * 0.3), 1e-3);
  }
}

}  // namespace
}  // namespace plastica
