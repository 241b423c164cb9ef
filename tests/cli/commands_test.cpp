#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "plastica/base/version.hpp"
#include "plastica/model/field.hpp"
#include "sweeps/compare/closed_forms.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "tests/cli/command.hpp"
#include "tests/cli/curves.hpp"
#include "tests/support/has.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kCommands[] = {"calibrate", "inspect",    "init",   "simulate",  "sweep",
                                     "merge",     "check",      "advise", "recommend", "stability",
                                     "diff",      "show",       "plot",   "report",    "export",
                                     "fields",    "completion", "man"};

/// Runs what must succeed without a word on stderr. @return what it wrote
std::string output_of(const Workplace& place, const std::vector<std::string>& arguments) {
  const CommandResult result = place.run(arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

/// Fits two specimens into fit.h5, with its summary in fit.json.
void fit_two(const Workplace& place) {
  place.write("a.csv", broken_curve(350.0, 1));
  place.write("b.csv", broken_curve(360.0, 2));
  const CommandResult result =
      place.run({"calibrate", "a.csv", "b.csv", "--quiet", "-o", "fit.h5", "--json", "fit.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
}

TEST(Command, TellsItsVersion) {
  EXPECT_EQ(output_of(Workplace(), {"--version"}), std::string(version()) + "\n");
}

TEST(Command, HelpsWithAnExampleForEachCommand) {
  const Workplace place;
  const std::string all = output_of(place, {"--help"});
  for (const std::string command : kCommands) {
    EXPECT_TRUE(has(all, "\n  " + command + " ")) << all;
    const std::string help = output_of(place, {command, "--help"});
    const std::size_t example = help.find("Example");
    ASSERT_NE(example, std::string::npos) << help;
    EXPECT_TRUE(has(help.substr(example), "plastica " + command)) << help;
  }
}

TEST(Command, HelpsIn80ColumnsAndSaysWhatAnOptionTakes) {
  const Workplace place;
  std::string all = output_of(place, {"--help"});
  for (const std::string command : kCommands) all += output_of(place, {command, "--help"});
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_TRUE(has(all, "--output FILE"));
  EXPECT_TRUE(has(all, "--threads N"));
  EXPECT_TRUE(has(all, "--stress COLUMN[:UNIT]"));
  for (const char* type : {"TEXT ", "INT:", "UINT", "FLOAT"}) EXPECT_FALSE(has(all, type)) << type;
}

TEST(Command, ListsEveryFieldAtTheBeginningOfALine) {
  const std::string list = "\n" + output_of(Workplace(), {"fields"});
  const auto derived = sweeps::derived_fields();
  const auto forms = sweeps::closed_forms();
  // The line put before, and those of titles with blank ones before the second and third.
  EXPECT_EQ(lines_of(list), 1 + fields().size() + derived.size() + forms.size() + 5);
  const auto expect = [&](std::string_view name) {
    EXPECT_TRUE(has(list, "\n" + std::string(name) + " ")) << name;
  };
  for (const Field& field : fields()) expect(field.path);
  for (const Field& field : derived) expect(field.path);
  for (const sweeps::ClosedForm& form : forms) expect(form.name);
}

TEST(Command, InitsAFitThatRunsAsItIs) {
  const Workplace place;
  EXPECT_EQ(output_of(place, {"init", "fit"}),
            "wrote ./fit.toml\nwrote ./example-curve.csv\nnext: plastica calibrate ./fit.toml\n");
  const CommandResult fitted = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_TRUE(fitted.out.ends_with("\nfitted 1, rejected 0, failed 0\n")) << fitted.out;
  EXPECT_EQ(fitted.err, "wrote fit.h5\n");
}

TEST(Command, InitsAFitThroughASceneThatRunsAsItIs) {
  const Workplace place;
  EXPECT_EQ(output_of(place, {"init", "scene-fit"}),
            "wrote ./scene-fit.toml\nwrote ./bend_test.toml\nwrote ./bend_test.csv\n"
            "next: plastica calibrate ./scene-fit.toml\n");
  EXPECT_EQ(place.run({"simulate", "bend_test.toml"}).code, 0);
  const CommandResult fitted = place.run({"calibrate", "scene-fit.toml"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_TRUE(fitted.out.ends_with("\nfitted 1, failed 0\n")) << fitted.out;
  EXPECT_EQ(fitted.err, "wrote scene-fit.h5\n");
}

TEST(Command, InitsACouponThatRunsAsItIs) {
  const Workplace place;
  output_of(place, {"init", "coupon"});
  const CommandResult result = place.run({"simulate", "coupon.toml"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with(
      "sample,drive [1],strain [1],stress [Pa],plastic_strain [1]\n0,0,0,0,0\n"))
      << result.out;
  EXPECT_TRUE(
      std::regex_search(result.err, std::regex("^[^\n]+: broken at sample \\d+, strain [0-9.]+")))
      << result.err;
  EXPECT_EQ(place.run({"simulate", "coupon.toml", "-o", "out.csv"}).code, 0);
  EXPECT_EQ(place.read("out.csv"), result.out);
}

TEST(Command, InspectsACurveAndProposesATargetThatRuns) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  const std::string text = output_of(place, {"inspect", "a.csv"});
  EXPECT_TRUE(has(text, "rows, 2 columns, separated by comma, decimal point")) << text;
  EXPECT_TRUE(has(text, "correction  trim-at-break")) << text;
  const std::size_t block = text.find("[[target]]");
  ASSERT_NE(block, std::string::npos) << text;
  place.write("fit.toml", text.substr(block));
  const CommandResult fitted = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
}

TEST(Command, DryRunsWithoutWritingAnything) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  place.write("b.csv", "");
  place.write("fit.toml", fit_file("'*.csv'"));
  output_of(place, {"init", "coupon"});
  const auto before = place.contents();
  const std::string text = output_of(place, {"calibrate", "fit.toml", "--dry-run"});
  EXPECT_TRUE(has(text, "samples  ready\n")) << text;
  EXPECT_TRUE(has(text, "b.csv: is empty\n")) << text;
  EXPECT_TRUE(has(text, "2 targets, 1 to fit, algorithm auto")) << text;
  EXPECT_TRUE(has(text, "nothing was run; the result would be fit.h5\n")) << text;
  EXPECT_TRUE(has(output_of(place, {"simulate", "coupon.toml", "--dry-run", "-o", "out.csv"}),
                  "coupon.toml: level coupon: "));
  EXPECT_EQ(place.contents(), before);
}

TEST(Command, NamesTheOutputAfterTheInput) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  place.write("b.csv", broken_curve());
  EXPECT_EQ(place.run({"calibrate", "a.csv"}).err, "wrote a.h5\n");
  EXPECT_EQ(place.run({"calibrate", "a.csv", "b.csv"}).err, "wrote fit.h5\n");
}

TEST(Command, HoldsAFixedParameter) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  ASSERT_EQ(
      place.run({"calibrate", "a.csv", "--fix", "youngs_modulus=190 GPa", "--json", "a.json"}).code,
      0);
  const auto fit = nlohmann::json::parse(place.read("a.json")).at("fits").at(0);
  EXPECT_EQ(fit.at("parameters").at("youngs_modulus").at("value"), 190e9);
  EXPECT_EQ(fit.at("parameters").at("youngs_modulus").at("role"), "fixed");
}

TEST(Command, ShowsAllSpecimensOrOne) {
  const Workplace place;
  fit_two(place);
  const std::string all = output_of(place, {"show", "fit.h5"});
  EXPECT_TRUE(has(all, "\n  a ") && has(all, "\n  b ")) << all;
  EXPECT_FALSE(has(all, "\nParameters\n")) << all;
  EXPECT_TRUE(all.ends_with("\nfitted 2, rejected 0, failed 0\n")) << all;
  const std::string one = output_of(place, {"show", "fit.h5", "--case", "b"});
  EXPECT_TRUE(one.starts_with("b: fitted\n")) << one;
  EXPECT_TRUE(has(one, "\nParameters\n") && has(one, "  yield_stress ")) << one;
  const std::string whole = output_of(place, {"show", "fit.h5", "--all"});
  EXPECT_TRUE(has(whole, "a: fitted\n") && has(whole, one)) << whole;
}

TEST(Command, ShowsWhatCalibratePrinted) {
  const Workplace place;
  place.write("a.csv", broken_curve());
  const CommandResult fitted = place.run({"calibrate", "a.csv"});
  EXPECT_EQ(output_of(place, {"show", "a.h5"}), fitted.out);
}

TEST(Command, ExportsARowForEachSpecimenOrSample) {
  const Workplace place;
  fit_two(place);
  const std::string table = output_of(place, {"export", "fit.h5", "--to", "csv"});
  EXPECT_TRUE(table.starts_with("name,law,status,reason,file,test,measure,loading,")) << table;
  EXPECT_EQ(lines_of(table), 3U);
  EXPECT_TRUE(has(table, "\na,ideal,fitted,,a.csv,tension,") &&
              has(table, "\nb,ideal,fitted,,b.csv,tension,"))
      << table;
  const std::string curves = output_of(place, {"export", "fit.h5", "--what", "curves"});
  EXPECT_TRUE(curves.starts_with("specimen,strain [1],stress_measured [Pa],stress_fitted [Pa]\n"));
  EXPECT_GT(lines_of(curves), 200U);
  EXPECT_EQ(output_of(place, {"export", "fit.h5", "-o", "fit.csv"}), "");
  EXPECT_EQ(place.read("fit.csv"), table);
}

TEST(Command, ExportsTheJsonThatCalibrateWrites) {
  const Workplace place;
  fit_two(place);
  EXPECT_EQ(output_of(place, {"export", "fit.h5", "-o", "named.json"}), "");
  EXPECT_EQ(place.read("named.json"), output_of(place, {"export", "fit.h5", "--to", "json"}));
  EXPECT_EQ(nlohmann::json::parse(output_of(place, {"export", "fit.h5", "--to", "json"})),
            nlohmann::json::parse(place.read("fit.json")));
}

TEST(Command, WritesTheDocumentedKeysIntoTheSummary) {
  const Workplace place;
  fit_two(place);
  const auto summary = nlohmann::json::parse(place.read("fit.json"));
  ASSERT_EQ(summary.at("fits").size(), 2U);
  for (const auto& fit : summary.at("fits")) {
    for (const char* key :
         {"name", "status", "characteristics", "parameters", "cost", "evaluations"}) {
      EXPECT_TRUE(fit.contains(key)) << key;
    }
    const auto& found = fit.at("characteristics");
    for (const char* key : {"youngs_modulus", "proof_stress", "rm", "strain_at_rm", "break_strain",
                            "break_strain_plastic"}) {
      EXPECT_TRUE(found.at(key).is_number()) << key;
    }
    for (const char* key : {"reh", "rel"}) EXPECT_TRUE(found.at(key).is_null()) << key;
    for (const char* name : {"youngs_modulus", "yield_stress", "break_strain"}) {
      EXPECT_TRUE(fit.at("parameters").at(name).at("value").is_number()) << name;
      EXPECT_TRUE(fit.at("parameters").at(name).at("standard_error").is_number()) << name;
    }
    EXPECT_GT(fit.at("evaluations").get<int>(), 0);
  }
  EXPECT_NEAR(summary.at("fits").at(1).at("parameters").at("yield_stress").at("value"), 360e6, 1e6);
}

}  // namespace
}  // namespace plastica::testing
