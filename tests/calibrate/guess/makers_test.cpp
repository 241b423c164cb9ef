#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "calibrate/guess/guess_file.hpp"
#include "tests/calibrate/target/curve_files.hpp"

/// Files as makers' programs and laboratories export them, each as short as it shows its kind. The
/// numbers are those of a steel: E = 200 GPa, yielding at 400 MPa, 100 mm^2, 50 mm.
namespace plastica::calibrate {
namespace {

using plastica::testing::CurveFiles;

struct Kind {
  std::string name;
  std::string head;  ///< lines above the rows
  std::string row;   ///< a row: $t time, $e strain [%], $m mm/mm, $l elongation [mm], $s MPa,
                     ///< $k kN, $n N
  std::string deformation, deformation_unit;  ///< what is wanted: the column and its unit
  std::string load, load_unit;
  std::optional<double> gauge_length{}, area{};  ///< [m], [m^2]
  std::vector<std::string> missing{};
  bool decimal_comma = false;
  double modulus = 200e9;  ///< that comes out [Pa]; 0: none
};

std::string number(double value, bool comma) {
  std::string text = std::to_string(value);
  if (comma) text[text.find('.')] = ',';
  return text;
}

std::string text_of(const Kind& kind) {
  std::string text = kind.head;
  for (int i = 0; i < 40; ++i) {
    const double strain = 0.02 * i;  // %
    const double stress = std::min(2000.0 * strain, 400.0) + 0.25 * i;
    std::string row = kind.row;
    const auto put = [&](const char* mark, double value) {
      for (std::size_t at = row.find(mark); at != std::string::npos; at = row.find(mark)) {
        row.replace(at, 2, number(value, kind.decimal_comma));
      }
    };
    put("$t", 0.1 * i);
    put("$e", strain);
    put("$m", strain / 100.0);
    put("$l", strain / 100.0 * 50.0);
    put("$s", stress);
    put("$k", stress * 0.1);
    put("$n", stress * 100.0);
    text += row + "\n";
  }
  return text;
}

class Makers : public ::testing::TestWithParam<Kind> {};

TEST_P(Makers, AreUnderstood) {
  const Kind& kind = GetParam();
  const io::CsvTable table = io::CsvTable::parse(text_of(kind), "curve.csv");
  const FileGuess guess = guess_file(table);
  ASSERT_EQ(guess.blocks.size(), 1U);
  const BlockGuess& block = guess.blocks.front();
  const TargetSource& source = block.source;
  const auto& deformation = source.strain ? source.strain : source.elongation;
  const auto& load = source.stress ? source.stress : source.force;
  ASSERT_TRUE(deformation && load);
  EXPECT_EQ(deformation->column, kind.deformation);
  EXPECT_EQ(deformation->unit.value_or(""), kind.deformation_unit);
  EXPECT_EQ(load->column, kind.load);
  EXPECT_EQ(load->unit.value_or(""), kind.load_unit);
  EXPECT_EQ(block.missing, kind.missing);
  const auto expect = [](const std::optional<SpecimenValue>& value, std::optional<double> wanted) {
    ASSERT_EQ(value.has_value(), wanted.has_value());
    if (!wanted) return;
    EXPECT_NEAR(*value->value / *wanted, 1.0, 1e-9);
  };
  expect(source.gauge_length, kind.gauge_length);
  expect(source.area, kind.area);
  // With what only the user knows the numbers come out right, whatever the columns are.
  TargetSource filled = source;
  for (const std::string& key : block.missing) {
    if (key == "area") filled.area = SpecimenValue{1e-4, {}, {}, {}};
    if (key == "gauge_length") filled.gauge_length = SpecimenValue{0.05, {}, {}, {}};
    if (key == "stress.unit") filled.stress->unit = "MPa";
    if (key == "strain.unit") filled.strain->unit = "%";
  }
  if (kind.modulus == 0.0) return;
  const CurveFiles files("makers-" + kind.name);
  filled.files = {files.write("curve.csv", text_of(kind))};
  const std::vector<Target> targets = import_targets(filled);
  ASSERT_EQ(targets.size(), 1U);
  ASSERT_TRUE(targets[0].characteristics.youngs_modulus) << targets[0].reason;
  EXPECT_NEAR(*targets[0].characteristics.youngs_modulus / kind.modulus, 1.0, 0.01);
}

const std::vector<std::string> kArea{"area"};
const std::vector<std::string> kBoth{"gauge_length", "area"};

INSTANTIATE_TEST_SUITE_P(
    Kinds, Makers,
    ::testing::Values(
        Kind{"TestXpertGerman",
             "Prüfprotokoll\nProbendicke a0;10;mm\nProbenbreite b0;10;mm\nMesslänge L0;50;mm\n\n"
             "Prüfzeit;Standardkraft;Standardweg;Dehnung (Extensometer)\ns;N;mm;%\n",
             "$t;$n;$l;$e",
             "Dehnung (Extensometer)",
             "%",
             "Standardkraft",
             "N",
             {},
             1e-4,
             {},
             true},
        Kind{"TestXpertTravelOnly",
             "\"L0\";50;\"mm\"\n\"S0\";100;\"mm²\"\n\"Standardweg\";\"Standardkraft\"\n\"mm\";"
             "\"N\"\n",
             "$l;$n",
             "Standardweg",
             "mm",
             "Standardkraft",
             "N",
             0.05,
             1e-4,
             {},
             true},
        Kind{"TestXpertStress", "Strain;Standard force\n%;MPa\n", "$e;$s", "Strain", "%",
             "Standard force", "MPa"},
        Kind{"TestXpertFrench",
             "\"Section\",100,\"mm²\"\n\"L0 - course standard\",50,\"mm\"\n\"Temps\",\"Force "
             "standard\",\"Course standard\"\n\"s\",\"N\",\"mm\"\n",
             "$t,$n,$l", "Course standard", "mm", "Force standard", "N", 0.05, 1e-4},
        Kind{
            "BluehillRaw",
            "Specimen properties : Width,10,mm,,\nSpecimen properties : Thickness,10,mm,,\n"
            "Specimen properties : Final width,9,mm,,\nSpecimen properties : Length,50,mm,,\n,,,,\n"
            "Time,Extension,Load,Tensile strain (Strain 1)\n(s),(mm),(N),(mm/mm)\n",
            "$t,$l,$n,$m",
            "Tensile strain (Strain 1)",
            "mm/mm",
            "Load",
            "N",
            {},
            1e-4},
        Kind{"BluehillExtensionOnly",
             "Specimen properties : Length,50,mm,,\nTime,Extension,Load\n(s),(mm),(kN)\n",
             "$t,$l,$k",
             "Extension",
             "mm",
             "Load",
             "kN",
             0.05,
             {},
             kArea},
        Kind{"BluehillQuoted",
             "\"Time\",\"Tensile extension\",\"Tensile stress\",\"Tensile "
             "strain\"\n\"(s)\",\"(mm)\",\"(MPa)\",\"(%)\"\n",
             "\"$t\",\"$l\",\"$s\",\"$e\"", "Tensile strain", "%", "Tensile stress", "MPa"},
        Kind{"TestWorks",
             "Width = 10 mm\nThickness = 10 mm\nCrosshead (mm)\tLoad (N)\tExtensometer (mm)\tTime "
             "(s)\n",
             "$l\t$n\t$l\t$t",
             "Extensometer",
             "mm",
             "Load",
             "N",
             {},
             1e-4,
             {"gauge_length"}},
        Kind{"TestWorksImperial",
             "Load (lbf),Strain (in/in)\n",
             "$n,$m",
             "Strain",
             "in/in",
             "Load",
             "lbf",
             {},
             {},
             kArea,
             false,
             200e9 * 4.4482216},
        Kind{"Trapezium",
             "\"Name\",\"1 _ 1\"\n\"Time\",\"Force\",\"Stroke\"\n\"sec\",\"N\",\"mm\"\n",
             "$t,$n,$l",
             "Stroke",
             "mm",
             "Force",
             "N",
             {},
             {},
             kBoth},
        Kind{"TrapeziumStressStrain", "Stress,Strain\nN/mm2,%\n", "$s,$e", "Strain", "%", "Stress",
             "N/mm2"},
        Kind{"TrapeziumStrokeStrain", "Time,Stress,Stroke Strain\nsec,MPa,%\n", "$t,$s,$e",
             "Stroke Strain", "%", "Stress", "MPa"},
        Kind{"WalterBai",
             "Probendurchmesser [mm];10\nZeit [s];Kraft [kN];Kolbenweg [mm];Längenänderung [mm]\n",
             "$t;$k;$l;$l",
             "Längenänderung",
             "mm",
             "Kraft",
             "kN",
             {},
             7.853981633974483e-05,
             {"gauge_length"},
             true,
             200e9 / 0.7853981634},
        Kind{"Catman",
             "Zeit  1 - Standardmessrate [s]\tKraft [kN]\tWeg [mm]\tDMS1 [um/m]\n",
             "$t\t$k\t$l\t$m",
             "DMS1",
             "um/m",
             "Kraft",
             "kN",
             {},
             {},
             kArea,
             true,
             200e15},
        Kind{"Mts793",
             "MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\n\nAxial Displacement\tAxial Force\tAxial "
             "Strain\tTime\nmm\tkN\tmm/mm\ts\n",
             "$l\t$k\t$m\t$t",
             "Axial Strain",
             "mm/mm",
             "Axial Force",
             "kN",
             {},
             {},
             kArea},
        Kind{"MtsElite",
             "Axial Count,Axial Displacement(mm),Axial Force(kN),Axial Strain(%)\n",
             "0,$l,$k,$e",
             "Axial Strain",
             "%",
             "Axial Force",
             "kN",
             {},
             {},
             kArea},
        Kind{"GomCorrelate",
             "Time [s];Technical strain Y [%];Force [kN]\n",
             "$t;$e;$k",
             "Technical strain Y",
             "%",
             "Force",
             "kN",
             {},
             {},
             kArea},
        Kind{"VicGauge",
             "\"eyy [1] - engr.\",\"Load [N]\",\"eps_yy [%]\"\n",
             "$t,$n,$e",
             "eps_yy",
             "%",
             "Load",
             "N",
             {},
             {},
             kArea},
        Kind{"Comments", "# gauge length = 50 mm\n# area: 100 mm^2\n# Elongation (mm), Load (N)\n",
             "$l,$n", "Elongation", "mm", "Load", "N", 0.05, 1e-4},
        Kind{"PercentComments",
             "% from rig 3\n% Section: 100 mm^2\nStrain [%],Force [N]\n",
             "$e,$n",
             "Strain",
             "%",
             "Force",
             "N",
             {},
             1e-4},
        Kind{"BlankSeparated", "Rig 3\n  Time (s)   Axial Strain (%)    Stress (MPa)\n",
             "  $t   $e   $s", "Axial Strain", "%", "Stress", "MPa"},
        Kind{"NoHeader", "", "$t,$e,$s", "2", "", "3", "", {}, {}, {"strain.unit", "stress.unit"}},
        Kind{"NoUnits",
             "strain,stress\n",
             "$m,$s",
             "strain",
             "",
             "stress",
             "",
             {},
             {},
             {"stress.unit"}},
        Kind{"UnitsInNames", "strain_percent,stress_MPa\n", "$e,$s", "strain_percent", "%",
             "stress_MPa", "MPa"},
        Kind{"SlashUnits",
             "Dehnung / %;Kraft / kN\n",
             "$e;$k",
             "Dehnung",
             "%",
             "Kraft",
             "kN",
             {},
             {},
             kArea,
             true},
        Kind{"Spanish",
             "Tiempo (s);Desplazamiento (mm);Fuerza (N)\n",
             "$t;$l;$n",
             "Desplazamiento",
             "mm",
             "Fuerza",
             "N",
             {},
             {},
             kBoth,
             true},
        Kind{"Italian",
             "Allungamento (mm);Forza (kN)\n",
             "$l;$k",
             "Allungamento",
             "mm",
             "Forza",
             "kN",
             {},
             {},
             kBoth,
             true},
        Kind{"French",
             "Déformation (%);Contrainte (MPa)\n",
             "$e;$s",
             "Déformation",
             "%",
             "Contrainte",
             "MPa",
             {},
             {},
             {},
             true},
        Kind{"DiameterColumn",
             "Load (N),Strain (%),Diameter (mm),Final Diameter (mm)\n",
             "$n,$e,10,8",
             "Strain",
             "%",
             "Load",
             "N",
             {},
             7.853981633974483e-05,
             {},
             false,
             200e9 / 0.7853981634},
        Kind{"BothMeasures",
             "true_strain,true_stress_MPa,engineering_strain,engineering_stress_MPa\n",
             "$m,$s,$m,$s", "engineering_strain", "", "engineering_stress_MPa", "MPa"},
        Kind{"Thousands",
             "Dehnung [%];Prüfkraft [N]\n",
             "$e;1.234,5",
             "Dehnung",
             "%",
             "Prüfkraft",
             "N",
             {},
             {},
             kArea,
             true,
             0.0},
        Kind{"TransverseToo", "Transverse strain [%],Axial strain [%],Stress [MPa]\n", "$e,$e,$s",
             "Axial strain", "%", "Stress", "MPa"},
        Kind{"NominalStrain", "Nominal strain [%],Stress [MPa],Strain [%]\n", "$e,$s,$e", "Strain",
             "%", "Stress", "MPa"}),
    [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace plastica::calibrate
