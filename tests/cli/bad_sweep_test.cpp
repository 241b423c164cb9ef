#include "tests/cli/bad_input.hpp"

namespace plastica::testing {
namespace {

const std::string kScene =
    "[beam]\nlength = '4 m'\nsegments = 8\n"
    "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
    "[[support]]\nat = 'start'\nkind = 'clamp'\n"
    "[[load]]\nat = 'end'\nforce = ['0 N', '-100 N', '0 N']\nhistory = 'ramp'\n"
    "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\n";

const std::string kSweep =
    "scene = 'scene.toml'\n"         // 1
    "[[axis]]\n"                     // 2
    "field = 'beam.segments'\n"      // 3
    "values = [4, 8, 16]\n"          // 4
    "[error]\n"                      // 5
    "probe = 'tip'\n"                // 6
    "against = 'theory:elastica'\n"  // 7
    ;

const std::string kCheck =
    "[[claim]]\n"                    // 1
    "name = 'order'\n"               // 2
    "sweep = 'sweep.toml'\n"         // 3
    "order = { at_least = 1.9 }\n";  // 4

/// What `sweep` answers to a file.
BadInput sweep(std::string name, const std::string& from, const std::string& to, std::string line,
               std::map<std::string, std::string> files = {}) {
  files.emplace("scene.toml", kScene);
  files.emplace("sweep.toml", changed(kSweep, from, to));
  return {
      std::move(name), std::move(files), {"sweep", "sweep.toml", "-o", "out.h5"}, std::move(line)};
}

BadInput check(std::string name, const std::string& from, const std::string& to, std::string line) {
  return {
      std::move(name),
      {{"scene.toml", kScene}, {"sweep.toml", kSweep}, {"check.toml", changed(kCheck, from, to)}},
      {"check", "check.toml"},
      std::move(line)};
}

/// What the command answers to other arguments than file and output.
BadInput called(std::string name, std::vector<std::string> arguments, std::string line) {
  return {std::move(name),
          {{"scene.toml", kScene}, {"sweep.toml", kSweep}, {"check.toml", kCheck}},
          std::move(arguments),
          std::move(line)};
}

class BadSweep : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadSweep, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Sweeps, BadSweep,
    ::testing::Values(
        sweep("NoScene", "scene.toml", "none.toml",
              "sweep.toml:1: scene = none.toml: is not a file in the folder of sweep.toml"),
        sweep("BadScene", "scene.toml", "bad.toml",
              "bad.toml:3: beam.segments = 0: must be from 1 to 1e+07",
              {{"bad.toml", changed(kScene, "segments = 8", "segments = 0")}}),
        sweep("PlaceByItsSegment", "scene.toml", "numbered.toml",
              "sweep.toml:3: beam.segments = 3 values: move the scene's load.at, the end of a "
              "segment by its number: give it as a fraction",
              {{"numbered.toml",
                changed(kScene, "[[load]]\nat = 'end'", "[[load]]\nat = { segment = 8 }")}}),
        sweep(
            "PlaceMovedBySet",
            "scene.toml'\n[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8, 16]\n",
            "numbered.toml'\n[set]\nbeam.segments = 16\n",
            "sweep.toml:3: beam.segments = another value: moves the scene's load.at, the end of a "
            "segment by its number: give it as a fraction",
            {{"numbered.toml",
              changed(kScene, "[[load]]\nat = 'end'", "[[load]]\nat = { segment = 8 }")}}),
        sweep("UnknownField", "beam.segments", "beam.segment",
              "sweep.toml:3: axis[1].field = beam.segment: is not a field; `plastica fields` lists "
              "them"),
        sweep("OutOfRange", "[4, 8, 16]", "[4, -8, 16]",
              "sweep.toml:4: axis[1].values[2] = -8: must be from 1 to 1e+07"),
        sweep("NoUnit", "beam.segments'\nvalues = [4, 8, 16]", "beam.length'\nvalues = [4]",
              "sweep.toml:4: axis[1].values[1] = 4: a length needs a unit (examples: m, mm, in)"),
        sweep("DimensionOfAnotherShape", "beam.segments'\nvalues = [4, 8, 16]",
              "section.radius'\nvalues = ['4 mm', '5 mm']",
              "sweep.toml:3: section.radius: moves nothing: section.shape is rectangle, which "
              "does not have it"),
        sweep("ParameterOfAnotherLaw", "beam.segments'\nvalues = [4, 8, 16]",
              "material.hardening.tangent_modulus'\nvalues = ['1 GPa', '2 GPa']",
              "sweep.toml:3: material.hardening.tangent_modulus: moves nothing: "
              "material.hardening.law is ideal, which does not have it"),
        sweep("ParameterOfAnotherRateLaw", "beam.segments'\nvalues = [4, 8, 16]",
              "material.rate.exponent'\nvalues = [4, 5]",
              "sweep.toml:3: material.rate.exponent: moves nothing: material.rate.law is none, "
              "which does not have it"),
        sweep("SetsADimensionOfAnotherShape", "[error]", "[set]\nsection.radius = '4 mm'\n[error]",
              "sweep.toml:6: section.radius: moves nothing: section.shape is rectangle, which "
              "does not have it"),
        sweep(
            "ShapeThatNeedsMore", "[error]", "[set]\nsection.shape = 'i_section'\n[error]",
            "sweep.toml:6: section.shape = i_section: needs section.flange_thickness, in [set] or "
            "as an "
            "axis"),
        sweep("WrongTheory", "theory:elastica", "theory:elastika",
              "sweep.toml: error.against = theory:elastika: is not a closed form; there are …"),
        sweep("TheoryThatDoesNotHold", "[error]", "[set]\nbeam.shape = 'arc'\n[error]",
              "sweep.toml: error.against = theory:elastica: …"),
        sweep("UnknownProbe", "'tip'", "'top'",
              "sweep.toml:6: error.probe = top: is not a probe of the scene; it has tip"),
        sweep("ApartOfATruth", "elastica'", "elastica'\napart = ['beam.segments']",
              "sweep.toml:8: error.apart = ['beam.segments']: goes with against = \"finest\" or "
              "\"richardson\""),
        sweep("ApartOfNoAxis", "theory:elastica'", "finest'\napart = ['solver.level']",
              "sweep.toml:8: error.apart[1] = solver.level: is not the field of an axis"),
        sweep("ApartAndRefined", "theory:elastica'",
              "finest'\napart = ['beam.segments']\nalong = 'beam.segments'",
              "sweep.toml:9: error.along = beam.segments: is named in apart, too"),
        sweep("UnknownKey", "[error]", "[eror]", "sweep.toml: error: is missing: it names the …"),
        check(
            "NoSweep", "sweep.toml", "none.toml",
            "check.toml:3: claim[1].sweep = none.toml: is not a file in the folder of check.toml"),
        check("NoLimit", "{ at_least = 1.9 }", "1.9",
              "check.toml:4: claim[1].order = 1.9: must be a table, { key = value, ... }"),
        check("TwoOfOneName", "[[claim]]\n",
              "[[claim]]\nname = 'order'\nsweep = 'sweep.toml'\nwork = { at_most = 1 }\n"
              "[[claim]]\n",
              "check.toml:6: claim[2].name = order: is the name of the claim in line 1: each has "
              "its own"),
        check("UnknownClaim", "order = {", "orders = {", "check.toml:1: claim[1]: claims nothing…"),
        check(
            "AboutNothing", "sweep = 'sweep.toml'\n", "",
            "check.toml:1: claim[1]: is about nothing: it needs one of sweep, scene, fit, result, "
            "stability"),
        check("OrderOfAScene", "sweep = 'sweep.toml'", "scene = 'scene.toml'",
              "check.toml:4: claim[1].order = { at_least = 1.9 }: is about a sweep, not about a "
              "scene"),
        check("SceneWithoutProbe", "sweep = 'sweep.toml'\norder = { at_least = 1.9 }",
              "scene = 'scene.toml'\nprobe = 'top'\nvalue = { at_most = '1 m' }",
              "check.toml:4: claim[1].probe = top: is not a probe of the scene; it has tip"),
        check("FitThatIsNone", "sweep = 'sweep.toml'\norder = { at_least = 1.9 }",
              "fit = 'scene.toml'\nfailed = { at_most = 0 }", "scene.toml…"),
        check("ResultThatIsNone", "sweep = 'sweep.toml'\norder = { at_least = 1.9 }",
              "result = 'scene.toml'\nfailed = { at_most = 0 }", "scene.toml: is not an HDF5 file"),
        check("ClaimThatCannotFail", "order = { at_least = 1.9 }", "failed = { at_most = 3 }",
              "check.toml:4: claim[1].failed = { at_most = 3 }: holds whatever happens: there are "
              "3"),
        called("NoFile", {"sweep", "none.toml"}, "none.toml: …"),
        called("OutputIsInput", {"sweep", "sweep.toml", "-o", "sweep.toml", "--force"},
               "--output = sweep.toml: …"),
        called("NothingToRunAgain", {"sweep", "sweep.toml", "--rerun-failed", "-o", "out.h5"},
               "--rerun-failed = out.h5: is not there: nothing has been run yet"),
        called("RecommendOfNoSweep", {"recommend", "scene.toml", "--within", "1 %"},
               "scene.toml: …")),
    [](const auto& input) { return input.param.name; });

/// Options of `recommend` that do not fit.
class BadWish : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadWish, IsRefusedInOneLine) {
  const Workplace place;
  place.write("scene.toml", kScene);
  place.write("sweep.toml", kSweep);
  ASSERT_EQ(place.run({"sweep", "sweep.toml", "--quiet", "-o", "sweep.h5"}).code, 0);
  const CommandResult result = place.run(GetParam().arguments);
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "plastica: " + GetParam().line + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Recommend, BadWish,
    ::testing::Values(
        BadInput{"Neither",
                 {},
                 {"recommend", "sweep.h5"},
                 "recommend: needs one of --within and --budget"},
        BadInput{"Both",
                 {},
                 {"recommend", "sweep.h5", "--within", "1 %", "--budget", "10"},
                 "recommend: needs one of --within and --budget"},
        BadInput{"Negative",
                 {},
                 {"recommend", "sweep.h5", "--within", "-1 %"},
                 "--within = -1 %: must be above 0"},
        BadInput{"AllOfIt",
                 {},
                 {"recommend", "sweep.h5", "--within", "100 %"},
                 "--within = 100 %: must be below 100 %"},
        BadInput{"WithinWithoutUnit",
                 {},
                 {"recommend", "sweep.h5", "--within", "0.1"},
                 "--within = 0.1: needs a unit: \"1 %\""},
        BadInput{"SameFileTwice",
                 {},
                 {"recommend", "sweep.h5", "--within", "9 %", "-o", "a.toml", "--next", "a.toml"},
                 "--next = a.toml: is the output, too"},
        BadInput{"NotTimed",
                 {},
                 {"recommend", "sweep.h5", "--budget", "2 ms"},
                 "--budget = 2 ms: needs a sweep that timed its cases: [cost] timed_runs"},
        BadInput{"ByTime",
                 {},
                 {"recommend", "sweep.h5", "--within", "1 %", "--by", "time"},
                 "--by = time: needs a sweep that timed its cases: [cost] timed_runs"}),
    [](const auto& input) { return input.param.name; });

}  // namespace
}  // namespace plastica::testing
