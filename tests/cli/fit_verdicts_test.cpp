#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/command.hpp"
#include "tests/cli/curves.hpp"

// What `plastica calibrate` says of how well curves determine parameters: the printed word, that of
// the JSON summary and the number behind both.

namespace plastica::testing {
namespace {

using Json = nlohmann::json;

/// SYNTHETIC: 1.5 strain up to the yield stress, then with the slope of the tangent, in MPa, 100
/// samples of strain 0 to 1 and a roughness of cosines: as ../shared/data/synthetic-bilinear. The
/// last sample is the largest of a straight line.
std::string bilinear_curve(double yield, double tangent, double noise) {
  std::string text = "strain,stress\n";
  for (int i = 0; i < 100; ++i) {
    const double e = i / 99.0, first = yield / 1.5;
    const double stress = e < first ? 1.5 * e : yield + tangent * (e - first);
    text += fmt::format("{:.17g},{:.17g}\n", e, stress + noise * std::cos(12.9898 * (99 - i)));
  }
  return text;
}

std::string bilinear_fit(const std::string& yield, const std::string& fit = "") {
  return "[fit]\n" + fit +
         "\n[fit.parameters]\nyoungs_modulus = { value = \"1.5 MPa\", fixed = true }\n"
         "yield_stress = " +
         yield +
         "\n[[target]]\nfiles = \"a.csv\"\n"
         "strain = { column = \"strain\", unit = \"1\" }\n"
         "stress = { column = \"stress\", unit = \"MPa\" }\n";
}

/// The fit of the only target as JSON; `out` gets what was printed.
Json calibrated(const Workplace& place, std::string& out,
                const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"calibrate", "fit.toml", "--json", "fit.json", "-o", "fit.h5"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const CommandResult result = place.run(arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  out = result.out;
  return Json::parse(place.read("fit.json")).at("fits").at(0);
}

/// The line of a table that begins with a word.
std::string line_of(const std::string& text, const std::string& word) {
  const std::size_t at = text.find("\n  " + word);
  if (at == std::string::npos) return {};
  return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

bool says(const std::string& line, const std::string& part) {
  return line.find(part) != std::string::npos;
}

TEST(FitVerdicts, SayThatALinearCurveDoesNotShowTheYieldStress) {
  const Workplace place;
  place.write("a.csv", bilinear_curve(10.0, 0.0, 0.01));
  place.write("fit.toml", bilinear_fit("{ bounds = [\"0.1 MPa\", \"9 MPa\"] }"));
  std::string out;
  const Json fit = calibrated(place, out, {"--profile", "--bootstrap", "40"});
  EXPECT_TRUE(says(line_of(out, "yield_stress"), "not identified")) << out;
  EXPECT_TRUE(says(out, "! yield_stress is not identified: the curves do not depend on it")) << out;
  const Json& yield = fit.at("parameters").at("yield_stress");
  EXPECT_EQ(yield.at("verdict"), "not identified");
  EXPECT_TRUE(yield.at("verdict_number").is_null());
  EXPECT_FALSE(yield.at("identified"));
  EXPECT_TRUE(yield.at("standard_error").is_null());
  // Below the last stresses the curve excludes it, above it says nothing.
  const Json& profile = fit.at("intervals").at("profile").at("yield_stress");
  EXPECT_EQ(profile.at("ends"), Json({"crossed", "bound"}));
  EXPECT_GT(profile.at("interval").at(0), 1.4e6);
  EXPECT_LT(profile.at("interval").at(0), 1.5e6);
  EXPECT_EQ(profile.at("interval").at(1), 9e6);
  const std::size_t intervals = out.find("Intervals of 95 %");
  ASSERT_NE(intervals, std::string::npos) << out;
  EXPECT_TRUE(says(line_of(out.substr(intervals), "yield_stress"), "… bound")) << out;
  EXPECT_TRUE(says(out, "bound: it has not, up to the parameter's bound")) << out;
}

TEST(FitVerdicts, SayThatABoundBites) {
  const Workplace place;
  place.write("a.csv", bilinear_curve(0.1, 0.0, 1e-3));
  place.write("fit.toml", bilinear_fit("{ bounds = [\"0.01 MPa\", \"0.09 MPa\"] }"));
  std::string out;
  const Json fit = calibrated(place, out, {"--profile"});
  EXPECT_TRUE(says(line_of(out, "yield_stress"), "at bound, upper 0.09 MPa")) << out;
  EXPECT_TRUE(says(out, "! yield_stress is at its upper bound")) << out;
  const Json& yield = fit.at("parameters").at("yield_stress");
  EXPECT_EQ(yield.at("verdict"), "at bound");
  EXPECT_DOUBLE_EQ(yield.at("verdict_number").get<double>(), 9e4);
  EXPECT_EQ(yield.at("at_upper"), true);
  const Json& profile = fit.at("intervals").at("profile").at("yield_stress");
  EXPECT_EQ(profile.at("ends"), Json({"crossed", "bound"}));
  EXPECT_DOUBLE_EQ(profile.at("interval").at(1).get<double>(), 9e4);
}

TEST(FitVerdicts, SayThatTheSamplingLimitsABreak) {
  const Workplace place;
  // 200 GPa, 350 MPa: finely sampled up to 0.3 %, then every 0.1 %; it breaks between 2.1 and 2.2
  // %.
  std::string curve = "Strain (%),Stress (MPa)\n";
  for (int i = 0; i < 36; ++i) {
    const double strain = i < 15 ? 0.02 * i : 0.3 + 0.1 * (i - 15);
    const double stress = std::min(2000.0 * strain, 350.0) + 0.2 * ((i * 37) % 11 - 5);
    curve += fmt::format("{:.2f},{:.2f}\n", strain, strain < 2.15 ? stress : 0.0);
  }
  place.write("a.csv", curve);
  place.write("fit.toml", fit_file("\"a.csv\""));
  std::string out;
  const Json fit = calibrated(place, out, {"--profile", "--bootstrap", "400"});
  EXPECT_TRUE(says(line_of(out, "break_strain"), "limited by sampling, ± 2.5 %")) << out;
  EXPECT_TRUE(says(out,
                   "! break_strain is limited by sampling: the break lies between two "
                   "samples"))
      << out;
  const Json& limit = fit.at("parameters").at("break_strain");
  EXPECT_EQ(limit.at("verdict"), "limited by sampling");
  // Half the distance of two samples over the value; 95 % of a break anywhere between them.
  const double value = limit.at("value").get<double>();
  EXPECT_NEAR(limit.at("verdict_number").get<double>(), 0.0005 / value, 1e-3 * 0.0005 / value);
  EXPECT_NEAR(limit.at("interval_high").get<double>() - value, 0.95 * 0.0005, 0.02 * 0.0005);
  const Json& intervals = fit.at("intervals");
  const Json& profile = intervals.at("profile").at("break_strain").at("interval");
  EXPECT_NEAR(profile.at(1).get<double>() - profile.at(0).get<double>(), 1.9 * 0.0005,
              0.02 * 0.0005);
  const Json& bootstrap = intervals.at("bootstrap").at("parameters").at("break_strain");
  EXPECT_NEAR(bootstrap.at("standard_error").get<double>(), 0.0005 / std::sqrt(3.0), 0.05 * 0.0005);
}

TEST(FitVerdicts, AreTheSameFromTheResultFile) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  place.write("fit.toml",
              fit_file("\"a.csv\"", "profile = true\nbootstrap = 40\nbootstrap_block = 2"));
  std::string out;
  const Json fit = calibrated(place, out);
  EXPECT_EQ(fit.at("intervals").at("bootstrap").at("block"), 2);
  EXPECT_EQ(place.run({"show", "fit.h5"}).out, out);
  EXPECT_EQ(place.run({"export", "fit.h5", "--to", "json"}).out, place.read("fit.json"));
  const std::string table = place.run({"export", "fit.h5", "--to", "csv"}).out;
  EXPECT_TRUE(says(table, "fit.yield_stress.profile_low [Pa]")) << table;
  for (const char* what : {"profile", "bootstrap"}) {
    const CommandResult drawn =
        place.run({"plot", "fit.h5", "--what", what, "-o", std::string(what) + ".gp"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
  }
  EXPECT_TRUE(says(place.read("profile.gp"), "least cost"));
  EXPECT_TRUE(says(place.read("bootstrap.gp"), "percentiles"));
}

TEST(FitVerdicts, AndIntervalsHaveTheSameBytesForAnyThreads) {
  const Workplace place;
  for (int i = 0; i < 4; ++i) {
    place.write(fmt::format("{}.csv", i), broken_curve(340.0 + 5.0 * i, i));
  }
  place.write("fit.toml", fit_file("\"*.csv\""));
  for (const char* threads : {"1", "3"}) {
    const CommandResult result =
        place.run({"calibrate", "fit.toml", "--profile", "--bootstrap", "40",
                   "--bootstrap-specimens", "100", "--threads", threads, "--json",
                   std::string(threads) + ".json", "-o", std::string(threads) + ".h5"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(says(result.out, "95 % of the mean")) << result.out;
  }
  EXPECT_EQ(place.read("1.json"), place.read("3.json"));
}

TEST(FitVerdicts, WithoutIntervalsNothingElseIsPrinted) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  place.write("fit.toml", fit_file("\"a.csv\""));
  std::string bare, with;
  const Json plain = calibrated(place, bare);
  EXPECT_FALSE(plain.contains("intervals"));
  Json fit = calibrated(place, with, {"--profile", "--bootstrap", "40", "--force"});
  fit.erase("intervals");
  EXPECT_EQ(fit, plain);
  const std::size_t begin = with.find("\nIntervals of 95 %"), end = with.find("\nFit\n");
  ASSERT_LT(begin, end);
  EXPECT_EQ(with.substr(0, begin) + with.substr(end), bare);
}

TEST(FitVerdicts, RefuseTooFewResamples) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  place.write("fit.toml", fit_file("\"a.csv\""));
  const CommandResult result = place.run({"calibrate", "fit.toml", "--bootstrap", "5"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "plastica: bootstrap = 5: must be 0, for none, or 20 to 1000000\n");
  EXPECT_FALSE(place.has("fit.h5"));
}

/// Fibres that harden break where they do, whatever the hinge length; rounding is no slope of it.
TEST(FitVerdicts, SayThatAHingeLengthWhichMovesNoCurveIsNotIdentified) {
  const Workplace place;
  const std::string data = std::string(PLASTICA_SOURCE_DIR) + "/data/";
  place.write("fit.toml",
              "[fit]\nsegments_error = false\nstarts = 1\n[fit.parameters]\n"
              "'rules.hinge_length' = { bounds = ['2 mm', '100 mm'] }\n"
              "[[target]]\nscene = '" +
                  data + "scenes/bend_test.toml'\nfiles = '" + data +
                  "targets/bend_test.csv'\n"
                  "abscissa = { drive = 'support[2]', column = 'Displacement' }\n"
                  "ordinate = { probe = 'force', column = 'Force', factor = -1 }\n"
                  "material = { youngs_modulus = '205 GPa', yield_stress = '380 MPa', "
                  "break_strain = '3 %' }\nbeam = { segments = 32 }\n");
  const CommandResult result = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("not identified"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("weak"), std::string::npos) << result.out;
  // And the specimen broke at 2 %, less than what is held.
  EXPECT_NE(result.out.find("the fitted beam is intact where it broke"), std::string::npos)
      << result.out;
}

}  // namespace
}  // namespace plastica::testing
