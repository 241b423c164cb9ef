// Elastic beams at rest; each in a plane or in space.

#include <cmath>
#include <numbers>

#include "plastica/theory/beam_cases.hpp"
#include "plastica/theory/elastica.hpp"
#include "tests/studies/corpus_parts.hpp"
#include "tests/studies/corpus_text.hpp"

namespace plastica::studies {
namespace {

constexpr const char* kPlane = "rest, elastic, plane";
constexpr const char* kSpace = "rest, elastic, space";

/// All of these have a square section of 10 mm and are a metre long: a hundred times their depth,
/// so that shear and thrust, which most closed forms leave out, do 1e-4 of the whole.
constexpr double kSide = 0.01;
const CorpusMetal kMetal;
const double kStiffness = kMetal.youngs_modulus * std::pow(kSide, 4) / 12.0;  // E I

std::string slender(std::string_view more = "") {
  return metal(kMetal) + beam(1.0, rectangle(kSide, kSide), more) + rules("elastic");
}

std::string clamped() { return slender() + support(kStart, "clamp"); }

/// Deflections of a hundredth of the length: theirs of second order are 1e-4 of the whole.
constexpr double kSmall = 0.01;

CorpusScene tip_force(double load) {
  const double force_size = load * kStiffness;  // P L^2/(E I) = load
  const theory::ElasticaTip truth = theory::elastica_tip_force(load);
  return corpus_scene(fmt::format("cantilever_force_{:g}", load), kPlane,
                      clamped() + at_rest(10) + force(kEnd, 0.0, force_size, 0.0) + tip(),
                      ClosedForm{"tip", truth.deflection, 3e-4});
}

CorpusScene tip_moment(double angle) {
  const theory::ElasticaTip truth = theory::elastica_tip_moment(angle);
  return corpus_scene(
      fmt::format("cantilever_moment_{:.3g}", angle), kPlane,
      clamped() + at_rest(20) + moment(kEnd, -angle * kStiffness, 0.0, 0.0) + tip(),
      // The circle closes: there the tip is at its root, and no error is over that.
      angle < 6.0 ? std::optional(ClosedForm{"tip", truth.deflection, 3e-4}) : std::nullopt);
}

/// Small deflections of a beam whose ends may come closer.
/// @param off  what shear and second order do [1]
CorpusScene small(const std::string& name, const theory::BeamCase& of, double at,
                  double off = 1e-3) {
  const bool start_clamped = of.ends != theory::BeamEnds::PinnedPinned;
  std::string text = slender() + support(kStart, start_clamped ? "clamp" : "pin");
  if (of.ends == theory::BeamEnds::ClampedClamped) {
    text += support(kEnd, "roller", "hold = [\"y\", \"rx\"]\n");
  } else if (of.ends != theory::BeamEnds::ClampedFree) {
    text += support(kEnd, "roller");
  }
  if (of.load.force != 0.0) {
    text += force(fmt::format("{:.4f}", of.load.position), 0.0, of.load.force, 0.0);
  }
  if (of.load.distributed != 0.0) text += even_load(of.load.distributed);
  text += at_rest(1) + probe("middle", "displacement", fmt::format("{:.4f}", at), "y");
  return corpus_scene(name, kPlane, text,
                      ClosedForm{"middle", theory::beam_deflection(of, at), off});
}

std::vector<CorpusScene> small_deflections() {
  using theory::BeamEnds;
  const double p = 48.0 * kStiffness * kSmall;
  const double q = 76.8 * kStiffness * kSmall;
  return {
      small("cantilever_even_load",
            {BeamEnds::ClampedFree, 1.0, kStiffness, {.distributed = 0.1 * q}}, 1.0),
      small("beam_force_middle",
            {BeamEnds::PinnedPinned, 1.0, kStiffness, {.position = 0.5, .force = p}}, 0.5),
      small("beam_even_load", {BeamEnds::PinnedPinned, 1.0, kStiffness, {.distributed = q}}, 0.5),
      small("propped_force",
            {BeamEnds::ClampedPinned, 1.0, kStiffness, {.position = 0.3, .force = p}}, 0.5),
      small("propped_even_load", {BeamEnds::ClampedPinned, 1.0, kStiffness, {.distributed = q}},
            0.6),
      small("clamped_even_load", {BeamEnds::ClampedClamped, 1.0, kStiffness, {.distributed = q}},
            0.5),
  };
}

/// Loads and probes that no division into few segments has at an end or a middle; with some, both
/// are in one segment. Near a clamp, with moment M and shear force V there, bending is
/// (M x^2/2 - V x^3/6)/(E I), shear V x/(k G A), here 0.62 % of it at 0.12 and 0.22 % at 0.13.
std::vector<CorpusScene> within_segments() {
  using theory::BeamEnds;
  const double p = 48.0 * kStiffness * kSmall;
  const auto of = [&](BeamEnds ends, double at) {
    return theory::BeamCase{ends, 1.0, kStiffness, {.position = at, .force = p}};
  };
  return {
      small("within_cantilever", of(BeamEnds::ClampedFree, 0.63), 0.37),
      small("within_propped", of(BeamEnds::ClampedPinned, 0.13), 0.12, 7e-3),
      small("within_propped_apart", of(BeamEnds::ClampedPinned, 0.71), 0.29, 2e-3),
      small("within_pinned", of(BeamEnds::PinnedPinned, 0.37), 0.41),
      small("within_clamped", of(BeamEnds::ClampedClamped, 0.41), 0.13, 3e-3),
  };
}

/// A column whose buckling load is `factor` times pi^2 E I/L^2, loaded by half of that.
CorpusScene column(const std::string& name, const std::string& supports, double factor) {
  const double euler = factor * std::numbers::pi * std::numbers::pi * kStiffness;
  return corpus_scene(name, kPlane,
                      slender() + supports + at_rest(1, "buckling = 1\nlevel = \"planar\"\n") +
                          force(kEnd, 0.0, 0.0, -0.5 * euler) + tip("z"),
                      // A column of this slenderness shortens by 8e-5 of its length until then.
                      ClosedForm{"buckling factor 1", 2.0, 1e-3});
}

std::vector<CorpusScene> columns() {
  // tan x = x: the buckling load of a column that is clamped and held at its end.
  const double propped = 4.493409457909064 / std::numbers::pi;
  return {column("column_free", support(kStart, "clamp"), 0.25),
          column("column_pinned", support(kStart, "pin") + support(kEnd, "roller"), 1.0),
          column("column_propped", support(kStart, "clamp") + support(kEnd, "roller"),
                 propped * propped)};
}

std::vector<CorpusScene> other_plane_scenes() {
  const std::string clamp = support(kStart, "clamp");
  return {
      corpus_scene("arch_tip_force", kPlane,
                   slender("shape = \"arc\"\narc_angle = \"90 deg\"\narc_towards = \"y\"\n") +
                       clamp + at_rest(4) + force(kEnd, 0.0, -3.0 * kStiffness, 0.0) + tip()),
      corpus_scene(
          "frame_corner", kPlane,
          metal(kMetal) + "[beam]\nshape = \"polyline\"\nsection = { " + rectangle(kSide, kSide) +
              " }\nsegments = 32\npoints = [[\"0 m\", \"0 m\", \"0 m\"], [\"0 m\", \"0 m\", "
              "\"0.6 m\"], [\"0 m\", \"0.4 m\", \"0.6 m\"]]\n\n" +
              rules("elastic") + clamp + at_rest(4) + force(kEnd, 0.0, 0.0, 2.0 * kStiffness) +
              tip("z")),
      corpus_scene("taper", kPlane,
                   slender() + clamp +
                       "[[region]]\nfrom = 0.0\nto = 1.0\nsection = { height = \"15 mm\" }\n"
                       "to_section = { height = \"6 mm\" }\n\n" +
                       at_rest(2) + force(kEnd, 0.0, kStiffness, 0.0) + tip()),
      corpus_scene("foundation", kPlane,
                   slender() + support(kStart, "pin") +
                       "[[support]]\nfrom = \"start\"\nto = \"end\"\nkind = \"elastic\"\n"
                       "stiffness = [\"0 Pa\", \"20 kPa\", \"0 Pa\"]\n\n" +
                       at_rest(1) + force("0.25", 0.0, -20.0, 0.0) +
                       probe("sag", "displacement", "0.25", "y") +
                       probe("tip", "displacement", kEnd, "y")),
      corpus_scene("follower_force", kPlane,
                   clamped() + at_rest(10) +
                       force(kEnd, 0.0, 4.0 * kStiffness, 0.0, "follows = true\n") + tip()),
      corpus_scene("own_weight_large", kPlane,
                   metal({.youngs_modulus = 2e8}) + beam(1.0, rectangle(kSide, kSide)) +
                       rules("elastic") + support(kStart, "clamp") + at_rest(4) +
                       "[gravity]\ny = \"-9.81 m/s^2\"\n\n" + tip()),
      corpus_scene("stocky_cantilever", kPlane,
                   metal(kMetal) + beam(0.5, rectangle(0.1, 0.1)) + rules("elastic") +
                       support(kStart, "clamp") + at_rest(1) + force(kEnd, 0.0, 1e5, 0.0) + tip() +
                       probe("root", "moment", kStart, "x")),
  };
}

CorpusScene bow_across(int degrees) {
  return corpus_scene(fmt::format("bow_{}_across", degrees), kSpace,
                      slender(fmt::format("shape = \"arc\"\narc_angle = \"{} deg\"\n"
                                          "arc_towards = \"y\"\n",
                                          degrees)) +
                          support(kStart, "clamp") + at_rest(5) +
                          force(kEnd, 4.0 * kStiffness, 0.0, 0.0) + tip("x") +
                          probe("tip_in_plane", "displacement", kEnd, "y"));
}

std::vector<CorpusScene> space_scenes() {
  const std::string clamp = support(kStart, "clamp");
  // Twice as wide as high: E I about x, and four times that about y.
  const std::string flat =
      metal(kMetal) + beam(1.0, rectangle(0.02, 0.01)) + rules("elastic") + clamp;
  const double weak = 2.0 * kStiffness;
  const double round = kMetal.youngs_modulus * std::numbers::pi * std::pow(0.01, 4) / 4.0;
  const double twist = kMetal.shear_modulus() * std::numbers::pi * std::pow(0.01, 4) / 2.0;  // G J
  const std::string bar = metal(kMetal) + beam(1.0, circle(0.01)) + rules("elastic") + clamp;
  return {
      corpus_scene("bar_twisted", kSpace,
                   bar + at_rest(1, "level = \"spatial\"\n") + moment(kEnd, 0.0, 0.0, 0.3 * twist) +
                       probe("tip", "rotation", kEnd, "z"),
                   ClosedForm{"tip", 0.3, 1e-6}),
      corpus_scene("skew_force_small", kSpace,
                   flat + at_rest(1) +
                       force(kEnd, 3.0 * 4.0 * weak * kSmall, 3.0 * weak * kSmall, 0.0) + tip() +
                       probe("tip_x", "displacement", kEnd, "x"),
                   ClosedForm{"tip", kSmall, 1e-3}),
      corpus_scene("skew_force_large", kSpace,
                   flat + at_rest(10) + force(kEnd, 4.0 * weak, 2.0 * weak, 0.0) + tip() +
                       probe("tip_x", "displacement", kEnd, "x")),
      corpus_scene("skew_moment_round", kSpace,
                   bar + at_rest(20) + moment(kEnd, -round, round, 0.0) + tip(),
                   // A round section bends about any axis alike: an arc in the plane at 45 degrees.
                   ClosedForm{"tip",
                              theory::elastica_tip_moment(std::numbers::sqrt2).deflection /
                                  std::numbers::sqrt2,
                              1e-3}),
      corpus_scene("bent_and_twisted", kSpace,
                   flat + at_rest(10) + force(kEnd, 0.0, 2.0 * weak, 0.0) +
                       moment(kEnd, 0.0, 0.0, weak) + tip() +
                       probe("tip_x", "displacement", kEnd, "x")),
      bow_across(45),
      bow_across(90),
      corpus_scene(
          "frame_in_space", kSpace,
          metal(kMetal) + "[beam]\nshape = \"polyline\"\nsection = { " + rectangle(kSide, kSide) +
              " }\nsegments = 30\npoints = [[\"0 m\", \"0 m\", \"0 m\"], [\"0 m\", \"0 m\", "
              "\"0.5 m\"], [\"0 m\", \"0.4 m\", \"0.5 m\"], [\"0.3 m\", \"0.4 m\", \"0.5 "
              "m\"]]\n\n" +
              rules("elastic") + clamp + at_rest(4) + force(kEnd, 0.0, 0.0, 2.0 * kStiffness) +
              tip("z")),
  };
}

}  // namespace

std::vector<CorpusScene> elastic_scenes_at_rest() {
  std::vector<CorpusScene> all;
  for (const double load : {0.01, 1.0, 2.0, 5.0, 10.0}) all.push_back(tip_force(load));
  for (const double angle : {0.5 * std::numbers::pi, 2.0 * std::numbers::pi}) {
    all.push_back(tip_moment(angle));
  }
  for (const auto& part :
       {small_deflections(), within_segments(), columns(), other_plane_scenes(), space_scenes()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace plastica::studies
