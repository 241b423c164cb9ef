#include "plastica/io/csv_header.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace plastica::io {
namespace {

/// "name = value unit" of each entry of header lines over a small table.
std::vector<std::string> entries_of(const std::string& lines, const std::string& rows) {
  std::vector<std::string> all;
  for (const HeaderEntry& entry : header_entries(CsvTable::parse(lines + rows, "h.csv"))) {
    std::ostringstream text;
    text << entry.name << " = " << entry.value << " " << entry.unit;
    all.push_back(text.str());
  }
  return all;
}

using All = std::vector<std::string>;
const std::string kPoints = "Strain (%),Stress (MPa)\n0.0,0.5\n0.1,20.5\n0.2,40.5\n0.3,60.5\n";
const std::string kCommas = "Dehnung (%);Spannung (MPa)\n0,0;0,5\n0,1;20,5\n0,2;40,5\n0,3;60,5\n";

TEST(HeaderEntries, AreANameANumberAndItsUnit) {
  EXPECT_EQ(entries_of("\"Section\",5.96,\"mm²\"\n", kPoints), All{"Section = 5.96 mm²"});
  EXPECT_EQ(entries_of("Breite (mm);12,5\n", kCommas), All{"Breite = 12.5 mm"});
  EXPECT_EQ(entries_of("# Gauge length: 50 mm\n", kPoints), All{"Gauge length = 50 mm"});
}

TEST(HeaderEntries, OfSeveralOnALineAreOneEach) {
  const All both{"Width = 12.5 mm", "Thickness = 6.4 mm"};
  EXPECT_EQ(entries_of("Width: 12.5 mm, Thickness: 6.4 mm\n", kPoints), both);
  EXPECT_EQ(entries_of("Width: 12.5 mm; Thickness: 6.4 mm\n", kPoints), both);
  EXPECT_EQ(entries_of("Diameter = 10 mm, L0 = 50 mm\n", kPoints),
            (All{"Diameter = 10 mm", "L0 = 50 mm"}));
  EXPECT_EQ(entries_of("Dicke: 6,4 mm; Breite: 12,5 mm\n", kCommas),
            (All{"Dicke = 6.4 mm", "Breite = 12.5 mm"}));
}

/// A number that a comma may cut, or that may be thousands, is none.
TEST(HeaderEntries, AreNoneWhereANumberMayBeAnother) {
  EXPECT_EQ(entries_of("Gauge length: 50,5 mm\n", kPoints), All{});
  EXPECT_EQ(entries_of("Area: 1,200 mm^2\n", kPoints), All{});
  EXPECT_EQ(entries_of("Fläche: 1.200 mm^2\n", kCommas), All{});
  EXPECT_EQ(entries_of("Breite: 12,500 mm\n", kCommas), All{"Breite = 12.5 mm"});
}

TEST(HeaderEntries, AreNoneOfARowOfSpecimens) {
  EXPECT_EQ(entries_of("Area [mm²];80,0;40,0\n", kCommas), All{});
}

}  // namespace
}  // namespace plastica::io
