#include <gtest/gtest.h>

#include "calibrate/config/read_fit_options.hpp"
#include "calibrate/config/read_parameters.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using testing::message_of;

FitOptions read(const std::string& text) {
  const auto document = io::TomlDocument::parse(text, "f.toml");
  FitOptions options = read_fit_options(document.root());
  document.root().check_unused();
  return options;
}

std::string error_of(const std::string& text) {
  return message_of([&] { read(text); });
}

/// The error of one line under [fit.parameters]; it stands on line 2.
std::string parameter_error(const std::string& line) {
  return error_of("[fit.parameters]\n" + line + "\n");
}

TEST(FitOptionsFile, AsksForIntervals) {
  const FitOptions options = read(
      "[fit]\nprofile = true\nbootstrap = 400\nbootstrap_block = 5\nbootstrap_specimens = 100\n");
  EXPECT_TRUE(options.intervals.profile);
  EXPECT_EQ(options.intervals.bootstrap, 400);
  EXPECT_EQ(options.intervals.block, 5);
  EXPECT_EQ(options.intervals.specimens, 100);
  EXPECT_EQ(error_of("[fit]\nbootstrap = 19\n"),
            "f.toml:2: fit.bootstrap = 19: must be 0, for none, or at least 20");
  EXPECT_FALSE(read("[fit]\n").intervals.profile);
}

TEST(FitOptionsFile, HasTheLibrarysDefaultsIfItIsEmpty) {
  const FitOptions options = read("");
  const FitOptions defaults;
  EXPECT_EQ(options.objective, defaults.objective);
  EXPECT_EQ(options.noise, defaults.noise);
  EXPECT_TRUE(options.weights.empty());
  EXPECT_EQ(options.break_weight, defaults.break_weight);
  EXPECT_EQ(options.algorithm, defaults.algorithm);
  EXPECT_EQ(options.stopping.local_evaluations, defaults.stopping.local_evaluations);
  EXPECT_EQ(options.seed, defaults.seed);
  EXPECT_EQ(options.confidence, defaults.confidence);
}

TEST(FitOptionsFile, FreesModulusYieldAndBreakIfItNamesNoParameter) {
  for (const std::string text : {"", "[fit]\n", "[fit.parameters]\n"}) {
    const auto parameters = read(text).parameters;
    ASSERT_EQ(parameters.size(), 3U);
    EXPECT_EQ(parameters[0].name(), "youngs_modulus");
    EXPECT_EQ(parameters[1].name(), "yield_stress");
    EXPECT_EQ(parameters[2].name(), "break_strain");
    for (const Parameter& parameter : parameters) {
      EXPECT_EQ(parameter.role, ParameterRole::Free);
      EXPECT_FALSE(parameter.lower || parameter.upper || parameter.value);
    }
    EXPECT_NO_THROW(check_parameters(parameters));
  }
}

TEST(FitOptionsFile, SetsEveryOption) {
  const FitOptions options = read(R"(
material = "6061-T6"
[fit]
objective = "least-squares"
noise = "2 MPa"
weights = [{ from = "0 %", weight = 1 }, { from = "1 %", weight = 0.2 }]
break_weight = 0.5
algorithm = "bobyqa"
seed = 7
confidence = "90 %"
[fit.stop]
global_evaluations = 0
local_evaluations = 99
parameter_tolerance = 1e-6
cost_tolerance = 0
[rules]
break_measure = "accumulated"
)");
  EXPECT_EQ(options.objective, Objective::LeastSquares);
  EXPECT_EQ(options.noise, 2e6);
  ASSERT_EQ(options.weights.size(), 2U);
  EXPECT_EQ(options.weights[0].from, 0.0);
  EXPECT_EQ(options.weights[0].weight, 1.0);
  EXPECT_DOUBLE_EQ(options.weights[1].from, 0.01);
  EXPECT_EQ(options.weights[1].weight, 0.2);
  EXPECT_EQ(options.break_weight, 0.5);
  EXPECT_EQ(options.algorithm, "bobyqa");
  EXPECT_EQ(options.seed, 7U);
  EXPECT_DOUBLE_EQ(options.confidence, 0.9);
  EXPECT_EQ(options.stopping.global_evaluations, 0);
  EXPECT_EQ(options.stopping.local_evaluations, 99);
  EXPECT_EQ(options.stopping.parameter_tolerance, 1e-6);
  EXPECT_EQ(options.stopping.cost_tolerance, 0.0);
  EXPECT_EQ(options.setup.scene.material.name, "6061-T6");
  EXPECT_EQ(options.setup.scene.break_measure, BreakMeasure::Accumulated);
}

TEST(FitOptionsFile, ReadsFreeFixedAndTiedParameters) {
  const auto parameters = read(R"(
[fit.parameters]
youngs_modulus = { value = "200 GPa", fixed = true }
yield_stress = { bounds = ["10 MPa", "2 GPa"], start = "300 MPa", scale = "linear" }
shear_yield_stress = { tie = "yield_stress", factor = 0.577 }
break_strain = { bounds = ["auto", "100 %"] }
poisson_ratio = 0.25
)")
                              .parameters;
  ASSERT_EQ(parameters.size(), 5U);
  EXPECT_EQ(parameters[0].role, ParameterRole::Fixed);
  EXPECT_DOUBLE_EQ(*parameters[0].value, 200e9);
  EXPECT_EQ(parameters[1].role, ParameterRole::Free);
  EXPECT_DOUBLE_EQ(*parameters[1].lower, 10e6);
  EXPECT_DOUBLE_EQ(*parameters[1].upper, 2e9);
  EXPECT_DOUBLE_EQ(*parameters[1].value, 300e6);
  EXPECT_EQ(parameters[1].scale, ParameterScale::Linear);
  EXPECT_EQ(parameters[1].where.line, 4);
  EXPECT_EQ(parameters[2].role, ParameterRole::Tied);
  EXPECT_EQ(parameters[2].tied_to, parameters[1].field);
  EXPECT_EQ(parameters[2].factor, 0.577);
  EXPECT_FALSE(parameters[3].lower);
  EXPECT_DOUBLE_EQ(*parameters[3].upper, 1.0);
  EXPECT_EQ(parameters[4].role, ParameterRole::Fixed);
  EXPECT_EQ(*parameters[4].value, 0.25);
  EXPECT_NO_THROW(check_parameters(parameters));
}

TEST(FitOptionsFile, ReadsPriors) {
  const auto parameters = read(
                              "[fit.parameters]\nyield_stress = { prior = { mean = '300 MPa', "
                              "standard_deviation = '20 MPa' } }\n")
                              .parameters;
  ASSERT_TRUE(parameters.at(0).prior);
  EXPECT_EQ(parameters[0].prior->mean, 300e6);
  EXPECT_EQ(parameters[0].prior->standard_deviation, 20e6);
  EXPECT_EQ(parameter_error("break_strain = { prior = { mean = 0.1, standard_deviation = 0.01 } }"),
            "f.toml:2: fit.parameters.break_strain.prior = { mean = 0.1, standard_deviation = 0.01 "
            "}: is none of a break strain, which is set, "
            "not searched");
  EXPECT_EQ(parameter_error("yield_stress = { prior = { mean = '300 MPa' } }"),
            "f.toml:2: fit.parameters.yield_stress.prior.standard_deviation: is missing");
}

TEST(FitOptionsFile, TakesAPathForAName) {
  const auto parameters = read(
                              "[fit.parameters]\n\"material.yield_stress\" = {}\n"
                              "material.hardening.tangent_modulus = { start = \"1 GPa\" }\n")
                              .parameters;
  ASSERT_EQ(parameters.size(), 2U);
  EXPECT_EQ(parameters[0].field->path, "material.yield_stress");
  EXPECT_EQ(parameters[1].field->path, "material.hardening.tangent_modulus");
  EXPECT_EQ(*parameters[1].value, 1e9);
}

TEST(FitOptionsErrors, WordsNumbersAndUnitsOfTheFitAreChecked) {
  EXPECT_EQ(error_of("[fit]\nobjective = 'squares'\n"),
            "f.toml:2: fit.objective = 'squares': must be one of \"path\", "
            "\"least-squares\"");
  EXPECT_EQ(error_of("[fit]\nobjective = 'least-squares'\nnoise = 2\n"),
            "f.toml:3: fit.noise = 2: a stress needs a unit (examples: Pa, MPa, ksi)");
  EXPECT_EQ(error_of("[fit]\nobjective = 'least-squares'\nnoise = '0 MPa'\n"),
            "f.toml:3: fit.noise = 0 MPa: must be above 0 Pa");
  EXPECT_EQ(error_of("[fit]\nnoise = '2 MPa'\n"),
            "f.toml:2: fit.noise = 2 MPa: goes with objective = \"least-squares\" alone");
  EXPECT_EQ(error_of("[fit]\nbreak_weight = -1\n"),
            "f.toml:2: fit.break_weight = -1: must be at least 0");
  EXPECT_EQ(error_of("[fit]\nseed = 1.5\n"),
            "f.toml:2: fit.seed = 1.5: must be an integer from 0 to 9223372036854775807");
  EXPECT_EQ(error_of("[fit]\nconfidence = 95\n"),
            "f.toml:2: fit.confidence = 95: must be above 0 % and below 100 %");
  EXPECT_EQ(error_of("[fit.stop]\nlocal_evaluations = 0\n"),
            "f.toml:2: fit.stop.local_evaluations = 0: must be an integer from 1 to "
            "1000000000");
  EXPECT_EQ(error_of("[fit.stop]\ncost_tolerance = 2\n"),
            "f.toml:2: fit.stop.cost_tolerance = 2: must be at least 0 and at most 1");
  EXPECT_EQ(error_of("fit = 3\n"), "f.toml:1: fit = 3: must be a table, [fit]");
}

TEST(FitOptionsErrors, AnUnknownAlgorithmIsRefusedWithTheListOfNames) {
  const std::string message = error_of("[fit]\nalgorithm = 'newton'\n");
  EXPECT_TRUE(message.starts_with("f.toml:2: fit.algorithm = 'newton': must be one of \"auto\", "))
      << message;
}

TEST(FitOptionsErrors, AnUnknownKeyIsRefused) {
  EXPECT_EQ(error_of("[fit]\nobjektive = 'path'\n"),
            "f.toml:2: fit.objektive = 'path': is not a key of fit; did you mean "
            "objective?");
  EXPECT_EQ(parameter_error("yield_stress = { bound = [1, 2] }"),
            "f.toml:2: fit.parameters.yield_stress.bound = [1, 2]: is not a key of "
            "fit.parameters.yield_stress; did you mean bounds?");
}

TEST(FitOptionsFile, TakesWeightsAsTablesOfTheirOwn) {
  const auto weights =
      read("[fit]\nobjective = 'least-squares'\n[[fit.weights]]\nfrom = 0.02\nweight = 0\n")
          .weights;
  ASSERT_EQ(weights.size(), 1U);
  EXPECT_EQ(weights[0].from, 0.02);
  EXPECT_EQ(weights[0].weight, 0.0);
}

TEST(FitOptionsErrors, WeightsAreStepsOfRisingStrainAndOfLeastSquares) {
  const auto error = [](const std::string& weights) {
    return error_of("[fit]\nobjective = 'least-squares'\nweights = " + weights + "\n");
  };
  EXPECT_EQ(error_of("[fit]\nweights = [{ from = 0, weight = 1 }]\n"),
            "f.toml:2: fit.weights = [{ from = 0, weight = 1 }]: goes with objective = "
            "\"least-squares\" alone");
  EXPECT_EQ(error("[]"),
            "f.toml:3: fit.weights = []: must have at least one { from = ..., weight = ... }");
  EXPECT_EQ(error("2"), "f.toml:3: fit.weights = 2: must be a list in brackets");
  EXPECT_EQ(error("[2]"), "f.toml:3: fit.weights[1] = 2: must be a table, { key = value, ... }");
  EXPECT_EQ(error("[{ from = 0 }]"), "f.toml:3: fit.weights[1].weight: is missing");
  EXPECT_EQ(error("[{ weight = 1 }]"), "f.toml:3: fit.weights[1].from: is missing");
  EXPECT_EQ(error("[{ from = '1 MPa', weight = 1 }]").substr(0, 38),
            "f.toml:3: fit.weights[1].from = 1 MPa:");
  EXPECT_EQ(error("[{ from = '-1 %', weight = 1 }]"),
            "f.toml:3: fit.weights[1].from = -1 %: must be at least 0: it is the size of the "
            "strain");
  EXPECT_EQ(error("[{ from = 0, weight = -1 }]"),
            "f.toml:3: fit.weights[1].weight = -1: must be at least 0");
  EXPECT_EQ(error("[{ from = 0, weight = inf }]").substr(0, 36),
            "f.toml:3: fit.weights[1].weight = in");
  EXPECT_EQ(error("[{ from = '1 %', weight = 1 }, { from = '1 %', weight = 2 }]"),
            "f.toml:3: fit.weights[2].from = 1 %: must be above that of the step before");
  EXPECT_EQ(
      error("[{ from = 0, weight = 1, until = 2 }]"),
      "f.toml:3: fit.weights[1].until = 2: is not a key of fit.weights[1]; its keys are from, "
      "weight");
}

TEST(FitOptionsErrors, AnUnknownParameterIsRefusedWithTheNearestName) {
  EXPECT_EQ(parameter_error("yeild_stress = {}"),
            "f.toml:2: fit.parameters.yeild_stress: is not the name of a parameter; did you mean "
            "yield_stress?");
  EXPECT_EQ(parameter_error("colour = {}"),
            "f.toml:2: fit.parameters.colour: is not the name of a parameter; `plastica fields` "
            "lists them");
  EXPECT_EQ(parameter_error("segments = {}"),
            "f.toml:2: fit.parameters.segments: is not a field that a fit can move");
}

TEST(FitOptionsErrors, AParameterThatIsNamedTwiceIsRefused) {
  EXPECT_EQ(parameter_error("yield_stress = {}\n\"material.yield_stress\" = {}"),
            "f.toml:3: fit.parameters.material.yield_stress: is the parameter of line 2, too");
}

TEST(FitOptionsErrors, BoundsMustBeTwoOrderedValuesInRange) {
  EXPECT_EQ(parameter_error("yield_stress = { bounds = ['2 GPa', '10 MPa'] }"),
            "f.toml:2: fit.parameters.yield_stress.bounds = ['2 GPa', '10 MPa']: the lower bound "
            "must be below the upper one");
  EXPECT_EQ(parameter_error("yield_stress = { bounds = ['2 GPa'] }"),
            "f.toml:2: fit.parameters.yield_stress.bounds = ['2 GPa']: must be two values, "
            "[lower, upper]");
  EXPECT_EQ(parameter_error("yield_stress = { bounds = '2 GPa' }"),
            "f.toml:2: fit.parameters.yield_stress.bounds = '2 GPa': must be a list in brackets");
  EXPECT_EQ(parameter_error("yield_stress = { bounds = ['0 MPa', '2 GPa'] }"),
            "f.toml:2: fit.parameters.yield_stress.bounds[1] = 0 MPa: must be above 0 Pa");
  EXPECT_EQ(parameter_error("yield_stress = { bounds = [10, '2 GPa'] }"),
            "f.toml:2: fit.parameters.yield_stress.bounds[1] = 10: a stress needs a unit "
            "(examples: Pa, MPa, ksi)");
  EXPECT_EQ(parameter_error("break_strain = { bounds = ['1 MPa', 1] }"),
            "f.toml:2: fit.parameters.break_strain.bounds[1] = 1 MPa: \"MPa\" is not a unit of "
            "strain (examples: %, 1, mm/mm, um/m)");
}

TEST(FitOptionsErrors, AStartMustBeWithinTheBounds) {
  EXPECT_EQ(parameter_error("yield_stress = { bounds = ['1 MPa', '2 MPa'], start = '3 MPa' }"),
            "f.toml:2: fit.parameters.yield_stress.start = 3 MPa: must be within the bounds");
}

TEST(FitOptionsErrors, ALogarithmicScaleNeedsPositiveBounds) {
  EXPECT_EQ(parameter_error("poisson_ratio = { bounds = [-0.5, 0.5], scale = 'logarithmic' }"),
            "f.toml:2: fit.parameters.poisson_ratio.scale = logarithmic: needs a lower bound "
            "above 0");
  EXPECT_EQ(parameter_error("poisson_ratio = { scale = 'log' }"),
            "f.toml:2: fit.parameters.poisson_ratio.scale = 'log': must be one of \"auto\", "
            "\"linear\", \"logarithmic\"");
}

TEST(FitOptionsErrors, AValueIsFixedOrNotAValue) {
  EXPECT_EQ(parameter_error("yield_stress = { value = '300 MPa' }"),
            "f.toml:2: fit.parameters.yield_stress.value = 300 MPa: needs fixed = true beside it; "
            "a free parameter's first value is its start");
  EXPECT_EQ(parameter_error("yield_stress = { fixed = true }"),
            "f.toml:2: fit.parameters.yield_stress.value: is missing");
  EXPECT_EQ(parameter_error("yield_stress = { fixed = true, value = '-1 MPa' }"),
            "f.toml:2: fit.parameters.yield_stress.value = -1 MPa: must be above 0 Pa");
  EXPECT_EQ(parameter_error("yield_stress = { fixed = 1, value = '1 MPa' }"),
            "f.toml:2: fit.parameters.yield_stress.fixed = 1: must be true or false");
  EXPECT_EQ(parameter_error("yield_stress = { fixed = true, value = '1 MPa', start = '1 MPa' }"),
            "f.toml:2: fit.parameters.yield_stress.start = 1 MPa: cannot go with fixed = true");
  EXPECT_EQ(parameter_error("yield_stress = true"),
            "f.toml:2: fit.parameters.yield_stress = true: must be a value, which fixes it, or a "
            "table such as { bounds = [...] }");
}

TEST(FitOptionsErrors, ATieMustLeadToAnotherUntiedParameterOfTheSameKind) {
  EXPECT_EQ(parameter_error("yield_stress = { tie = 'yield_stress' }"),
            "f.toml:2: fit.parameters.yield_stress.tie = yield_stress: a parameter cannot be tied "
            "to itself");
  EXPECT_EQ(parameter_error("shear_yield_stress = { tie = 'yield' }"),
            "f.toml:2: fit.parameters.shear_yield_stress.tie = yield: is not the name of a "
            "parameter");
  EXPECT_EQ(parameter_error("shear_yield_stress = { tie = 'yield_stress' }"),
            "f.toml:2: fit.parameters.shear_yield_stress.tie = yield_stress: is not one of the "
            "fit's parameters");
  EXPECT_EQ(parameter_error("shear_yield_stress = { tie = 'yield_stress' }\n"
                            "yield_stress = { tie = 'shear_yield_stress' }"),
            "f.toml:2: fit.parameters.shear_yield_stress.tie = yield_stress: is tied itself");
  EXPECT_EQ(parameter_error("break_strain = { tie = 'yield_stress' }"),
            "f.toml:2: fit.parameters.break_strain.tie = yield_stress: is a stress, break_strain "
            "a strain");
  EXPECT_EQ(parameter_error("break_shear_strain = { tie = 'break_strain', bounds = [0.1, 1] }"),
            "f.toml:2: fit.parameters.break_shear_strain.bounds = [0.1, 1]: cannot go with a tie");
  EXPECT_EQ(parameter_error("break_shear_strain = { factor = 2 }"),
            "f.toml:2: fit.parameters.break_shear_strain.factor = 2: belongs to a tie");
  EXPECT_EQ(parameter_error("break_shear_strain = { tie = 'break_strain', factor = 0 }"),
            "f.toml:2: fit.parameters.break_shear_strain.factor = 0: must not be 0");
}

TEST(FitOptionsErrors, AFitWithoutAFreeParameterIsRefused) {
  EXPECT_EQ(parameter_error("yield_stress = '300 MPa'"),
            "f.toml:1: fit.parameters: needs at least one that is free");
}

TEST(FitOptionsErrors, AMaterialMustNotBeLeftToTheLibrarysDefaults) {
  const auto check = [](const std::string& text, Deformation test) {
    return message_of([&] {
      const auto document = io::TomlDocument::parse(text, "f.toml");
      check_material_is_given(document.root(), read_fit_options(document.root()).parameters, test);
    });
  };
  const std::string yield = "[fit.parameters]\nyield_stress = {}\n";
  const std::string message =
      "f.toml:1: fit.parameters.youngs_modulus: is missing: make it a parameter, or give it in "
      "[material]";
  EXPECT_EQ(check(yield, Deformation::Tension), message);
  EXPECT_EQ(check("", Deformation::Tension), "no error");
  EXPECT_EQ(check("material = 'S355'\n" + yield, Deformation::Tension), "no error");
  EXPECT_EQ(check("[material]\nname = 'S355'\n" + yield, Deformation::Tension), "no error");
  EXPECT_EQ(check("[material]\nyoungs_modulus = '70 GPa'\n" + yield, Deformation::Bending),
            "no error");
  const std::string shear = "[fit.parameters]\nshear_modulus = {}\nshear_yield_stress = {}\n";
  EXPECT_EQ(check(shear, Deformation::Torsion), "no error");
  EXPECT_EQ(check(shear, Deformation::Tension), message);
}

}  // namespace
}  // namespace plastica::calibrate
