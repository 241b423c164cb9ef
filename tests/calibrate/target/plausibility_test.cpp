#include "calibrate/target/plausibility.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "calibrate/target/make.hpp"

namespace plastica::calibrate {
namespace {

/// What a tension test of a material gives: Ramberg and Osgood's curve [Pa], to a largest strain.
struct Specimen {
  const char* material;
  double modulus, proof, exponent, end;
};

Curve curve_of(const Specimen& of, double stress = 1.0, double strain = 1.0) {
  Curve curve;
  const auto strain_at = [&](double s) {
    return s / of.modulus + 0.002 * std::pow(s / of.proof, of.exponent);
  };
  double most = of.proof;
  while (strain_at(most) < of.end) most *= 1.001;
  for (int i = 0; i <= 600; ++i) {
    const double s = most * i / 600.0;
    curve.strain.push_back(strain * strain_at(s));
    curve.stress.push_back(stress * s);
  }
  return curve;
}

/// Handbook values (MMPDS, ASM, CAMPUS), rounded: E, Rp0.2, and how far they stretch.
const std::vector<Specimen>& materials() {
  static const std::vector<Specimen> all = {{"S355", 205e9, 370e6, 8.0, 0.2},
                                            {"spring steel", 206e9, 1700e6, 20.0, 0.05},
                                            {"austenitic steel", 193e9, 240e6, 5.0, 0.5},
                                            {"6061-T6", 69e9, 276e6, 20.0, 0.1},
                                            {"7075-T6", 71e9, 503e6, 20.0, 0.1},
                                            {"annealed copper", 120e9, 40e6, 4.0, 0.4},
                                            {"Ti-6Al-4V", 114e9, 880e6, 25.0, 0.1},
                                            {"magnesium AZ31", 45e9, 200e6, 12.0, 0.12},
                                            {"lead", 16e9, 6e6, 4.0, 0.3},
                                            {"aluminium at 500 degC", 45e9, 8e6, 6.0, 0.4},
                                            {"tungsten", 400e9, 750e6, 20.0, 0.02},
                                            {"PA66-GF30", 9.5e9, 120e6, 8.0, 0.03},
                                            {"ABS", 2.3e9, 38e6, 8.0, 0.1},
                                            {"HDPE", 1.0e9, 15e6, 4.0, 0.5},
                                            {"metallic glass", 95e9, 1700e6, 60.0, 0.022}};
  return all;
}

TEST(Plausibility, LetsMaterialsPass) {
  for (const Specimen& material : materials()) {
    const Target target = make_target("specimen", curve_of(material));
    EXPECT_EQ(target.status, TargetStatus::Ready) << material.material << ": " << target.reason;
  }
}

/// Fibres break at some percent without a yield, and silicone is soft.
TEST(Plausibility, LetsFibresAndSiliconePass) {
  for (const auto& [modulus, end] : {std::pair(70e9, 0.041), {72e9, 0.055}, {0.4e6, 2.0}}) {
    Curve curve;
    for (int i = 0; i <= 100; ++i) {
      curve.strain.push_back(end * i / 100.0);
      curve.stress.push_back(modulus * curve.strain.back());
    }
    EXPECT_EQ(make_target("t", curve).status, TargetStatus::Ready)
        << make_target("t", curve).reason;
  }
}

struct UnitMistake {
  double stress, strain;
  std::string likely_cause;
};

TEST(Plausibility, RefusesMetalsInWrongUnitsAndNamesTheMistake) {
  const std::vector<UnitMistake> mistakes = {
      {1e3, 1.0, "stress looks a thousand times too large"},
      {1e-3, 1.0, "stress looks a thousand times too small"},
      {1e6, 1.0, "stress looks a million times too large"},
      {1e-6, 1.0, "stress looks a million times too small"},
      {1e-2, 1.0, "stress looks a hundred times too small"},
      {4.0, 1.0, "stress looks four times too large"},
      {1.0, 10.0, "strain looks ten times too large"},
      {1.0, 1e2, "strain looks a hundred times too large: is it in %?"},
      {1.0, 1e-2, "strain looks a hundred times too small: is it a fraction, not in %?"},
      {1.0, 1e-3, "strain looks a"}};  // beyond some curves' knowing: a hundred or a thousand times
  for (const Specimen& material : materials()) {
    const double yield_strain = material.proof / material.modulus;
    if (material.modulus < 60e9 || material.proof < 150e6 || yield_strain > 0.015) continue;
    for (const UnitMistake& mistake : mistakes) {
      const Target target = make_target("m", curve_of(material, mistake.stress, mistake.strain));
      const std::string what =
          std::string(material.material) + ", " + mistake.likely_cause + ": " + target.reason;
      // Nothing tells a very strong metal in a unit that is too small from a polymer.
      if (mistake.stress < 0.1 && yield_strain > 5e-3 && target.status == TargetStatus::Ready) {
        const bool is_warned = std::ranges::any_of(target.warnings, [](const std::string& warning) {
          return warning.find("as of a rubber: are the units") != std::string::npos;
        });
        EXPECT_EQ(is_warned, mistake.stress * material.modulus < 0.5e9) << what;
        continue;
      }
      // Aluminium that is four times too strong may be a steel, and so on.
      const bool may_be_another = (mistake.stress == 4.0 && material.modulus < 113e9) ||
                                  (mistake.strain == 10.0 && yield_strain < 3.1e-3);
      if (may_be_another && target.status == TargetStatus::Ready) continue;
      EXPECT_EQ(target.status, TargetStatus::Implausible) << what;
      EXPECT_NE(target.reason.find(mistake.likely_cause), std::string::npos) << what;
    }
  }
}

/// The machine's give adds to the strain of a steel: only its modulus shows it.
TEST(Plausibility, SuspectsTravelWhereASteelIsTooSoft) {
  Curve curve = curve_of({"steel", 205e9, 370e6, 8.0, 0.2});
  for (std::size_t i = 0; i < curve.size(); ++i) curve.strain[i] += curve.stress[i] / 8e9;
  const Target target = make_target("travel", curve);
  EXPECT_EQ(target.status, TargetStatus::Implausible);
  EXPECT_NE(target.reason.find("may be crosshead travel"), std::string::npos) << target.reason;
}

TEST(Plausibility, ComparesTheModulusWithTheOneThatIsExpected) {
  TargetOptions options;
  options.expected_modulus = 205e9;
  const Curve aluminium = curve_of({"6061-T6", 69e9, 276e6, 20.0, 0.1});
  const Target target = make_target("wrong", aluminium, options);
  EXPECT_EQ(target.status, TargetStatus::Implausible);
  EXPECT_NE(target.reason.find("is off the expected 205 GPa by more than a factor of 2.5 "
                               "(plausible.modulus_factor)"),
            std::string::npos)
      << target.reason;
  options.plausible.modulus_factor = 3.5;
  EXPECT_EQ(make_target("wider", aluminium, options).status, TargetStatus::Ready);
}

TEST(Plausibility, FitsWhatTheUserAcceptsAndSaysSo) {
  TargetOptions options;
  options.accept = true;
  const Curve steel = curve_of({"steel", 205e9, 370e6, 8.0, 0.2}, 1e3);
  const Target target = make_target("steel", steel, options);
  EXPECT_EQ(target.status, TargetStatus::Ready);
  ASSERT_FALSE(target.warnings.empty());
  EXPECT_TRUE(target.warnings.back().starts_with("implausible, but accepted: Young's modulus of"))
      << target.warnings.back();
}

/// What is in no range is what a user may widen.
TEST(Plausibility, FollowsTheBoundsThatAreGiven) {
  const Curve diamond = curve_of({"more than diamond", 2e12, 20e9, 30.0, 0.02});
  EXPECT_EQ(make_target("d", diamond).status, TargetStatus::Implausible);
  TargetOptions options;
  options.plausible.max_modulus = options.plausible.max_ductile_modulus = 3e12;
  EXPECT_EQ(make_target("d", diamond, options).status, TargetStatus::Ready);
  const Curve copper = curve_of({"copper", 120e9, 40e6, 4.0, 0.4});
  options.plausible.min_yield_strain = 1e-3;
  EXPECT_NE(make_target("c", copper, options)
                .reason.find("is less than 0.1 % "
                             "(plausible.yield_strain)"),
            std::string::npos);
  options = {};
  options.plausible.max_strain = 0.3;
  EXPECT_NE(make_target("c", copper, options)
                .reason.find("is more than 30 % "
                             "(plausible.strain)"),
            std::string::npos);
}

std::vector<Target> group(const std::vector<double>& moduli, const TargetOptions& options = {}) {
  std::vector<Target> targets;
  for (const double modulus : moduli) {
    targets.push_back(
        make_target("t", curve_of({"", modulus, 0.002 * modulus, 10.0, 0.1}), options));
  }
  check_groups(targets, options);
  return targets;
}

TEST(Plausibility, RefusesTheSpecimenThatIsTenTimesOffItsGroup) {
  const std::vector<Target> targets = group({200e9, 19e9, 205e9, 198e9});
  EXPECT_EQ(targets[0].status, TargetStatus::Ready);
  EXPECT_EQ(targets[1].status, TargetStatus::Implausible);
  EXPECT_NE(targets[1].reason.find("the median of its 4 specimens (plausible.group_factor)"),
            std::string::npos)
      << targets[1].reason;
  EXPECT_EQ(targets[2].status, TargetStatus::Ready);
  EXPECT_EQ(group({200e9, 21e9, 205e9, 198e9})[1].status, TargetStatus::Ready);
  EXPECT_EQ(group({200e9, 19e9})[1].status, TargetStatus::Ready) << "two have no median";
  TargetOptions options;
  options.plausible.group_factor = 20.0;
  EXPECT_EQ(group({200e9, 19e9, 205e9, 198e9}, options)[1].status, TargetStatus::Ready);
}

TEST(Plausibility, WarnsOfTheSpecimenThatIsHalfAgainOffItsGroup) {
  const auto warned = [](const Target& target) {
    return std::ranges::any_of(target.warnings, [](const std::string& warning) {
      return warning.find("the median of its 3 specimens: is its gauge length, area") !=
             std::string::npos;
    });
  };
  const std::vector<Target> targets = group({200e9, 100e9, 205e9});
  EXPECT_FALSE(warned(targets[0]));
  EXPECT_TRUE(warned(targets[1]));
  EXPECT_EQ(targets[1].status, TargetStatus::Ready);
}

TEST(Plausibility, ComparesAGroupWithItselfAlone) {
  std::vector<Target> targets;
  for (const auto& [lot, modulus] :
       {std::pair("a", 200e9), {"a", 201e9}, {"a", 202e9}, {"b", 15e9}, {"b", 15.1e9}}) {
    targets.push_back(make_target("t", curve_of({"", modulus, 0.002 * modulus, 10.0, 0.1})));
    targets.back().group = {{"lot", lot}};
  }
  check_groups(targets, {});
  for (const Target& target : targets) EXPECT_EQ(target.status, TargetStatus::Ready);
}

TEST(Plausibility, SaysItsBounds) {
  TargetOptions options;
  options.expected_modulus = 70e9;
  EXPECT_EQ(
      plausible_text(options),
      "Young's modulus 0.1 MPa to 1300 GPa, beyond a strain of 2 % to 450 GPa; yield strain 0.005 "
      "% to 3 % (the latter above 120 MPa), and at least 0.5 % below a modulus of 4.5 GPa; "
      "strain up to 1200 %, above 120 MPa up to 150 %; within a factor of 10 of its group's "
      "median; Young's modulus within a factor of 2.5 of 70 GPa");
}

}  // namespace
}  // namespace plastica::calibrate
