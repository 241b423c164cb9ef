// Beams in motion: elastic, yielding and breaking, in a plane and in space.

#include <cmath>
#include <numbers>

#include "plastica/theory/beam_vibration.hpp"
#include "tests/studies/corpus_parts.hpp"
#include "tests/studies/corpus_text.hpp"

namespace plastica::studies {
namespace {

constexpr const char* kMovingPlane = "motion, elastic, plane";
constexpr const char* kMovingSpace = "motion, elastic, space";
constexpr const char* kMovingYield = "motion, yielding";
constexpr const char* kMovingBreak = "motion, breaking";

/// Soft enough that a metre of it swings once in a quarter of a second.
const CorpusMetal kPlastic{.youngs_modulus = 2e9, .density = 1200.0, .more = ""};
constexpr double kRodSide = 0.02;

std::string rod(const CorpusMetal& of, std::string_view more = "") {
  return metal(of) + beam(1.0, rectangle(kRodSide, kRodSide), more);
}

std::string elastic_rod(std::string_view more = "") {
  return rod(kPlastic, more) + rules("elastic");
}

std::string gravity(double y) {
  return fmt::format("[gravity]\ny = \"{} m/s^2\"\nhistory = \"constant\"\n\n", y);
}

/// Let go from straight, under a gravity that bends it little: Euler and Bernoulli's beam.
CorpusScene released_little() {
  const theory::VibratingBeam of{1.0, kPlastic.youngs_modulus * std::pow(kRodSide, 4) / 12.0,
                                 kPlastic.density * kRodSide * kRodSide};
  const double duration = 0.5;
  return corpus_scene(
      "released_little", kMovingPlane,
      elastic_rod() + clamp() + gravity(-0.5) +
          in_motion(duration, 50, "rotary_inertia = \"off\"\n") + tip(),
      ClosedForm{"tip", theory::released_cantilever_tip(of, -0.5, duration, 20), 3e-3});
}

CorpusScene released(double y) {
  return corpus_scene(fmt::format("released_{:g}", -y), kMovingPlane,
                      elastic_rod() + clamp() + gravity(y) + in_motion(0.6, 60) + tip());
}

/// A clamp that turns smoothly, as an arm does, with a body at its end.
CorpusScene turned(double degrees, double time, double mass) {
  return corpus_scene(
      fmt::format("turned_{:g}_in_{:g}", degrees, time), kMovingPlane,
      elastic_rod() + in_motion(0.5, 50) +
          support(kStart, "clamp",
                  fmt::format("rotation = [\"{} deg\", \"0 deg\", \"0 deg\"]\nhistory = {{ "
                              "smooth_step = [\"0 s\", \"{} s\"] }}\n",
                              degrees, time)) +
          fmt::format("[[mass]]\nat = \"end\"\nmass = \"{} kg\"\n\n", mass) + tip());
}

std::vector<CorpusScene> moving_in_a_plane() {
  const std::string sine = "history = { period = \"300 ms\", cycles = 3 }\n";
  const std::string smooth = "history = { smooth_step = [\"0 s\", \"100 ms\"] }\n";
  const std::string body = "[[mass]]\nat = \"end\"\nmass = \"0.5 kg\"\n\n";
  return {
      released_little(),
      released(-9.81),
      released(-30.0),
      turned(30.0, 0.1, 0.1),
      turned(90.0, 0.2, 0.2),
      corpus_scene("sine_at_tip", kMovingPlane,
                   elastic_rod() + clamp() + in_motion(0.6, 60) + force(kEnd, 0.0, 1.0, 0.0, sine) +
                       tip() + probe("root", "moment", kStart, "x")),
      corpus_scene("smooth_step_damped", kMovingPlane,
                   elastic_rod() + clamp() +
                       in_motion(0.6, 60, "damping = \"stiffness\"\ndamping_time = \"5 ms\"\n") +
                       force(kEnd, 0.0, 3.0, 0.0, smooth) + tip()),
      corpus_scene("body_thrown", kMovingPlane,
                   elastic_rod() + clamp() + body + in_motion(0.6, 60) +
                       "[[initial_motion]]\nfrom = 0.9\nvelocity = [\"0 m/s\", \"1 m/s\", \"0 "
                       "m/s\"]\n\n" +
                       tip()),
      corpus_scene("base_shaken", kMovingPlane,
                   elastic_rod() +
                       support(kStart, "clamp",
                               "translation = [\"0 m\", \"0.02 m\", \"0 m\"]\nhistory = { "
                               "smooth_step = [\"0 s\", \"150 ms\"] }\n") +
                       in_motion(0.6, 60) + tip()),
      corpus_scene("pendulum", kMovingPlane,
                   metal({.youngs_modulus = 5e7, .density = 1200.0}) +
                       beam(1.0, rectangle(kRodSide, kRodSide)) + rules("elastic") +
                       support(kStart, "pin") + gravity(-9.81) + in_motion(0.5, 50) + tip()),
      corpus_scene("flying", kMovingPlane,
                   elastic_rod() + in_motion(0.3, 60) +
                       "[[initial_motion]]\nfrom = 0.5\nvelocity = [\"0 m/s\", \"2 m/s\", \"0 "
                       "m/s\"]\n\n" +
                       tip()),
      corpus_scene(
          "simply_held_struck", kMovingPlane,
          elastic_rod() + support(kStart, "pin") + support(kEnd, "roller") + in_motion(0.3, 60) +
              force("0.5", 0.0, 10.0, 0.0, "history = { period = \"100 ms\", cycles = 0.5 }\n") +
              probe("middle", "displacement", "0.5", "y")),
      corpus_scene("within_sine", kMovingPlane,
                   elastic_rod() + clamp() + in_motion(0.6, 60) +
                       force("0.63", 0.0, 1.0, 0.0, sine) +
                       probe("at_37", "displacement", "0.37", "y") + tip()),
  };
}

std::vector<CorpusScene> moving_in_space() {
  const std::string flat = metal(kPlastic) + beam(1.0, rectangle(0.03, 0.015)) + rules("elastic");
  return {
      corpus_scene("released_skew", kMovingSpace,
                   flat + clamp() +
                       "[gravity]\nx = \"-5 m/s^2\"\ny = \"-5 m/s^2\"\nhistory = \"constant\"\n\n" +
                       in_motion(0.5, 50) + tip() + probe("tip_x", "displacement", kEnd, "x")),
      corpus_scene("bow_released", kMovingSpace,
                   elastic_rod("shape = \"arc\"\narc_angle = \"90 deg\"\narc_towards = \"y\"\n") +
                       clamp() + "[gravity]\nx = \"-9.81 m/s^2\"\nhistory = \"constant\"\n\n" +
                       in_motion(0.5, 50) + tip("x")),
      corpus_scene("turned_about_two_axes", kMovingSpace,
                   flat + in_motion(0.5, 50) +
                       support(kStart, "clamp",
                               "rotation = [\"40 deg\", \"0 deg\", \"40 deg\"]\nhistory = { "
                               "smooth_step = [\"0 s\", \"200 ms\"] }\n") +
                       tip() + probe("tip_x", "displacement", kEnd, "x")),
      corpus_scene(
          "circling_force", kMovingSpace,
          flat + clamp() + in_motion(0.5, 50) +
              force(kEnd, 0.0, 1.0, 0.0, "history = { period = \"250 ms\", cycles = 2 }\n") +
              force(kEnd, 2.0, 0.0, 0.0,
                    "history = { period = \"250 ms\", cycles = 2, phase = \"90 deg\", "
                    "offset = -1 }\n") +
              tip() + probe("tip_x", "displacement", kEnd, "x")),
  };
}

/// A bar of steel that is thrown with a body at its end, and yields.
CorpusScene thrown(const std::string& name, const std::string& how, double speed,
                   const std::string& of_metal) {
  const CorpusMetal steel{.more = of_metal};
  return corpus_scene(
      name, kMovingYield,
      metal(steel) + beam(0.5, rectangle(0.01, 0.01)) + how + clamp() +
          "[[mass]]\nat = \"end\"\nmass = \"1 kg\"\n\n" +
          fmt::format("[[initial_motion]]\nfrom = 0.9\nvelocity = [\"0 m/s\", \"{} m/s\", \"0 "
                      "m/s\"]\n\n",
                      speed) +
          in_motion(0.2, 50) + tip());
}

std::vector<CorpusScene> moving_yields() {
  const std::string linear = "hardening = { law = \"linear\", tangent_modulus = \"5 GPa\" }\n";
  const std::string full = rules("interaction", "yield_cap = \"fully_plastic\"\n");
  const std::string half_sine = "history = { period = \"80 ms\", cycles = 0.5 }\n";
  const double m = CorpusMetal{}.yield_stress * std::pow(0.02, 3) / 6.0;
  return {
      thrown("thrown_ideal", full, 4.0, ""),
      thrown("thrown_hardening", full, 6.0, linear),
      thrown("thrown_fibres", rules("fibre"), 5.0, linear),
      corpus_scene("struck_over_yield", kMovingYield,
                   metal({.more = linear}) + beam(0.5, rectangle(0.02, 0.02)) + rules("fibre") +
                       clamp() + in_motion(0.06, 60) +
                       force(kEnd, 0.0, 1.2 * m / 0.5, 0.0, half_sine) + tip()),
      corpus_scene("struck_skew_over_yield", kMovingYield,
                   metal({.more = linear}) + beam(0.5, rectangle(0.02, 0.02)) +
                       rules("interaction") + clamp() + in_motion(0.06, 60) +
                       force(kEnd, 0.7 * m / 0.5, 0.8 * m / 0.5, 0.0, half_sine) + tip() +
                       probe("tip_x", "displacement", kEnd, "x")),
  };
}

std::vector<CorpusScene> moving_breaks() {
  const std::string brittle =
      "break_strain = 0.01\nhardening = { law = \"linear\", tangent_modulus = \"5 GPa\" }\n";
  const std::string full = rules("interaction", "yield_cap = \"fully_plastic\"\n");
  const std::string pulse = "history = { period = \"40 ms\", cycles = 0.5 }\n";
  const double m = CorpusMetal{}.yield_stress * std::pow(0.02, 3) / 6.0;
  return {
      corpus_scene("broken_by_a_body", kMovingBreak,
                   metal({.more = brittle}) + beam(0.5, rectangle(0.01, 0.01)) + full + clamp() +
                       "[[mass]]\nat = \"end\"\nmass = \"1 kg\"\n\n" +
                       "[[initial_motion]]\nfrom = 0.9\nvelocity = [\"0 m/s\", \"10 m/s\", \"0 "
                       "m/s\"]\n\n" +
                       in_motion(0.03, 30) + tip()),
      corpus_scene("broken_by_a_pulse", kMovingBreak,
                   metal({.more = brittle}) + beam(0.5, rectangle(0.02, 0.02)) + full + clamp() +
                       in_motion(0.02, 20) + force(kEnd, 0.0, 4.0 * m / 0.5, 0.0, pulse) + tip()),
      corpus_scene("cut_in_flight", kMovingBreak,
                   elastic_rod() + clamp() + gravity(-9.81) + in_motion(0.3, 60) +
                       "[[cut]]\nat = 0.5\ntime = \"100 ms\"\n\n" + tip()),
  };
}

}  // namespace

std::vector<CorpusScene> scenes_in_motion() {
  std::vector<CorpusScene> all;
  for (const auto& part :
       {moving_in_a_plane(), moving_in_space(), moving_yields(), moving_breaks()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace plastica::studies
