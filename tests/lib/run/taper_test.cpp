#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "plastica/model/torsion.hpp"
#include "plastica/run/batch.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;
using testing::last_of;

/// A cantilever whose section goes to another one at its end.
Scene tapered(int segments, const std::function<void(Section&)>& change) {
  Scene scene = testing::cantilever_scene(segments);
  scene.end_rule = EndRule::HalfJoint;
  Region taper{Place::start(), Place::end(), scene.section, scene.material};
  taper.to_section = taper.section;
  change(*taper.to_section);
  scene.regions = {taper};
  return scene;
}

/// The fraction of the length that a section has at s/L = xi is 1 - r xi.
void half_as_high(Section& section) { section.height *= 0.5; }

double integral(const std::function<double(double)>& f) {
  constexpr int kIntervals = 2000;  // Simpson: exact to 1e-12 of what is smooth
  double sum = 0.0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double weight = i == 0 || i == kIntervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * f(static_cast<double>(i) / kIntervals);
  }
  return sum / (3.0 * kIntervals);
}

/// Errors at 8, 16, 32 and 64 segments fall by four in the end.
void expect_order_two(const std::function<double(int)>& value, double exact, double error_at_64) {
  std::vector<double> errors;
  for (const int n : {8, 16, 32, 64}) errors.push_back(std::fabs(value(n) / exact - 1.0));
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.7);
  EXPECT_NEAR(errors[2] / errors[3], 4.0, 0.25);
  EXPECT_LT(errors.back(), error_at_64);
}

/// Unit-load theorem: the tip goes by the integral of P (L - s)^2/(E I(s)).
TEST(Taper, BendsAsTheIntegralOverItsLengthSays) {
  constexpr double kForce = 0.01;
  const Scene first = testing::cantilever_scene(1);
  const double exact = kForce / testing::bending_stiffness_of(first) * integral([](double xi) {
                         return std::pow(1.0 - xi, 2) / std::pow(1.0 - 0.5 * xi, 3);
                       });
  for (const Level level : {Level::Planar, Level::Spatial}) {
    expect_order_two(
        [&](int n) {
          Scene scene = tapered(n, half_as_high);
          scene.loads = {{.at = Place::end(), .force = {0.0, kForce, 0.0}}};
          add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
          return last_of(completed(scene, {.level = level, .steps = 1}), 0);
        },
        exact, 2e-4);
  }
}

/// A bar of area A (1 - xi/2) is drawn out by P L/(E A) 2 ln 2.
TEST(Taper, StretchesAsTheLogarithmSays) {
  expect_order_two(
      [&](int n) {
        Scene scene = tapered(n, [](Section& section) { section.width *= 0.5; });
        scene.loads = {{.at = Place::end(), .force = {0.0, 0.0, 1.0}}};
        add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Z);
        return last_of(completed(scene, {.translation = JointTranslation::Elastic, .steps = 1}), 0);
      },
      2.0 * std::numbers::ln2 / (200e9 * 4e-4), 1.2e-4);
}

/// A cone from R to R/2 turns by T L/(G J) 2/3 (2^3 - 1) = 14/3 T L/(G J).
TEST(Taper, TwistsAsAConeDoes) {
  const double radius = 0.01;
  expect_order_two(
      [&](int n) {
        Scene scene = tapered(n, [](Section& /*section*/) {});
        Region& cone = scene.regions[0];
        cone.section.shape = SectionShape::Circle;
        cone.section.radius = radius;
        cone.to_section = cone.section;
        cone.to_section->radius = 0.5 * radius;
        scene.loads = {{.at = Place::end(), .moment = {0.0, 0.0, 1.0}}};
        add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
        return last_of(completed(scene, {.steps = 1}), 0);
      },
      14.0 / 3.0 / (200e9 / 2.6 * std::numbers::pi / 2.0 * std::pow(radius, 4)), 1.5e-3);
}

/// From h to h/4 the hinge is where h(xi)^2/(1 - xi) is least, at xi = 2/3: the beam carries 3/4 of
/// what a prism of its clamped end would.
TEST(Taper, CarriesThePlasticMomentOfItsWeakestPlace) {
  const double prism = 250e6 * 0.02 * 0.02 * 0.02 / 4.0;  // N, of 1 m
  for (const int n : {12, 48}) {
    Scene scene = tapered(n, [](Section& section) { section.height *= 0.25; });
    scene.material.youngs_modulus = scene.regions[0].material.youngs_modulus = 200e13;
    scene.yield_model = YieldModel::PerAxis;
    scene.yield_cap = YieldCap::FullyPlastic;
    scene.loads = {{.at = Place::end(), .force = {0.0, 2.0 * prism, 0.0}}};
    const Response response = simulate(scene, {.level = Level::Planar});
    ASSERT_EQ(response.status, Status::LimitLoad);
    EXPECT_NEAR(2.0 * response.limit->below, 0.75, 2e-4);  // a joint is there: 12/3 and 48/3
  }
}

/// Kirchhoff (1879): a wedge that comes to an edge at x = 0 moves by (J1(z) or I1(z))/sqrt(x) with
/// z^2 = 4 omega x L/sqrt(E I/(rho A)), I and A of the clamped end, where deflection and slope are
/// zero: J1 I2 + J2 I1 = 0.
double wedge_frequency() {
  const auto condition = [](double z) {
    return std::cyl_bessel_j(1.0, z) * std::cyl_bessel_i(2.0, z) +
           std::cyl_bessel_j(2.0, z) * std::cyl_bessel_i(1.0, z);
  };
  double low = 4.0, high = 5.0;
  while (high - low > 1e-13) {
    const double middle = 0.5 * (low + high);
    (condition(low) * condition(middle) <= 0.0 ? high : low) = middle;
  }
  return 0.25 * low * low;
}

TEST(Taper, RingsAsKirchhoffsWedge) {
  EXPECT_NEAR(wedge_frequency(), 5.315, 5e-4);  // his own figure
  expect_order_two(
      [](int n) {
        Scene scene = tapered(n, [](Section& section) { section.height *= 1e-6; });
        scene.loads = {{.at = Place::end(), .force = {0.0, 1e-20, 0.0}}};  // a scene needs one
        const double area = 4e-4;
        const double wave =
            std::sqrt(testing::bending_stiffness_of(scene) / (scene.material.density * area));
        const SolverOptions options{.level = Level::Planar, .rotary_inertia = RotaryInertia::Off};
        return 2.0 * std::numbers::pi * unloaded_frequencies(scene, options, 1)[0] / wave;
      },
      wedge_frequency(), 5e-4);
}

TEST(Taper, IsTheSameFromBothEnds) {
  const auto end_moment = [](bool turned) {
    Scene scene = tapered(9, half_as_high);
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
    Region& taper = scene.regions[0];
    if (turned) std::swap(taper.section, *taper.to_section);
    scene.loads = {{.at = {turned ? 2.0 / 3.0 : 1.0 / 3.0, {}}, .force = {0.0, 1.0, 0.0}}};
    add_probe(scene, ProbeQuantity::Moment, turned ? Place::end() : Place::start(), Component::X);
    return last_of(
        completed(scene,
                  {.level = Level::Planar, .translation = JointTranslation::Elastic, .steps = 1}),
        0);
  };
  EXPECT_NEAR(std::fabs(end_moment(true)), std::fabs(end_moment(false)), 1e-9);
}

TEST(Taper, ThatGoesNowhereIsThePrism) {
  Scene scene = tapered(8, [](Section& /*section*/) {});
  scene.yield_model = YieldModel::Interaction;
  scene.loads = {{.at = Place::end(), .force = {100.0, 300.0, 0.0}}};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  Scene prism = scene;
  prism.regions.clear();
  EXPECT_EQ(last_of(completed(scene), 0), last_of(completed(prism), 0));
}

/// M/W of the place itself, first yield too.
TEST(Taper, HasTheStressOfEachPlace) {
  Scene scene = tapered(8, half_as_high);
  scene.loads = {{.at = Place::end(), .force = {0.0, 10.0, 0.0}}};
  for (const double at : {0.0, 0.25, 0.75}) {
    add_probe(scene, ProbeQuantity::Stress, {at, {}}, Component::X);
  }
  const Response response = completed(scene, {.level = Level::Planar, .steps = 1});
  for (std::size_t i = 0; i < 3; ++i) {
    const double xi = scene.probes[i].at.fraction;
    const double height = 0.02 * (1.0 - 0.5 * xi);
    const double stress = 10.0 * (1.0 - xi) / (0.02 * height * height / 6.0);
    EXPECT_NEAR(std::fabs(last_of(response, i)), stress, 1e-4 * stress);
  }
}

TEST(Taper, IsTheSameInEveryModelAndInABatch) {
  Scene scene = tapered(8, half_as_high);
  scene.loads = {{.at = Place::end(), .force = {0.0, 10.0, 0.0}}};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double elastic = last_of(completed(scene), 0);
  for (const YieldModel model : {YieldModel::PerAxis, YieldModel::Interaction,
                                 YieldModel::Conservative, YieldModel::Fibre}) {
    scene.yield_model = model;
    EXPECT_NEAR(last_of(completed(scene), 0), elastic, 1e-6 * elastic);
  }
  scene.yield_model = YieldModel::PerAxis;
  scene.loads[0].force[1] = 700.0;  // beyond first yield, 667 N
  Scene other = scene;
  other.regions[0].to_section->height = 0.015;
  const std::vector<BatchCase> cases{{"a", scene, {}}, {"b", other, {}}, {"c", scene, {}}};
  const std::vector<BatchRow> rows = run_batch(cases);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(last_of(rows[i].response, 0), last_of(completed(cases[i].scene), 0), 1e-9);
  }
  EXPECT_NE(last_of(rows[0].response, 0), last_of(rows[1].response, 0));
}

/// In time each scheme's stiffness and mass are the same: a beam that is let go rings alike.
TEST(Taper, SwingsAlikeInEveryScheme) {
  Scene scene = tapered(6, half_as_high);
  scene.initial_motions = {{.from = {0.5, {}}, .velocity = {0.0, 0.1, 0.0}}};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const auto run = [&](Scheme scheme) {
    return last_of(completed(scene, {.analysis = Analysis::Dynamics,
                                     .duration = 5e-3,
                                     .scheme = scheme,
                                     .time_step = 1e-6}),
                   0);
  };
  const double implicit = run(Scheme::EnergyMomentum);
  EXPECT_GT(std::fabs(implicit), 1e-5);
  EXPECT_NEAR(run(Scheme::ArticulatedMidpoint), implicit, 1e-3 * std::fabs(implicit));
}

/// What acts on the weak end is carried by the section there, whatever the segments: T_p and M_p of
/// the end, and its axial capacity.
TEST(Taper, CarriesAtItsWeakEndWhatTheSectionThereDoes) {
  for (const int segments : {4, 16}) {
    Scene scene = tapered(segments, [](Section& section) {
      section.width *= 0.5;
      section.height *= 0.5;
    });
    scene.yield_cap = YieldCap::FullyPlastic;
    const SectionProperties end = section_properties(*scene.regions[0].to_section, 0.3);
    const double yield = scene.material.yield_stress;
    const double torque = yield / std::sqrt(3.0) * end.plastic_torsion_modulus;
    const double moment = yield * end.plastic_section_modulus_x;
    const double pull = yield * end.area;
    const auto limit_load = [&](const Load& load, Level level, YieldModel model) {
      scene.yield_model = model;
      scene.loads = {load};
      const Response response =
          simulate(scene, {.level = level, .translation = JointTranslation::Elastic, .steps = 40});
      EXPECT_EQ(response.status, Status::LimitLoad);
      return response.chain.factor[response.samples - 1];
    };
    const Load twist{.moment = {0.0, 0.0, 2.0 * torque}};
    EXPECT_NEAR(limit_load(twist, Level::Twist, YieldModel::PerAxis), 0.5, 1e-3) << segments;
    const Load bend{.moment = {2.0 * moment, 0.0, 0.0}, .follows = true};
    EXPECT_NEAR(limit_load(bend, Level::Planar, YieldModel::PerAxis), 0.5, 1e-3) << segments;
    const Load stretch{.force = {0.0, 0.0, 2.0 * pull}};
    EXPECT_NEAR(limit_load(stretch, Level::Planar, YieldModel::Interaction), 0.5, 1e-3) << segments;
  }
}

TEST(Taper, RefusesAnotherShapeAtItsEnd) {
  const Scene scene = tapered(4, [](Section& section) { section.shape = SectionShape::Circle; });
  EXPECT_EQ(testing::message_of([&] { prepare(scene); }),
            "region[1].to_section.shape = circle: must be that of section, rectangle");
}

/// A box takes finite elements, some 10 ms.
TEST(Taper, SolvesTheTorsionOfEachOfItsBoxesOnce) {
  Scene scene = tapered(20, [](Section&) {});
  Region& taper = scene.regions[0];
  for (Section* section : {&scene.section, &taper.section, &*taper.to_section}) {
    *section = {.shape = SectionShape::RectangularTube, .width = 0.02, .height = 0.02};
    section->inner_width = 0.016;
    section->inner_height = 0.015703;
  }
  taper.to_section->inner_height = 0.011;
  scene.yield_model = YieldModel::Fibre;
  scene.loads.push_back({.moment = {0.0, 0.0, 1.0}});
  const SolverOptions options{.level = Level::Spatial, .fibres = 4, .steps = 1};
  const std::size_t before = boxes_solved();
  EXPECT_EQ(simulate(scene, options).status, Status::Completed);
  // Those of 21 nodes, the first of which is the scene's own, too, and of 20 middles.
  EXPECT_EQ(boxes_solved() - before, 41U);
  // Nor does another model of the same beam solve them anew.
  EXPECT_FALSE(scene_warnings(prepare(scene, options)).empty());
  EXPECT_EQ(boxes_solved() - before, 41U);
}

}  // namespace
}  // namespace plastica
