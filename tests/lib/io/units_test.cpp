#include "plastica/io/units.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <thread>
#include <vector>

#include "tests/lib/io/message_from.hpp"

namespace plastica::io {
namespace {

double scale(std::string_view unit, Dimension dimension) {
  const UnitConversion conversion = unit_conversion(unit, dimension);
  EXPECT_EQ(conversion.offset, 0.0) << unit;
  return conversion.scale;
}

TEST(Units, ConvertStressesToPascal) {
  EXPECT_EQ(scale("Pa", Dimension::Stress), 1.0);
  EXPECT_EQ(scale("MPa", Dimension::Stress), 1e6);
  EXPECT_EQ(scale("GPa", Dimension::Stress), 1e9);
  for (const char* unit : {"N/mm^2", "N/mm2", "N/mm²", "N mm-2"}) {
    EXPECT_EQ(scale(unit, Dimension::Stress), 1e6) << unit;
  }
  // 1 lbf = 4.4482216152605 N, 1 in = 0.0254 m, both exact.
  EXPECT_NEAR(scale("psi", Dimension::Stress), 4.4482216152605 / (0.0254 * 0.0254), 1e-9);
  EXPECT_NEAR(scale("ksi", Dimension::Stress), 4448.2216152605 / (0.0254 * 0.0254), 1e-6);
}

TEST(Units, ConvertForcesLengthsAndAreas) {
  EXPECT_EQ(scale("kN", Dimension::Force), 1e3);
  EXPECT_EQ(scale("mm", Dimension::Length), 1e-3);
  EXPECT_EQ(scale("in", Dimension::Length), 0.0254);
  EXPECT_EQ(scale("mm^2", Dimension::Area), 1e-6);
  EXPECT_EQ(scale("in^2", Dimension::Area), 0.00064516);
  EXPECT_EQ(scale("1/s", Dimension::StrainRate), 1.0);
  EXPECT_EQ(scale("g/cm^3", Dimension::Density), 1e3);
  EXPECT_EQ(scale("kg/m^3", Dimension::Density), 1.0);
  EXPECT_EQ(scale("sec", Dimension::Time), 1.0);
  EXPECT_EQ(scale("1/mm", Dimension::Curvature), 1e3);
  EXPECT_DOUBLE_EQ(scale("deg/m", Dimension::Curvature), std::numbers::pi / 180.0);
}

TEST(Units, ConvertMomentsHoweverTheyAreWritten) {
  for (const char* unit : {"Nm", "N m", "N*m", "N.m", "N·m"}) {
    EXPECT_EQ(scale(unit, Dimension::Moment), 1.0) << unit;
  }
  EXPECT_EQ(scale("kNm", Dimension::Moment), 1e3);
  EXPECT_EQ(scale("Nmm", Dimension::Moment), 1e-3);
}

TEST(Units, ConvertWhatSupportsAndLoadsAreGivenIn) {
  EXPECT_EQ(scale("m/s^2", Dimension::Acceleration), 1.0);
  EXPECT_EQ(scale("gravity", Dimension::Acceleration), 9.80665);
  EXPECT_EQ(scale("kN/mm", Dimension::Stiffness), 1e6);
  EXPECT_EQ(scale("kN/m", Dimension::ForcePerLength), 1e3);
  EXPECT_EQ(scale("N m/m", Dimension::MomentPerLength), 1.0);
  EXPECT_EQ(scale("kNm/m", Dimension::MomentPerLength), 1e3);
  for (const char* unit : {"N m/rad", "Nm/rad", "N m"}) {
    EXPECT_EQ(scale(unit, Dimension::RotationalStiffness), 1.0) << unit;
  }
  for (const char* unit : {"kN m/deg", "kNm/deg", "MN mm/deg"}) {
    EXPECT_DOUBLE_EQ(scale(unit, Dimension::RotationalStiffness), 1e3 * 180.0 / std::numbers::pi)
        << unit;
  }
  EXPECT_EQ(message_from<InputError>([] { parse_quantity("5 kg", Dimension::Acceleration); }),
            "5 kg: \"kg\" is not a unit of acceleration (examples: m/s^2, gravity)");
}

TEST(Units, ConvertWhatMotionsAreGivenIn) {
  EXPECT_EQ(scale("m/s", Dimension::Velocity), 1.0);
  EXPECT_EQ(scale("mm/s", Dimension::Velocity), 1e-3);
  EXPECT_DOUBLE_EQ(scale("km/h", Dimension::Velocity), 1.0 / 3.6);
  EXPECT_EQ(scale("rad/s", Dimension::AngularVelocity), 1.0);
  EXPECT_DOUBLE_EQ(scale("deg/s", Dimension::AngularVelocity), std::numbers::pi / 180.0);
  EXPECT_EQ(message_from<InputError>([] { parse_quantity("5 m", Dimension::Velocity); }),
            "5 m: \"m\" is not a unit of velocity (examples: m/s, km/h)");
  EXPECT_EQ(message_from<InputError>([] { parse_quantity("5", Dimension::AngularVelocity); }),
            "5: an angular velocity needs a unit (examples: rad/s, deg/s)");
}

/// A turn is no radian: periods in a second and angles in a second are not taken for each other.
TEST(Units, TellFrequenciesFromAngularVelocities) {
  EXPECT_EQ(scale("Hz", Dimension::Frequency), 1.0);
  EXPECT_EQ(scale("1/s", Dimension::Frequency), 1.0);
  EXPECT_EQ(scale("kHz", Dimension::Frequency), 1e3);
  EXPECT_DOUBLE_EQ(scale("rpm", Dimension::AngularVelocity), std::numbers::pi / 30.0);
  for (const char* unit : {"rad/s", "rpm", "deg/s", "s"}) {
    EXPECT_THROW(unit_conversion(unit, Dimension::Frequency), InputError) << unit;
  }
  for (const char* unit : {"Hz", "kHz", "hertz", "Hertz", "HERTZ", "Bq"}) {
    EXPECT_THROW(unit_conversion(unit, Dimension::AngularVelocity), InputError) << unit;
  }
  EXPECT_EQ(message_from<InputError>([] { parse_quantity("5 rad/s", Dimension::Frequency); }),
            "5 rad/s: \"rad/s\" is not a unit of frequency (examples: Hz, kHz, 1/s)");
}

TEST(Units, ConvertWhatMotionsHave) {
  EXPECT_EQ(scale("J", Dimension::Energy), 1.0);
  EXPECT_EQ(scale("kN mm", Dimension::Energy), 1.0);
  EXPECT_EQ(scale("kJ", Dimension::Energy), 1e3);
  EXPECT_EQ(scale("MJ/m^3", Dimension::EnergyDensity), 1e6);
  EXPECT_EQ(scale("kg m/s", Dimension::Momentum), 1.0);
  EXPECT_EQ(scale("kg m^2/s", Dimension::AngularMomentum), 1.0);
  EXPECT_THROW(unit_conversion("%", Dimension::Energy), InputError);
}

/// What udunits2 makes a factor or an offset of: "MPa 2" is no unit of ours.
TEST(Units, HaveNoFactorsAndNoOffsets) {
  for (const char* unit : {"GPa 5%", "GPa (5)", "GPa @ 20", "GPa 2", "MPa.2", "2 MPa", "MPa %",
                           "MPa*2", "MPa/2", "MPa since 2"}) {
    EXPECT_THROW(unit_conversion(unit, Dimension::Stress), InputError) << unit;
    EXPECT_FALSE(is_unit(unit)) << unit;
  }
  for (const char* unit : {"GPa from20", "GPa pi", "GPa ppm", "GPa deg", "GPa °"}) {
    EXPECT_THROW(unit_conversion(unit, Dimension::Stress), InputError) << unit;
  }
  for (const char* unit : {"N/mm^2", "N/mm2", "N mm-2", "N mm**-2", "N mm^-2", "N/mm²"}) {
    EXPECT_EQ(scale(unit, Dimension::Stress), 1e6) << unit;
  }
  EXPECT_EQ(scale("1/s", Dimension::StrainRate), 1.0);
  EXPECT_EQ(scale("%/min", Dimension::StrainRate), 0.01 / 60.0);
  EXPECT_THROW(parse_quantity("+-100 N", Dimension::Force), InputError);
  EXPECT_EQ(parse_quantity("+100 N", Dimension::Force), 100.0);
}

TEST(Units, ConvertTemperaturesWithTheirOffset) {
  EXPECT_EQ(scale("K", Dimension::Temperature), 1.0);
  for (const char* unit : {"degC", "°C"}) {
    const UnitConversion celsius = unit_conversion(unit, Dimension::Temperature);
    EXPECT_EQ(celsius.scale, 1.0) << unit;
    EXPECT_DOUBLE_EQ(celsius(20.0), 293.15) << unit;
  }
  EXPECT_NEAR(unit_conversion("degF", Dimension::Temperature)(212.0), 373.15, 1e-9);
}

TEST(Units, ConvertStrainsAndTakeNoUnitForOne) {
  for (const char* unit : {"", " ", "1", "mm/mm", "in/in", "m/m", "-"}) {
    EXPECT_EQ(scale(unit, Dimension::Strain), 1.0) << unit;
  }
  EXPECT_EQ(scale("%", Dimension::Strain), 0.01);
  for (const char* unit : {"um/m", "µm/m", "microstrain", "µε"}) {
    EXPECT_EQ(scale(unit, Dimension::Strain), 1e-6) << unit;
  }
}

TEST(Units, ConvertAnglesAndPureNumbers) {
  EXPECT_EQ(scale("rad", Dimension::Angle), 1.0);
  EXPECT_EQ(scale("deg", Dimension::Angle), std::numbers::pi / 180.0);
  EXPECT_EQ(scale("°", Dimension::Angle), std::numbers::pi / 180.0);
  EXPECT_EQ(scale("", Dimension::None), 1.0);
  EXPECT_EQ(scale("%", Dimension::None), 0.01);
}

TEST(Units, AWrongDimensionNamesTheOneWanted) {
  EXPECT_EQ(message_from<InputError>([] {
              unit_conversion("mm", Dimension::Stress, {"fit.toml", 12}, "stress.unit");
            }),
            "fit.toml:12: stress.unit = mm: is not a unit of stress (examples: Pa, MPa, ksi)");
  EXPECT_EQ(message_from<InputError>([] { unit_conversion("deg", Dimension::Strain, {}, "unit"); }),
            "unit = deg: is not a unit of strain (examples: %, 1, mm/mm, um/m)");
  EXPECT_EQ(message_from<InputError>([] { unit_conversion("m", Dimension::None, {}, "nu"); }),
            "nu = m: is not a unit of a pure number (examples: 1, %)");
}

TEST(Units, AnUnknownUnitIsRefusedLikeAWrongOne) {
  for (const char* unit : {"mpa", "wibble", "5 MPa", "10", "(", "%", "MPa MPa", "lg(re 1 Pa)"}) {
    EXPECT_EQ(message_from<InputError>([&] { unit_conversion(unit, Dimension::Stress, {}, "u"); }),
              "u = " + std::string(unit) + ": is not a unit of stress (examples: Pa, MPa, ksi)");
  }
}

TEST(Units, UsualMisspellingsMeanWhatTheyCanOnlyMean) {
  EXPECT_EQ(unit_conversion("Mpa", Dimension::Stress).scale, 1e6);
  EXPECT_EQ(unit_conversion("KN", Dimension::Force).scale, 1e3);
  EXPECT_EQ(unit_conversion("N/MM^2", Dimension::Stress).scale, 1e6);
  EXPECT_EQ(unit_conversion("PSI", Dimension::Stress).scale,
            unit_conversion("psi", Dimension::Stress).scale);
  EXPECT_FALSE(is_unit("force"));
}

TEST(Units, AReciprocalIsNoConversion) {
  EXPECT_EQ(message_from<InputError>([] { unit_conversion("1/s", Dimension::Time, {}, "t"); }),
            "t = 1/s: is not a unit of time (examples: s, min, h)");
  EXPECT_EQ(message_from<InputError>([] { unit_conversion("m", Dimension::Curvature, {}, "k"); }),
            "k = m: is not a unit of curvature (examples: rad/m, deg/m, 1/mm)");
}

TEST(Units, ABareNumberIsNoStress) {
  EXPECT_EQ(
      message_from<InputError>([] { unit_conversion("", Dimension::Stress, {}, "stress.unit"); }),
      "stress.unit: a stress needs a unit (examples: Pa, MPa, ksi)");
  EXPECT_EQ(message_from<InputError>(
                [] { parse_quantity("355", Dimension::Stress, {}, "yield_stress"); }),
            "yield_stress = 355: a stress needs a unit (examples: Pa, MPa, ksi)");
  EXPECT_EQ(message_from<InputError>([] { parse_quantity("3", Dimension::Angle, {}, "twist"); }),
            "twist = 3: an angle needs a unit (examples: rad, deg)");
}

TEST(Quantity, OfAStrainOfOneAndMoreNeedsItsUnit) {
  EXPECT_EQ(message_from<InputError>([] { parse_quantity("20", Dimension::Strain, {}, "b"); }),
            "b = 20: would be 2000 % as a fraction: write the unit, \"20 %\" or \"2000 %\"");
  EXPECT_THROW(parse_quantity("-1", Dimension::Strain), InputError);
  EXPECT_DOUBLE_EQ(parse_quantity("2000 %", Dimension::Strain), 20.0);
  EXPECT_EQ(parse_quantity("2 mm/mm", Dimension::Strain), 2.0);
  EXPECT_EQ(parse_quantity("0.99", Dimension::Strain), 0.99);
  EXPECT_EQ(parse_quantity("20", Dimension::None), 20.0);
}

TEST(Quantity, IsANumberAndAUnit) {
  EXPECT_EQ(parse_quantity("355 MPa", Dimension::Stress), 355e6);
  EXPECT_EQ(parse_quantity(" +2.5e2kN ", Dimension::Force), 250e3);
  EXPECT_DOUBLE_EQ(parse_quantity("0.2 %", Dimension::Strain), 0.002);
  EXPECT_EQ(parse_quantity("1e-3", Dimension::Strain), 1e-3);
  EXPECT_EQ(parse_quantity("-40 degC", Dimension::Temperature), 273.15 - 40.0);
}

TEST(Quantity, SaysWhatIsWrongWithIt) {
  const auto message = [](const char* text, Dimension dimension) {
    return message_from<InputError>([&] { parse_quantity(text, dimension, {"a.toml", 3}, "x"); });
  };
  EXPECT_EQ(message("MPa", Dimension::Stress),
            "a.toml:3: x = MPa: does not begin with a number; wanted: a number and a unit of "
            "stress, such as \"1 Pa\"");
  EXPECT_EQ(message("355 kg", Dimension::Stress),
            "a.toml:3: x = 355 kg: \"kg\" is not a unit of stress (examples: Pa, MPa, ksi)");
  EXPECT_EQ(message("0,2 %", Dimension::Strain),
            "a.toml:3: x = 0,2 %: has a decimal comma; write a point");
  EXPECT_EQ(message("1e999 MPa", Dimension::Stress),
            "a.toml:3: x = 1e999 MPa: is not a finite number");
  EXPECT_EQ(message("nan", Dimension::Strain), "a.toml:3: x = nan: is not a finite number");
  EXPECT_EQ(message("1.2.3", Dimension::Strain),
            "a.toml:3: x = 1.2.3: \".3\" is not a unit of strain (examples: %, 1, mm/mm, um/m)");
}

TEST(Units, AreToldFromOtherWords) {
  for (const char* unit : {"MPa", "%", "kN", "N/mm²", "mm", "degC", "1/s", "microstrain"}) {
    EXPECT_TRUE(is_unit(unit)) << unit;
  }
  for (const char* word :
       {"", "true", "2", "5 mm", "a", "corrected", "left", "m 0x", "0 m", "m 0.0"}) {
    EXPECT_FALSE(is_unit(word)) << word;
  }
}

TEST(Units, WithAFactorAreToldFromUnits) {
  for (const char* text : {"10 MPa", "10MPa", "x10 N", "x 10 N", "10^1 N", "10**3 psi", "10⁻³ MPa",
                           "1e+3 N", "10 x N", "0.1 N", "1000 N"}) {
    EXPECT_TRUE(is_scaled_unit(text)) << text;
    EXPECT_FALSE(is_unit(text)) << text;
  }
  for (const char* text : {"MPa", "2", "X10", "10", "20 MPa", "1E1", "1/s", "N/mm^2", ""}) {
    EXPECT_FALSE(is_scaled_unit(text)) << text;
  }
}

/// What scales a column's numbers, and what says what these are of.
TEST(Units, KnowAFactorInAName) {
  const auto of_force = [](const char* name) { return factor_in_name(name, Dimension::Force); };
  EXPECT_EQ(of_force("Force (10 N)"), "10 N");
  EXPECT_EQ(of_force("Load in 10 kN"), "10 kN");
  EXPECT_EQ(of_force("Force (x10)"), "x10");
  EXPECT_EQ(of_force("Force x 10"), "x 10");
  EXPECT_EQ(of_force("10*Force"), "10*");
  EXPECT_EQ(of_force("Force*10"), "*10");
  EXPECT_EQ(of_force("10 x Force"), "10 x");
  EXPECT_EQ(of_force("Force 10 N"), "10 N");
  EXPECT_EQ(factor_in_name("Strain (10^-3)", Dimension::Strain), "10^-3");
  EXPECT_EQ(factor_in_name("Strain (1e-6)", Dimension::Strain), "1e-6");
  EXPECT_EQ(factor_in_name("Stress (10^3 psi)", Dimension::Stress), "10^3 psi");
  for (const char* name : {"Force",
                           "Force (N)",
                           "Force (10)",
                           "Run (2)",
                           "Force (1 N)",
                           "Force (20 °C)",
                           "F_10",
                           "Force 2 N",
                           "Sample 10",
                           "Force (X10)",
                           "Force (X12)",
                           "Force (1A)",
                           "Force (1E1)",
                           "Force (10 mm)",
                           "Force (10 x 2 mm)",
                           "Force (3 x 10 mm)",
                           "10xyz",
                           "Force (0.5 N)",
                           "Force (N/mm^2)",
                           "Kanal 1000",
                           "Force (90 deg)",
                           "Force (10 %/min)"}) {
    EXPECT_EQ(of_force(name), "") << name;
  }
  EXPECT_EQ(factor_in_name("Load cell 10 kN", Dimension::Force), "10 kN");
  EXPECT_EQ(factor_in_name("Load cell 10 kN", Dimension::Force, true), "");
  EXPECT_EQ(factor_in_name("Force (x10)", Dimension::Force, true), "x10");
  EXPECT_EQ(factor_in_name("Elongation (L0 = 100 mm)", Dimension::Length), "");
  EXPECT_EQ(factor_in_name("Stress (20 mm x 10 mm)", Dimension::Stress), "");
  EXPECT_EQ(factor_in_name("Strain (50 mm)", Dimension::Strain), "");
  EXPECT_EQ(factor_in_name("Stress (Rp0.2)", Dimension::Stress), "");
  EXPECT_EQ(factor_in_name("Strain (10 %)", Dimension::Strain), "10 %");
}

TEST(Units, WithABracketAloneOrASumAreRefused) {
  for (const char* unit : {"N)", "(N", "N+1", "mm^2)", "m)(", "MPa))"}) {
    EXPECT_FALSE(is_unit(unit)) << unit;
    EXPECT_FALSE(is_unit_of(unit, Dimension::Force)) << unit;
  }
  EXPECT_TRUE(is_unit_of("N/(mm^2)", Dimension::Stress));
}

TEST(Units, MayBeAskedFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4, 0.0);
  for (std::size_t t = 0; t < sums.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 200; ++i) {
        sums[t] += unit_conversion("MPa", Dimension::Stress).scale;
        sums[t] += is_unit("furlong/fortnight") ? 1.0 : 0.0;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_EQ(sum, 200.0 * (1e6 + 1.0));
}

}  // namespace
}  // namespace plastica::io
