#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/command.hpp"

/// Mistakes of units and columns, each by the command: none of them may pass without a word.
namespace plastica::testing {
namespace {

/// A tension test of a steel, 205 GPa and 370 MPa, by Ramberg and Osgood.
/// @param row  text of a row of a strain [1] and a stress [MPa]
std::string steel(const std::string& header,
                  const std::function<std::string(double, double)>& row) {
  std::string text = header + "\n";
  for (int i = 0; i <= 300; ++i) {
    const double stress = 450.0 * i / 300.0;
    const double strain = stress / 205e3 + 0.002 * std::pow(stress / 370.0, 20.0);
    text += row(strain, stress) + "\n";
  }
  return text;
}

std::string steel(const std::string& header, double strain_factor = 1.0,
                  double stress_factor = 1.0) {
  return steel(header, [=](double strain, double stress) {
    return fmt::format("{:.8g},{:.8g}", strain_factor * strain, stress_factor * stress);
  });
}

const std::string kSteelHeader = "Strain [mm/mm],Stress [MPa]";

struct Outcome {
  int code = 0;
  std::string said;    ///< on stderr
  std::string reason;  ///< of the first fit that is not usable
};

Outcome calibrated(const Workplace& place, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "calibrate");
  arguments.insert(arguments.end(), {"-o", "fit.h5", "--json", "fit.json", "--quiet", "--force"});
  const CommandResult result = place.run(arguments);
  Outcome outcome{result.code, result.err, {}};
  if (!place.has("fit.json")) return outcome;
  const auto json = nlohmann::json::parse(place.read("fit.json"));
  for (const auto& fit : json.at("fits")) {
    if (fit.at("usable") == true) continue;
    const auto& why = fit.at(fit.at("reason").is_null() ? "why_unusable" : "reason");
    outcome.reason = why.get<std::string>();
    break;
  }
  return outcome;
}

void expect_implausible(const std::vector<std::string>& arguments, const std::string& text,
                        const std::string& likely_cause) {
  const Workplace place;
  place.write("a.csv", text);
  const Outcome outcome = calibrated(place, arguments);
  EXPECT_EQ(outcome.code, 1) << outcome.said;
  EXPECT_TRUE(outcome.reason.starts_with("implausible: ")) << outcome.reason << outcome.said;
  EXPECT_NE(outcome.reason.find(likely_cause), std::string::npos) << outcome.reason;
}

TEST(Plausible, TheSteelItselfIsFitted) {
  const Workplace place;
  place.write("a.csv", steel(kSteelHeader));
  EXPECT_EQ(calibrated(place, {"a.csv"}).code, 0);
}

TEST(Plausible, AUnitThatContradictsTheHeaderIsAnError) {
  const Workplace place;
  place.write("a.csv", steel(kSteelHeader));
  const CommandResult result = place.run({"calibrate", "a.csv", "--stress", "Stress:GPa"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "plastica: stress = GPa: contradicts a.csv, where \"Stress\" is in MPa: correct one of "
            "them, or let this one go before (override_unit = true, --override-unit)\n");
}

TEST(Plausible, AnOverriddenUnitIsTakenWithAWarning) {
  const Workplace place;
  place.write("a.csv", steel("Strain [mm/mm],Stress [GPa]"));
  const CommandResult result =
      place.run({"calibrate", "a.csv", "--stress", "Stress:MPa", "--override-unit"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("! \"Stress\" is not taken in its file's unit, GPa, as you say"),
            std::string::npos)
      << result.out;
}

TEST(Plausible, AGaugeLengthThatDividesNothingIsSaid) {
  const Workplace place;
  place.write("a.csv", steel(kSteelHeader));
  const CommandResult result = place.run({"calibrate", "a.csv", "--gauge-length", "50 mm"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("a.csv: --gauge-length is of no use: the strain is read from "),
            std::string::npos)
      << result.err;
}

// A steel of 20 GPa: its gauge length is ten times too short.
TEST(Plausible, AGaugeLengthTenTimesTooShortIsNamed) {
  const Workplace place;
  place.write("a.csv", steel("Elongation [mm],Force [N]", 50.0, 120.0));
  const auto with_gauge = [&](const char* length) {
    return place
        .run({"calibrate", "a.csv", "--gauge-length", length, "--area", "120 mm^2", "--force"})
        .out;
  };
  const std::string warning = "below that of every structural metal";
  const std::string out = with_gauge("5 mm");
  EXPECT_NE(out.find(warning), std::string::npos) << out;
  EXPECT_NE(out.find("gauge length"), std::string::npos) << out;
  EXPECT_EQ(with_gauge("50 mm").find(warning), std::string::npos);
  // Of several specimens it is no letter in a table alone.
  place.write("b.csv", place.read("a.csv"));
  const std::string of_both = place
                                  .run({"calibrate", "a.csv", "b.csv", "--gauge-length", "5 mm",
                                        "--area", "120 mm^2", "--force"})
                                  .out;
  const std::size_t heading = of_both.find("\nWarnings of all specimens\n");
  ASSERT_NE(heading, std::string::npos) << of_both;
  EXPECT_NE(of_both.find("structural metal", heading), std::string::npos) << of_both;
}

TEST(Plausible, StressesAThousandTimesTooLarge) {
  expect_implausible({"a.csv"}, steel("Strain [mm/mm],Stress [GPa]"),
                     "stress looks a thousand times too large");
}

TEST(Plausible, FractionsThatAreCalledPercent) {
  expect_implausible({"a.csv"}, steel("Strain [%],Stress [MPa]"), "is it a fraction, not in %?");
}

TEST(Plausible, PercentThatAreCalledFractions) {
  for (const std::string unit : {"-", "mm/mm"}) {
    expect_implausible({"a.csv"}, steel("Strain [" + unit + "],Stress [MPa]", 100.0),
                       "strain looks a hundred times too large: is it in %?");
  }
}

TEST(Plausible, AGaugeLengthInMetres) {
  expect_implausible({"a.csv", "--gauge-length", "50 m", "--area", "120 mm^2"},
                     steel("Elongation [mm],Force [N]", 50.0, 120.0),
                     "is the gauge length in mm, not m?");
}

TEST(Plausible, AnAreaInSquareCentimetres) {
  expect_implausible({"a.csv", "--gauge-length", "50 mm", "--area", "120 cm^2"},
                     steel("Elongation [mm],Force [N]", 50.0, 120.0),
                     "is the area in mm^2, not cm^2?");
}

TEST(Plausible, TravelThatIsTakenForStrain) {
  expect_implausible({"a.csv"},
                     steel(kSteelHeader,
                           [](double strain, double stress) {
                             return fmt::format("{:.8g},{:.8g}", strain + stress / 8000.0, stress);
                           }),
                     "the strain may be crosshead travel");
}

TEST(Plausible, OneFileOfThreeInKilopascalDoesNotEnterTheMean) {
  const Workplace place;
  place.write("a.csv", steel(kSteelHeader));
  place.write("b.csv", steel(kSteelHeader, 1.0, 1.01));
  place.write("c.csv", steel(kSteelHeader, 1.0, 0.99e-3));
  const Outcome outcome = calibrated(place, {"a.csv", "b.csv", "c.csv"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.reason.find("a thousand times too small"), std::string::npos) << outcome.reason;
  const auto json = nlohmann::json::parse(place.read("fit.json"));
  const auto& modulus = json["groups"][0]["characteristics"]["youngs_modulus"];
  EXPECT_EQ(modulus["n"], 2);
  EXPECT_NEAR(modulus["mean"].get<double>(), 206e9, 1e9);
}

/// What passes alone is told by its group: a polymer a hundred times too stiff.
TEST(Plausible, OneFileThatIsOffItsGroup) {
  const Workplace place;
  for (const auto& [name, factor] : {std::pair("a.csv", 1e-2), {"b.csv", 1.01e-2}, {"c.csv", 0.3}})
    place.write(name, steel(kSteelHeader, 4.0, factor));
  const Outcome outcome = calibrated(place, {"a.csv", "b.csv", "c.csv"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.reason.find("the median of its 3 specimens"), std::string::npos)
      << outcome.reason;
}

TEST(Plausible, AnotherMaterialThanTheOneThatIsNamed) {
  const Workplace place;
  place.write("a.csv", steel(kSteelHeader));
  place.write("fit.toml",
              "material = '6061-T6'\n[fit.parameters]\nyield_stress = {}\n[[target]]\n"
              "files = 'a.csv'\nstrain = 'Strain'\nstress = 'Stress'\n");
  const Outcome outcome = calibrated(place, {"fit.toml"});
  EXPECT_EQ(outcome.code, 1) << outcome.said;
  EXPECT_NE(outcome.reason.find("is off the expected"), std::string::npos) << outcome.reason;
}

TEST(Plausible, WhatTheUserAcceptsIsFitted) {
  const Workplace place;
  place.write("a.csv", steel("Strain [mm/mm],Stress [GPa]"));
  EXPECT_EQ(calibrated(place, {"a.csv", "--accept"}).code, 0);
  const std::string fit = "[[target]]\nfiles = 'a.csv'\nstrain = 'Strain'\nstress = 'Stress'\n";
  for (const std::string plausible :
       {"accept = true", "youngs_modulus = ['1 GPa', '1e6 GPa']\nductile_modulus = '1e6 GPa'\n"}) {
    place.write("fit.toml", fit + "[target.plausible]\n" + plausible + "\n");
    const Outcome outcome = calibrated(place, {"fit.toml"});
    EXPECT_EQ(outcome.code, 0) << outcome.said << outcome.reason;
  }
}

TEST(Plausible, TheBoundsArePrintedBeforeARun) {
  const Workplace place;
  place.write("a.csv", steel(kSteelHeader));
  const CommandResult result = place.run({"calibrate", "a.csv", "--dry-run"});
  EXPECT_NE(result.out.find("plausible: Young's modulus 0.1 MPa to 1300 GPa, "), std::string::npos)
      << result.out;
}

/// A beam's curve in a unit that the user insists on.
TEST(Plausible, ABeamsMisfitOfMoreThanHalfIsNoUsableFit) {
  const Workplace place;
  place.write("bar.toml",
              "[beam]\nlength = '400 mm'\nsegments = 4\n"
              "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
              "[material]\nname = 'S355'\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
              "[[support]]\nat = 'end'\nkind = 'roller'\nhold = ['y']\n"
              "translation = ['0 mm', '-80 mm', '0 mm']\n"
              "[[probe]]\nname = 'force'\nkind = 'reaction'\nat = 'end'\ncomponent = 'y'\n");
  place.write("a.csv",
              "Displacement (mm),Force (N)\n0,0\n1,125\n2,250\n3,375\n4,500\n5,625\n6,750\n");
  const auto fit = [&](const std::string& unit) {
    return "[fit]\nparameters.youngs_modulus = { bounds = ['50 GPa', '500 GPa'] }\n"
           "[[target]]\nfiles = 'a.csv'\nscene = 'bar.toml'\n"
           "abscissa = { drive = 'support[2]', column = 'Displacement' }\n"
           "ordinate = { probe = 'force', column = 'Force', factor = -1" +
           unit + " }\n";
  };
  place.write("fit.toml", fit(""));
  EXPECT_EQ(calibrated(place, {"fit.toml"}).code, 0);
  place.write("fit.toml", fit(", unit = 'kN'"));
  EXPECT_EQ(calibrated(place, {"fit.toml"}).code, 2);
  place.write("fit.toml", fit(", unit = 'kN', override_unit = true"));
  const Outcome outcome = calibrated(place, {"fit.toml"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.reason.find("of the largest value, above 50 %"), std::string::npos)
      << outcome.reason;
}

}  // namespace
}  // namespace plastica::testing
