#include "tests/cli/bad_input.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kScene =
    "[material]\n"                                     // 1
    "name = 'S355'\n"                                  // 2
    "yield_stress = '370 MPa'\n"                       // 3
    "[section]\n"                                      // 4
    "shape = 'rectangle'\n"                            // 5
    "width = '20 mm'\n"                                // 6
    "height = '40 mm'\n"                               // 7
    "[beam]\n"                                         // 8
    "segments = 10\n"                                  // 9
    "[drive]\n"                                        // 10
    "deformation = 'tension'\n"                        // 11
    "strain = { turning_points = ['1 %', '-1 %'] }\n"  // 12
    "[[probe]]\n"                                      // 13
    "kind = 'strain'\n"                                // 14
    "[[probe]]\n"                                      // 15
    "kind = 'stress'\n";                               // 16

BadInput edit(std::string name, const std::string& from, const std::string& to,
              const std::string& line) {
  return bad_scene(std::move(name), changed(kScene, from, to), line, {{"mine.csv", "my own"}});
}

BadInput output(std::string name, std::vector<std::string> options, std::string line) {
  options.insert(options.begin(), {"simulate", "scene.toml", "-o"});
  return {std::move(name),
          {{"scene.toml", kScene}, {"mine.csv", "my own"}},
          std::move(options),
          std::move(line)};
}

class BadScene : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadScene, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    File, BadScene,
    ::testing::Values(
        BadInput{"Missing",
                 {},
                 {"simulate", "scene.toml"},
                 "scene.toml: cannot be read: No such file or directory"},
        edit("UnknownMaterial", "S355", "S356",
             "2: material.name = S356: must be one of S235, S275, S355, …"),
        edit("ValueOutOfRange", "370 MPa", "-370 MPa",
             "3: material.yield_stress = -370 MPa: must be above 0 Pa"),
        edit("UnknownShape", "rectangle", "square",
             "5: section.shape = square: must be one of rectangle, circle, round_tube, "
             "rectangular_tube, i_section, numbers"),
        edit("UnknownProfile", "shape = 'rectangle'\nwidth = '20 mm'\nheight = '40 mm'",
             "profile = 'IPE 210'",
             "5: section.profile = IPE 210: is no profile that is known: IPE 80 to 600, HEA 100 to "
             "1000, HEB 100 to 1000"),
        edit("ProfileWithAHeight", "shape = 'rectangle'\nwidth = '20 mm'", "profile = 'IPE 200'",
             "6: section.height = 40 mm: does not go with profile, which has all dimensions: "
             "leave one"),
        edit("ISectionWithoutFlanges", "'rectangle'", "'i_section'",
             "4: section.flange_thickness: is missing: shape = \"i_section\" needs it"),
        edit("NumbersWithoutArea", "'rectangle'", "'numbers'",
             "6: section.width = 20 mm: is of shape = \"rectangle\", and not of shape = "
             "\"numbers\""),
        edit("CircleWithAnInnerRadius", "'rectangle'\nwidth = '20 mm'\nheight = '40 mm'",
             "'circle'\nradius = '20 mm'\ninner_radius = '10 mm'",
             "7: section.inner_radius = 10 mm: is of shape = \"round_tube\", and not of shape = "
             "\"circle\""),
        edit("ISectionWithoutAWeb", "'rectangle'",
             "'i_section'\nflange_thickness = '20 mm'\nweb_thickness = '2 mm'",
             "6: section.flange_thickness = 0.02: leaves no web: flanges and fillets must be below "
             "section.height = 0.04 together"),
        edit("ForgottenLaw", "[drive]", "[material.hardening]\ntangent_modulus = '1 GPa'\n[drive]",
             "11: material.hardening.tangent_modulus = 1 GPa: is of law = \"linear\", and not of "
             "law = \"ideal\""),
        edit("ForgottenRateLaw", "[drive]", "[material.rate]\nexponent = 5\n[drive]",
             "11: material.rate.exponent = 5: is of law = \"cowper_symonds\", and not of law = "
             "\"none\""),
        edit("RateLawWithoutItsReference", "[drive]",
             "[material.rate]\nlaw = 'cowper_symonds'\nexponent = 5\nstrain_rate = '1 1/s'\n"
             "[drive]",
             "10: material.rate.reference_rate: is missing: material.rate.law = "
             "\"cowper_symonds\" needs it"),
        edit("RateOfACoupon", "[drive]",
             "[material.rate]\nlaw = 'johnson_cook'\nreference_rate = '1 1/s'\n"
             "coefficient = 0.01\n[drive]",
             "10: material.rate.strain_rate: is missing: a scene at rest, or a coupon, knows no "
             "time; the rate law needs a rate that all has"),
        edit("RateInAnotherUnit", "[drive]",
             "[material.rate]\nlaw = 'johnson_cook'\nreference_rate = '1 m/s'\n[drive]",
             "12: material.rate.reference_rate = 1 m/s: \"m/s\" is not a unit of strain rate "
             "(examples: 1/s, %/min)"),
        edit("TableWithoutStress", "[drive]",
             "[material.hardening]\nlaw = 'multilinear'\nplastic_strain = [0.01, 0.02]\n"
             "flow_stress = ['400 MPa']\n[drive]",
             "13: material.hardening.flow_stress = ['400 MPa']: must have as many numbers as "
             "material.hardening.plastic_strain, 2"),
        edit(
            "TableWithoutStresses", "[drive]",
            "[material.hardening]\nlaw = 'multilinear'\nplastic_strain = [0.01]\n[drive]",
            "10: material.hardening.flow_stress_1 = 0: must be above 0: the point's plastic strain "
            "has none"),
        edit("TableWithoutStrains", "[drive]",
             "[material.hardening]\nlaw = 'multilinear'\nflow_stress = ['400 MPa']\n[drive]",
             "10: material.hardening.plastic_strain_1 = 0: must be above 0, where the stress is "
             "material.yield_stress"),
        edit("TableWithoutItsLaw", "[drive]",
             "[material.hardening]\nplastic_strain = [0.01]\nflow_stress = ['400 MPa']\n[drive]",
             "11: material.hardening.plastic_strain = [0.01]: is of law = \"multilinear\", and not "
             "of law = \"ideal\""),
        edit(
            "TableThatFallsTooSteeply", "[drive]",
            "[material.hardening]\nlaw = 'multilinear'\nplastic_strain = [0.001]\n"
            "flow_stress = ['300 MPa']\n[drive]",
            "13: material.hardening.flow_stress_1 = 3e+08: falls from 3.7e+08 more steeply than …"),
        edit("TableThatDoesNotRise", "[drive]",
             "[material.hardening]\nlaw = 'multilinear'\nplastic_strain = [0.01, 0.01]\n"
             "flow_stress = ['400 MPa', '410 MPa']\n[drive]",
             "12: material.hardening.plastic_strain_2 = 0.01: must be above the one before, 0.01"),
        edit("TableTooLong", "[drive]",
             "[material.hardening]\nlaw = 'multilinear'\n"
             "plastic_strain = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]\n[drive]",
             "12: material.hardening.plastic_strain = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]: has 11 "
             "numbers: there is room for 10"),
        edit("TableGivenTwice", "[drive]",
             "[material.hardening]\nlaw = 'multilinear'\nplastic_strain = [0.01]\n"
             "plastic_strain_1 = 0.02\n[drive]",
             "13: material.hardening.plastic_strain_1 = 0.02: is given twice: there is a list, "
             "too"),
        edit("LengthWithoutUnit", "'20 mm'", "20",
             "6: section.width = 20: a length needs a unit (examples: m, mm, in)"),
        edit("UnknownKey", "height", "heigth",
             "7: section.heigth = '40 mm': is not a key of section; did you mean height?"),
        edit("BrokenCount", "10", "1.5", "9: beam.segments = 1.5: must be an integer"),
        edit("CountOutOfRange", "10", "0", "9: beam.segments = 0: must be from 1 to 1e+07"),
        edit("UnknownDeformation", "tension", "shear",
             "11: drive.deformation = shear: must be one of tension, bending, torsion"),
        edit("StrainInMegapascal", "-1 %", "-1 MPa",
             "12: drive.strain.turning_points[2] = -1 MPa: \"MPa\" is not a unit of strain "
             "(examples: %, 1, mm/mm, um/m)"),
        edit("NoSamples", "{ turning_points = ['1 %', '-1 %'] }", "[]",
             "12: drive.strain = []: must have at least one sample"),
        edit("MissingTable", "turning_points = ['1 %', '-1 %']",
             "table = 'm.csv', column = 'Strain'",
             "12: drive.strain.table = m.csv: is not a file in the folder of scene.toml"),
        edit("UnknownProbe", "'stress'", "'stres'",
             "16: probe[2].kind = 'stres': must be one of \"strain\", \"stress\", …"),
        edit("ProbeByItsOldKey", "kind = 'stress'", "quantity = 'stress'",
             "16: probe[2].quantity = stress: is called kind"),
        edit("ProbeOfAChain", "'stress'", "'moment'",
             "16: probe[2].kind = moment: is recorded of a chain alone"),
        edit("ProbeAtAPlace", "'stress'", "'stress'\nat = 'end'",
             "17: probe[2].at = end: is of no use: a coupon is the same everywhere"),
        edit("LevelOfAChain", "segments = 10", "segments = 10\n[solver]\nlevel = 'planar'",
             "11: solver.level: must be auto or coupon in a scene with a drive"),
        edit("GravityOnACoupon", "[material]", "[gravity]\ny = '-9.81 m/s^2'\n[material]",
             "1: gravity: does not go with [drive]: a scene is a chain with supports and loads, "
             "or a coupon with a drive"),
        edit("YieldModelOfAChain", "[drive]", "[rules]\nyield_model = 'interaction'\n[drive]",
             "11: rules.yield_model = interaction: is of chains: a coupon has one stress "
             "component"),
        edit("BreakLimitOfAChain", "[drive]", "[rules]\nbreak_limit_z = '3 %'\n[drive]",
             "11: rules.break_limit_z = 3 %: is of chains: a coupon breaks at "
             "material.break_strain or material.break_shear_strain"),
        edit("HingeOfAChain", "[drive]", "[rules]\nhinge_length = '0 m'\n[drive]",
             "11: rules.hinge_length = 0 m: is of chains: a coupon has no hinge"),
        edit("CurvedCoupon", "segments = 10", "shape = 'arc'\narc_angle = '90 deg'",
             "9: beam.shape: must be straight in a scene with a drive"),
        edit("ProbeTwice", "'stress'", "'strain'",
             "16: probe[2].kind = strain: is the name of another probe, too")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Output, BadScene,
    ::testing::Values(output("OutputExists", {"mine.csv"},
                             "mine.csv: exists already: use --force to overwrite it"),
                      output("OutputInMissingFolder", {"none/out.csv"},
                             "none/out.csv: cannot be written: there is no folder none"),
                      output("OutputOverTheScene", {"scene.toml", "--force"},
                             "--output = scene.toml: is a file that this run reads")),
    name_of_case);

TEST(BadScenes, NeedADriveOrSupports) {
  expect_refusal({"",
                  {{"scene.toml", "[material]\nname = 'S355'\n"}},
                  {"simulate", "scene.toml"},
                  "scene.toml: support: is missing: a scene needs [[support]] and loads, or a "
                  "[drive]; a beam in free flight needs solver.analysis = \"dynamics\""});
}

}  // namespace
}  // namespace plastica::testing
