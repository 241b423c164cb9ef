#include "tests/cli/bad_input.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kMassScene =
    "[beam]\n"                                                                // 1
    "segments = 4\n"                                                          // 2
    "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"  // 3
    "[solver]\n"                                                              // 4
    "steps = 1\n"                                                             // 5
    "[[support]]\n"                                                           // 6
    "at = 'start'\n"                                                          // 7
    "kind = 'clamp'\n"                                                        // 8
    "[gravity]\n"                                                             // 9
    "y = '-9.81 m/s^2'\n"                                                     // 10
    "[[mass]]\n"                                                              // 11
    "at = 'end'\n"                                                            // 12
    "mass = '2 kg'\n"                                                         // 13
    "inertia = ['1 kg m^2', '0 kg m^2', '0 kg m^2']\n";                       // 14

/// The scene with one piece changed, and the line that `simulate` answers with behind the file.
BadInput mass_change(std::string name, const std::string& from, const std::string& to,
                     const std::string& line) {
  return bad_scene(std::move(name), changed(kMassScene, from, to), line);
}

class BadMass : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadMass, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Mass, BadMass,
    ::testing::Values(
        mass_change("UnknownKey", "inertia", "offset",
                    "14: mass[1].offset = ['1 kg m^2', '0 kg m^2', '0 kg m^2']: is not a key of "
                    "mass[1]; its keys are at, mass, inertia"),
        mass_change("Negative", "'2 kg'", "'-2 kg'", "13: mass[1].mass = -2: must be at least 0"),
        mass_change("OfNothing", "'2 kg'\ninertia = ['1 kg m^2', '0 kg m^2', '0 kg m^2']", "'0 kg'",
                    "13: mass[1].mass = 0: must be above 0 kg, or have inertia"),
        mass_change("Missing", "mass = '2 kg'\n", "", "11: mass[1].mass: is missing"),
        mass_change("WithoutPlace", "at = 'end'\n", "", "11: mass[1].at: is missing"),
        mass_change("WithoutUnit", "'2 kg'", "2",
                    "13: mass[1].mass = 2: a mass needs a unit (examples: kg, g, t)"),
        mass_change("InAnotherUnit", "'2 kg'", "'2 N'", "13: mass[1].mass = 2 N: …"),
        mass_change("OfNegativeInertia", "'1 kg m^2'", "'-1 kg m^2'",
                    "14: mass[1].inertia = -1: must be at least 0"),
        mass_change("OfOneMoment", "['1 kg m^2', '0 kg m^2', '0 kg m^2']", "['1 kg m^2']",
                    "14: mass[1].inertia = ['1 kg m^2']: must have three components: x, y and z"),
        mass_change("OffTheBeam", "'end'", "1.5",
                    "12: mass[1].at = 1.5: must be a fraction of the length, 0 to 1"),
        mass_change("OffTheSegments", "'end'", "{ segment = 5 }",
                    "12: mass[1].at = { segment = 5 }: must be a segment from 1 to 4, or 0 for "
                    "the start"),
        mass_change("OfACoupon",
                    "[[support]]\nat = 'start'\nkind = 'clamp'\n[gravity]\ny = '-9.81 m/s^2'\n",
                    "[drive]\nstrain = [0]\n",
                    "8: mass: does not go with [drive]: a scene is a chain with supports and "
                    "loads, or a coupon with a drive"),
        mass_change("WithoutAnythingThatActs", "[gravity]\ny = '-9.81 m/s^2'\n", "",
                    " load: is missing: give a [[load]], gravity, or a support's translation or "
                    "rotation")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
