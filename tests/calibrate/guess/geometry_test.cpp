#include "calibrate/guess/geometry.hpp"

#include <gtest/gtest.h>

#include <string>

namespace plastica::calibrate {
namespace {

GivenGeometry geometry_of(const std::string& lines, char separator = ',') {
  std::string rows = "Extension (mm),Load (N)\n0.0,0.5\n0.1,20.5\n0.2,40.5\n0.3,60.5\n";
  for (char& c : rows) c = c == ',' ? separator : c;
  return find_geometry(io::CsvTable::parse(lines + rows, "g.csv"));
}

double length_of(const std::string& lines, char separator = ',') {
  const GivenGeometry given = geometry_of(lines, separator);
  return given.gauge_length ? 1e3 * given.gauge_length->si : 0.0;
}

double area_of(const std::string& lines, char separator = ',') {
  const GivenGeometry given = geometry_of(lines, separator);
  return given.area ? 1e6 * given.area->si : 0.0;
}

TEST(Geometry, IsWhatTheHeaderSays) {
  EXPECT_DOUBLE_EQ(length_of("Gauge length: 50 mm\n"), 50.0);
  EXPECT_DOUBLE_EQ(length_of("L0,50,mm\n"), 50.0);
  EXPECT_DOUBLE_EQ(length_of("Initial gauge length [mm],50\n"), 50.0);
  EXPECT_DOUBLE_EQ(area_of("Querschnitt;80;mm²\n", ';'), 80.0);
  EXPECT_DOUBLE_EQ(area_of("Width: 12.5 mm, Thickness: 6.4 mm\n"), 80.0);
  EXPECT_NEAR(area_of("Diameter = 10 mm, L0 = 50 mm\n"), 78.54, 0.01);
  EXPECT_DOUBLE_EQ(length_of("Diameter = 10 mm, L0 = 50 mm\n"), 50.0);
}

/// What stands after the test, of another part, or of the machine, is no dimension of the specimen.
TEST(Geometry, IsNotThatOfAnotherThing) {
  EXPECT_DOUBLE_EQ(length_of("Gauge length at break: 57 mm\nGauge length: 50 mm\n"), 50.0);
  EXPECT_DOUBLE_EQ(area_of("Section après rupture;40;mm²\nSection initiale;80;mm²\n", ';'), 80.0);
  EXPECT_DOUBLE_EQ(area_of("Ultimate area,40,mm²\nWidth,12.5,mm\nThickness,6.4,mm\n"), 80.0);
  EXPECT_DOUBLE_EQ(area_of("Piston area: 2000 mm^2\nCross section: 80 mm^2\n"), 80.0);
  EXPECT_DOUBLE_EQ(area_of("S0;80;mm²\nOberfläche;3000;mm²\n", ';'), 80.0);
  EXPECT_DOUBLE_EQ(length_of("Lens focal length: 35 mm\n"), 0.0);
  EXPECT_DOUBLE_EQ(length_of("Total length: 200 mm\n"), 0.0);
  EXPECT_DOUBLE_EQ(length_of("Thread length,20,mm\nParallel length,60,mm\n"), 60.0);
  EXPECT_DOUBLE_EQ(area_of("Head width,20,mm\nWidth,12.5,mm\nThickness,6.4,mm\n"), 80.0);
  EXPECT_DOUBLE_EQ(length_of("Le dispositif,30,mm\n"), 0.0);
}

TEST(Geometry, IsNoneWhereTheFileContradictsItself) {
  const GivenGeometry lengths =
      geometry_of("Specimen gauge length: 60 mm\nExtensometer gauge length: 25 mm\n");
  EXPECT_FALSE(lengths.gauge_length.has_value());
  EXPECT_NE(lengths.doubt_of_length.find("Extensometer gauge length"), std::string::npos);
  const GivenGeometry areas = geometry_of("Specimen 1 area: 80 mm^2\nSpecimen 2 area: 40 mm^2\n");
  EXPECT_FALSE(areas.area.has_value());
  EXPECT_EQ(areas.doubt_of_area, "\"Specimen 1 area\" = 80 mm^2 and \"Specimen 2 area\" = 40 mm^2");
  EXPECT_FALSE(geometry_of("L0,50,mm\nLe,25,mm\n").gauge_length.has_value());
  EXPECT_DOUBLE_EQ(length_of("L0,50,mm\nGauge length,50,mm\n"), 50.0);
  const GivenGeometry tube =
      geometry_of("Inner diameter: 8 mm\nOuter diameter: 12 mm\nWall thickness: 2 mm\n");
  EXPECT_FALSE(tube.area.has_value());
  EXPECT_NE(tube.doubt_of_area.find("a tube"), std::string::npos);
}

}  // namespace
}  // namespace plastica::calibrate
