#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>

#include "tests/calibrate/engine/parse_engine_texts.hpp"
#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kScene = R"([beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
segments = 4

[[support]]
at = "start"
kind = "clamp"

[[load]]
at = "end"
force = ["0 N", "-10 N", "0 N"]

)";

constexpr const char* kCoupon = "[drive]\nstrain = [0, \"1 %\"]\n";

/// Stands for AGX Dynamics: counts what a module adds.
constexpr const char* kAgx = R"(class Any:
    def __init__(self, *arguments): pass
    def __getattr__(self, name): return lambda *arguments: Any()

RigidBody = Frame = Vec3 = Quat = RangeReal = Any

class LockJoint(Any):
    (TRANSLATIONAL_1, TRANSLATIONAL_2, TRANSLATIONAL_3, ROTATIONAL_1, ROTATIONAL_2,
     ROTATIONAL_3) = range(6)
    def __init__(self, *arguments): self.compliance = {}
    def setCompliance(self, value, freedom): self.compliance[freedom] = value
)";

/// A folder with fits of two specimens and a scene.
class ExportBeam : public ::testing::Test {
 protected:
  ExportBeam() {
    place_.write("a.csv", broken_curve());
    place_.write("b.csv", broken_curve(400.0, 1));
    place_.write("scene.toml", kScene);
    EXPECT_EQ(place_.run({"calibrate", "a.csv", "b.csv", "-o", "fit.h5", "--quiet"}).code, 0);
  }

  std::string beam_of(std::vector<std::string> more) const {
    more.insert(more.begin(), {"export", "fit.h5", "--scene", "scene.toml"});
    const CommandResult result = place_.run(std::move(more));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(result.err.starts_with("note: the scene's yield surface")) << result.err;
    return result.out;
  }

  /// A fitted value [SI] in the table of specimens.
  double fitted(const std::string& specimen, const std::string& column) const {
    const std::string table = place_.run({"export", "fit.h5"}).out;
    std::istringstream lines(table);
    std::string head;
    std::string line;
    std::getline(lines, head);
    while (std::getline(lines, line) && !line.starts_with(specimen + ",")) {
    }
    std::istringstream names(head);
    std::istringstream values(line);
    for (std::string name; std::getline(names, name, ',');) {
      std::string value;
      std::getline(values, value, ',');
      if (name == column) return std::stod(value);
    }
    ADD_FAILURE() << column;
    return 0.0;
  }

  Workplace place_;
};

TEST_F(ExportBeam, HasTheFittedNumbersInEachFormat) {
  const double modulus = fitted("b", "fit.youngs_modulus [Pa]");
  const double yield = fitted("b", "fit.yield_stress [Pa]");
  const double strain = fitted("b", "fit.break_strain [1]");
  const double second_moment = std::pow(0.02, 4) / 12.0;
  const auto expect_joint = [&](const ParsedBeam& beam) {
    const ParsedJoint& joint = beam.joints.at("joint_0");
    const double stiffness = modulus * second_moment / 0.125;
    EXPECT_NEAR(joint.stiffness[0], stiffness, 1e-12 * stiffness);
    const double moment = yield * second_moment / 0.01;
    EXPECT_NEAR(joint.yield_moment[0], moment, 1e-12 * moment);
    EXPECT_NEAR(joint.break_angle[0], 2.0 * strain, 1e-12 * strain);  // L_p = h
  };
  expect_joint(parse_csv(beam_of({"--case", "b", "--to", "csv"})));
  expect_joint(parse_mjcf(beam_of({"--case", "b", "--to", "mjcf"})));
  expect_joint(parse_agx(beam_of({"--case", "b", "--to", "agx"})));
  expect_joint(parse_chrono(beam_of({"--case", "b", "--to", "chrono"})));
  expect_joint(parse_opensees(beam_of({"--case", "b", "--to", "opensees"})));
}

TEST_F(ExportBeam, HasAsManySegmentsAsAreAskedFor) {
  const std::string text = beam_of({"--case", "a", "--to", "chrono", "--segments", "7"});
  EXPECT_EQ(parse_chrono(text).segments.size(), 7U);
}

TEST_F(ExportBeam, SaysWhereItsNumbersComeFrom) {
  const std::string text = beam_of({"--case", "a", "--to", "mjcf"});
  EXPECT_NE(text.find("Note: material fitted to a\n"), std::string::npos);
  EXPECT_TRUE(std::regex_search(text, std::regex("Note: yield_stress = .* ± .* MPa, fitted\n")));
}

TEST_F(ExportBeam, IsTheSameForAnEngineAndAsAFile) {
  const std::string text = beam_of({"--case", "a", "--to", "mjcf"});
  EXPECT_EQ(beam_of({"--case", "a", "--to", "mjcf", "-o", "beam.xml"}), "");
  EXPECT_EQ(place_.read("beam.xml"), text);
}

TEST_F(ExportBeam, RunsAsAPythonModule) {
  place_.write("beam.py", beam_of({"--case", "a", "--to", "agx"}));
  place_.write("agx.py", kAgx);
  const CommandResult run = place_.run_program(
      PLASTICA_PYTHON,
      {"-B", "-c",
       "import sys; sys.path.insert(0, '.'); import agx, beam\n"
       "bodies, joints = beam.build(agx.Any())\n"
       "half = joints['joint_0'].compliance; whole = joints['joint_1'].compliance\n"
       "print(len(bodies), len(joints), round(whole[3] / half[3], 9))"});
  EXPECT_EQ(run.out, "4 4 2.0\n") << run.err;
}

TEST_F(ExportBeam, OfASimulatedSceneHasItsOwnMaterial) {
  place_.write("loaded.toml", std::string(kScene) +
                                  "[[support]]\nat = \"end\"\nkind = \"pillar\"\nnormal = \"y\"\n");
  ASSERT_EQ(place_.run({"simulate", "loaded.toml", "-o", "s.h5", "--quiet"}).code, 0);
  const CommandResult table = place_.run({"export", "s.h5", "--what", "beam"});
  EXPECT_EQ(table.code, 0) << table.err;
  const double stiffness = 210e9 * std::pow(0.02, 4) / 12.0 / 0.25;
  EXPECT_NEAR(parse_csv(table.out).joints.at("joint_1").stiffness[0], stiffness, 1e-12 * stiffness);
  EXPECT_NE(table.err.find("note: support[2] at 1 m only pushes: left out\n"), std::string::npos)
      << table.err;
  EXPECT_EQ(place_.run({"export", "s.h5", "--to", "opensees", "--segments", "3"}).code, 0);
}

TEST_F(ExportBeam, OfASceneFileIsThatOfItsResult) {
  ASSERT_EQ(place_.run({"simulate", "scene.toml", "-o", "s.h5", "--quiet"}).code, 0);
  for (const std::string format : {"csv", "mjcf", "opensees"}) {
    const CommandResult of_file = place_.run({"export", "scene.toml", "--to", format});
    const CommandResult of_result =
        place_.run({"export", "s.h5", "--what", "beam", "--to", format});
    EXPECT_EQ(of_file.code, 0) << of_file.err;
    EXPECT_EQ(of_file.out,
              format == "csv" ? of_result.out : place_.run({"export", "s.h5", "--to", format}).out);
  }
}

/// Neither supports nor loads are asked for where a beam alone is wanted.
TEST_F(ExportBeam, OfASceneFileNeedsABeamAlone) {
  const std::string text = kScene;
  place_.write("bare.toml", text.substr(0, text.find("[[support]]")));
  const CommandResult beam = place_.run({"export", "bare.toml", "--segments", "8"});
  EXPECT_EQ(beam.code, 0) << beam.err;
  const ParsedBeam parsed = parse_csv(beam.out);
  EXPECT_EQ(parsed.joints.size(), 7U);
  const double stiffness = 210e9 * std::pow(0.02, 4) / 12.0 / 0.125;
  EXPECT_NEAR(parsed.joints.at("joint_1").stiffness[0], stiffness, 1e-12 * stiffness);
  const std::map<std::string, std::string> files{
      {"bare.toml", place_.read("bare.toml")},
      {"coupon.toml", kCoupon},
      {"wrong.toml", text + "[material]\nyield_stress = '-1 Pa'\n"}};
  const std::vector<std::pair<std::vector<std::string>, std::string>> requests = {
      {{"bare.toml", "--to", "json"},
       "bare.toml: is a scene, which has a beam alone: what it does is in the result of plastica "
       "simulate"},
      {{"bare.toml", "--what", "probes"}, "bare.toml: is a scene, which has a beam alone: …"},
      {{"bare.toml", "--case", "a"}, "--case: is for results; this is a scene"},
      {{"bare.toml", "--time", "1 s"}, "--time: is for results; this is a scene"},
      {{"coupon.toml"}, "coupon.toml:2: drive.strain: a coupon has no joints: …"},
      {{"wrong.toml"}, "wrong.toml:15: material.yield_stress = -1 Pa: …"}};
  for (const auto& [more, line] : requests) {
    SCOPED_TRACE(line);
    std::vector<std::string> arguments{"export"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal({"", files, arguments, line});
  }
}

TEST_F(ExportBeam, IsPutIntoTheWorldOfAnEngine) {
  const std::string text = beam_of({"--case", "a", "--to", "mjcf", "--up", "z", "--gravity",
                                    "9.81 m/s^2", "--damping", "2 ms", "--contacts", "others"});
  EXPECT_NE(text.find("gravity=\"0 0 -9.81\""), std::string::npos);
  EXPECT_NE(text.find("contype=\"2\" conaffinity=\"1\""), std::string::npos);
  EXPECT_NE(text.find("The damping of a joint is 0.002 s times its stiffness\n"),
            std::string::npos);
  EXPECT_NE(beam_of({"--case", "a", "--to", "agx", "--up", "x", "--gravity", "9.81 m/s^2"})
                .find("\nGRAVITY = (-9.81, 0, 0)\n"),
            std::string::npos);
}

TEST_F(ExportBeam, ThatCannotBeIsRefusedInOneLine) {
  place_.write("coupon.toml", kCoupon);
  std::map<std::string, std::string> files;
  for (const char* name : {"fit.h5", "scene.toml", "coupon.toml"}) files[name] = place_.read(name);
  const std::vector<std::pair<std::vector<std::string>, std::string>> requests = {
      {{"--to", "mjfc"},
       "--to = mjfc: must be one of csv, json, markdown, latex, mjcf, agx, bullet, chrono, "
       "opensees, vtkhdf, xdmf; did "
       "you mean mjcf?"},
      {{"--to", "mjcf", "--case", "a"},
       "--scene: is missing: a fit knows the material; a scene file has the beam"},
      {{"--to", "mjcf", "--scene", "scene.toml"},
       "fit.h5: --case: must be a specimen of the file: a, b"},
      {{"--to", "mjcf", "--scene", "scene.toml", "--case", "c"},
       "fit.h5: --case = c: must be a specimen of the file: a, b"},
      {{"--to", "mjcf", "--scene", "none.toml", "--case", "a"}, "none.toml: cannot be read…"},
      {{"--to", "agx", "--scene", "coupon.toml", "--case", "a"},
       "drive.strain: a coupon has no joints: an export needs a beam"},
      {{"--to", "agx", "--scene", "scene.toml", "--case", "a", "--segments", "0"},
       "beam.segments = 0: must be…"},
      {{"--to", "json", "--scene", "scene.toml"},
       "--scene: goes with a beam: --what beam, or --to mjcf, agx, bullet, chrono or opensees"},
      {{"--case", "a"},
       "--case: goes with a beam: --what beam, or --to mjcf, agx, bullet, chrono or opensees"},
      {{"--segments", "3"},
       "--segments: goes with a beam: --what beam, or --to mjcf, agx, bullet, chrono or opensees"},
      {{"--to", "mjcf", "--scene", "scene.toml", "--case", "a", "--gravity", "9.81"},
       "--gravity = 9.81: an acceleration needs a unit (examples: m/s^2, gravity)"},
      {{"--to", "mjcf", "--scene", "scene.toml", "--case", "a", "--gravity", "-9.81 m/s^2"},
       "--gravity = -9.81: must not be negative"},
      {{"--to", "mjcf", "--scene", "scene.toml", "--case", "a", "--damping", "1 m"},
       "--damping = 1 m: …"},
      {{"--to", "opensees", "--scene", "scene.toml", "--case", "a", "--up", "z"},
       "--up: goes with --to mjcf, agx, bullet or chrono"},
      {{"--to", "agx", "--scene", "scene.toml", "--case", "a", "--damping", "1 ms"},
       "--damping: goes with --to mjcf, bullet or chrono"},
      {{"--to", "agx", "--scene", "scene.toml", "--case", "a", "--contacts", "all"},
       "--contacts: goes with --to mjcf"},
      {{"--to", "mjcf", "--up", "up"}, "--up = up: must be one of x, y, z, -x, -y, -z"},
      {{"--to", "mjcf", "--contacts", "othres"},
       "--contacts = othres: must be one of none, others, all; did you mean others?"},
      {{"--to", "mjcf", "--target", "a"},
       "--target: is for results of fits; this is a result of fits"},
      {{"--to", "csv", "--up", "z"},
       "--up: goes with a beam: --what beam, or --to mjcf, agx, bullet, chrono or opensees"},
      {{"--to", "mjcf", "--what", "curves"}, "--what: goes with --to csv or json"},
      {{"--to", "mjcf", "--time", "1 s"},
       "--time: is for simulated scenes; this is a result of fits"},
      {{"--to", "mjcf", "--scene", "scene.toml", "--case", "a", "-o", "scene.toml", "--force"},
       "--output = scene.toml: is a file that this run reads"}};
  for (const auto& [more, line] : requests) {
    SCOPED_TRACE(line);
    std::vector<std::string> arguments{"export", "fit.h5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal({"", files, arguments, line});
  }
}

}  // namespace
}  // namespace plastica::testing
