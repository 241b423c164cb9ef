#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "tests/calibrate/target/curve_files.hpp"
#include "tests/support/message.hpp"

// Columns say by their names whether they are true strain and stress; blocks may say otherwise.

namespace plastica::calibrate {
namespace {

using plastica::testing::CurveFiles;
using plastica::testing::message_of;

struct Named {
  std::string strain, stress;
  std::optional<Measure> measure{};
};

TargetSource source_of(const CurveFiles& files, const Named& named) {
  TargetSource source = CurveFiles::source(
      {files.write_curve("one.csv", 1.0, 1e-6, named.strain + "," + named.stress)});
  source.strain->column = named.strain;
  source.stress->column = named.stress;
  source.measure = named.measure;
  return source;
}

/// The columns that a warning names.
std::vector<std::string> doubted(const Named& named) {
  const CurveFiles files("named_measure");
  std::vector<std::string> columns;
  const std::vector<Target> targets = import_targets(source_of(files, named));
  for (const std::string& warning : targets.at(0).warnings) {
    if (warning.find(" by its name, and is taken for ") == std::string::npos) continue;
    columns.push_back(warning.substr(1, warning.find('"', 1) - 1));
  }
  return columns;
}

TEST(NamedMeasure, OfTrueStrainAndStressIsToBeSaid) {
  const CurveFiles files("true_measure");
  Named named{"True strain", "True stress"};
  EXPECT_EQ(message_of([&] { import_targets(source_of(files, named)); }),
            "fit.toml:3: measure: is needed: \"True strain\" and \"True stress\" are true strain "
            "and stress by their names; write measure = \"true\", or \"engineering\" if they are "
            "not");
  named.measure = Measure::True;
  EXPECT_EQ(import_targets(source_of(files, named)).at(0).measure, Measure::True);
}

TEST(NamedMeasure, IsDoubtedWhereTheBlockSaysTheOther) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(doubted({"True strain", "True stress", Measure::True}), Names{});
  EXPECT_EQ(doubted({"Strain", "Stress"}), Names{});
  EXPECT_EQ(doubted({"Strain", "True stress", Measure::True}), Names{});
  EXPECT_EQ(doubted({"Engineering strain", "Nominal stress"}), Names{});
  EXPECT_EQ(doubted({"True strain", "True stress", Measure::Engineering}),
            (Names{"True strain", "True stress"}));
  EXPECT_EQ(doubted({"Technische Dehnung", "Wahre Spannung"}), (Names{"Wahre Spannung"}));
  EXPECT_EQ(doubted({"Engineering strain", "Eng. stress", Measure::True}),
            (Names{"Engineering strain", "Eng. stress"}));
}

/// Force over area and elongation over gauge length are of the engineering measure.
TEST(NamedMeasure, IsNotTrueOfForceAndElongation) {
  const CurveFiles files("divided_measure");
  TargetSource source = source_of(files, {"Strain", "Force", Measure::True});
  source.force = ColumnSource{"Force", "kN", {}};
  source.stress.reset();
  source.area = SpecimenValue{1e-4, "", "mm^2", {}};
  EXPECT_EQ(message_of([&] { import_targets(source); }),
            "fit.toml:3: measure = true: is not that of force over area and of elongation over "
            "gauge length: corrections.measure = \"true\" converts them");
  TargetSource torsion = source_of(files, {"Strain", "Stress", Measure::True});
  torsion.test = calibrate::Test::Torsion;
  EXPECT_EQ(message_of([&] { import_targets(torsion); }),
            "fit.toml:3: measure = true: goes with test = \"tension\" alone");
}

/// What cannot be true is neither asked for nor doubted.
TEST(NamedMeasure, OfOtherTestsAndOfForceIsNoQuestion) {
  const CurveFiles files("other_measure");
  TargetSource bending = source_of(files, {"True strain", "True stress"});
  bending.test = calibrate::Test::Bending;
  EXPECT_NO_THROW(import_targets(bending));
  TargetSource divided = source_of(files, {"Log strain", "Log force"});
  divided.force = ColumnSource{"Log force", "kN", {}};
  divided.stress.reset();
  divided.area = SpecimenValue{1e-4, "", "mm^2", {}};
  EXPECT_NO_THROW(import_targets(divided));
}

// A curve of plastic strain begins at its yield stress, and has no elastic part.
TEST(NamedMeasure, OfPlasticStrainAloneIsRefused) {
  const CurveFiles files("plastic_strain");
  for (const char* name : {"Plastic strain", "plastische Dehnung", "true plastic strain",
                           "strain_plastic", "Inelastic strain"}) {
    const TargetSource source = source_of(files, {name, "Stress"});
    const std::string message = message_of([&] { import_targets(source); });
    EXPECT_NE(message.find("is plastic strain by its name: a fit needs the total strain"),
              std::string::npos)
        << name << ": " << message;
    TargetOptions accept;
    accept.accept = true;
    EXPECT_EQ(import_targets(source, accept).at(0).status, TargetStatus::Ready) << name;
  }
  for (const char* name : {"Total strain (elastic + plastic)", "Strain", "Elastoplastic strain",
                           "Plastic specimen strain"}) {
    EXPECT_EQ(import_targets(source_of(files, {name, "Stress"})).at(0).status, TargetStatus::Ready)
        << name;
  }
}

TEST(NamedTest, IsDoubtedWhereTheBlockSaysAnother) {
  const CurveFiles files("named_test");
  const auto doubts = [&](const Named& named, Deformation test) {
    TargetSource source = source_of(files, named);
    source.test = test;
    const std::vector<std::string> warnings = import_targets(source).at(0).warnings;
    return std::ranges::count_if(warnings, [](const std::string& warning) {
      return warning.find("by its name, and is taken for") != std::string::npos;
    });
  };
  const Named shear{"Shear strain", "Shear stress (MPa)"};
  EXPECT_EQ(doubts(shear, Deformation::Tension), 1);
  EXPECT_EQ(doubts(shear, Deformation::Torsion), 0);
  EXPECT_EQ(doubts({"Strain", "Flexural stress"}, Deformation::Tension), 1);
  EXPECT_EQ(doubts({"Strain", "Biegespannung"}, Deformation::Bending), 0);
  EXPECT_EQ(doubts({"Strain", "Scherspannung"}, Deformation::Bending), 1);
  for (const char* name : {"Stress", "Elastischer Spannungsanteil", "Technischer Spannungswert",
                           "Mechanischer Spannungswert", "Stress Fischer", "Spannung Vorschub"}) {
    EXPECT_EQ(doubts({"Strain", name}, Deformation::Tension), 0) << name;
  }
  for (const char* name :
       {"Torsion stress", "Torsionsspannung", "Schubspannung", "Bending stress"}) {
    EXPECT_EQ(doubts({"Strain", name}, Deformation::Tension), 1) << name;
  }
}

}  // namespace
}  // namespace plastica::calibrate
