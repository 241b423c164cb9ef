#include "calibrate/config/scene_fit_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/calibrate/config/config_folder.hpp"

namespace plastica::calibrate {
namespace {

class SceneFitFileTest : public ConfigFolder {
 protected:
  void SetUp() override {
    ConfigFolder::SetUp();
    write("bar.toml", R"([beam]
length = "1 m"
segments = 4
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[material]
name = "S355"
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
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
component = "y"
)");
    write("a.csv", "Displacement (mm),Force (kN)\n0,0\n1,0.5\n2,0.9\n1,0.4\n3,0\n");
    write("b.csv", "Displacement (mm),Force (kN)\n0,0\n1,0.6\n");
  }

  SceneFitFile parse(const std::string& text) const {
    return parse_scene_fit_file(text, path("fit.toml"));
  }

  std::string refusal(const std::string& text) const {
    try {
      (void)parse(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  const std::string kFit =
      "[fit]\nparameters.yield_stress = { bounds = [\"100 MPa\", \"1 GPa\"], prior = { mean = "
      "\"300 MPa\", standard_deviation = \"30 MPa\" } }\n";
  const std::string kTarget =
      "[[target]]\nfiles = \"*.csv\"\nscene = \"bar.toml\"\n"
      "abscissa = { drive = \"support[2]\", column = 1 }\n"
      "ordinate = { probe = \"force\", column = \"Force\", factor = -1 }\n";
};

TEST_F(SceneFitFileTest, ReadsTargetsThatShareTheirParameters) {
  const SceneFitFile file =
      parse(kFit + kTarget + "noise = \"5 N\"\nweight = 2\nbeam = { segments = 8 }\n");
  ASSERT_EQ(file.cases.size(), 1U);
  EXPECT_EQ(file.cases[0].name, "fit");
  ASSERT_EQ(file.cases[0].targets.size(), 2U);
  const WeightedTarget& a = file.cases[0].targets[0];
  EXPECT_EQ(a.target.name, "a");
  EXPECT_EQ(a.target.table, 1U);
  EXPECT_EQ(a.target.kind, Abscissa::Support);
  EXPECT_EQ(a.target.driven, 1U);
  EXPECT_EQ(a.target.abscissa, (std::vector<double>{0.0, 1e-3, 2e-3, 1e-3}));
  EXPECT_EQ(a.target.ordinate, (std::vector<double>{0.0, 500.0, 900.0, 400.0}));
  EXPECT_EQ(a.target.ordinate_factor, -1.0);
  EXPECT_EQ(a.target.noise, 5.0);
  EXPECT_EQ(a.weight, 2.0);
  EXPECT_EQ(a.setup.scene.beam.segments, 8);
  ASSERT_TRUE(a.target.broke);
  EXPECT_EQ(a.target.broke->broken_from(1e-3), 3e-3);
  EXPECT_FALSE(file.cases[0].targets[1].target.broke);
  ASSERT_TRUE(file.options.parameters[0].prior);
  EXPECT_EQ(file.options.parameters[0].prior->mean, 300e6);
  ASSERT_EQ(file.inputs.size(), 2U);
  EXPECT_EQ(file.inputs[1].name, "bar.toml");
}

TEST_F(SceneFitFileTest, ReadsCurvesAsItSays) {
  write("a.csv", "# bar 1\nWeg;Kraft\n0;0\n1,5;500\n1,4;510\n2,5;900\n");
  const SceneFitFile file =
      parse(kFit +
            "[[target]]\nfiles = \"a.csv\"\nscene = \"bar.toml\"\nseparator = \";\"\n"
            "decimal = \",\"\nreversal_tolerance = \"0.2 mm\"\n"
            "abscissa = { probe = \"tip\", column = 1, unit = \"mm\" }\n"
            "ordinate = { probe = \"force\", column = \"Kraft\", unit = \"N\" }\n");
  const SceneTarget& target = file.cases.at(0).targets.at(0).target;
  ASSERT_EQ(target.abscissa.size(), 3U);
  EXPECT_DOUBLE_EQ(target.abscissa[1], 1.45e-3);
  ASSERT_EQ(target.repairs.size(), 1U);
  EXPECT_EQ(target.repairs[0].kind, "abscissa-reversals");
}

TEST_F(SceneFitFileTest, SaysThatACurveCountsTwice) {
  std::string once = kTarget;
  once.replace(once.find("*.csv"), 5, "a.csv");
  const SceneFitFile file = parse(kFit + once + once);
  ASSERT_EQ(file.cases.at(0).targets.size(), 2U);
  EXPECT_TRUE(file.cases[0].targets[0].target.warnings.empty());
  EXPECT_EQ(
      file.cases[0].targets[1].target.warnings,
      (std::vector<std::string>{
          "its curve is that of a, too: two [[target]] blocks read it, and it counts twice"}));
}

TEST_F(SceneFitFileTest, ReadsObjectiveAndAlgorithm) {
  const SceneFitFile usual = parse(kFit + kTarget);
  EXPECT_EQ(usual.options.objective, Objective::LeastSquares);
  EXPECT_EQ(usual.options.algorithm, "auto");
  const SceneFitFile file = parse(kFit + "objective = \"path\"\nalgorithm = \"sbplx\"\n" + kTarget);
  EXPECT_EQ(file.options.objective, Objective::Path);
  EXPECT_EQ(file.options.algorithm, "sbplx");
}

TEST_F(SceneFitFileTest, ReadsFitsOfTheirOwn) {
  const SceneFitFile file =
      parse(kFit + "shared = false\nstarts = 5\nsegments_error = false\n" + kTarget);
  ASSERT_EQ(file.cases.size(), 2U);
  EXPECT_EQ(file.cases[1].name, "b");
  EXPECT_EQ(file.options.starts, 5);
  EXPECT_FALSE(file.options.segments_error);
  EXPECT_TRUE(parse(kFit + kTarget).options.segments_error);
}

TEST_F(SceneFitFileTest, ReadsWhichIntervalsAreWanted) {
  const IntervalOptions none = parse(kFit + kTarget).options.intervals;
  EXPECT_FALSE(none.profile);
  EXPECT_EQ(none.bootstrap, 0);
  const IntervalOptions all =
      parse(kFit +
            "profile = true\nbootstrap = 400\nbootstrap_block = 3\nbootstrap_specimens = 20\n" +
            kTarget)
          .options.intervals;
  EXPECT_TRUE(all.profile);
  EXPECT_EQ(all.bootstrap, 400);
  EXPECT_EQ(all.block, 3);
  EXPECT_EQ(all.specimens, 20);
  EXPECT_EQ(refusal(kFit + "bootstrap = 5\n" + kTarget),
            path("fit.toml") + ":3: fit.bootstrap = 5: must be 0, for none, or at least 20");
}

TEST_F(SceneFitFileTest, ReadsANumberOfSegmentsForAllBeams) {
  const SceneFitFile file = parse(kFit + "segments = 10\n" + kTarget);
  for (const WeightedTarget& target : file.cases.at(0).targets) {
    EXPECT_EQ(target.setup.scene.beam.segments, 10);
  }
  EXPECT_FALSE(file.chooses_segments);
  const SceneFitFile chosen = parse(kFit + "segments = \"auto\"\nwithin = \"0.5 %\"\n" + kTarget);
  EXPECT_TRUE(chosen.chooses_segments);
  EXPECT_DOUBLE_EQ(chosen.options.segments_within, 0.005);
}

TEST_F(SceneFitFileTest, RefusesSegmentsThatContradict) {
  const auto line = [this](const std::string& keys) { return refusal(kFit + keys + kTarget); };
  const std::string file = path("fit.toml");
  EXPECT_EQ(line("segments = \"auto\"\n"),
            file +
                ":3: fit.segments = auto: needs `within`, what the segments may do to a "
                "value: \"0.5 %\"");
  EXPECT_EQ(line("segments = \"many\"\n"),
            file + ":3: fit.segments = many: must be \"auto\" or a number");
  EXPECT_EQ(line("within = \"200 %\"\n"),
            file + ":3: fit.within = 200 %: must be above 0 % and below 100 %");
  EXPECT_EQ(line("within = \"1 %\"\nsegments_error = false\n"),
            file + ":3: fit.within = 1 %: needs the error of the segments (segments_error)");
  EXPECT_NE(refusal(kFit + "segments = 10\n" + kTarget + "beam = { segments = 8 }\n")
                .find("beam.segments = 8: contradicts fit.segments, which is for all beams of the "
                      "fit"),
            std::string::npos);
}

// The end of segment 2 of 4 is another place among 8.
TEST_F(SceneFitFileTest, RefusesABeamThatMovesWhatStandsAtASegmentByItsNumber) {
  std::ifstream file(path("bar.toml"));
  std::string scene{std::istreambuf_iterator<char>(file), {}};
  const std::string tip = "kind = \"displacement\"\nat = \"end\"";
  scene.replace(scene.find(tip), tip.size(), "kind = \"displacement\"\nat = { segment = 2 }");
  write("bar.toml", scene);
  const std::string why =
      "moves the scene's probe.at, the end of a segment by its number: give it as a fraction";
  EXPECT_NE(refusal(kFit + kTarget + "beam = { segments = 8 }\n").find(why), std::string::npos);
  EXPECT_NE(refusal(kFit + "segments = 8\n" + kTarget).find(why), std::string::npos);
  EXPECT_EQ(refusal(kFit + kTarget + "beam = { segments = 4 }\n"), "");
}

TEST_F(SceneFitFileTest, ReadsTheShippedOne) {
  const std::string path = std::string(PLASTICA_SOURCE_DIR) + "/data/fits/bend_test.toml";
  EXPECT_TRUE(names_scenes(path));
  EXPECT_FALSE(names_scenes(std::string(PLASTICA_SOURCE_DIR) + "/data/fits/demo.toml"));
  const SceneFitFile file = read_scene_fit_file(path);
  EXPECT_EQ(file.cases.at(0).targets.at(0).target.name, "bend_test");
  EXPECT_TRUE(file.cases[0].targets[0].target.broke);
}

TEST_F(SceneFitFileTest, FitsAnyNumberOfTheFieldTable) {
  const SceneFitFile file = parse(
      "[fit.parameters]\n\"rules.hinge_length\" = { bounds = [\"5 mm\", \"50 mm\"] }\n" + kTarget);
  EXPECT_EQ(file.options.parameters[0].field->path, "rules.hinge_length");
}

TEST_F(SceneFitFileTest, NamesWhatIsWrong) {
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = kFit + kTarget;
    text.replace(text.find(from), from.size(), to);
    std::string line = refusal(text);
    const std::string folder = path("");
    while (line.find(folder) != std::string::npos)
      line.replace(line.find(folder), folder.size(), "");
    return line;
  };
  EXPECT_EQ(with("scene = \"bar", "scene = \"bra"),
            "fit.toml:5: target[1].scene = bra.toml: is not a file in " +
                path("").substr(0, path("").size() - 1));
  EXPECT_EQ(
      with("support[2]", "suport[2]"),
      "fit.toml:6: target[1].abscissa.drive = suport[2]: must be \"strain\", \"support[I]\" or "
      "\"load[I]\", I its number from 1 on");
  EXPECT_EQ(with("support[2]", "support[3]"),
            "fit.toml:6: abscissa.drive = support[3]: the scene has 2 of them");
  EXPECT_EQ(
      with("drive = \"support[2]\", ", ""),
      "fit.toml:6: target[1].abscissa: needs one of probe (compared along the scene's own path), "
      "drive (the scene follows what was measured) and time = true");
  EXPECT_EQ(with("probe = \"force\"", "probe = \"fource\""),
            "fit.toml:7: ordinate.probe = fource: is not one of the scene's probes: force, "
            "tip");
  EXPECT_EQ(with("ordinate = { probe = \"force\", column = \"Force\", factor = -1 }",
                 "[target.ordinate]\nprobe = \"fource\"\ncolumn = \"Force\""),
            "fit.toml:8: ordinate.probe = fource: is not one of the scene's probes: force, "
            "tip");
  EXPECT_EQ(with("ordinate = { probe = \"force\", column = \"Force\", factor = -1 }",
                 "[target.ordinate]\nprobe = \"force\"\ncolumn = \"Force\"\nunit = \"mm\""),
            "fit.toml:10: target[1].ordinate.unit = mm: is not a unit of force (examples: N, kN, "
            "lbf)");
  EXPECT_EQ(with("\"Force\"", "\"Load\""),
            "fit.toml:7: ordinate = Load: is not a column of a.csv, which has 2 columns: "
            "Displacement, Force");
  EXPECT_EQ(with("factor = -1", "factor = 0"),
            "fit.toml:7: target[1].ordinate.factor = 0: must not be 0");
  EXPECT_EQ(with("files =", "fils ="),
            "fit.toml:3: target[1].files: is missing; is it \"fils\" on line 4?");
  EXPECT_EQ(with("standard_deviation = \"30 MPa\"", "standard_deviation = \"0 MPa\""),
            "fit.toml:2: fit.parameters.yield_stress.prior.standard_deviation = 0 MPa: must be "
            "above 0");
}

}  // namespace
}  // namespace plastica::calibrate
