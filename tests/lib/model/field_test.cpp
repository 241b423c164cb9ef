#include "plastica/model/field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>

#include "plastica/model/field_table.hpp"
#include "tests/support/message.hpp"

namespace plastica {
namespace {

using testing::message_of;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string error_of_setting(std::string_view path, const FieldValue& value,
                             std::string_view shown = {}) {
  return message_of([&] {
    plastica::Setup setup;
    set_field(setup, find_field(path), value, {"beam.toml", 7}, shown);
  });
}

/// A number that a field takes and that is not its default.
double another_number(const Field& field) {
  if (field.kind == FieldKind::Integer) return 17.0;
  if (field.range.low == 1.0) return 2.0;
  return field.range.high == 1.0 || field.range.high == 0.5 ? 0.25 : 0.0123;
}

TEST(FieldTable, HasNoPathTwice) {
  std::set<std::string_view> paths;
  for (const Field& field : fields()) EXPECT_TRUE(paths.insert(field.path).second) << field.path;
  EXPECT_GE(paths.size(), 30U);
}

/// Results call a fitted number by the last part of its path alone.
TEST(FieldTable, HasNoTwoNumbersOfOneLastPart) {
  std::set<std::string_view> names;
  for (const Field& field : fields()) {
    if (field.kind == FieldKind::Choice) continue;
    EXPECT_TRUE(names.insert(field.path.substr(field.path.rfind('.') + 1)).second) << field.path;
  }
}

TEST(FieldTable, DocumentsEveryFieldInOneLine) {
  for (const Field& field : fields()) {
    EXPECT_FALSE(field.doc.empty()) << field.path;
    EXPECT_EQ(field.doc.find('\n'), std::string_view::npos) << field.path;
    EXPECT_NE(field.path.find('.'), std::string_view::npos) << field.path;
  }
}

TEST(FieldTable, GivesBackEveryValueThatIsSet) {
  for (const Field& field : fields()) {
    plastica::Setup setup;
    if (field.kind == FieldKind::Choice) {
      ASSERT_GE(field.choices.size(), 2U) << field.path;
      for (const std::string_view word : field.choices) {
        set_field(setup, field, std::string(word));
        EXPECT_EQ(std::get<std::string>(field.get(setup)), word) << field.path;
      }
    } else {
      const double value = another_number(field);
      set_field(setup, field, value);
      EXPECT_EQ(std::get<double>(field.get(setup)), value) << field.path;
    }
  }
}

TEST(FieldTable, SetsOneMemberAlone) {
  const plastica::Setup defaults;
  for (const Field& field : fields()) {
    plastica::Setup setup;
    const FieldValue value = field.kind == FieldKind::Choice
                                 ? FieldValue(std::string(field.choices.back()))
                                 : FieldValue(another_number(field));
    set_field(setup, field, value);
    for (const Field& other : fields()) {
      if (&other == &field) continue;
      EXPECT_EQ(other.get(setup), other.get(defaults)) << field.path << " moves " << other.path;
    }
  }
}

TEST(FieldTable, HasDefaultsWithinTheirRanges) {
  const plastica::Setup setup;
  for (const Field& field : fields()) {
    const FieldValue value = field.get(setup);
    if (const double* number = std::get_if<double>(&value)) {
      EXPECT_TRUE(field.range.contains(*number)) << field.path;
      EXPECT_NO_THROW(check_field(field, *number)) << field.path;
    }
    EXPECT_FALSE(default_text(field).empty()) << field.path;
  }
}

TEST(FieldTable, ShowsDefaultsAsTextAndUnsetOptionalsAsSuch) {
  EXPECT_EQ(default_text(find_field("yield_stress")), "3.55e+08");
  EXPECT_EQ(default_text(find_field("section.shape")), "rectangle");
  EXPECT_EQ(default_text(find_field("beam.segments")), "10");
  EXPECT_EQ(default_text(find_field("break_strain")), "unset");
}

TEST(FieldTable, ReachesEveryMaterialFieldOnce) {
  std::set<MaterialField> reached;
  for (const Field& field : fields()) {
    if (!field.material) continue;
    EXPECT_TRUE(reached.insert(*field.material).second) << field.path;
  }
  EXPECT_EQ(reached.size(), kMaterialFields);
}

TEST(FieldTable, NamesTheMaterialFieldThatItsMemberBecomes) {
  for (const Field& field : fields()) {
    if (!field.material) continue;
    plastica::Setup setup;
    set_field(setup, field, another_number(field));
    const MaterialValues<double> values = material_values(setup.scene.material);
    EXPECT_EQ(values[static_cast<std::size_t>(*field.material)], another_number(field))
        << field.path;
  }
}

TEST(FieldTable, GivesTheWordsOfAMotionTheirMeaning) {
  plastica::Setup setup;
  const auto set = [&](std::string_view path, const std::string& word) {
    set_field(setup, find_field(path), word);
    return setup.solver;
  };
  EXPECT_EQ(set("solver.analysis", "dynamics").analysis, Analysis::Dynamics);
  EXPECT_EQ(set("solver.analysis", "statics").analysis, Analysis::Statics);
  EXPECT_EQ(set("solver.scheme", "linearly_implicit_euler").scheme, Scheme::LinearlyImplicitEuler);
  EXPECT_EQ(set("solver.scheme", "linearly_implicit_midpoint").scheme,
            Scheme::LinearlyImplicitMidpoint);
  EXPECT_EQ(set("solver.scheme", "generalized_alpha").scheme, Scheme::GeneralizedAlpha);
  EXPECT_EQ(set("solver.scheme", "energy_momentum").scheme, Scheme::EnergyMomentum);
  EXPECT_EQ(set("solver.damping", "stiffness").damping, Damping::Stiffness);
  EXPECT_EQ(set("solver.damping", "relaxation").damping, Damping::Relaxation);
  EXPECT_EQ(set("solver.damping", "none").damping, Damping::None);
  EXPECT_EQ(set("solver.rotary_inertia", "off").rotary_inertia, RotaryInertia::Off);
  EXPECT_EQ(set("solver.rotary_inertia", "on").rotary_inertia, RotaryInertia::On);
  EXPECT_EQ(set("solver.precision", "float").precision, Precision::Float);
  EXPECT_EQ(set("solver.precision", "double").precision, Precision::Double);
}

TEST(FieldTable, LetsOptionalFieldsBeUnsetAgain) {
  plastica::Setup setup;
  const Field& field = find_field("material.break_strain");
  set_field(setup, field, 0.2);
  set_field(setup, field, std::monostate{});
  EXPECT_FALSE(setup.scene.material.break_strain);
  EXPECT_EQ(error_of_setting("beam.length", std::monostate{}),
            "beam.toml:7: beam.length: cannot be left unset");
}

TEST(FindField, TakesAPathOrItsLastPart) {
  EXPECT_EQ(find_field("material.yield_stress").path, "material.yield_stress");
  EXPECT_EQ(find_field("yield_stress").path, "material.yield_stress");
  EXPECT_EQ(find_field("tangent_modulus").path, "material.hardening.tangent_modulus");
  EXPECT_EQ(find_field_or_null("yield_stress"), nullptr);
  EXPECT_EQ(find_field_or_null("beam.length"), &find_field("length"));
}

TEST(FindField, RefusesAnUnknownName) {
  EXPECT_EQ(message_of([] {
              find_field("yeild_stress", {"fit.toml", 3});
            }),
            "fit.toml:3: yeild_stress: is not a field; `plastica fields` lists them");
}

TEST(FindField, RefusesAnAmbiguousLastPartButTakesItsPath) {
  std::array<Field, 2> table{};
  table[0].path = "beam.length";
  table[1].path = "hinge.length";
  EXPECT_EQ(message_of([&] { model_detail::find_in(table, "length", {}); }),
            "length: is ambiguous: beam.length or hinge.length");
  EXPECT_EQ(&model_detail::find_in(table, "hinge.length", {}), &table[1]);
}

TEST(Range, StatesItsRuleInWords) {
  EXPECT_EQ(Range{}.rule(), "must be finite");
  EXPECT_EQ((Range{0.0, kInfinite, true, false}.rule()), "must be above 0");
  EXPECT_EQ(Range{0.0}.rule(), "must be at least 0");
  EXPECT_EQ((Range{0.0, 1.0, false, false}.rule()), "must be from 0 to 1");
  EXPECT_EQ((Range{-1.0, 0.5, true, false}.rule()), "must be above -1 and at most 0.5");
  EXPECT_EQ((Range{0.0, 1.0, false, true}.rule()), "must be at least 0 and below 1");
  EXPECT_EQ((Range{-kInfinite, 2.0, false, false}.rule()), "must be at most 2");
}

TEST(Range, ContainsItsEndsUnlessTheyAreOpen) {
  const Range range{0.0, 1.0, true, false};
  EXPECT_FALSE(range.contains(0.0));
  EXPECT_TRUE(range.contains(1e-300));
  EXPECT_TRUE(range.contains(1.0));
  EXPECT_FALSE(range.contains(1.0000001));
}

TEST(Range, NeverContainsWhatIsNotFinite) {
  for (const double value : {kInfinite, -kInfinite, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(Range{}.contains(value));
    EXPECT_FALSE(Range{0.0}.contains(value));
  }
}

TEST(SetField, NamesFileLineFieldValueAndRule) {
  EXPECT_EQ(error_of_setting("yield_stress", -1e6, "-1 MPa"),
            "beam.toml:7: material.yield_stress = -1 MPa: must be above 0 Pa");
  EXPECT_EQ(error_of_setting("poisson_ratio", 0.7),
            "beam.toml:7: material.poisson_ratio = 0.7: must be above -1 and at most 0.5");
  EXPECT_EQ(error_of_setting("saturation_stress", kInfinite),
            "beam.toml:7: material.hardening.saturation_stress = inf: must be finite");
  EXPECT_EQ(error_of_setting("time_step", 0.0),
            "beam.toml:7: solver.time_step = 0: must be above 0 s");
  EXPECT_EQ(error_of_setting("rho_infinity", 1.1),
            "beam.toml:7: solver.rho_infinity = 1.1: must be from 0 to 1");
  EXPECT_EQ(error_of_setting("frames", -1.0),
            "beam.toml:7: solver.frames = -1: must be from 0 to 1e+07");
}

TEST(SetField, TakesOnlyIntegersForAnIntegerField) {
  EXPECT_EQ(error_of_setting("segments", 2.5),
            "beam.toml:7: beam.segments = 2.5: must be an integer");
  EXPECT_EQ(error_of_setting("segments", 0.0),
            "beam.toml:7: beam.segments = 0: must be from 1 to 1e+07");
  EXPECT_EQ(error_of_setting("segments", 3.0), "no error");
}

TEST(SetField, TellsWordsFromNumbers) {
  EXPECT_EQ(error_of_setting("section.shape", 3.0),
            "beam.toml:7: section.shape = 3: must be a word");
  EXPECT_EQ(error_of_setting("section.width", std::string("wide")),
            "beam.toml:7: section.width = wide: must be a number");
  EXPECT_EQ(error_of_setting("deformation", std::string("shear")),
            "beam.toml:7: drive.deformation = shear: must be one of tension, bending, torsion");
}

TEST(SetField, LeavesTheSetupAloneWhenItRefuses) {
  plastica::Setup setup;
  EXPECT_THROW(set_field(setup, find_field("yield_stress"), -1.0), InputError);
  EXPECT_EQ(setup.scene.material.yield_stress, Material{}.yield_stress);
}

}  // namespace
}  // namespace plastica
