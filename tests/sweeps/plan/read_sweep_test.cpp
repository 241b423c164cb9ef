#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plastica/model/numbered_place.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {
namespace {

std::vector<double> numbers(const Axis& axis) {
  std::vector<double> out;
  for (const FieldValue& value : axis.values) out.push_back(std::get<double>(value));
  return out;
}

Sweep one_axis(const std::string& lines) {
  return cantilever_sweep("[[axis]]\n" + lines + "\n" + kTipError);
}

TEST(ReadSweep, TakesListsWithUnits) {
  const Sweep sweep = one_axis("field = 'material.youngs_modulus'\nvalues = ['70 GPa', '210 GPa']");
  ASSERT_EQ(sweep.axes.size(), 1U);
  EXPECT_EQ(sweep.axes[0].field->path, "material.youngs_modulus");
  EXPECT_EQ(numbers(sweep.axes[0]), (std::vector<double>{70e9, 210e9}));
  EXPECT_EQ(sweep.name, "test");
  EXPECT_EQ(sweep.inputs.size(), 2U);
}

TEST(ReadSweep, TakesAnOldQuantityAndNamesTheNewOne) {
  const auto of = [](const std::string& word) {
    return cantilever_sweep(segments_axis("[4, 8]") + "[error]\nquantity = '" + word + "'\n");
  };
  const Sweep old = of("ledger_error"), now = of("energy_balance_error");
  EXPECT_EQ(old.quantity.kind, QuantityKind::EnergyBalanceError);
  EXPECT_EQ(old.quantity.name, now.quantity.name);
  EXPECT_TRUE(now.notes.empty());
  ASSERT_EQ(old.notes.size(), 1U);
  EXPECT_TRUE(old.notes[0].ends_with(": ledger_error is now energy_balance_error")) << old.notes[0];
}

TEST(ReadSweep, TakesAnOldFieldAndNamesTheNewOne) {
  const Sweep axis = one_axis("field = 'solver.most_iterations'\nvalues = [20, 25]");
  EXPECT_EQ(axis.axes[0].field->path, "solver.max_iterations");
  ASSERT_EQ(axis.notes.size(), 1U);
  EXPECT_TRUE(axis.notes[0].ends_with(": solver.most_iterations is now solver.max_iterations"));
  const Sweep set = cantilever_sweep("[set]\nsolver.most_iterations = 20\n" +
                                     segments_axis("[4, 8]") + kTipError);
  EXPECT_EQ(set.axes[0].field->path, "solver.max_iterations");
  EXPECT_EQ(set.notes.size(), 1U);
}

TEST(ReadSweep, FindsAFieldByItsLastPart) {
  EXPECT_EQ(one_axis("field = 'segments'\nvalues = [4]").axes[0].field->path, "beam.segments");
}

TEST(ReadSweep, TakesAnOptionalFieldThatIsNotSet) {
  const Sweep sweep = one_axis("field = 'rules.hinge_length'\nvalues = ['unset', '0 m']");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(sweep.axes[0].values[0]));
  EXPECT_FALSE(CaseTable(sweep).setup(0).scene.hinge_length.has_value());
  EXPECT_EQ(CaseTable(sweep).setup(1).scene.hinge_length, 0.0);
}

TEST(ReadSweep, DividesARangeEvenlyOrByRatios) {
  const auto linear =
      one_axis("field = 'beam.length'\nlinear = { from = '1 m', to = '3 m', count = 5 }");
  EXPECT_EQ(numbers(linear.axes[0]), (std::vector<double>{1.0, 1.5, 2.0, 2.5, 3.0}));
  const auto ratios = numbers(
      one_axis("field = 'solver.time_step'\nlogarithmic = { from = '1 ms', to = '1 s', count = 4 }")
          .axes[0]);
  ASSERT_EQ(ratios.size(), 4U);
  EXPECT_DOUBLE_EQ(ratios[1], 1e-2);
  EXPECT_DOUBLE_EQ(ratios[2], 1e-1);
  EXPECT_EQ(ratios[3], 1.0);
}

TEST(ReadSweep, RoundsIntegersAndKeepsEachOnce) {
  const Sweep sweep =
      one_axis("field = 'beam.segments'\nlogarithmic = { from = 2, to = 8, count = 9 }");
  EXPECT_EQ(numbers(sweep.axes[0]), (std::vector<double>{2, 3, 4, 5, 6, 7, 8}));
}

TEST(ReadSweep, CrossesAxesWithTheFirstOneSlowest) {
  const Sweep sweep = cantilever_sweep(
      segments_axis("[4, 8, 16]") +
      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n" + kTipError);
  const CaseTable cases(sweep);
  ASSERT_EQ(cases.size(), 6U);
  EXPECT_EQ(cases.position(3), (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(cases.setup(3).scene.beam.segments, 8);
  EXPECT_EQ(cases.setup(3).scene.end_rule, EndRule::Equal);
}

TEST(ReadSweep, MovesZippedAxesTogether) {
  const Sweep sweep = cantilever_sweep(
      "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8]\nzip = 'a'\n"
      "[[axis]]\nfield = 'solver.steps'\nvalues = [1, 2, 3]\n"
      "[[axis]]\nfield = 'solver.fibres'\nvalues = [10, 20]\nzip = 'a'\n" +
      kTipError);
  const CaseTable cases(sweep);
  ASSERT_EQ(cases.size(), 6U);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const plastica::Setup setup = cases.setup(i);
    EXPECT_EQ(setup.solver.fibres, setup.scene.beam.segments == 4 ? 10 : 20);
  }
}

TEST(ReadSweep, RepeatsValuesOfZippedAxes) {
  const Sweep sweep = cantilever_sweep(
      "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 4]\nzip = 'a'\n"
      "[[axis]]\nfield = 'solver.steps'\nvalues = [1, 2]\nzip = 'a'\n" +
      kTipError);
  EXPECT_EQ(CaseTable(sweep).size(), 2U);
}

TEST(ReadSweep, DividesABeamOfTheLengthThatAnotherAxisSets) {
  const Sweep sweep = cantilever_sweep(
      "[[axis]]\nfield = 'beam.segment_depth'\nvalues = [0.5]\n"
      "[[axis]]\nfield = 'beam.slenderness'\nvalues = [8]\n" +
      kTipError);
  const plastica::Setup setup = CaseTable(sweep).setup(0);
  EXPECT_DOUBLE_EQ(setup.scene.beam.length, 0.16);
  EXPECT_EQ(setup.scene.beam.segments, 16);
}

TEST(ReadSweep, SamplesItsAxesTogetherAndTheSameForASeed) {
  const std::string axes =
      "[[axis]]\nfield = 'material.youngs_modulus'\nsampled = ['100 GPa', '200 GPa']\n"
      "[[axis]]\nfield = 'beam.length'\nsampled = ['1 m', '100 m']\nspacing = 'logarithmic'\n" +
      kTipError;
  for (const std::string method : {"latin_hypercube", "sobol"}) {
    const std::string sample = "[sample]\nmethod = '" + method + "'\ncount = 64\nseed = 3\n";
    const Sweep sweep = cantilever_sweep(sample + axes);
    EXPECT_EQ(CaseTable(sweep).size(), 64U);
    auto lengths = numbers(sweep.axes[1]);
    EXPECT_EQ(lengths, numbers(cantilever_sweep(sample + axes).axes[1]));
    // Half of them below the middle of the logarithms.
    EXPECT_EQ(std::count_if(lengths.begin(), lengths.end(), [](double l) { return l < 10.0; }), 32);
    EXPECT_GE(*std::min_element(lengths.begin(), lengths.end()), 1.0);
    EXPECT_LE(*std::max_element(lengths.begin(), lengths.end()), 100.0);
  }
}

/// How often each value comes up.
std::map<double, int> counts_of(const std::string& method, const std::string& axis) {
  const Sweep sweep = cantilever_sweep("[sample]\nmethod = '" + method + "'\ncount = 1024\n" +
                                       "[[axis]]\n" + axis + "\n" + kTipError);
  std::map<double, int> counts;
  for (const double value : numbers(sweep.axes[0])) ++counts[value];
  return counts;
}

TEST(ReadSweep, SamplesEachIntegerAlike) {
  for (const std::string method : {"latin_hypercube", "sobol"}) {
    for (const std::string ends : {"[10, 12]", "[12, 10]", "[5, 40]"}) {
      const auto counts = counts_of(method, "field = 'beam.segments'\nsampled = " + ends);
      const bool few = ends != "[5, 40]";
      ASSERT_EQ(counts.size(), few ? 3U : 36U) << ends;
      EXPECT_EQ(counts.begin()->first, few ? 10.0 : 5.0);
      EXPECT_EQ(counts.rbegin()->first, few ? 12.0 : 40.0);
      // Both methods have one point in each 1024th: an integer's part holds at most two more or
      // fewer than its share.
      for (const auto& [value, count] : counts) {
        EXPECT_NEAR(count, few ? 341.3 : 28.4, 2.0) << method << ' ' << ends << ' ' << value;
      }
    }
  }
}

TEST(ReadSweep, SamplesIntegersByTheirPartOfALogarithmicAxis) {
  for (const std::string method : {"latin_hypercube", "sobol"}) {
    const auto counts =
        counts_of(method, "field = 'solver.steps'\nsampled = [1, 3]\nspacing = 'logarithmic'");
    ASSERT_EQ(counts.size(), 3U);
    for (const auto& [value, count] : counts) {
      const double part = std::log((value + 0.5) / (value - 0.5)) / std::log(3.5 / 0.5);
      EXPECT_NEAR(count, 1024 * part, 2.0) << method << ' ' << value;
    }
  }
}

// The end of segment 5 is another place with another number of segments.
TEST(ReadSweep, RefusesPlacesThatMoveWithTheSegments) {
  Scene scene = cantilever_sweep(segments_axis("[8]") + kTipError).setup.scene;
  const SolverOptions solver;
  EXPECT_FALSE(numbered_place(scene, solver).has_value());
  scene.loads[0].at = {0.0, 0};  // the start
  EXPECT_FALSE(numbered_place(scene, solver).has_value());
  scene.loads[0].at = {0.0, 5};
  EXPECT_EQ(numbered_place(scene, solver).value_or(""), "load.at");
}

// Joints of a beam twice as long would be half as stiff; lengths that are given stay.
TEST(ReadSweep, RefusesLengthsThatGivenLengthsOfJointsDoNotFollow) {
  const io::ScratchFolder folder;
  folder.write("scene.toml",
               "beam = { length = '1 m', segments = 4, joint_lengths = ['0.25 m', '0.25 m', "
               "'0.25 m'], section = { shape = 'rectangle', width = '20 mm', height = '20 mm' } }\n"
               "material.name = 'S355'\n"
               "[[support]]\nat = 'start'\nkind = 'clamp'\n"
               "[[load]]\nat = 'end'\nforce = ['0 N', '1 N', '0 N']\n"
               "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = 'y'\n");
  const auto refusal = [&](const std::string& rest) {
    return testing::message_of([&] {
      parse_sweep("scene = 'scene.toml'\n" + rest + "\n[error]\nprobe = 'tip'\n",
                  folder.file("sweep.toml"));
    });
  };
  const std::string rule =
      "changes the beam's length, and the scene's beam.joint_lengths stay: leave these out, or "
      "vary scale.size";
  const auto axis = [](const std::string& field, const std::string& values) {
    return "[[axis]]\nfield = '" + field + "'\nvalues = " + values;
  };
  EXPECT_TRUE(refusal(axis("beam.length", "['1 m', '2 m']")).ends_with("beam.length: " + rule));
  EXPECT_TRUE(refusal(axis("beam.slenderness", "[10, 50]")).ends_with(rule));
  EXPECT_TRUE(refusal("[set]\nbeam.length = '2 m'\n" +
                      axis("material.youngs_modulus", "['70 GPa', '210 GPa']"))
                  .ends_with("beam.length: " + rule));
  EXPECT_EQ(refusal(axis("scale.size", "[1, 2]")), "no error");
  EXPECT_EQ(refusal(axis("beam.length", "['1 m']")), "no error");
}

TEST(ReadSweep, SetsFieldsForAllCases) {
  const Sweep sweep = cantilever_sweep("[set]\nrules.end_rule = 'equal'\n'solver.steps' = 3\n" +
                                       segments_axis("[4]") + kTipError);
  const plastica::Setup setup = CaseTable(sweep).setup(0);
  EXPECT_EQ(setup.scene.end_rule, EndRule::Equal);
  EXPECT_EQ(setup.solver.steps, 3);
}

TEST(ReadSweep, RefinesAlongTheFirstAxisThatCan) {
  const std::string axes = "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['equal']\n" +
                           segments_axis("[4, 8]") +
                           "[[axis]]\nfield = 'solver.steps'\nvalues = [1, 2]\n";
  EXPECT_EQ(cantilever_sweep(axes + kTipError).refined, 1U);
  EXPECT_EQ(cantilever_sweep(axes + kTipError + "along = 'solver.steps'\n").refined, 2U);
}

TEST(CaseTable, GivesIdsOfContent) {
  const auto id = [](const std::string& text) {
    return CaseTable(cantilever_sweep(text + kTipError)).id(0);
  };
  const std::string eight = id(segments_axis("[8]"));
  EXPECT_EQ(eight.size(), 16U);
  EXPECT_EQ(eight, id("# a remark\nname = 'other'\n" + segments_axis("[8, 16]")));
  EXPECT_NE(eight, id(segments_axis("[16]")));
  EXPECT_NE(eight, id("[set]\nsolver.tolerance = 1e-9\n" + segments_axis("[8]")));
  // 4 m of 20 mm: 8 segments are 25 depths long.
  EXPECT_EQ(eight, id("[[axis]]\nfield = 'beam.segment_depth'\nvalues = [25]\n"));
}

TEST(CaseTable, GivesOtherQuantitiesOtherIds) {
  const auto id = [](const std::string& error) {
    return CaseTable(cantilever_sweep(segments_axis("[8, 16]") + "[error]\n" + error)).id(0);
  };
  EXPECT_EQ(id("probe = 'tip'\n"), id("probe = 'tip'\nagainst = 'finest'\n"));
  EXPECT_NE(id("probe = 'tip'\n"), id("probe = 'tip'\ntake = 'max'\n"));
  EXPECT_NE(id("probe = 'tip'\n"), id("probe = 'clamp_moment'\n"));
  EXPECT_NE(id("quantity = 'natural_frequency'\n"),
            id("quantity = 'natural_frequency'\nmode = 2\n"));
}

struct BadSweep {
  std::string text;
  std::string line;  ///< behind the file's name
};

class BadSweepFile : public ::testing::TestWithParam<BadSweep> {};

TEST_P(BadSweepFile, IsRefusedInOneLine) {
  const std::string file = std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/test.toml";
  const std::string message =
      plastica::testing::message_of([] { cantilever_sweep(GetParam().text); });
  EXPECT_EQ(message, file + ":" + GetParam().line);
}

const std::string kAxis = "[[axis]]\nfield = 'beam.segments'\n";

INSTANTIATE_TEST_SUITE_P(
    Files, BadSweepFile,
    ::testing::Values(
        BadSweep{kAxis + "values = [8]\n",
                 " error: is missing: it names the probe or quantity that is looked at"},
        BadSweep{kAxis + kTipError,
                 "2: axis[1]: needs one of values, linear, logarithmic and sampled"},
        BadSweep{kAxis + "values = []\n" + kTipError, "4: axis[1].values = []: must not be empty"},
        BadSweep{kAxis + "values = [8, 8]\n" + kTipError,
                 "4: axis[1].values[2] = 8: is there twice"},
        BadSweep{kAxis + "values = [0]\n" + kTipError,
                 "4: axis[1].values[1] = 0: must be from 1 to 1e+07"},
        BadSweep{kAxis + "values = [8]\n" + kAxis + "values = [4]\n" + kTipError,
                 "6: axis[2].field = beam.segments: has an axis already"},
        BadSweep{kAxis + "values = [8]\n[[axis]]\nfield = 'beam.segment_depth'\nvalues = [1]\n" +
                     kTipError,
                 "6: beam.segment_depth: sets the same number as beam.segments, which has an axis"},
        BadSweep{"[set]\nbeam.length = '2 m'\n[[axis]]\nfield = 'beam.slenderness'\n"
                 "values = [10]\n" +
                     kTipError,
                 "5: beam.slenderness: sets the same number as beam.length, which has a value in "
                 "[set]"},
        BadSweep{"[set]\nbeam.length = '2 m'\nbeam.slenderness = 30\n" + kAxis + "values = [8]\n" +
                     kTipError,
                 "4: beam.slenderness: sets the same number as beam.length, which has a value in "
                 "[set]"},
        BadSweep{"[[axis]]\nfield = 'beam.segmnts'\nvalues = [8]\n" + kTipError,
                 "3: axis[1].field = beam.segmnts: is not a field; `plastica fields` lists them"},
        BadSweep{"[[axis]]\nfield = 'rules.end_rule'\nlinear = { from = 1, to = 2, count = 2 }\n" +
                     kTipError,
                 "4: axis[1].linear.from = 1: needs a field of numbers: list its words"},
        BadSweep{kAxis + "logarithmic = { from = 8, to = 8, count = 2 }\n" + kTipError,
                 "4: axis[1].logarithmic.to = 8: must differ from the other end"},
        BadSweep{kAxis + "sampled = [4, 8]\n" + kTipError,
                 " sample: is missing: an axis has sampled; it takes method, count and seed"},
        BadSweep{kAxis +
                     "values = [4, 8]\nzip = 'a'\n[[axis]]\nfield = 'solver.steps'\n"
                     "values = [1]\nzip = 'a'\n" +
                     kTipError,
                 "9: axis[2].zip = a: moves axes together that have 2 and 1 values"},
        BadSweep{kAxis + "values = [8]\n[error]\nprobe = 'top'\n",
                 "6: error.probe = top: is not a probe of the scene; it has tip, clamp_moment"},
        BadSweep{kAxis + "values = [8]\n[error]\nprobe = 'tip'\nagainst = 'theory'\n",
                 "7: error.against = theory: must be theory:NAME, reference:FILE, value:NUMBER, "
                 "finest or richardson"},
        BadSweep{kAxis + "values = [8]\n[error]\nprobe = 'tip'\nagainst = 'value:1'\n",
                 "7: error.against = 1: a length needs a unit (examples: m, mm, in)"},
        BadSweep{kAxis + "values = [8]\n[error]\nquantity = 'natural_frequency'\n"
                         "against = 'value:12 %'\n",
                 "7: error.against = 12 %: \"%\" is not a unit of frequency (examples: Hz, kHz, "
                 "1/s)"},
        BadSweep{"[[axis]]\nfield = 'rules.end_rule'\nvalues = ['equal']\n[error]\nprobe = 'tip'\n"
                 "against = 'finest'\n",
                 "7: error.against = finest: needs an axis that refines, such as beam.segments"},
        BadSweep{
            kAxis + "values = [8]\ntypo = 1\n" + kTipError,
            "5: axis[1].typo = 1: is not a key of axis[1]; its keys are field, values, linear, "
            "logarithmic, zip, sampled, spacing"}));

}  // namespace
}  // namespace plastica::sweeps
