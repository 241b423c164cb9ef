#include "plastica/run/scene_warnings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "plastica/run/peak_warning.hpp"
#include "plastica/run/plane_warning.hpp"
#include "plastica/run/run_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/run/warnings_of.hpp"
#include "tests/support/chain_scene.hpp"

namespace plastica {
namespace {

using testing::cantilever;

/// The lowest frequency of a clamped bar is 3.516/(2 pi) sqrt(E I/(rho A))/L^2.
TEST(PathWarnings, SayWhereSamplesMissTheBeamsSwing) {
  const auto sampled = [](double in_period) {
    Scene scene = cantilever();
    SolverOptions options;
    options.analysis = Analysis::Dynamics;
    options.time_step = 1e-4;
    options.steps = 20;
    const Material& m = scene.material;
    const SectionProperties p = section_properties(scene.section, m.poisson_ratio);
    const double length = scene.beam.length;
    const double frequency =
        3.516 / (2.0 * std::numbers::pi) *
        std::sqrt(m.youngs_modulus * p.second_moment_x / (m.density * p.area)) / (length * length);
    options.duration = options.steps / (in_period * frequency);
    return scene_warnings(prepare(scene, options));
  };
  EXPECT_TRUE(warns(sampled(1.5), "are not those of the motion"));
  EXPECT_FALSE(warns(sampled(2.1), "are not those of the motion"));
  EXPECT_TRUE(warns(sampled(3.0), "extremes lack up to 50 % of such a swing"));  // 1 - cos(60 deg)
  EXPECT_FALSE(warns(sampled(4.2), "samples every"));
}

// Two segments, each clamped at its outer end: nothing can move, and there is no frequency.
TEST(PathWarnings, SayNothingOfSamplesWhereSupportsHoldEverySegment) {
  Scene scene = testing::cantilever();
  scene.beam.segments = 2;
  scene.end_rule = EndRule::Equal;
  scene.supports.push_back({.at = {1.0, {}}, .kind = SupportKind::Clamp});
  scene.loads[0].force = {};
  scene.loads[0].moment = {0.0, 0.0, 1.0};
  SolverOptions options;
  options.analysis = Analysis::Dynamics;
  options.duration = 1.0;
  EXPECT_FALSE(warns(scene_warnings(prepare(scene, options)), "samples every"));
}

TEST(PathWarnings, SayWhereARampGrowsWithALongerHistory) {
  const auto with = [](const std::function<void(Scene&)>& change) {
    return warnings_of([&](Scene& s) {
      s.loads[0].history = History::turning_points({1.0, -1.0, 0.0});
      change(s);
    });
  };
  EXPECT_TRUE(warns(with([](Scene& s) {
                      s.gravity = {0.0, -9.81, 0.0};
                    }),
                    "gravity follows a ramp, and the path ends at 3 s"));
  EXPECT_TRUE(warns(with([](Scene& s) {
                      s.loads.push_back({.force = {0.0, 1.0, 0.0}});
                    }),
                    "load[2] follows a ramp"));
  EXPECT_FALSE(warns(with([](Scene&) {}), "follows a ramp"));
  EXPECT_FALSE(warns(with([](Scene& s) {
                       s.gravity = {0.0, -9.81, 0.0};
                       s.gravity_history = History::constant();
                     }),
                     "follows a ramp"));
  EXPECT_FALSE(warns(warnings_of([](Scene& s) {
                       s.gravity = {0.0, -9.81, 0.0};
                     }),
                     "follows a ramp"));
}

// Z/W of a rectangle is 3/2.
TEST(PathWarnings, SayThatFullyPlasticJointsHardenTooSteeply) {
  const auto of = [](YieldCap yield_cap, HardeningLaw law, YieldModel model) {
    return warns(warnings_of([=](Scene& s) {
                   s.yield_cap = yield_cap;
                   s.yield_model = model;
                   s.material.hardening.law = law;
                   s.material.hardening.tangent_modulus = 1e9;
                 }),
                 "harden 1.5 times as steeply");
  };
  using enum YieldCap;
  EXPECT_TRUE(of(FullyPlastic, HardeningLaw::Linear, YieldModel::Interaction));
  EXPECT_FALSE(of(FullyPlastic, HardeningLaw::Ideal, YieldModel::Interaction));
  EXPECT_FALSE(of(FirstYield, HardeningLaw::Linear, YieldModel::Interaction));
}

/// A cantilever whose clamp yields at W sigma_y/L = 0.6313 of its load: it is a mechanism from
/// there, and carries the rest as it hangs from the clamp. Whether a step of the load meets that is
/// chance.
TEST(PathWarnings, SayWhereABeamGivesWayBeforeItGoesOn) {
  Scene scene = cantilever();
  scene.section = Section{};
  scene.section.width = 0.02;
  scene.section.height = 0.04;
  scene.beam.length = 1.0;
  scene.beam.segments = 10;
  scene.material.youngs_modulus = 210e9;
  scene.material.yield_stress = 355e6;
  scene.loads.resize(1);
  scene.loads[0] = {.force = {0.0, -3000.0, 0.0}};
  int ended = 0, went_on = 0;
  for (const int steps : {5, 18, 19, 20, 40}) {
    SolverOptions options;
    options.steps = steps;
    const Model model = prepare(scene, options);
    const Response response = simulate(scene, options);
    const auto warnings = run_warnings(scene, options, model, response);
    // W = 2/3 of the plastic modulus: the limit is that of the first yield.
    EXPECT_TRUE(warns(warnings, "yield_cap")) << steps;
    const bool says = warns(warnings, "the beam gives way as it yields: between factors of 0.63");
    if (response.status == Status::LimitLoad) {
      ++ended;
      EXPECT_FALSE(says) << steps;
      EXPECT_NEAR(response.limit->below, 0.6313, 1e-3) << steps;
    } else {
      ++went_on;
      EXPECT_EQ(response.status, Status::Completed) << steps;
      EXPECT_TRUE(says) << steps;
    }
  }
  EXPECT_GT(ended, 0);
  EXPECT_GT(went_on, 0);
}

/// A slender one hangs from its clamp with less of a turn: of 20 mm it still moves some 40 times as
/// far as elastically beyond M_p/L = 0.71 of its load.
TEST(PathWarnings, SayWhereASlenderBeamGivesWay) {
  Scene scene = cantilever();
  scene.section = Section{};
  scene.section.width = scene.section.height = 0.02;
  scene.beam.length = 1.0;
  scene.beam.segments = 20;
  scene.material.youngs_modulus = 210e9;
  scene.material.yield_stress = 355e6;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.loads.resize(1);
  scene.loads[0] = {.force = {0.0, -1000.0, 0.0}};
  const auto said = [&](double load, int steps) {
    scene.loads[0].force[1] = -load;
    SolverOptions options;
    options.steps = steps;
    const Response response = testing::completed(scene, options);
    return warns(run_warnings(scene, options, prepare(scene, options), response),
                 "the beam gives way as it yields: between factors of 0.7");
  };
  for (const int steps : {10, 20, 100}) EXPECT_TRUE(said(1000.0, steps)) << steps;
  EXPECT_FALSE(said(700.0, 100)) << "below M_p/L";
}

/// Of N alone the section carries no more by another cap; and what hardens gives way as it should.
TEST(PathWarnings, SayNothingOfCapsUnderAnAxialForceNorOfHardeningThatIsFlat) {
  const auto said = [](const std::function<void(Scene&)>& change, const SolverOptions& options) {
    Scene scene = cantilever();
    scene.beam.segments = 8;
    scene.loads.resize(1);
    scene.loads[0] = {};
    change(scene);
    const Model model = prepare(scene, options);
    return run_warnings(scene, options, model, simulate(scene, options));
  };
  const SectionProperties p = section_properties(cantilever().section, 0.3);
  const double yield = cantilever().material.yield_stress;
  const auto pulled = said([&](Scene& s) { s.loads[0].force[2] = 2.0 * yield * p.area; }, {});
  EXPECT_FALSE(warns(pulled, "up to 1.5"));
  const auto hardened = said(
      [&](Scene& s) {
        s.loads[0].moment[0] = 1.2 * yield * p.section_modulus_x;
        s.material.hardening.law = HardeningLaw::Linear;
        s.material.hardening.tangent_modulus = 1e-3 * s.material.youngs_modulus;
      },
      {});
  EXPECT_FALSE(warns(hardened, "gives way"));
}

TEST(PathWarnings, SayThatNoLoadHasComeToALimitWhereNoneActs) {
  Scene scene = testing::cantilever_scene(4);
  Response response;
  response.status = Status::LimitLoad;
  ASSERT_EQ(peak_warnings(scene, response).size(), 1U);
  EXPECT_TRUE(peak_warnings(scene, response)[0].starts_with("nothing but motions of supports"));
  scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
  EXPECT_TRUE(peak_warnings(scene, response).empty());
  scene.loads.clear();
  scene.gravity = {0.0, -9.81, 0.0};
  EXPECT_TRUE(peak_warnings(scene, response).empty());
}

TEST(PathWarnings, SayWhereARegionCoversAnother) {
  const auto with = [](double from) {
    return warnings_of([=](Scene& s) {
      Region one;
      one.from = {0.0, {}};
      one.to = {0.5, {}};
      one.section = s.section;
      one.material = s.material;
      Region other = one;
      other.from = {from, {}};
      other.to = {1.0, {}};
      s.regions = {one, other};
    });
  };
  EXPECT_TRUE(warns(with(0.25), "region[2] lies over region[1] from 0.25 to 0.5 of the length"));
  EXPECT_FALSE(warns(with(0.5), "lies over"));
}

/// A cantilever in the level of space with a force along y: at the end of its path it lies beside
/// its plane by so much.
TEST(PathWarnings, SayWhereOnlyRoundingTakesABeamOutOfItsPlane) {
  const auto warned = [](double beside, const std::function<void(Scene&, Response&)>& change) {
    Scene scene = cantilever();
    scene.loads = {{.at = Place::end(), .force = {0.0, -300.0, 0.0}}};
    Response response;
    response.chain.position = {0.0, 0.0, 0.0, beside, -0.1, 0.9};
    change(scene, response);
    SolverOptions options;
    options.level = Level::Spatial;
    return plane_warning(scene, options, Level::Spatial, response).has_value();
  };
  const auto as_it_is = [](Scene&, Response&) {};
  EXPECT_TRUE(warned(1e-3, as_it_is));
  EXPECT_TRUE(warned(-1e-3, as_it_is));
  EXPECT_FALSE(warned(1e-12, as_it_is));
  EXPECT_FALSE(warned(1e-3, [](Scene& s, Response&) { s.loads[0].force[0] = 0.6; }));
  EXPECT_FALSE(warned(1e-3, [](Scene&, Response& r) { r.critical.emplace(); }));
  // Bent about the other axis, it leaves another plane.
  EXPECT_FALSE(warned(1e-3, [](Scene& s, Response& r) {
    s.loads[0].force = {-300.0, 0.0, 0.0};
    r.chain.position[4] = 0.0;
  }));
}

}  // namespace
}  // namespace plastica
