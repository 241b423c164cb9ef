#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>

#include "calibrate/store/scene_fit_store.hpp"
#include "tests/calibrate/engine/parse_engine_texts.hpp"
#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"

/// `plastica export` of beams that were fitted through scenes.
namespace plastica::testing {
namespace {

constexpr const char* kBar = R"([beam]
length = "400 mm"
segments = 6
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[rules]
yield_model = "per_axis"
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-100 N", "0 N"]
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
)";

constexpr const char* kFit = R"([fit]
starts = 1
segments_error = false
[fit.parameters]
youngs_modulus = { bounds = ["50 GPa", "500 GPa"] }
material.density = { value = "2700 kg/m^3", fixed = true }
shear_yield_stress = { tie = "youngs_modulus", factor = 0.001 }
)";

constexpr const char* kTarget = R"([[target]]
files = "a.csv"
scene = "bar.toml"
abscissa = { drive = "load[1]", column = "Force" }
ordinate = { probe = "tip", column = "Displacement", factor = -1 }
beam = { segments = 8 }
)";

/// A folder with a fit through one scene, or two, of which the scene files are gone.
class ExportSceneFit : public ::testing::Test {
 protected:
  void fit(const std::string& text) const {
    place_.write("bar.toml", kBar);
    place_.write("long.toml", changed(kBar, "segments = 6", "segments = 4"));
    place_.write("a.csv", "Force (N),Displacement (mm)\n100,0.76\n200,1.53\n300,2.29\n");
    place_.write("fit.toml", text);
    const CommandResult result = place_.run({"calibrate", "fit.toml", "--quiet", "--force"});
    ASSERT_EQ(result.code, 0) << result.err;
    std::filesystem::remove(place_.path("bar.toml"));
    std::filesystem::remove(place_.path("long.toml"));
  }

  CommandResult beam(std::vector<std::string> more) const {
    more.insert(more.begin(), {"export", "fit.h5"});
    return place_.run(std::move(more));
  }

  Workplace place_;
};

TEST_F(ExportSceneFit, NeedsNoSceneFile) {
  fit(std::string(kFit) + kTarget);
  const CommandResult table = beam({"--what", "beam"});
  ASSERT_EQ(table.code, 0) << table.err;
  EXPECT_EQ(table.err, "");
  const ParsedBeam made = parse_csv(table.out);
  EXPECT_EQ(made.joints.size(), 8U);
  // F L^3/(3 w I)
  const double modulus = 100.0 * std::pow(0.4, 3) / (3.0 * 0.763e-3 * std::pow(0.02, 4) / 12.0);
  const double stiffness = modulus * std::pow(0.02, 4) / 12.0 / 0.05;
  EXPECT_NEAR(made.joints.at("joint_1").stiffness[0] / stiffness, 1.0, 0.02);
  // What the fit held and tied.
  EXPECT_NE(table.out.find("rho = 2700 kg/m^3"), std::string::npos);
  EXPECT_NE(table.out.find("material.density = 2700.0 kg/m^3, fixed"), std::string::npos);
  EXPECT_NE(table.out.find(", tied\n"), std::string::npos);
  EXPECT_NE(table.out.find("scene: bar.toml, as the fit has it"), std::string::npos);
}

TEST_F(ExportSceneFit, SaysInEachFormatWithHowManySegmentsTheFitWasMade) {
  fit(std::string(kFit) + kTarget);
  for (const char* format : {"csv", "mjcf", "agx", "bullet", "chrono", "opensees"}) {
    SCOPED_TRACE(format);
    const CommandResult own = beam({"--what", "beam", "--to", format});
    EXPECT_NE(own.out.find("fitted with 8 segments"), std::string::npos) << own.out;
    EXPECT_EQ(own.err.find("warning"), std::string::npos) << own.err;
    const CommandResult other = beam({"--what", "beam", "--to", format, "--segments", "12"});
    EXPECT_NE(other.out.find("fitted with 8 segments"), std::string::npos) << other.out;
    EXPECT_TRUE(
        other.err.starts_with("warning: fit.h5: the fit was made with 8 segments, this "
                              "beam has 12: the numbers may be off\n"))
        << other.err;
  }
  // A scene file may be given as well, with segments of its own.
  place_.write("mine.toml", kBar);
  const CommandResult mine = beam({"--what", "beam", "--scene", "mine.toml"});
  EXPECT_EQ(parse_csv(mine.out).joints.size(), 6U);
  EXPECT_NE(mine.err.find("the fit was made with 8 segments, this beam has 6"), std::string::npos)
      << mine.err;
  EXPECT_EQ(mine.out.find("rho = 2700"), std::string::npos);
}

// The end of segment 6 of 6 is another place among 12.
TEST_F(ExportSceneFit, RefusesSegmentsThatMoveAPlace) {
  fit(std::string(kFit) + kTarget);
  place_.write("mine.toml", changed(kBar, "kind = \"displacement\"\nat = \"end\"",
                                    "kind = \"displacement\"\nat = { segment = 6 }"));
  const std::map<std::string, std::string> files{{"fit.h5", place_.read("fit.h5")},
                                                 {"mine.toml", place_.read("mine.toml")}};
  const std::vector<std::string> words{"export",  "fit.h5",    "--to",      "opensees",
                                       "--scene", "mine.toml", "--segments"};
  const auto with = [&](const std::string& segments) {
    std::vector<std::string> all = words;
    all.push_back(segments);
    return all;
  };
  expect_refusal(
      {"", files, with("12"),
       "--segments = 12: moves the scene's probe.at, the end of a segment by its number: "
       "give it as a fraction"});
  EXPECT_EQ(place_.run(with("6")).code, 0);
}

TEST_F(ExportSceneFit, TakesOneOfSeveralScenesByItsName) {
  fit(std::string(kFit) + kTarget +
      changed(changed(kTarget, "bar.toml", "long.toml"), "beam = { segments = 8 }\n", ""));
  const std::map<std::string, std::string> files{{"fit.h5", place_.read("fit.h5")}};
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--to", "mjcf"},
                  "--target: must be one of those of the fit, which went through several scenes: a "
                  "(bar.toml (8 segments), ideal plasticity), a#2 (long.toml (4 segments), ideal "
                  "plasticity)"});
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--to", "mjcf", "--scene", "none.toml"},
                  "--scene = none.toml: is no file, nor a scene that the fit went through: "
                  "bar.toml (8 segments), long.toml (4 segments)"});
  const CommandResult one = beam({"--what", "beam", "--scene", "long.toml"});
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.err, "");
  EXPECT_EQ(parse_csv(one.out).joints.size(), 4U);
  EXPECT_NE(one.out.find("fitted with 4 segments"), std::string::npos);
  // It is what was fitted, whatever stands in a file of its name by now.
  place_.write("long.toml", kBar);
  EXPECT_EQ(beam({"--what", "beam", "--scene", "long.toml"}).out, one.out);
  const CommandResult file = beam({"--what", "beam", "--scene", "./long.toml"});
  EXPECT_EQ(parse_csv(file.out).joints.size(), 6U);
}

// The numbers of a fit hold with the law that each target's scene had, not with the first one's.
TEST_F(ExportSceneFit, ASceneKeepsTheLawThatItWasFittedWith) {
  place_.write("hard.toml", changed(kBar, "segments = 6", "segments = 4") +
                                "[material.hardening]\nlaw = \"linear\"\n"
                                "tangent_modulus = \"2 GPa\"\n");
  fit(std::string(kFit) + kTarget +
      changed(changed(kTarget, "bar.toml", "hard.toml"), "beam = { segments = 8 }\n", ""));
  EXPECT_EQ(beam({"--what", "beam", "--scene", "bar.toml"}).out.find("linear hardening"),
            std::string::npos);
  const std::string hard = beam({"--what", "beam", "--scene", "hard.toml"}).out;
  EXPECT_NE(hard.find("linear hardening"), std::string::npos) << hard;
  EXPECT_NE(hard.find("the fit's targets have several laws"), std::string::npos);
  const std::string targets = beam({"--what", "targets"}).out;
  EXPECT_NE(targets.find(",ideal,planar,"), std::string::npos) << targets;
  EXPECT_NE(targets.find(",linear,planar,"), std::string::npos) << targets;
}

TEST_F(ExportSceneFit, CannotChooseBetweenScenesOfOneName) {
  fit(std::string(kFit) + kTarget + changed(kTarget, "segments = 8", "segments = 4"));
  expect_refusal({"",
                  {{"fit.h5", place_.read("fit.h5")}},
                  {"export", "fit.h5", "--to", "mjcf", "--scene", "bar.toml"},
                  "--target: must be one of those of the fit, which went through several scenes: a "
                  "(bar.toml (8 segments), ideal plasticity), a#2 (bar.toml (4 segments), ideal "
                  "plasticity)"});
  const CommandResult second = beam({"--to", "csv", "--target", "a#2"});
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(parse_csv(second.out).joints.size(), 4U);
  EXPECT_NE(second.out.find("scene: bar.toml, as the fit has it for target a#2"),
            std::string::npos);
}

/// Two tests that yield, a of a scene of ideal plasticity, b and b2 of one that hardens by 5 GPa.
class ExportJointFit : public ExportSceneFit {
 protected:
  void fit_two_laws(const std::string& shared = "true") const {
    const auto target = [](const std::string& files, const std::string& scene) {
      return "[[target]]\nfiles = \"" + files + "\"\nscene = \"" + scene +
             "\"\nabscissa = { drive = \"load[1]\", column = \"Force\" }\n"
             "ordinate = { probe = \"tip\", column = \"Displacement\", factor = -1 }\n";
    };
    const std::string metal = "[material]\nyield_stress = \"300 MPa\"\n";
    place_.write("ideal.toml", kBar + metal);
    place_.write("hard.toml", changed(kBar, "segments = 6", "segments = 4") + metal +
                                  "[material.hardening]\nlaw = \"linear\"\n"
                                  "tangent_modulus = \"5 GPa\"\n");
    const std::string curve = "Force (N),Displacement (mm)\n100,0.76\n200,1.53\n300,2.29\n";
    for (const char* name : {"b.csv", "b2.csv"}) place_.write(name, curve);
    fit(changed(kFit, "[fit]\n", "[fit]\nshared = " + shared + "\n") +
        target("a.csv", "ideal.toml") + target("b*.csv", "hard.toml"));
    for (const char* name : {"ideal.toml", "hard.toml"}) {
      std::filesystem::remove(place_.path(name));
    }
  }

  /// Of a parameter, as the HDF5 file has it.
  double stored(const char* name, std::size_t fit = 0) const {
    const auto contents = calibrate::read_scene_fit_store(place_.path("fit.h5"));
    return contents.records.at(fit).result.parameter(name).value;
  }

  void expect_beam(const std::string& text, double modulus, double tangent, int segments) const {
    const ParsedBeam made = parse_csv(text);
    EXPECT_EQ(made.joints.size(), static_cast<std::size_t>(segments));
    const ParsedJoint& joint = made.joints.at("joint_1");
    const double stiffness = modulus * std::pow(0.02, 4) / 12.0 / (0.4 / segments);
    EXPECT_NEAR(joint.stiffness[0] / stiffness, 1.0, 1e-9);
    if (tangent > 0.0) {
      EXPECT_NEAR(joint.hardened_stiffness[0] / stiffness, tangent / modulus, 1e-9);
    } else {
      EXPECT_EQ(text.find("linear hardening"), std::string::npos) << text;
    }
  }
};

TEST_F(ExportJointFit, OfEachTargetHasItsOwnScenesLaw) {
  fit_two_laws();
  const double modulus = stored("youngs_modulus");
  for (const auto& [target, tangent, segments] :
       {std::tuple("a", 0.0, 6), std::tuple("b", 5e9, 4), std::tuple("b2", 5e9, 4)}) {
    SCOPED_TRACE(target);
    const CommandResult made = beam({"--target", target});
    ASSERT_EQ(made.code, 0) << made.err;
    expect_beam(made.out, modulus, tangent, segments);
  }
  EXPECT_NE(beam({"--target", "b"}).out.find("several laws: this is linear hardening"),
            std::string::npos);
  EXPECT_NE(beam({"--scene", "hard.toml"}).out.find("as the fit has it for targets b, b2"),
            std::string::npos);
}

TEST_F(ExportJointFit, NamesItsTargetsWhereItCannotChoose) {
  fit_two_laws();
  const std::string all =
      "a (ideal.toml (6 segments), ideal plasticity), b (hard.toml (4 segments), linear "
      "hardening), b2 (hard.toml (4 segments), linear hardening)";
  const std::map<std::string, std::string> files{{"fit.h5", place_.read("fit.h5")}};
  for (const char* format : {"mjcf", "agx", "bullet", "chrono", "opensees"}) {
    expect_refusal(
        {"",
         files,
         {"export", "fit.h5", "--to", format},
         "--target: must be one of those of the fit, which went through several scenes: " + all});
  }
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--to", "mjcf", "--target", "c"},
                  "--target = c: must be one of those of the fit: " + all});
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--to", "mjcf", "--target", "a", "--scene", "hard.toml"},
                  "--scene = hard.toml: is no file, nor a scene that target a went through: "
                  "ideal.toml (6 segments)"});
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--what", "curves", "--target", "a"},
                  "--target: goes with a beam: --what beam, or --to mjcf, agx, bullet, chrono or "
                  "opensees"});
}

// A file's own law may be none of the fit's: then its numbers would be of no law that was fitted.
TEST_F(ExportJointFit, GivesASceneFileTheLawOfATarget) {
  fit_two_laws();
  place_.write("mine.toml", changed(kBar, "segments = 6", "segments = 5") +
                                "[material.hardening]\nlaw = \"linear\"\n"
                                "tangent_modulus = \"1 GPa\"\n");
  place_.write("other.toml", std::string(kBar) +
                                 "[material.hardening]\nlaw = \"voce_chaboche\"\n"
                                 "saturation_stress = \"50 MPa\"\nsaturation_rate = 10\n");
  const double modulus = stored("youngs_modulus");
  expect_beam(beam({"--scene", "mine.toml", "--target", "b"}).out, modulus, 5e9, 5);
  expect_beam(beam({"--scene", "mine.toml", "--target", "a"}).out, modulus, 0.0, 5);
  expect_beam(beam({"--scene", "mine.toml"}).out, modulus, 1e9, 5);
  const CommandResult other = beam({"--scene", "other.toml"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(other.err.starts_with(
      "plastica: --target: must be one of those of the fit: they have several laws, the scene has "
      "none of them, but "))
      << other.err;
}

TEST_F(ExportJointFit, OfFitsThatShareNothingTakesTheSceneOfEach) {
  fit_two_laws("false");
  const CommandResult made = beam({"--to", "csv", "--what", "beam", "--case", "b"});
  ASSERT_EQ(made.code, 0) << made.err;
  expect_beam(made.out, stored("youngs_modulus", 1), 5e9, 4);
  expect_beam(beam({"--what", "beam", "--case", "a"}).out, stored("youngs_modulus", 0), 0.0, 6);
}

TEST_F(ExportJointFit, SaysTheLawsWhereverItSaysOne) {
  fit_two_laws();
  EXPECT_NE(beam({}).out.find("\nfit,\"ideal, linear\",fitted,"), std::string::npos)
      << beam({}).out;
  EXPECT_NE(beam({"--to", "json"}).out.find("\"law\": \"ideal, linear\""), std::string::npos);
  const std::string report = place_.run({"show", "fit.h5"}).out;
  EXPECT_NE(report.find("  a   ideal   planar"), std::string::npos) << report;
  EXPECT_NE(report.find("  b   linear  planar"), std::string::npos) << report;
  EXPECT_EQ(place_.run({"plot", "fit.h5", "-o", "fit.gp"}).code, 0);
  EXPECT_NE(place_.read("fit.gp").find("'b: linear hardening'"), std::string::npos);
}

}  // namespace
}  // namespace plastica::testing
