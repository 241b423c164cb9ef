#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"

/// `plastica calibrate` of targets that name scenes.
namespace plastica::testing {
namespace {

std::string shipped(const std::string& name) {
  return std::string(PLASTICA_SOURCE_DIR) + "/data/" + name;
}

constexpr const char* kFittedScene = R"([beam]
length = "400 mm"
segments = 6
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[material]
name = "S355"
[rules]
yield_model = "fibre"
[[support]]
at = "start"
kind = "clamp"
[[support]]
at = "end"
kind = "roller"
hold = ["y"]
translation = ["0 mm", "-80 mm", "0 mm"]
[[probe]]
name = "force"
kind = "reaction"
at = "end"
component = "y"
)";

constexpr const char* kSceneFit = R"([fit]
shared = false
[fit.parameters]
youngs_modulus = { bounds = ["50 GPa", "500 GPa"] }
[[target]]
files = "*.csv"
scene = "bar.toml"
abscissa = { drive = "support[2]", column = "Displacement" }
ordinate = { probe = "force", column = "Force", factor = -1 }
)";

/// 3 EI/L^3 is 131 N/mm at 210 GPa; two bars that differ by a tenth.
void write_bars(const Workplace& place) {
  place.write("bar.toml", kFittedScene);
  place.write("fit.toml", kSceneFit);
  place.write("a.csv", "Displacement (mm),Force (N)\n1,130\n2,263\n1,131\n-1,-131\n");
  place.write("b.csv", "Displacement (mm),Force (N)\n1,144\n2,289\n1,144\n-1,-144\n");
}

TEST(SceneFitCommand, FindsTheIntervalsThatAreAskedFor) {
  const Workplace place;
  write_bars(place);
  const CommandResult result = place.run({"calibrate", "fit.toml", "--profile", "--bootstrap", "20",
                                          "--json", "fit.json", "-o", "fit.h5"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto fit = nlohmann::json::parse(place.read("fit.json")).at("fits").at(0);
  const auto& intervals = fit.at("intervals");
  const auto& profile = intervals.at("profile").at("youngs_modulus");
  EXPECT_EQ(profile.at("ends").at(0), "crossed");
  EXPECT_LT(profile.at("interval").at(0), fit.at("parameters").at("youngs_modulus").at("value"));
  EXPECT_EQ(intervals.at("bootstrap").at("resamples"), 20);
  for (const char* what : {"profile", "bootstrap"}) {
    const CommandResult drawn =
        place.run({"plot", "fit.h5", "--what", what, "-o", std::string(what) + ".gp"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
  }
  EXPECT_NE(place.read("profile.gp").find("least cost"), std::string::npos);
}

TEST(SceneFitCommand, SaysWhatItMendedInTheCurves) {
  const Workplace place;
  write_bars(place);
  place.write("a.csv",
              "Displacement (mm),Force (N)\n1,130\n# paused\n2,NaN\n2,263\n1,131\n-1,-131\n");
  const CommandResult result = place.run({"calibrate", "fit.toml", "-o", "fit.h5"});
  ASSERT_EQ(result.code, 0) << result.err;
  const std::string mended =
      "\nRepaired\n  nan-rows: rows dropped that lack one of the two numbers\n    1 sample in a\n";
  EXPECT_NE(result.out.find(mended), std::string::npos) << result.out;
  const CommandResult shown = place.run({"show", "fit.h5"});
  EXPECT_NE(shown.out.find(mended), std::string::npos) << "kept with the result: " << shown.out;
}

TEST(SceneFitCommand, FitsTheShippedBendTest) {
  const Workplace place;
  const CommandResult result =
      place.run({"calibrate", shipped("fits/bend_test.toml"), "--json", "fit.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "wrote bend_test.h5\n");
  const auto fit = nlohmann::json::parse(place.read("fit.json")).at("fits").at(0);
  const auto value = [&](const std::string& name) {
    for (const auto& p : fit.at("parameters")) {
      if (p.at("path") == "material." + name) return p.at("value").get<double>();
    }
    return 0.0;
  };
  // What the curve was made with; 32 segments are off by 0.1 %.
  EXPECT_NEAR(value("youngs_modulus"), 205e9, 0.005 * 205e9);
  EXPECT_NEAR(value("yield_stress"), 380e6, 0.005 * 380e6);
  EXPECT_NEAR(value("break_strain"), 0.02, 0.02 * 0.02);
  const CommandResult shown = place.run({"show", "bend_test.h5"});
  EXPECT_EQ(shown.code, 0);
  EXPECT_EQ(shown.out, result.out);
  EXPECT_NE(shown.out.find("identified"), std::string::npos) << shown.out;
}

TEST(SceneFitCommand, FitsEachSpecimenOrAllTogether) {
  const Workplace place;
  write_bars(place);
  const CommandResult each = place.run({"calibrate", "fit.toml", "-o", "each.h5"});
  ASSERT_EQ(each.code, 0) << each.err;
  EXPECT_TRUE(each.out.ends_with("fitted 2, failed 0\n")) << each.out;
  place.write("fit.toml", changed(kSceneFit, "shared = false", "shared = true"));
  const CommandResult together =
      place.run({"calibrate", "fit.toml", "-o", "all.h5", "--json", "all.json"});
  ASSERT_EQ(together.code, 0) << together.err;
  const auto fits = nlohmann::json::parse(place.read("all.json")).at("fits");
  EXPECT_EQ(fits.size(), 1U);
  EXPECT_EQ(fits.at(0).at("name"), "fit");
}

TEST(SceneFitCommand, SaysWhatWouldRun) {
  const Workplace place;
  write_bars(place);
  const CommandResult result = place.run({"calibrate", "fit.toml", "--dry-run"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(
      result.out.starts_with("2 fits of 2 targets, written to fit.h5\n"
                             "a: 4 samples, 6 segments, planar"))
      << result.out;
  EXPECT_NE(result.out.find("; slopes by companions\nb: "), std::string::npos) << result.out;
  EXPECT_FALSE(place.has("fit.h5"));
  place.write("bar.toml", std::string(kFittedScene) + "[solver]\ncontrol = \"arc_length\"\n");
  const std::string plan = place.run({"calibrate", "fit.toml", "--dry-run"}).out;
  EXPECT_NE(plan.find("; slopes by runs of their own: its path is not followed by the load "
                      "(solver.control)\n"),
            std::string::npos)
      << plan;
}

TEST(SceneFitCommand, SaysHowTheErrorOfTheSegmentsWouldBeFound) {
  const Workplace place;
  write_bars(place);
  const auto plan = [&] { return place.run({"calibrate", "fit.toml", "--dry-run"}).out; };
  EXPECT_TRUE(plan().ends_with(
      "then again with half and with twice the segments, for their error: a search each from the "
      "fitted values,\nhalf and twice the work a run (fit.segments_error = false: neither)\n"
      "  a: 3 segments and 12 segments\n  b: 3 segments and 12 segments\n"))
      << plan();
  place.write("bar.toml", changed(kFittedScene, "segments = 6", "segments = 7"));
  EXPECT_NE(plan().find("  a: none with half (beam.segments = 7: cannot be halved: it is no even "
                        "number) and 14 segments\n"),
            std::string::npos)
      << plan();
  place.write("fit.toml", changed(kSceneFit, "[fit]\n", "[fit]\nsegments_error = false\n"));
  EXPECT_EQ(plan().find("then again"), std::string::npos) << plan();
}

/// The shipped bend test, told to choose its segments.
std::string chosen_within(const Workplace& place, const std::string& within) {
  std::string text = place.read(shipped("fits/bend_test.toml"));
  text = changed(text, "beam     = { segments = 32 }\n", "");
  for (const std::string folder : {"targets", "scenes"}) {
    text = changed(text, "\"../" + folder, "\"" + shipped(folder));
  }
  return "[fit]\nsegments = \"auto\"\nwithin = \"" + within + "\"\nstarts = 1\n" + text;
}

TEST(SceneFitCommand, ChoosesTheSegmentsAndKeepsWhatItChose) {
  const Workplace place;
  place.write("fit.toml", chosen_within(place, "1 %"));
  const CommandResult plan = place.run({"calibrate", "fit.toml", "--dry-run"});
  EXPECT_NE(plan.out.find("segments: by trial fits, until they move no value by more than 1 %"),
            std::string::npos)
      << plan.out << plan.err;
  const CommandResult result = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(result.err.starts_with("segments: 8 move ")) << result.err;
  const auto fit = nlohmann::json::parse(place.read("fit.json")).at("fits").at(0);
  const int segments = fit.at("segments").at("segments").get<int>();
  EXPECT_GT(segments, 8);
  EXPECT_LT(segments, 32);
  for (const auto& p : fit.at("parameters")) {
    // What the curve was made with, by a beam of far more segments.
    const std::string path = p.at("path").get<std::string>();
    const double truth = path == "material.youngs_modulus" ? 205e9
                         : path == "material.yield_stress" ? 380e6
                                                           : 0.02;
    EXPECT_NEAR(p.at("value").get<double>(), truth, 0.015 * truth) << path;
  }
  // The result has the number: the beam that is exported is the one that was fitted.
  const CommandResult beam = place.run({"export", "fit.h5", "--to", "mjcf", "-o", "beam.xml"});
  ASSERT_EQ(beam.code, 0) << beam.err;
  const std::string bodies = place.read("beam.xml");
  int count = 0;
  for (auto at = bodies.find("<body "); at != std::string::npos;
       at = bodies.find("<body ", at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, segments + 1);  // a body for each, and the one that is clamped
  // Again from what was chosen: the same run.
  EXPECT_EQ(place.run({"calibrate", "fit.toml", "--resume", "--quiet"}).code, 0);
}

TEST(SceneFitCommand, SaysWhereTheSegmentsMoveAValueByMoreThanIsAsked) {
  const Workplace place;
  place.write("fit.toml",
              changed(chosen_within(place, "0.01 %"), "segments = \"auto\"", "segments = 10"));
  const CommandResult result = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_NE(result.out.find("fit.within asks for 0.01 %"), std::string::npos) << result.out;
}

TEST(SceneFitCommand, DoesNotPromiseWhatCannotRun) {
  const Workplace place;
  write_bars(place);
  place.write("b.csv", "Displacement (mm),Force (N)\n1,144\n");
  const CommandResult result = place.run({"calibrate", "fit.toml", "--dry-run"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "plastica: target = b: has no more samples than the fit has parameters\n");
}

TEST(SceneFitCommand, ComparesLaws) {
  const Workplace place;
  write_bars(place);
  const CommandResult result = place.run(
      {"calibrate", "fit.toml", "--laws", "ideal,linear", "--json", "fit.json", "-o", "fit.h5"});
  ASSERT_EQ(result.code, 0) << result.err;
  for (const char* said :
       {"Laws for a, by parts of the curve held out", "Laws for b, by parts", "of parts held out",
        "runs of scenes", "for all", "fitted 2, failed 0"}) {
    EXPECT_NE(result.out.find(said), std::string::npos) << said << result.out;
  }
  const auto json = nlohmann::json::parse(place.read("fit.json"));
  ASSERT_EQ(json.at("fits").size(), 4U);
  EXPECT_EQ(json.at("fits").at(1).at("name"), "a");
  EXPECT_EQ(json.at("fits").at(1).at("law"), "linear");
  // The bars stay elastic.
  EXPECT_EQ(json.at("laws").at("all").at("advised"), "ideal");
  EXPECT_EQ(json.at("counts").at("fitted"), 2);
  EXPECT_FALSE(json.at("fits").at(0).at("segments").is_null());
  EXPECT_TRUE(json.at("fits").at(1).at("segments").is_null()) << "of the advised law alone";
  EXPECT_EQ(place.run({"show", "fit.h5"}).out, result.out);
  const CommandResult one = place.run({"show", "fit.h5", "--case", "b:linear"});
  EXPECT_NE(one.out.find("tangent_modulus"), std::string::npos) << one.out << one.err;
  const CommandResult advised = place.run({"show", "fit.h5", "--case", "b"});
  EXPECT_EQ(advised.out.find("tangent_modulus"), std::string::npos) << advised.out;
  EXPECT_EQ(place.run({"plot", "fit.h5", "--what", "laws", "-o", "laws.gp"}).code, 0);
  EXPECT_NE(place.read("laws.gp").find("title 'linear, "), std::string::npos);
  const CommandResult table = place.run({"export", "fit.h5"});
  EXPECT_TRUE(table.out.starts_with("name,law,status")) << table.out;
  const CommandResult curves = place.run({"export", "fit.h5", "--what", "curves"});
  EXPECT_NE(curves.out.find("\nb:linear,b,"), std::string::npos) << curves.out;
}

TEST(SceneFitCommand, RefusesLawsThatItCannotCompare) {
  const Workplace place;
  write_bars(place);
  const auto said = [&](const std::string& laws) {
    const CommandResult result = place.run({"calibrate", "fit.toml", "--laws", laws});
    EXPECT_EQ(result.code, 2) << laws;
    return result.err;
  };
  EXPECT_EQ(said("ideal,ludwik"),
            "plastica: --laws = ludwik: is no law; there are ideal, linear, voce, chaboche, "
            "multilinear\n");
  EXPECT_EQ(said("linear,linear"), "plastica: --laws = linear: is named twice\n");
  EXPECT_EQ(said("ideal,multilinear"),
            "plastica: laws = multilinear: needs a table, and none is made up: "
            "material.hardening.plastic_strain and flow_stress of a fit file say where its fit "
            "begins\n");
  const CommandResult prior = place.run({"calibrate", "fit.toml", "--no-modulus-prior"});
  EXPECT_EQ(prior.code, 2);
  EXPECT_EQ(
      prior.err,
      "plastica: --no-modulus-prior: is for curves: fits through scenes have no such prior\n");
  EXPECT_EQ(said("ideal,chaboche"),
            "plastica: target = a: has no more samples than the fit has parameters\n");
  EXPECT_FALSE(place.has("fit.h5"));
  place.write("fit.toml", changed(kSceneFit, "shared = false", "laws = ['ideal', 'ideal']"));
  const CommandResult twice = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(twice.code, 2);
  EXPECT_EQ(twice.err, "plastica: fit.toml:2: fit.laws[2] = ideal: is named twice\n");
}

TEST(SceneFitCommand, HasTheSameBytesOnEveryNumberOfThreads) {
  const Workplace place;
  write_bars(place);
  ASSERT_EQ(place
                .run({"calibrate", "fit.toml", "-o", "1.h5", "--json", "1.json", "--threads", "1",
                      "--quiet"})
                .code,
            0);
  ASSERT_EQ(place
                .run({"calibrate", "fit.toml", "-o", "3.h5", "--json", "3.json", "--threads", "3",
                      "--quiet"})
                .code,
            0);
  EXPECT_EQ(place.read("1.json"), place.read("3.json"));
}

TEST(SceneFitCommand, ChecksAllFitsBeforeTheFirst) {
  const Workplace place;
  write_bars(place);
  place.write("b.csv", "Displacement (mm),Force (N)\n1,144\n");
  const CommandResult result = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "plastica: target = b: has no more samples than the fit has parameters\n");
  EXPECT_FALSE(place.has("fit.h5"));
}

TEST(SceneFitCommand, KeepsAFailedFitAsARow) {
  const Workplace place;
  write_bars(place);
  // No bar of 400 mm can be pushed by 40 m.
  place.write("b.csv", "Displacement (mm),Force (N)\n1,144\n40000,289\n1,144\n");
  const CommandResult result = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(result.out.ends_with("fitted 1, failed 1\n")) << result.out;
  EXPECT_NE(result.out.find("gives no curve"), std::string::npos) << result.out;
}

BadInput bad_fit(std::string name, const std::string& from, const std::string& to,
                 const std::string& line) {
  return {std::move(name),
          {{"bar.toml", kFittedScene},
           {"a.csv", "Displacement (mm),Force (N)\n1,130\n2,263\n1,131\n-1,-131\n"},
           {"fit.toml", changed(kSceneFit, from, to)}},
          {"calibrate", "fit.toml"},
          line};
}

class BadSceneFit : public ::testing::TestWithParam<BadInput> {};
TEST_P(BadSceneFit, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    SceneFits, BadSceneFit,
    ::testing::Values(
        bad_fit("NoScene", "scene = \"bar.toml\"", "scene = \"bra.toml\"",
                "fit.toml:7: target[1].scene = bra.toml: is not a file"),
        bad_fit("NoBound", "{ bounds = [\"50 GPa\", \"500 GPa\"] }", "{ start = \"50 GPa\" }",
                "fit.toml:4: material.youngs_modulus: needs a lower and an upper bound to be "
                "fitted"),
        bad_fit("ParameterInATarget", "scene = \"bar.toml\"",
                "scene = \"bar.toml\"\nmaterial = { youngs_modulus = \"200 GPa\" }",
                "fit.toml:8: target[1].material.youngs_modulus = 200 GPa: is a parameter of the "
                "fit, which gives all targets its value: say it in fit.parameters, or leave it out "
                "there"),
        bad_fit(
            "ParameterInTheBeamOfATarget", "scene = \"bar.toml\"",
            "scene = \"bar.toml\"\nbeam = { material = { youngs_modulus = \"200 GPa\" } }",
            "fit.toml:8: target[1].beam.material.youngs_modulus = 200 GPa: is a parameter of the "
            "fit, which gives all targets its value: say it in fit.parameters, or leave it out "
            "there"),
        bad_fit("UnknownKey", "[fit]\n", "[fit]\nobjektive = \"path\"\n",
                "fit.toml:2: fit.objektive…"),
        bad_fit("UnknownObjective", "[fit]\n", "[fit]\nobjective = \"squares\"\n",
                "fit.toml:2: fit.objective = \"squares\": must be one of \"path\", "
                "\"least-squares\""),
        bad_fit("AlgorithmBesideStarts", "[fit]\n", "[fit]\nalgorithm = \"bobyqa\"\nstarts = 3\n",
                "fit.toml:3: fit.starts = 3: goes with algorithm = \"auto\": any other one goes "
                "alone"),
        bad_fit("NoBreak", "[fit.parameters]\n",
                "[fit.parameters]\nbreak_strain = { bounds = [\"1 %\", \"9 %\"] }\n",
                "fit.toml:4: material.break_strain: cannot be fitted: the target does not say "
                "where it broke"),
        bad_fit("WrongUnit", "column = \"Displacement\"", "column = \"Displacement\", unit = \"N\"",
                "fit.toml:8: target[1].abscissa.unit = N: is not a unit of length (examples: m, "
                "mm, in)")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
