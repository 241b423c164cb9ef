#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "plastica/theory/beam_cases.hpp"
#include "plastica/theory/report_formulas.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Report against mechanics: the rows of design 2.4, each as two numbers out of a chain.

namespace plastica {
namespace {

using testing::completed;
using testing::tolerance;

constexpr double kYield = 250e6;
constexpr double kHalf = 0.5;  ///< tributary length of the one joint [m]

const Section kSquareBar{.width = 0.02, .height = 0.02};
const Section kWide{.width = 0.02, .height = 0.01};
const Section kTall{.width = 0.01, .height = 0.02};
const Section kRoundBar{.shape = SectionShape::Circle, .radius = 0.01};

/// What the one joint of a beam of two segments does, both ends clamped and one of them turned.
struct OneJoint {
  double moment = 0.0;   ///< [N m]
  double plastic = 0.0;  ///< permanent angle [rad]
  double strain = 0.0;   ///< permanent, in the break measure [1]
};

/// @param axis  0, 1: bending about x, y; 2: torsion
Scene turned(const Section& section, Formulas formulas, std::size_t axis, double angle) {
  Scene scene = testing::cantilever_scene(2);
  scene.section = section;
  scene.formulas = formulas;
  scene.end_rule = EndRule::Equal;
  scene.hinge_length = 0.0;
  scene.yield_model = YieldModel::PerAxis;
  Support end{.at = Place::end(), .hold = HeldFreedoms{}};
  (*end.hold)[3 + axis] = true;
  end.rotation[axis] = angle;
  scene.supports.push_back(end);
  return scene;
}

OneJoint run_joint(const Scene& scene, std::size_t axis) {
  const Response response = simulate(scene, {.steps = 50});
  EXPECT_TRUE(usable(response.status)) << name_of(response.status);
  const std::size_t at = (response.samples - 1) * response.chain.joints + 1;
  return {std::fabs(response.chain.moment[3 * at + axis]),
          std::fabs(response.chain.plastic_angle[3 * at + axis]),
          response.chain.plastic_strain[at]};
}

/// Report and mechanics of the same bar.
struct Row {
  double report = 0.0;
  double mechanics = 0.0;
  double ratio() const { return report / mechanics; }
};

void show(const std::string& what, const Row& row) {
  std::printf("| %s | %.6g | %.6g | %.4f |\n", what.c_str(), row.report, row.mechanics,
              row.ratio());
}

/// Elastic stiffness of the joint [N m/rad].
Row stiffness(const Section& section, std::size_t axis) {
  constexpr double kSmall = 1e-4;
  const auto of = [&](Formulas formulas) {
    return run_joint(turned(section, formulas, axis, kSmall), axis).moment / kSmall;
  };
  return {of(Formulas::Report), of(Formulas::Mechanics)};
}

/// Moment on the plateau [N m]; the same yield stress in shear for both.
Row cap(const Section& section, std::size_t axis, bool same_shear_yield = true) {
  const auto of = [&](Formulas formulas) {
    Scene scene = turned(section, formulas, axis, 1.0);
    if (same_shear_yield) scene.material.shear_yield_stress = kYield;
    return run_joint(scene, axis).moment;
  };
  return {of(Formulas::Report), of(Formulas::Mechanics)};
}

/// Permanent strain of the joint when it has turned by an angle, over the permanent angle [1/rad].
Row strain_per_angle(const Section& section, std::size_t axis, double angle) {
  const auto of = [&](Formulas formulas) {
    const OneJoint joint = run_joint(turned(section, formulas, axis, angle), axis);
    return joint.strain / joint.plastic;
  };
  return {of(Formulas::Report), of(Formulas::Mechanics)};
}

TEST(ReportRows, Equation1IsHalfAsStiffInBending) {
  const double ei = 200e9 * std::pow(0.02, 4) / 12.0;
  const Row row = stiffness(kSquareBar, 0);
  show("(1) bending stiffness, square [N m/rad]", row);
  EXPECT_NEAR(row.mechanics / (ei / kHalf), 1.0, tolerance(1e-9));
  EXPECT_NEAR(row.ratio(), 0.5, tolerance(1e-9));
}

TEST(ReportRows, Equation2TakesASecondMomentForTheTorsionConstant) {
  // On top of the half that (2) shares with (1).
  struct Case {
    const char* name;
    Section section;
    double ratio;
  };
  for (const Case& c : {Case{"circle", kRoundBar, 0.50}, Case{"square", kSquareBar, 0.593},
                        Case{"2:1", kWide, 1.458}}) {
    Row row = stiffness(c.section, 2);
    show(std::string("(2) torsion stiffness, ") + c.name + " [N m/rad]", row);
    EXPECT_NEAR(2.0 * row.ratio(), c.ratio, tolerance(5e-4)) << c.name;
  }
}

TEST(ReportRows, Equations4And5HalveTheMomentOfASquareAtFirstYield) {
  const Row row = cap(kSquareBar, 0);
  show("(4), (5) bending cap, square [N m]", row);
  EXPECT_NEAR(row.mechanics, kYield * std::pow(0.02, 3) / 6.0, tolerance(1e-8));
  EXPECT_NEAR(row.ratio(), 0.5, tolerance(1e-12));
  const Row x = cap(kTall, 0);
  const Row y = cap(kTall, 1);
  show("(4) bending cap about x, h = 2b [N m]", x);
  show("(5) bending cap about y, h = 2b [N m]", y);
  EXPECT_NEAR(x.ratio(), 1.0, tolerance(1e-12));
  EXPECT_NEAR(y.ratio(), 0.25, tolerance(1e-12));
}

TEST(ReportRows, Equation6IsFourPercentTooLargeAtTwoToOne) {
  const Row row = cap(kWide, 2);
  show("(6) torsion cap, 2:1 [N m]", row);
  EXPECT_NEAR(row.ratio() - 1.0, 0.043, tolerance(5e-4));
}

TEST(ReportRows, Equation7SwapsTheSidesOfAFlatSection) {
  // The library's report formulas follow (24), which (7) contradicts.
  constexpr double kAngle = 0.01;
  const Row row{theory::report::bending_strain_x(kTall.width, kAngle, kHalf) / kAngle,
                strain_per_angle(kTall, 0, 0.2).mechanics};
  show("(7) strain of bending about x per angle, h = 2b [1/rad]", row);
  EXPECT_NEAR(row.mechanics, kTall.height / 2.0 / kHalf, tolerance(1e-12));
  EXPECT_NEAR(row.ratio(), 0.5, tolerance(1e-5));
}

TEST(ReportRows, Equation8TakesHalfTheSideForTheLeverOfShear) {
  const Row row = strain_per_angle(kSquareBar, 2, 1.0);
  show("(8) shear strain per angle, square [1/rad]", row);
  EXPECT_NEAR(row.report, 0.500 * 0.02 / kHalf, tolerance(1e-12));
  EXPECT_NEAR(row.mechanics, 0.675 * 0.02 / kHalf, tolerance(2e-5));
}

TEST(ReportRows, Equation24TakesTheSineOfTheHalfAngle) {
  const Row row = strain_per_angle(kSquareBar, 0, 2.5);
  show("(24) strain per angle of a joint turned by 2.5 rad, square [1/rad]", row);
  const double kept = run_joint(turned(kSquareBar, Formulas::Report, 0, 2.5), 0).plastic;
  EXPECT_NEAR(row.mechanics, 0.01 / kHalf, tolerance(1e-12));
  EXPECT_NEAR(row.report, 0.02 / kHalf * std::sin(kept / 2.0) / kept, tolerance(1e-12));
  // As printed it falls beyond half a turn, and a joint would heal.
  constexpr double kThreeQuarters = 1.5 * std::numbers::pi;  // of a turn [rad]
  const Row beyond{theory::report::bending_strain(0.02, kThreeQuarters, kHalf),
                   0.01 * kThreeQuarters / kHalf};
  show("(24) as printed, strain at 270 degrees, square [1]", beyond);
  EXPECT_NEAR(beyond.report, 0.02 / kHalf * std::sin(0.5 * kThreeQuarters), tolerance(1e-12));
}

TEST(ReportRows, ShearYieldsAtTheYieldStressItselfInTheReport) {
  const Row row = cap(kRoundBar, 2, false);
  show("tau_y not given: torsion cap, circle [N m]", row);
  EXPECT_NEAR(row.ratio(), std::numbers::sqrt3, tolerance(1e-12));
}

TEST(ReportRows, ShearBreaksAtTheBreakStrainItselfInTheReport) {
  const auto limit = [](Formulas formulas) {
    Scene scene = turned(kRoundBar, formulas, 2, 20.0);
    scene.material.break_strain = 0.1;
    const Response response = simulate(scene, {.steps = 200});
    EXPECT_EQ(response.status, Status::Broken);
    return response.chain.events.front().joints.front().strain;
  };
  const Row row{limit(Formulas::Report), limit(Formulas::Mechanics)};
  show("gamma_break not given, eps_break = 10 %: shear strain at break [1]", row);
  EXPECT_NEAR(row.report, 0.1, tolerance(1.1e-5));
  EXPECT_NEAR(row.mechanics, 0.1 * std::numbers::sqrt3, tolerance(2e-5));
}

/// Wendelius' Figure 8 with N_c constraints: 4 m at rest on two pillars under its weight.
Scene figure8(int constraints, Formulas formulas) {
  Scene scene = testing::chain_scene(constraints + 1);
  scene.beam.length = 4.0;
  scene.section.width = scene.section.height = 0.2;
  scene.formulas = formulas;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::ramp();
  scene.supports = {{.at = Place::start(), .kind = SupportKind::Pillar},
                    {.at = Place::end(), .kind = SupportKind::Pillar},
                    {.at = Place::start(),
                     .kind = SupportKind::Pin,
                     .hold = HeldFreedoms{false, false, true, false, false, false}}};
  testing::add_probe(scene, ProbeQuantity::Displacement, Place{0.5, {}}, Component::Y);
  return scene;
}

TEST(ReportRows, MomentsOfFigure8DoNotDependOnTheSegments) {
  const double weight = 7850.0 * 9.81 * 0.2 * 0.2;
  for (const Formulas formulas : {Formulas::Report, Formulas::Mechanics}) {
    double worst = 0.0;
    for (const int constraints : {20, 30, 50, 100}) {
      const Response response = completed(figure8(constraints, formulas), {.steps = 1});
      const int n = constraints + 1;
      const std::size_t base = (response.samples - 1) * response.chain.joints;
      for (int i = 1; i < n; ++i) {
        const double z = 4.0 * i / n;
        const double curve = weight * z * (4.0 - z) / 2.0;
        const double moment =
            std::fabs(response.chain.moment[3 * (base + static_cast<std::size_t>(i))]);
        worst = std::max(worst, std::fabs(moment - curve) / (weight * 2.0));
      }
    }
    std::printf("| figure 8, moments off the curve, over the largest: %.2e |\n", worst);
    // The pillars' levers change by the square of the slope, 3e-4 with mechanics.
    EXPECT_LT(worst, tolerance(1e-6));
  }
}

TEST(ReportRows, DeflectionsDependOnTheSegmentsMuchWithTheRigidClampAndLittleWithTheHalfJoint) {
  const auto error = [](EndRule rule, int segments) {
    Scene scene = testing::cantilever_scene(segments);
    scene.end_rule = rule;
    scene.loads.push_back({.force = {0.0, -1e-2, 0.0}});
    testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    const theory::BeamCase beam{.length = 1.0,
                                .bending_stiffness = testing::bending_stiffness_of(scene),
                                .load = {.position = 1.0, .force = -1e-2}};
    return testing::last_of(completed(scene, {.steps = 1}), 0) /
               theory::beam_deflection(beam, 1.0) -
           1.0;
  };
  for (const int segments : {5, 10, 20, 40, 80}) {
    std::printf("| tip force, N = %d | rigid clamp %+.3f %% | half joint %+.4f %% |\n", segments,
                100.0 * error(EndRule::Equal, segments),
                100.0 * error(EndRule::HalfJoint, segments));
  }
  EXPECT_NEAR(error(EndRule::Equal, 20), -0.07375, tolerance(1e-6));
  EXPECT_NEAR(std::log2(error(EndRule::Equal, 40) / error(EndRule::Equal, 80)), 1.0,
              tolerance(0.02));
  EXPECT_NEAR(error(EndRule::HalfJoint, 20), 0.00125, tolerance(1e-6));
  EXPECT_NEAR(std::log2(error(EndRule::HalfJoint, 20) / error(EndRule::HalfJoint, 40)), 2.0,
              tolerance(0.01));
}

}  // namespace
}  // namespace plastica
