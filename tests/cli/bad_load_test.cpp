#include "tests/cli/bad_chain_scene.hpp"

namespace plastica::testing {
namespace {

class BadLoad : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadLoad, IsRefusedInOneLine) { expect_refusal(GetParam()); }

/// A table's error names the table.
TEST(BadLoadTable, OfAHistoryInKilonewtonsIsRefused) {
  expect_refusal({"InKilonewtons",
                  {{"scene.toml", changed(kChainScene, "'ramp'",
                                          "{ table = 'f.csv', time = 't', factor = 'F' }")},
                   {"f.csv", "t [s],F [kN]\n0,0\n1,2\n"}},
                  {"simulate", "scene.toml"},
                  "f.csv: unit of F = kN: is not a unit of a pure number (examples: 1, %)"});
}

BadInput with_table(const std::string& name, const std::string& keys, const std::string& table,
                    const std::string& message) {
  return {name,
          {{"scene.toml", changed(kChainScene, "'ramp'",
                                  "{ table = 'f.csv', time = 't', factor = 'F'" + keys + " }")},
           {"f.csv", table}},
          {"simulate", "scene.toml"},
          message};
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadLoad,
    ::testing::Values(with_table("WithoutAUnitOfTime", "", "t,F\n0,0\n1,2\n",
                                 "scene.toml:20: load[1].history.time = t: has no unit in the "
                                 "header of f.csv: say time_unit = \"s\""),
                      with_table("WhoseTimeRunsBack", ", time_unit = 'ms'",
                                 "t,F\n0,0\n2,1\n1.5,2\n",
                                 "f.csv:4: t = 1.5: must rise from one to the next")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Load, BadLoad,
    ::testing::Values(
        change_chain("OfNothing", "force = ['0 N', '-100 N', '0 N']\n", "",
                     "17: load[1]: needs force or moment"),
        change_chain("InOneNumber", "['0 N', '-100 N', '0 N']", "'-100 N'",
                     "19: load[1].force = '-100 N': must be a list in brackets"),
        change_chain("WithoutUnit", "'-100 N'", "-100",
                     "19: load[1].force[2] = -100: a force needs a unit (examples: N, kN, lbf)"),
        change_chain(
            "OfAMomentInNewton", "force = ['0 N', '-100 N', '0 N']",
            "moment = ['1 N', '0 N m', '0 N m']",
            "19: load[1].moment[1] = 1 N: \"N\" is not a unit of moment (examples: N m, kN m, "
            "lbf in)"),
        change_chain(
            "SpreadInNewton", "at = 'end'\nforce", "at = 'start'\nto = 'end'\nforce",
            "20: load[1].force[1] = 0 N: \"N\" is not a unit of force per length (examples: "
            "N/m, kN/m, lbf/in)"),
        change_chain("SpreadOverNothing", "at = 'end'\nforce = ['0 N', '-100 N', '0 N']",
                     "at = 'end'\nto = 'end'\nforce = ['0 N/m', '-100 N/m', '0 N/m']",
                     "19: load[1].to = end: must lie beyond at = end"),
        change_chain("ThatFollowsAWord", "history", "follows = 'yes'\nhistory",
                     "20: load[1].follows = 'yes': must be true or false"),
        change_chain("OfUnknownKey", "history", "direction = 'y'\nhistory",
                     "20: load[1].direction = 'y': is not a key of load[1]; its keys are at, from, "
                     "to, force, "
                     "moment, follows, history"),
        change_chain(
            "OfUnknownHistory", "'ramp'", "'step'",
            "20: load[1].history = step: must be \"ramp\", \"constant\", { cycles }, "
            "{ turning_points }, { time, factor }, { smooth_step }, { period, cycles } or { table, "
            "time, factor }"),
        change_chain("OfASineWithoutEnd", "'ramp'", "{ period = '1 s' }",
                     "20: load[1].history.cycles: is missing"),
        change_chain(
            "OfASineInMetres", "'ramp'", "{ period = '1 m', cycles = 3 }",
            "20: load[1].history.period = 1 m: \"m\" is not a unit of time (examples: s, min, h)"),
        change_chain("OfASineOfNoTime", "'ramp'", "{ period = '0 s', cycles = 3 }",
                     "20: load[1].history.period = 0 s: must be above 0 s"),
        change_chain(
            "OfASineWithAnAmplitude", "'ramp'", "{ period = '1 s', cycles = 3, amplitude = 2 }",
            "20: load[1].history.amplitude = 2: is not a key of load[1].history; its keys are "
            "period, cycles, phase, offset"),
        change_chain(
            "OfAStepBackInTime", "'ramp'", "{ smooth_step = ['2 s', '1 s'] }",
            "20: load[1].history.smooth_step = ['2 s', '1 s']: must be two times, from and to, "
            "the first not before 0 and the second after it"),
        change_chain("OfAFrequency", "'ramp'", "{ frequency = '2 Hz', cycles = 3 }",
                     "20: load[1].history.frequency = 2 Hz: is not known: a sine is { period = "
                     "\"0.5 s\", cycles }"),
        change_chain(
            "OfNoTable", "'ramp'", "{ table = 'shaker.csv', time = 't', factor = 'a' }",
            "20: load[1].history.table = shaker.csv: is not a file in the folder of scene.toml"),
        change_chain("OfNoCycles", "'ramp'", "{ cycles = 0 }",
                     "20: load[1].history.cycles = 0: must be an integer from 1 to 100000"),
        change_chain(
            "OfTwoHistories", "'ramp'", "{ cycles = 2, turning_points = [1] }",
            "20: load[1].history = { cycles = 2, turning_points = [1] }: must be \"ramp\", …"),
        change_chain("WithTimesOfNoFactors", "'ramp'", "{ time = ['0 s', '1 s'] }",
                     "20: load[1].history.factor: is missing"),
        change_chain(
            "WithMoreTimesThanFactors", "'ramp'", "{ time = ['0 s', '1 s'], factor = [1] }",
            "20: load[1].history = 2 times, 1 factors: must be as many of one as of the other, "
            "and at least one"),
        change_chain("WithTimesThatRunBack", "'ramp'",
                     "{ time = ['0 s', '2 s', '1 s'], factor = [0, 1, 2] }",
                     "20: load[1].history.time = 1: must rise from one to the next"),
        change_chain(
            "WithTimesInMetres", "'ramp'", "{ time = ['0 m'], factor = [1] }",
            "20: load[1].history.time[1] = 0 m: \"m\" is not a unit of time (examples: s, min, "
            "h)"),
        change_chain("OfNoTurningPoints", "'ramp'", "{ turning_points = [] }",
                     "20: load[1].history.turning_points = []: must not be empty"),
        change_chain(
            "MisspelledHistory", "'ramp'", "{ turning_point = [1] }",
            "20: load[1].history.turning_point = [1]: is not a key of load[1].history; did you "
            "mean turning_points?"),
        change_chain("ConstantWithoutDuration", "'ramp'", "'constant'",
                     "8: solver.duration = 0: must be above 0 where every history is constant"),
        add_to_chain(
            "AndGravityInMetres", "[gravity]\ny = '-9.81 m'\n",
            "26: gravity.y = -9.81 m: \"m\" is not a unit of acceleration (examples: m/s^2, "
            "gravity)"),
        add_to_chain("AndGravityOfUnknownKey", "[gravity]\nup = '1 m/s^2'\n",
                     "26: gravity.up = '1 m/s^2': is not a key of gravity; its keys are x, y, z, "
                     "acceleration, history"),
        change_chain(
            "ThatIsGravityInOneNumber", "[beam]", "gravity = '9.81 m/s^2'\n[beam]",
            "1: gravity = 9.81 m/s^2: must be a list of x, y and z, or a table of acceleration, "
            "or x, y and z, and history")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
