#include "plastica/io/scene_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <variant>

#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/section_kind.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using testing::message_of;

const std::string kDrive = "[drive]\nstrain = [0, 0.01]\n";

Setup read_scene(const std::string& text) { return parse_scene_file(text, "s.toml").setup; }

std::string scene_error(const std::string& text) {
  return message_of([&] { parse_scene_file(text, "s.toml"); });
}

const std::string kChain =
    "support = [{ at = 'start', kind = 'clamp' }]\n"
    "load = [{ at = 'end', force = ['0 N', '1 N', '0 N'] }]\n";

/// A scene that a field can be set in to any value of its range.
/// The shape that a dimension is of, and its other dimensions.
std::string section_around(std::string_view path) {
  for (const SectionKind* kind : section_kinds()) {
    const std::span<const Field> dimensions = kind->dimensions();
    const auto is_it = [&](const Field& field) { return field.path == path; };
    const bool of_word = path == "section.shape" && kind->word() == "circle";
    if (!of_word && std::ranges::none_of(dimensions, is_it)) continue;
    std::string text =
        of_word ? std::string() : "section.shape = '" + std::string(kind->word()) + "'\n";
    for (const Field& field : dimensions) {
      if (is_it(field)) continue;
      const double value = std::get<double>(field.get(plastica::Setup{}));
      text += std::string(field.path) + " = '" + std::to_string(value) + " m'\n";
    }
    return text;
  }
  return {};
}

std::string scene_around(std::string_view path) {
  if (path == "beam.shape") {
    return kChain + "beam.points = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '1 m']]\n";
  }
  if (path == "beam.arc_angle") return kChain + "beam.shape = 'arc'\n";
  if (path.starts_with("section.") && path != "section.shear_coefficient") {
    return section_around(path) + "drive.strain = [0]\n";
  }
  for (const HardeningKind* kind : hardening_kinds()) {
    for (const Field& field : kind->parameters()) {
      if (field.path != path) continue;
      return "drive.strain = [0]\nmaterial.hardening.law = '" + std::string(kind->word()) + "'\n";
    }
  }
  const std::string motion = "solver.analysis = 'dynamics'\n" + kChain;
  if (path == "solver.damping") return motion + "solver.damping_time = '1 s'\n";
  if (path == "solver.damping_time") return motion + "solver.damping = 'stiffness'\n";
  const bool of_chain = path.starts_with("gravity.") || path == "solver.level" ||
                        path == "solver.analysis" || path == "solver.precision" ||
                        path == "solver.buckling" || path == "solver.frequencies" ||
                        path == "rules.yield_model" || path == "rules.hinge_length" ||
                        path.starts_with("rules.break_limit");
  return of_chain ? kChain : "drive.strain = [0]\n";
}

class SceneFileWithTable : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("scene_") + test->name() + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  plastica::Setup read_here(const std::string& strain) const {
    return parse_scene_file("[drive]\nstrain = " + strain, path("s.toml")).setup;
  }
  std::string error_here(const std::string& strain) const {
    std::string text = message_of([&] { (void)read_here(strain); });
    for (auto at = text.find(folder_); at != std::string::npos; at = text.find(folder_)) {
      text.erase(at, folder_.string().size() + 1);
    }
    return text;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST(SceneFile, TakesDefaultsForWhatItDoesNotSay) {
  const plastica::Setup setup = read_scene(kDrive);
  const plastica::Setup defaults;
  EXPECT_EQ(setup.scene.name, "s");
  EXPECT_EQ(setup.scene.drive.strain, (std::vector<double>{0.0, 0.01}));
  for (const Field& field : fields())
    EXPECT_EQ(field.get(setup), field.get(defaults)) << field.path;
  ASSERT_EQ(setup.scene.probes.size(), 1U);
  EXPECT_EQ(setup.scene.probes[0].quantity, ProbeQuantity::Stress);
}

TEST(SceneFile, TakesAnOldKeyAndNamesTheNewOne) {
  const SceneFile old = parse_scene_file(kDrive + "[solver]\nmost_iterations = 7\n", "s.toml");
  EXPECT_EQ(old.setup.solver.max_iterations, 7);
  EXPECT_EQ(old.notes,
            (std::vector<std::string>{"s.toml:4: most_iterations is now max_iterations"}));
  EXPECT_TRUE(parse_scene_file(kDrive, "s.toml").notes.empty());
}

TEST(SceneFile, ReadsEveryFieldOfTheFieldTable) {
  // Shapes that need all of their dimensions are read below.
  const auto needed = [](const Field& field) {
    return section_kind(SectionShape::Numbers).needs(field) && field.path.starts_with("section.") &&
           field.get(plastica::Setup{}) == FieldValue{0.0};
  };
  for (const Field& field : fields()) {
    if (needed(field)) continue;
    std::string value;
    FieldValue wanted;
    if (field.kind == FieldKind::Choice) {
      // The last word, except where other fields would have to follow suit.
      std::string word(field.choices.back());
      if (field.path == "rules.formulas") word = "report";
      if (field.path == "section.shape") word = "circle";
      if (field.path == "material.hardening.law") word = "linear";
      value = '"' + word + '"';
      wanted = word;
    } else {
      const double number = field.range.contains(2.0) ? 2.0 : 0.25;
      // A hole must be smaller than the section around it.
      const double fitting = field.path.starts_with("section.inner") ? 0.03125 : number;
      value = '"' + std::to_string(fitting) + " " + std::string(si_unit(field.dimension)) + '"';
      if (field.kind == FieldKind::Integer) value = "2";
      wanted = fitting;
    }
    if (field.material && is_of_table(*field.material)) continue;
    if (field.path.starts_with("material.rate.")) continue;
    const plastica::Setup setup =
        read_scene(scene_around(field.path) + std::string(field.path) + " = " + value);
    EXPECT_EQ(field.get(setup), wanted) << field.path;
  }
}

TEST(SceneFile, ReadsARateLaw) {
  const auto rate_of = [](const std::string& keys) {
    return read_scene("[material.rate]\n" + keys + kDrive).scene.material.rate;
  };
  const RateDependence steel = rate_of(
      "law = 'cowper_symonds'\nreference_rate = '40.4 1/s'\nexponent = 5\n"
      "strain_rate = '0.1 1/s'\n");
  EXPECT_EQ(steel.law, RateLaw::CowperSymonds);
  EXPECT_EQ(steel.reference_rate, 40.4);
  EXPECT_EQ(steel.exponent, 5.0);
  EXPECT_EQ(steel.strain_rate, 0.1);
  const RateDependence alloy = rate_of(
      "law = 'johnson_cook'\nreference_rate = '1 1/s'\ncoefficient = 0.015\n"
      "strain_rate = '20 1/s'\n");
  EXPECT_EQ(alloy.law, RateLaw::JohnsonCook);
  EXPECT_EQ(alloy.coefficient, 0.015);
}

TEST(SceneFile, ReadsATableOfHardening) {
  const Hardening h = read_scene(
                          "[material.hardening]\nlaw = 'multilinear'\n"
                          "plastic_strain = ['0.2 %', 0.01]\n"
                          "flow_stress = ['380 MPa', '0.4 GPa']\nkinematic_fraction = 0.25\n" +
                          kDrive)
                          .scene.material.hardening;
  EXPECT_EQ(h.law, HardeningLaw::Multilinear);
  EXPECT_DOUBLE_EQ(h.plastic_strain[0], 0.002);
  EXPECT_DOUBLE_EQ(h.plastic_strain[1], 0.01);
  EXPECT_EQ(h.plastic_strain[2], 0.0);
  EXPECT_DOUBLE_EQ(h.flow_stress[0], 380e6);
  EXPECT_DOUBLE_EQ(h.flow_stress[1], 400e6);
  EXPECT_EQ(h.kinematic_fraction, 0.25);
}

TEST(SceneFile, ReadsShapesThatNeedAllOfTheirDimensions) {
  const Section i = read_scene(
                        "[section]\nshape = 'i_section'\nwidth = '60 mm'\n"
                        "height = '100 mm'\nflange_thickness = '8 mm'\n"
                        "web_thickness = '5 mm'\nfillet_radius = '7 mm'\n" +
                        kDrive)
                        .scene.section;
  EXPECT_EQ(i.shape, SectionShape::ISection);
  EXPECT_DOUBLE_EQ(i.flange_thickness, 0.008);
  EXPECT_DOUBLE_EQ(i.web_thickness, 0.005);
  EXPECT_DOUBLE_EQ(i.fillet_radius, 0.007);
  const SectionNumbers n =
      read_scene(
          "[section]\nshape = 'numbers'\narea = '20 cm^2'\n"
          "second_moment_x = '400 cm^4'\nsecond_moment_y = '100 cm^4'\n"
          "section_modulus_x = '80 cm^3'\nsection_modulus_y = '25 cm^3'\n"
          "plastic_section_modulus_x = '89 cm^3'\nplastic_section_modulus_y = '40 cm^3'\n"
          "torsion_constant = '7 cm^4'\ntorsion_modulus = '8 cm^3'\n"
          "plastic_torsion_modulus = '12 cm^3'\n" +
          kDrive)
          .scene.section.numbers;
  EXPECT_DOUBLE_EQ(n.area, 20e-4);
  EXPECT_DOUBLE_EQ(n.second_moment_y, 100e-8);
  EXPECT_DOUBLE_EQ(n.plastic_section_modulus_y, 40e-6);
  EXPECT_DOUBLE_EQ(n.torsion_constant, 7e-8);
  EXPECT_DOUBLE_EQ(n.plastic_torsion_modulus, 12e-6);
}

/// The default of one dimension beside the others would be a beam that nobody has.
TEST(SceneFileErrors, ASectionThatLacksADimensionIsRefused) {
  const auto refusal = [](const std::string& section) {
    return message_of([&] {
      (void)parse_scene_file("drive = { strain = ['0 %', '1 %'] }\n[section]\n" + section,
                             "s.toml");
    });
  };
  EXPECT_EQ(refusal("shape = 'rectangle'\nwidth = '20 mm'\n"),
            "s.toml:2: section.height: is missing: shape = \"rectangle\" needs it");
  EXPECT_EQ(refusal("height = '20 mm'\n"),
            "s.toml:2: section.width: is missing: shape = \"rectangle\" needs it");
  EXPECT_EQ(refusal("shape = 'circle'\n"),
            "s.toml:2: section.radius: is missing: shape = \"circle\" needs it");
  // A region has the beam's shape, of which it need say what differs alone.
  const auto region = [](const std::string& section) {
    return message_of([&] {
      (void)parse_scene_file(
          kChain + "[[region]]\nfrom = 0.5\nto = 1.0\nsection = { " + section + " }\n", "s.toml");
    });
  };
  EXPECT_EQ(region("width = '20 mm'"), "no error");
  EXPECT_TRUE(region("shape = 'circle'")
                  .ends_with("section.radius: is missing: shape = \"circle\" "
                             "needs it"));
}

TEST(SceneFile, TakesANamedMaterialAsTheBase) {
  const plastica::Setup shorthand = read_scene("material = '6061-T6'\n" + kDrive);
  EXPECT_EQ(shorthand.scene.material.name, "6061-T6");
  EXPECT_EQ(shorthand.scene.material.youngs_modulus, 68.9e9);
  const plastica::Setup changed =
      read_scene("[material]\nyield_stress = '300 MPa'\nname = '6061-T6'\n" + kDrive);
  EXPECT_EQ(changed.scene.material.youngs_modulus, 68.9e9);
  EXPECT_DOUBLE_EQ(changed.scene.material.yield_stress, 300e6);
}

TEST(SceneFile, ReadsSamplesWithAndWithoutUnits) {
  EXPECT_EQ(read_scene("[drive]\nstrain = [0, '1 %', 0.02]").scene.drive.strain,
            (std::vector<double>{0.0, 0.01, 0.02}));
}

TEST(SceneFile, RunsStraightOverTurningPoints) {
  const auto strain = read_scene(
                          "[drive]\nstrain = { turning_points = ['2 %', 0.02, '-2 %'], "
                          "points_between = 3 }")
                          .scene.drive.strain;
  ASSERT_EQ(strain.size(), 9U);
  EXPECT_EQ(strain[0], 0.0);
  EXPECT_DOUBLE_EQ(strain[1], 0.005);
  EXPECT_EQ(strain[4], 0.02);
  EXPECT_DOUBLE_EQ(strain[6], 0.0);
  EXPECT_EQ(strain[8], -0.02);
  EXPECT_EQ(read_scene("[drive]\nstrain = { turning_points = [0.01] }").scene.drive.strain.size(),
            52U);
}

TEST(SceneFile, ReadsProbes) {
  const plastica::Setup setup = read_scene(kDrive +
                                           "[[probe]]\nkind = 'load'\n[[probe]]\nname = 'used'\n"
                                           "kind = 'accumulated_strain'\n");
  ASSERT_EQ(setup.scene.probes.size(), 2U);
  EXPECT_EQ(setup.scene.probes[0].name, "load");
  EXPECT_EQ(setup.scene.probes[0].quantity, ProbeQuantity::Load);
  EXPECT_EQ(setup.scene.probes[1].name, "used");
  EXPECT_EQ(setup.scene.probes[1].quantity, ProbeQuantity::AccumulatedStrain);
}

TEST_F(SceneFileWithTable, ReadsAColumnBesideTheFile) {
  write("d.csv", "Time (s),Strain (%)\n0,0\n1,0.5\n2,1\n");
  const std::vector<double> wanted{0.0, 0.005, 0.01};
  EXPECT_EQ(read_here("{ table = 'd.csv', column = 'Strain' }").scene.drive.strain, wanted);
  EXPECT_EQ(read_here("{ table = 'd.csv', column = 2 }").scene.drive.strain, wanted);
  EXPECT_EQ(read_here("{ table = 'd.csv', column = 2, unit = '1', override_unit = true }")
                .scene.drive.strain,
            (std::vector<double>{0.0, 0.5, 1.0}));
  EXPECT_EQ(
      error_here("{ table = 'd.csv', column = 2, unit = '1' }"),
      "s.toml:2: drive.strain.column = 1: contradicts d.csv, where \"Strain\" is in %: "
      "correct one of them, or let this one go before (override_unit = true, --override-unit)");
}

TEST_F(SceneFileWithTable, RefusesATableOrColumnThatIsNotThere) {
  write("d.csv", "Strain\n0\n1\n2\n");
  EXPECT_EQ(error_here("{ table = 'e.csv', column = 'Strain' }"),
            "s.toml:2: drive.strain.table = e.csv: is not a file in the folder of s.toml");
  EXPECT_EQ(error_here("{ table = 'd.csv', column = 'Stress' }"),
            "s.toml:2: drive.strain.column = Stress: is not a column of d.csv, which has 1 column: "
            "Strain");
}

TEST_F(SceneFileWithTable, RefusesAColumnWithGaps) {
  write("d.csv", "t,Strain\n0,0\n1,NaN\n2,1\n");
  EXPECT_EQ(error_here("{ table = 'd.csv', column = 'Strain' }"),
            "d.csv:3: Strain = NaN: must be a number");
}

TEST(SceneFileErrors, AnUnknownMaterialIsRefusedWithTheListOfNames) {
  const std::string rule =
      "must be one of S235, S275, S355, 42CrMo4, 1.4301, 6061-T6, 6082-T6, 2024-T3, 7075-T6, C24";
  EXPECT_EQ(scene_error("material = 'S999'\n" + kDrive), "s.toml:1: material = S999: " + rule);
  EXPECT_EQ(scene_error("[material]\nname = 'S999'\n" + kDrive),
            "s.toml:2: material.name = S999: " + rule);
}

TEST(SceneFileErrors, AFieldOutOfRangeIsRefusedAsItIsWritten) {
  EXPECT_EQ(scene_error("[material]\nyield_stress = '-5 MPa'\n" + kDrive),
            "s.toml:2: material.yield_stress = -5 MPa: must be above 0 Pa");
  EXPECT_EQ(scene_error("[beam]\nsegments = 2.5\n" + kDrive),
            "s.toml:2: beam.segments = 2.5: must be an integer");
}

TEST(SceneFileErrors, AChoiceThatIsNoneIsRefused) {
  EXPECT_EQ(scene_error("[section]\nshape = 'round'\n" + kDrive),
            "s.toml:2: section.shape = round: must be one of rectangle, circle, round_tube, "
            "rectangular_tube, i_section, numbers");
}

TEST(SceneFileErrors, FieldsThatContradictEachOtherAreRefused) {
  EXPECT_EQ(scene_error("[rules]\nformulas = 'report'\nyield_cap = 'fully_plastic'\n" + kDrive),
            "s.toml:3: rules.yield_cap = fully_plastic: Wendelius' caps are at first yield");
}

TEST(SceneFileErrors, AnUnknownKeyIsRefusedWithTheNearestField) {
  EXPECT_EQ(scene_error("[material]\nyeild_stress = '5 MPa'\n" + kDrive),
            "s.toml:2: material.yeild_stress = '5 MPa': is not a key of material; did you mean "
            "yield_stress?");
}

TEST(SceneFileErrors, ASceneWithoutADriveIsRefused) {
  EXPECT_EQ(
      scene_error("name = 'x'\n"),
      "s.toml: support: is missing: a scene needs [[support]] and loads, or a [drive]; a beam "
      "in free flight needs solver.analysis = \"dynamics\"");
  EXPECT_EQ(scene_error("[drive]\n"), "s.toml:1: drive.strain: is missing");
  EXPECT_EQ(scene_error("[drive]\nstrain = []\n"),
            "s.toml:2: drive.strain = []: must have at least one sample");
}

TEST(SceneFileErrors, ADriveOfNoKnownKindIsRefused) {
  EXPECT_EQ(scene_error("[drive]\nstrain = 0.1\n"),
            "s.toml:2: drive.strain = 0.1: must be a list of strains, { table, column } or "
            "{ turning_points }");
  EXPECT_EQ(scene_error("[drive]\nstrain = { turning_point = [1] }\n"),
            "s.toml:2: drive.strain.turning_point = [1]: is not a key of drive.strain; did you "
            "mean turning_points?");
  EXPECT_EQ(scene_error("[drive]\nstrain = {}\n"),
            "s.toml:2: drive.strain = {}: must have either table and column, or turning_points");
  EXPECT_EQ(scene_error("[drive]\nstrain = ['1 MPa']\n"),
            "s.toml:2: drive.strain[1] = 1 MPa: \"MPa\" is not a unit of strain (examples: %, 1, "
            "mm/mm, um/m)");
}

TEST(SceneFileErrors, TwoProbesOfOneNameAreRefused) {
  EXPECT_EQ(scene_error(kDrive + "[[probe]]\nkind = 'load'\n[[probe]]\nkind = 'load'\n"),
            "s.toml:6: probe[2].kind = load: is the name of another probe, too");
  EXPECT_TRUE(scene_error(kDrive + "[[probe]]\nkind = 'forces'\n")
                  .starts_with("s.toml:4: probe[1].kind = 'forces': must be one of \"strain\", "
                               "\"stress\", \"plastic_strain\", "));
  EXPECT_EQ(scene_error(kDrive + "[[probe]]\nquantity = 'stress'\n"),
            "s.toml:4: probe[1].quantity = stress: is called kind");
}

}  // namespace
}  // namespace plastica::io
