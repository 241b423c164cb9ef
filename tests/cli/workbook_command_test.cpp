#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/command.hpp"
#include "tests/support/workbook_file.hpp"

// Curves and tables of specimens in Excel workbooks.

namespace plastica::testing {
namespace {

std::string number(double value) { return nlohmann::json(value).dump(); }

/// 200 GPa, ideal plasticity: elongation of 80 mm in mm, force on 50 mm^2 in kN.
std::string sheet_of(double yield) {
  std::vector<std::vector<SheetCell>> rows{{text_cell("S0"), text_cell("50 mm²")},
                                           {text_cell("L0"), text_cell("80 mm")},
                                           {},
                                           {text_cell("Dehnung"), text_cell("Kraft")},
                                           {text_cell("mm"), text_cell("kN")}};
  for (int i = 0; i < 200; ++i) {
    const double strain = 5e-5 * i;
    const double stress = std::min(200e3 * strain, yield);
    rows.push_back({number_cell(number(80.0 * strain)), number_cell(number(0.05 * stress))});
  }
  return sheet_xml(rows);
}

double yield_of(const Workplace& place) {
  const auto fit = nlohmann::json::parse(place.read("fit.json")).at("fits").at(0);
  return fit.at("parameters").at("yield_stress").at("value").get<double>();
}

TEST(WorkbookCommand, InspectsAndFitsTheSheetOfACurve) {
  const Workplace place;
  write_workbook(place.path("one.xlsx").string(),
                 {{"Info", sheet_xml({{text_cell("Kunde")}})}, {"Probe", sheet_of(300.0)}});
  const CommandResult seen = place.run({"inspect", "one.xlsx"});
  EXPECT_EQ(seen.code, 0) << seen.err;
  for (const char* said : {"of the sheet Probe", "elongation (name, unit)", "force (name, unit)",
                           "gauge_length = \"80 mm\"", "area = \"50 mm^2\""}) {
    EXPECT_NE(seen.out.find(said), std::string::npos) << said << '\n' << seen.out;
  }
  // The block runs as it stands.
  place.write("fit.toml", seen.out.substr(seen.out.find("[[target]]")));
  const CommandResult fitted = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_NEAR(yield_of(place), 300e6, 300.0);
}

TEST(WorkbookCommand, AsksWhichOfSeveralSheets) {
  const Workplace place;
  write_workbook(place.path("two.xlsx").string(),
                 {{"Probe 1", sheet_of(300.0)}, {"Probe 2", sheet_of(320.0)}});
  const CommandResult which = place.run({"calibrate", "two.xlsx"});
  EXPECT_EQ(which.code, 2);
  EXPECT_EQ(which.err,
            "plastica: two.xlsx: sheet: must be named, as several have a table of numbers: Probe 1 "
            "(200 rows), Probe 2 (200 rows)\n");
  const CommandResult seen = place.run({"inspect", "two.xlsx", "--sheet", "Probe 2"});
  EXPECT_NE(seen.out.find("sheet = \"Probe 2\""), std::string::npos) << seen.out;
  const CommandResult fitted =
      place.run({"calibrate", "two.xlsx", "--sheet", "Probe 2", "--json", "fit.json"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_NEAR(yield_of(place), 320e6, 320.0);
  EXPECT_NE(fitted.out.find("two:Probe 2: fitted"), std::string::npos) << fitted.out;
  EXPECT_EQ(place.run({"calibrate", "two.xlsx", "--sheet", "Probe 3"}).code, 2);
}

TEST(WorkbookCommand, TakesTheTableOfSpecimensFromAWorkbook) {
  const Workplace place;
  std::string curve = "Strain,Force\n";
  for (int i = 0; i < 200; ++i) {
    const double strain = 5e-5 * i;
    curve += number(strain) + "," + number(100.0 * std::min(200e3 * strain, 300.0)) + "\n";
  }
  place.write("a.csv", curve);
  write_workbook(place.path("info.xlsx").string(),
                 {{"Maße", sheet_xml({{text_cell("Name"), text_cell("S0 [mm^2]")},
                                      {text_cell("a"), number_cell("100")}})}});
  place.write("fit.toml",
              "[[target]]\nfiles = 'a.csv'\nstrain = { column = 'Strain', unit = '1' }\n"
              "force = { column = 'Force', unit = 'N' }\narea = { from = 'S0' }\n"
              "table = { file = 'info.xlsx', key = 'Name', sheet = 'Maße' }\n");
  const CommandResult fitted = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_NEAR(yield_of(place), 300e6, 300.0);
}

/// What is kept of the table with the result is read as the table was.
TEST(WorkbookCommand, TakesTheMarkThatIsGivenForATable) {
  const Workplace place;
  std::string curve = "Strain,Force\n";
  for (int i = 0; i < 200; ++i) {
    const double strain = 5e-5 * i;
    curve += number(strain) + "," + number(1.25 * std::min(200e3 * strain, 300.0)) + "\n";
  }
  place.write("a.csv", curve);
  write_workbook(place.path("info.xlsx").string(),
                 {{"A", sheet_xml({{text_cell("Name"), text_cell("S0 [mm^2]")},
                                   {text_cell("a"), text_cell("1,250")}})}});
  const std::string fit =
      "[[target]]\nfiles = 'a.csv'\nstrain = {{ column = 'Strain', unit = '1' }}\n"
      "force = {{ column = 'Force', unit = 'N' }}\narea = {{ from = 'S0' }}\n"
      "table = {{ file = 'info.xlsx', key = 'Name'{} }}\n";
  place.write("fit.toml", fmt::format(fmt::runtime(fit), ""));
  const CommandResult asks = place.run({"calibrate", "fit.toml"});
  EXPECT_EQ(asks.code, 2);
  EXPECT_NE(asks.err.find("decimal: must be given: numbers such as 1,250"), std::string::npos)
      << asks.err;
  place.write("fit.toml", fmt::format(fmt::runtime(fit), ", decimal = ','"));
  const CommandResult fitted = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_NEAR(yield_of(place), 300e6, 300.0);
}

/// One specimen a sheet: each has a name and a row of its own.
TEST(WorkbookCommand, TakesEachSheetForASpecimen) {
  const Workplace place;
  write_workbook(place.path("w.xlsx").string(), {{"S1", sheet_of(300.0)}, {"S2", sheet_of(300.0)}});
  place.write("info.csv", "key,S0 [mm^2],L0 [mm]\nw,1,80\nw:S1,50,80\nS2,100,80\n");
  const std::string block =
      "[[target]]\nfiles = 'w.xlsx'\nsheet = '{}'\nelongation = {{ column = 'Dehnung' }}\n"
      "force = {{ column = 'Kraft' }}\narea = {{ from = 'S0' }}\ngauge_length = {{ from = 'L0' }}\n"
      "table = {{ file = 'info.csv', key = 'key' }}\n";
  place.write("fit.toml",
              fmt::format(fmt::runtime(block), "S1") + fmt::format(fmt::runtime(block), "S2"));
  const CommandResult fitted = place.run({"calibrate", "fit.toml", "--json", "fit.json"});
  EXPECT_EQ(fitted.code, 0) << fitted.err << fitted.out;
  const auto fits = nlohmann::json::parse(place.read("fit.json")).at("fits");
  ASSERT_EQ(fits.size(), 2U);
  const auto yield = [&](std::size_t i) {
    return fits.at(i).at("parameters").at("yield_stress").at("value").get<double>();
  };
  EXPECT_EQ(fits.at(0).at("name"), "w:S1");
  EXPECT_NEAR(yield(0), 300e6, 300.0);
  EXPECT_EQ(fits.at(1).at("name"), "w:S2");
  EXPECT_NEAR(yield(1), 150e6, 300.0);
}

}  // namespace
}  // namespace plastica::testing
