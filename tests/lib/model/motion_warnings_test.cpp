#include "plastica/model/motion_warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using std::numbers::pi;
using testing::cantilever;

using Change = std::function<void(Scene&, SolverOptions&)>;

/// Warnings of the slender cantilever in motion for a second, well resolved.
std::vector<std::string> warnings_of(const Change& change) {
  Scene scene = cantilever();
  SolverOptions options;
  options.analysis = Analysis::Dynamics;
  options.steps = 100;
  change(scene, options);
  check_scene(scene, options);
  return scene_warnings(prepare(scene, options));
}

bool has(const std::vector<std::string>& warnings, const std::string& text) {
  for (const std::string& warning : warnings) {
    if (warning.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(MotionWarnings, AreNoneOfAMotionThatIsWellResolved) {
  EXPECT_EQ(warnings_of([](Scene&, SolverOptions&) {}), std::vector<std::string>{});
  // At rest, nobody asks for the step.
  EXPECT_EQ(warnings_of([](Scene&, SolverOptions& o) {
              o.analysis = Analysis::Statics;
              o.time_step = 1.0;
            }),
            std::vector<std::string>{});
}

TEST(MotionWarnings, SayHowFewStepsAreInAPeriod) {
  // 1.8751^2 0.02/sqrt(12) sqrt(210e9/7850)/(2 pi) = 16.7 Hz, 59.8 ms.
  const auto warnings = warnings_of([](Scene&, SolverOptions& o) { o.time_step = 5e-3; });
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0],
            "steps of 0.005 s are 12 in a period of the beam's first frequency in bending, about "
            "16.7 Hz (below 20); solver.time_step = \"0.00299 s\" makes 20");
  // Steps end at samples, and adaptive ones look after themselves.
  EXPECT_EQ(warnings_of([](Scene&, SolverOptions& o) {
              o.time_step = 5e-3;
              o.steps = 1000;
            }),
            std::vector<std::string>{});
  EXPECT_EQ(warnings_of([](Scene&, SolverOptions& o) {
              o.time_step = 5e-3;
              o.step_error = 1e-4;
            }),
            std::vector<std::string>{});
}

/// A twist or a stretch that a load sets swinging is faster than the first bending.
TEST(MotionWarnings, CountTheStepsOfASwingingTwistAndStretch) {
  const auto twisted = [](const History& history, double across) {
    return warnings_of([&](Scene& scene, SolverOptions& o) {
      o.time_step = 1e-3;
      o.steps = 1000;
      scene.loads.push_back({.moment = {across, 0.0, 10.0}, .history = history});
    });
  };
  // sqrt(80.77 GPa 0.1406 0.02^4/(7850 2 0.02^4/12))/(4 m) = 736.5 Hz; the scene bends, too.
  const auto is_of_twist = [](const std::vector<std::string>& warnings) {
    return has(warnings,
               "are 1.36 in a period of the beam's first frequency in torsion, about 736 Hz");
  };
  EXPECT_TRUE(is_of_twist(twisted(History::constant(), 1.0)));
  EXPECT_TRUE(has(twisted(History::constant(), 1.0),
                  "samples every 0.001 s: the beam swings with its first frequency in torsion"));
  EXPECT_FALSE(has(twisted(History::smooth_step(0.0, 0.5), 1.0), "samples every"));
  EXPECT_TRUE(is_of_twist(twisted({{0.0, 1e-3}, {0.0, 1.0}}, 1.0)));
  // A ramp that has hardly begun by the end of the motion.
  EXPECT_TRUE(has(warnings_of([](Scene& scene, SolverOptions& o) {
                    o.duration = 0.01;
                    o.steps = 10;
                    o.time_step = 1e-3;
                    scene.loads.push_back({.moment = {1.0, 0.0, 10.0}});
                  }),
                  "first frequency in torsion"));
  // Neither what grows slowly, nor a trifle.
  EXPECT_FALSE(is_of_twist(twisted(History::smooth_step(0.0, 0.5), 1.0)));
  EXPECT_FALSE(is_of_twist(twisted({{0.0, 0.5}, {0.0, 1.0}}, 1.0)));
  EXPECT_FALSE(is_of_twist(twisted(History::constant(), 200.0)));
  const auto pulled = [](JointTranslation translation, double mass) {
    return warnings_of([&](Scene& scene, SolverOptions& o) {
      o.time_step = 1e-3;
      o.steps = 1000;
      o.translation = translation;
      scene.loads.push_back({.force = {0.0, 0.0, 10.0}, .history = History::constant()});
      if (mass > 0.0) scene.masses.push_back({.mass = mass});
    });
  };
  // sqrt(210e9/7850)/4 m = 1293 Hz.
  const auto stretched = pulled(JointTranslation::Elastic, 0.0);
  ASSERT_FALSE(stretched.empty());
  EXPECT_NE(stretched[0].find("first frequency in stretching, about 1.29e+03 Hz"),
            std::string::npos)
      << stretched[0];
  EXPECT_EQ(pulled(JointTranslation::Rigid, 0.0), std::vector<std::string>{});
  // A mass beyond that of the bar makes a spring of it.
  EXPECT_FALSE(has(pulled(JointTranslation::Elastic, 10.0), "in stretching"));
}

TEST(MotionWarnings, SayWhatAFirstOrderSchemeTakes) {
  const auto warnings = warnings_of([](Scene&, SolverOptions& o) {
    o.scheme = Scheme::LinearlyImplicitEuler;
    o.time_step = 1e-4;
  });
  ASSERT_EQ(warnings.size(), 1U);
  // 1 - exp(-pi omega dt) with pi omega dt = 3.142 105.0 1e-4 = 0.03299.
  EXPECT_EQ(warnings[0],
            "solver.scheme = \"linearly_implicit_euler\" is of first order: it takes about 3.24 % "
            "of the amplitude in each period of the beam's first frequency in bending, about 16.7 "
            "Hz; \"linearly_implicit_midpoint\" costs the same");
}

TEST(MotionWarnings, SayThatGeneralizedAlphaMayGainEnergyWithoutDamping) {
  const auto warnings = [](double rho, Scheme scheme) {
    return warnings_of([&](Scene&, SolverOptions& o) {
      o.scheme = scheme;
      o.rho_infinity = rho;
    });
  };
  EXPECT_TRUE(has(warnings(1.0, Scheme::GeneralizedAlpha), "solver.rho_infinity = 1"));
  EXPECT_FALSE(has(warnings(0.99, Scheme::GeneralizedAlpha), "solver.rho_infinity"));
  EXPECT_FALSE(has(warnings(1.0, Scheme::EnergyMomentum), "solver.rho_infinity"));
}

TEST(MotionWarnings, SayThatARestitutionIsThatOfTheTouchedPoint) {
  const auto with = [](double restitution) {
    return warnings_of([=](Scene& scene, SolverOptions& /*options*/) {
      Support pillar;
      pillar.at = Place::end();
      pillar.kind = SupportKind::Pillar;
      pillar.gap = 0.01;
      pillar.restitution = restitution;
      scene.supports.push_back(pillar);
    });
  };
  EXPECT_TRUE(has(with(0.5), "support[2].restitution = 0.5 is that of the touched point"));
  EXPECT_FALSE(has(with(0.0), "touched point"));
}

TEST(MotionWarnings, KnowWhatImplicitEulerDoesToAVibration) {
  // The scheme itself on x'' = -omega^2 x, over a period of 600 steps.
  const double omega = 2.0 * pi * 16.71;  // of the slender cantilever
  const double step = 2.0 * pi / omega / 600.0;
  double x = 1.0;
  double v = 0.0;
  for (int i = 0; i < 600; ++i) {
    v = (v - step * omega * omega * x) / (1.0 + step * step * omega * omega);
    x += step * v;
  }
  const double lost = 100.0 * (1.0 - std::hypot(x, v / omega));
  char text[32];
  std::snprintf(text, sizeof text, "about %.2f %%", lost);
  EXPECT_TRUE(has(warnings_of([&](Scene&, SolverOptions& o) {
                    o.scheme = Scheme::LinearlyImplicitEuler;
                    o.time_step = step;
                    o.duration = 600.0 * step;  // else steps are shorter, from sample to sample
                    o.steps = 1;
                  }),
                  text))
      << text;
}

TEST(MotionWarnings, SayWhichSchemesRingAfterAnImpact) {
  const auto impact = [](Scheme scheme, const Change& change) {
    return warnings_of([&](Scene& s, SolverOptions& o) {
      s.supports.push_back({Place::end(), SupportKind::Pillar});
      o.scheme = scheme;
      o.rotary_inertia = RotaryInertia::Off;
      change(s, o);
    });
  };
  const auto as_it_is = [](Scene&, SolverOptions&) {};
  const auto warnings = impact(Scheme::EnergyMomentum, as_it_is);
  ASSERT_EQ(warnings.size(), 1U);
  // sqrt(48) 0.02/sqrt(12) sqrt(210e9/7850) 64^2/(2 pi) = 134.9 kHz.
  EXPECT_EQ(warnings[0],
            "solver.scheme = \"energy_momentum\" damps nothing: after an impact on a pillar the "
            "chain rings on at up to about 1.35e+05 Hz, which steps of 0.001 s do not follow; "
            "\"generalized_alpha\" or solver.damping takes that out");
  EXPECT_TRUE(has(impact(Scheme::LinearlyImplicitMidpoint, as_it_is), "rings on"));
  EXPECT_EQ(impact(Scheme::GeneralizedAlpha, as_it_is), std::vector<std::string>{});
  EXPECT_EQ(impact(Scheme::EnergyMomentum,
                   [](Scene&, SolverOptions& o) {
                     o.damping = Damping::Stiffness;
                     o.damping_time = 1e-4;
                   }),
            std::vector<std::string>{});
  EXPECT_EQ(warnings_of([](Scene&, SolverOptions& o) { o.scheme = Scheme::EnergyMomentum; }),
            std::vector<std::string>{});
  // Sections as deep as segments are long halve 1 + 12 I/(A l^2) = 2 of the square.
  EXPECT_TRUE(has(impact(Scheme::EnergyMomentum,
                         [](Scene& s, SolverOptions& o) {
                           s.beam.segments = 50;
                           o.rotary_inertia = RotaryInertia::On;
                         }),
                  "up to about 5.82e+04 Hz"));
}

/// A trapezoid is meant; a table of a curve is not.
TEST(MotionWarnings, SayThatASupportsSpeedJumpsAtEachRow) {
  const auto moved = [](const History& history) {
    return warnings_of([&](Scene& s, SolverOptions&) {
      s.supports[0].translation = {0.0, 0.01, 0.0};
      s.supports[0].history = history;
      s.yield_model = YieldModel::Elastic;
    });
  };
  std::vector<double> time, factor, line;
  for (int i = 0; i <= 20; ++i) {
    time.push_back(0.05 * i);
    factor.push_back(std::sin(2.0 * time.back()));
    line.push_back(2.0 * time.back());
  }
  const auto warnings = moved({time, factor});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0],
            "support[1] moves along straight lines, and its speed jumps 18 times: reactions have "
            "nothing of the force that these jumps take; interpolation = \"cubic\" in its history "
            "makes them smooth");
  EXPECT_EQ(moved(History::spline(time, factor)), std::vector<std::string>{});
  EXPECT_EQ(moved({time, line}), std::vector<std::string>{}) << "no jump";
  History cycles = History::turning_points({1, -1, 1, -1, 1, -1, 1, -1});
  for (double& at : cycles.time) at *= 0.1;
  EXPECT_EQ(moved(cycles), std::vector<std::string>{}) << "it turns back, as it is meant to";
  EXPECT_EQ(moved({{0.0, 0.1, 0.3, 0.6, 1.0}, {0.0, 0.0, 1.0, 1.0, 0.0}}),
            std::vector<std::string>{});
}

TEST(MotionWarnings, SayThatForcesOfSinglePrecisionAreNoisy) {
  const auto in = [](Precision precision, Scheme scheme, ProbeQuantity quantity) {
    return warnings_of([&](Scene& s, SolverOptions& o) {
      o.precision = precision;
      o.scheme = scheme;
      o.steps = 1000;
      s.probes.push_back({"f", quantity, Place::start()});
    });
  };
  const auto noisy = in(Precision::Float, Scheme::GeneralizedAlpha, ProbeQuantity::Reaction);
  EXPECT_TRUE(has(noisy, "solver.precision = \"float\": f may have noise of some "));
  for (const auto& quiet :
       {in(Precision::Double, Scheme::GeneralizedAlpha, ProbeQuantity::Reaction),
        in(Precision::Float, Scheme::ArticulatedMidpoint, ProbeQuantity::Reaction),
        in(Precision::Float, Scheme::GeneralizedAlpha, ProbeQuantity::Displacement)}) {
    EXPECT_FALSE(has(quiet, "noise of some"));
  }
}

/// Rounding of places over the square of the step, beside what acts.
TEST(MotionWarnings, SayThatForcesOfTheShortestStepsAreNoisy) {
  const auto at = [](double step, double force) {
    return warnings_of([&](Scene& s, SolverOptions& o) {
      o.time_step = step;
      o.duration = 100.0 * step;
      o.steps = 1;
      s.gravity = {};
      s.loads = {{}};
      s.loads[0].force = {0.0, force, 0.0};
      s.probes.push_back({"f", ProbeQuantity::Reaction, Place::start()});
    });
  };
  EXPECT_TRUE(has(at(1e-8, 10.0), "s: f may have noise of some "));
  EXPECT_FALSE(has(at(1e-5, 10.0), "noise of some"));
  EXPECT_FALSE(has(at(1e-8, 1e9), "noise of some"));
  // What began to move by itself is under no force that would be told.
  EXPECT_TRUE(has(at(1e-8, 0.0), "noise of some"));
  EXPECT_FALSE(has(at(1e-5, 0.0), "noise of some"));
}

TEST(MotionWarnings, KnowArticulatedEulerAndTheStepsThatAreTaken) {
  const auto lost = [](Scheme scheme, double step) {
    const auto warnings = warnings_of([&](Scene&, SolverOptions& o) {
      o.scheme = scheme;
      o.time_step = step;
      o.duration = 0.01;
      o.steps = 100;
    });
    for (const std::string& warning : warnings) {
      const auto at = warning.find("it takes about ");
      if (at != std::string::npos) return warning.substr(at);
    }
    return std::string();
  };
  const std::string whole = lost(Scheme::ArticulatedEuler, 1e-4);
  EXPECT_NE(whole.find("articulated_midpoint"), std::string::npos) << whole;
  // 0.1 ms from sample to sample takes two steps of 50 us, be they 60 or 99 us at most.
  const std::string half = lost(Scheme::LinearlyImplicitEuler, 5e-5);
  EXPECT_EQ(lost(Scheme::LinearlyImplicitEuler, 6e-5), half);
  EXPECT_EQ(lost(Scheme::LinearlyImplicitEuler, 9.9e-5), half);
  EXPECT_NE(lost(Scheme::LinearlyImplicitEuler, 1e-4), half);
}

TEST(MotionWarnings, SayThatARampOfGravityGrows) {
  const auto heavy = [](const History& history) {
    return warnings_of([&](Scene& s, SolverOptions& o) {
      s.gravity[1] = -9.81;
      s.gravity_history = history;
      o.duration = 3.0;
      o.steps = 300;
    });
  };
  const auto warnings = heavy(History::ramp());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0],
            "gravity follows a ramp: it grows by 9.81 m/s^2 in each second, to 29.4 m/s^2 at the "
            "end; history = \"constant\" has it from the first");
  EXPECT_EQ(heavy(History::constant()), std::vector<std::string>{});
}

TEST(MotionWarnings, SayThatTheFrequencyIsWithoutPointMasses) {
  const auto warnings = warnings_of([](Scene& s, SolverOptions& o) {
    s.masses.push_back({Place::end(), 1.0, {}});
    o.time_step = 0.01;
  });
  EXPECT_TRUE(has(warnings, " Hz without its point masses (below 20)"));
}

TEST(MotionWarnings, SayWhichCutNeverComes) {
  const auto cut = [](double time) {
    return warnings_of([&](Scene& s, SolverOptions&) { s.cuts.push_back({{0.5, {}}, time}); });
  };
  EXPECT_EQ(cut(0.99), std::vector<std::string>{});
  EXPECT_EQ(cut(1.0).size(), 1U);
  ASSERT_EQ(cut(1.5).size(), 1U);
  EXPECT_EQ(cut(1.5)[0], "cut[1] at 1.5 s never comes: the motion ends at 1 s");
}

TEST(MotionWarnings, CountAnInitialMotionAmongWhatBendsTheBeam) {
  EXPECT_TRUE(has(warnings_of([](Scene& s, SolverOptions&) {
                    s.yield_model = YieldModel::PerAxis;
                    s.initial_motions.push_back({.spin = {0.0, 1.0, 0.0}});
                  }),
                  "bending about both axes"));
}

}  // namespace
}  // namespace plastica
