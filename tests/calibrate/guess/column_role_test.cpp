#include "calibrate/guess/column_role.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace plastica::calibrate {
namespace {

using enum ColumnRole;

struct Named {
  std::string_view name, unit;
  ColumnRole role;
};

TEST(ColumnRole, GoesByNamesOfFiveLanguagesAndByUnits) {
  const std::vector<Named> columns{{"Tensile strain (Strain 1)", "mm/mm", Strain},
                                   {"Dehnung", "%", Strain},
                                   {"Déformation", "", Strain},
                                   {"eps_yy", "%", Strain},
                                   {"ε", "%", Strain},
                                   {"AVE2", "%", Strain},
                                   {"DMS 1", "um/m", Strain},
                                   {"Strain", "mm", Elongation},
                                   {"Extensometer", "mm", Elongation},
                                   {"Feinwegaufnehmer", "mm", Elongation},
                                   {"Allongement", "mm", Elongation},
                                   {"Déformation", "mm", Elongation},
                                   {"Extension", "mm", Travel},
                                   {"Displacement", "mm", Travel},
                                   {"Stroke", "mm", Travel},
                                   {"Crosshead separation", "mm", Travel},
                                   {"Standardweg", "mm", Travel},
                                   {"Traversenweg absolut", "mm", Travel},
                                   {"Course standard", "mm", Travel},
                                   {"DÉPLACEMENT", "mm", Travel},
                                   {"Axial Displacement", "in", Travel},
                                   {"Corsa", "mm", Travel},
                                   {"Spannung", "MPa", Stress},
                                   {"Standard force", "MPa", Stress},
                                   {"Contrainte", "MPa", Stress},
                                   {"Esfuerzo", "", Stress},
                                   {"σ", "MPa", Stress},
                                   {"Prüfkraft", "kN", Force},
                                   {"Charge", "kN", Force},
                                   {"Fuerza", "N", Force},
                                   {"Load", "lbf", Force},
                                   {"Kanal 3", "kN", Force},
                                   {"Zeit  1 - Standardmessrate", "s", Time},
                                   {"Temps", "", Time},
                                   {"Breite", "mm", Geometry},
                                   // Other quantities, whatever else their names hold.
                                   {"Strain rate", "1/s", Other},
                                   {"Dehngeschwindigkeit", "%", Other},
                                   {"Transverse strain", "%", Other},
                                   {"Young's modulus", "MPa", Other},
                                   {"Temperature", "degC", Other},
                                   {"Axial Count", "", Other},
                                   {"Volume_Fraction", "", Other},
                                   {"Humidity", "-", Other}};
  for (const Named& column : columns) {
    EXPECT_EQ(words_of(meaning_of(column.name, column.unit).role), words_of(column.role))
        << column.name << " in " << column.unit;
  }
}

TEST(ColumnRole, SeesTravelAndTrueMeasures) {
  EXPECT_TRUE(meaning_of("Nominal strain", "%").is_travel);
  EXPECT_TRUE(meaning_of("Crosshead strain", "%").is_travel);
  EXPECT_FALSE(meaning_of("Strain", "%").is_travel);
  EXPECT_FALSE(meaning_of("Extensometer travel", "mm").is_travel);
  EXPECT_TRUE(meaning_of("Wahre Spannung", "MPa").is_true);
  EXPECT_FALSE(meaning_of("Spannung", "MPa").is_true);
}

TEST(ColumnRole, AUnitMayEndANameButAWordMayNot) {
  EXPECT_EQ(meaning_of("Stress_MPa", "").unit, "MPa");
  EXPECT_EQ(meaning_of("strain_percent", "").unit, "%");
  EXPECT_EQ(meaning_of("engineering_strain", "").unit, std::nullopt);
  EXPECT_EQ(meaning_of("stress_in", "").unit, std::nullopt);
  EXPECT_EQ(meaning_of("stress_in", "").role, Stress);
}

}  // namespace
}  // namespace plastica::calibrate
