// Beams at rest that yield, and that break; each in a plane or in space.

#include <cmath>
#include <numbers>

#include "plastica/theory/cantilever.hpp"
#include "plastica/theory/limit_load.hpp"
#include "tests/studies/corpus_parts.hpp"
#include "tests/studies/corpus_text.hpp"

namespace plastica::studies {
namespace {

constexpr const char* kYieldPlane = "rest, yielding, plane";
constexpr const char* kYieldSpace = "rest, yielding, space";
constexpr const char* kBreak = "rest, breaking";

const CorpusMetal kBarMetal;
constexpr double kBarSide = 0.02;
const double kFirstYield = kBarMetal.yield_stress * std::pow(kBarSide, 3) / 6.0;  // M_y
const double kFull = 1.5 * kFirstYield;                                           // M_p

std::string square(double length, const CorpusMetal& of = kBarMetal) {
  return metal(of) + beam(length, rectangle(kBarSide, kBarSide));
}

/// Loaded over first yield and unloaded: what stays is known for small deflections. The beam is
/// ten times as long as deep, bent by a hundredth of its length.
CorpusScene loaded_and_unloaded(double ratio) {
  const double length = 0.2;
  const double yield_force = kFirstYield / length;
  const double yield_tip = kFirstYield * length * length /
                           (3.0 * kBarMetal.youngs_modulus * std::pow(kBarSide, 4) / 12.0);
  return corpus_scene(
      fmt::format("cantilever_to_{:g}_and_off", ratio), kYieldPlane,
      square(length) + rules("fibre") + at_rest(20) + clamp() +
          force(kEnd, 0.0, ratio * yield_force, 0.0, "history = { turning_points = [1, 0] }\n") +
          tip(),
      // Of the residual tip, the rotations leave out what they do at 50 times the depth, 3 %
      // (0.5409 and 0.5247 mm there), times the square of a fifth of the length.
      ClosedForm{"tip", theory::residual_tip_ratio(ratio) * yield_tip, 3e-3});
}

/// What the loads of the next scenes are of those at which mechanisms form. Beyond, the curve is
/// flat at first and then rises, as the ends come closer: whether a path passes that is chance.
constexpr double kNearly = 0.97;

CorpusScene limit(const std::string& name, const std::string& held, const std::string& loads) {
  return corpus_scene(name, kYieldPlane,
                      square(1.0) + rules("interaction", "yield_cap = \"fully_plastic\"\n") +
                          at_rest(30) + held + loads + probe("middle", "displacement", "0.5", "y"));
}

std::vector<CorpusScene> limits() {
  const std::string roller = support(kEnd, "roller");
  return {
      limit("nearly_limit_pinned_force", support(kStart, "pin") + roller,
            force("0.5", 0.0,
                  kNearly * theory::limit_force(theory::BeamEnds::PinnedPinned, kFull, 1.0, 0.5),
                  0.0)),
      limit("nearly_limit_propped_force", clamp() + roller,
            force("0.5", 0.0,
                  kNearly * theory::limit_force(theory::BeamEnds::ClampedPinned, kFull, 1.0, 0.5),
                  0.0)),
      limit("nearly_limit_propped_even_load", clamp() + roller,
            even_load(kNearly *
                      theory::limit_distributed(theory::BeamEnds::ClampedPinned, kFull, 1.0))),
  };
}

std::vector<CorpusScene> hardening() {
  const CorpusMetal linear{.more =
                               "hardening = { law = \"linear\", tangent_modulus = \"5 GPa\" }\n"};
  const CorpusMetal voce{
      .more =
          "hardening = { law = \"voce_chaboche\", saturation_stress = \"100 MPa\", "
          "saturation_rate = 20, backstress_modulus_1 = \"20 GPa\", backstress_rate_1 = 200 }\n"};
  const auto driven = [](double way, const std::string& history) {
    return support(kEnd, "roller",
                   fmt::format("hold = [\"y\"]\ntranslation = [\"0 m\", \"{} m\", \"0 m\"]\n{}\n",
                               way, history)) +
           probe("force", "reaction", kEnd, "y");
  };
  return {
      corpus_scene("linear_hardening_force", kYieldPlane,
                   square(0.4, linear) + rules("fibre") + at_rest(20) + clamp() +
                       force(kEnd, 0.0, 1.7 * kFirstYield / 0.4, 0.0) + tip()),
      corpus_scene("linear_hardening_driven", kYieldPlane,
                   square(0.4, linear) + rules("fibre") + at_rest(30) + clamp() + driven(0.06, "")),
      corpus_scene("voce_driven", kYieldPlane,
                   square(0.4, voce) + rules("fibre") + at_rest(30) + clamp() + driven(0.04, "")),
      corpus_scene("voce_cycle", kYieldPlane,
                   square(0.4, voce) + rules("fibre") + at_rest(60) + clamp() +
                       driven(0.02, "history = { turning_points = [1, -1, 1] }\n")),
      corpus_scene(
          "moment_law_driven", kYieldPlane,
          square(0.4, linear) + rules("interaction") + at_rest(30) + clamp() + driven(0.05, "")),
      corpus_scene("three_point_yielding", kYieldPlane,
                   square(0.6, linear) + rules("fibre") + at_rest(20) + support(kStart, "pin") +
                       support(kEnd, "roller") +
                       force("0.5", 0.0, 1.8 * 4.0 * kFirstYield / 0.6, 0.0) +
                       probe("middle", "displacement", "0.5", "y")),
      corpus_scene("within_three_point_yielding", kYieldPlane,
                   square(0.6, linear) + rules("fibre") + at_rest(20) + support(kStart, "pin") +
                       support(kEnd, "roller") +
                       force("0.37", 0.0, 1.8 * kFirstYield / (0.6 * 0.37 * 0.63), 0.0) +
                       probe("at_41", "displacement", "0.41", "y")),
  };
}

std::vector<CorpusScene> in_space() {
  const CorpusMetal linear{.more =
                               "hardening = { law = \"linear\", tangent_modulus = \"10 GPa\" }\n"};
  const double m = kFirstYield;
  const std::string to_and_fro = "history = { turning_points = [1, 0] }\n";
  return {
      corpus_scene("bent_and_twisted_over_yield", kYieldSpace,
                   square(0.4, linear) + rules("interaction") + at_rest(20) + clamp() +
                       force(kEnd, 0.0, 1.1 * m / 0.4, 0.0, to_and_fro) +
                       moment(kEnd, 0.0, 0.0, 0.5 * m, to_and_fro) + tip() +
                       probe("twist", "rotation", kEnd, "z")),
      corpus_scene("skew_over_yield", kYieldSpace,
                   square(0.4, linear) + rules("interaction") + at_rest(20) + clamp() +
                       force(kEnd, 0.6 * m / 0.4, m / 0.4, 0.0) + tip() +
                       probe("tip_x", "displacement", kEnd, "x")),
      corpus_scene("skew_per_axis", kYieldSpace,
                   square(0.4, linear) + rules("per_axis") + at_rest(20) + clamp() +
                       force(kEnd, 1.2 * m / 0.4, 1.3 * m / 0.4, 0.0) + tip() +
                       probe("tip_x", "displacement", kEnd, "x")),
      corpus_scene("bow_over_yield", kYieldSpace,
                   metal(linear) +
                       beam(0.5, rectangle(kBarSide, kBarSide),
                            "shape = \"arc\"\narc_angle = \"60 deg\"\narc_towards = \"y\"\n") +
                       rules("interaction") + at_rest(20) + clamp() +
                       force(kEnd, 1.3 * m / 0.5, 0.0, 0.0) + tip("x")),
  };
}

/// Bent by its end until it breaks.
CorpusScene broken(const std::string& name, double strain, const std::string& more_rules,
                   double way) {
  const CorpusMetal of{.more = fmt::format("break_strain = {}\n"
                                           "hardening = {{ law = \"linear\", tangent_modulus = "
                                           "\"2 GPa\" }}\n",
                                           strain)};
  return corpus_scene(
      name, kBreak,
      square(0.5, of) + rules("interaction", "yield_cap = \"fully_plastic\"\n" + more_rules) +
          at_rest(60) + clamp() +
          support(
              kEnd, "roller",
              fmt::format("hold = [\"y\"]\ntranslation = [\"0 m\", \"{} m\", \"0 m\"]\n", way)) +
          probe("force", "reaction", kEnd, "y"));
}

std::vector<CorpusScene> breaking() {
  const double m = kFirstYield;
  const CorpusMetal brittle{.more =
                                "break_strain = 0.01\nbreak_shear_strain = 0.01\n"
                                "hardening = { law = \"linear\", tangent_modulus = \"5 GPa\" }\n"};
  return {
      broken("broken_at_2_percent", 0.02, "", 0.2),
      broken("broken_at_5_percent", 0.05, "", 0.35),
      broken("broken_by_its_longer_hinge", 0.02, "hinge_length = \"40 mm\"\n", 0.25),
      corpus_scene("broken_three_point", kBreak,
                   square(0.6, brittle) + rules("interaction", "yield_cap = \"fully_plastic\"\n") +
                       at_rest(60) + support(kStart, "pin") + support(kEnd, "roller") +
                       support("0.5", "roller",
                               "hold = [\"y\"]\ntranslation = [\"0 m\", \"-0.08 m\", \"0 m\"]\n") +
                       probe("force", "reaction", "0.5", "y")),
      corpus_scene("broken_by_twist", kBreak,
                   square(0.5, brittle) + rules("per_axis") + at_rest(60) + clamp() +
                       support(kEnd, "guide",
                               "hold = [\"rz\"]\nrotation = [\"0 rad\", \"0 rad\", \"2 rad\"]\n") +
                       probe("twist", "rotation", "0.5", "z")),
      corpus_scene("broken_at_a_weak_part", kBreak,
                   square(0.5, brittle) +
                       "[[region]]\nfrom = 0.4\nto = 0.6\nsection = { height = \"12 mm\" }\n\n" +
                       rules("interaction", "yield_cap = \"fully_plastic\"\n") + at_rest(60) +
                       clamp() + moment(kEnd, -1.2 * m, 0.0, 0.0) + tip()),
  };
}

}  // namespace

std::vector<CorpusScene> yielding_scenes_at_rest() {
  std::vector<CorpusScene> all;
  for (const double ratio : {1.1, 1.2, 1.4}) all.push_back(loaded_and_unloaded(ratio));
  for (const auto& part : {limits(), hardening(), in_space(), breaking()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace plastica::studies
