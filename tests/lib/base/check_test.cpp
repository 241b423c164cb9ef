#include "plastica/base/check.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "plastica/base/quantity.hpp"
#include "plastica/base/status.hpp"
#include "plastica/base/version.hpp"

namespace plastica {
namespace {

TEST(InputError, NamesFileLineFieldValueAndRule) {
  const InputError error({"fit.toml", 12}, "yield_stress", "-3 MPa", "must be above 0");
  EXPECT_STREQ(error.what(), "fit.toml:12: yield_stress = -3 MPa: must be above 0");
  EXPECT_EQ(error.field(), "yield_stress");
  EXPECT_EQ(error.where().line, 12);
}

TEST(InputError, LeavesOutWhatIsUnknown) {
  EXPECT_STREQ(InputError({}, "", "", "is empty").what(), "is empty");
  EXPECT_STREQ(InputError({"a.csv", 0}, "", "", "is empty").what(), "a.csv: is empty");
  EXPECT_STREQ(InputError({"a.csv", 3}, "x", "", "is unknown").what(), "a.csv:3: x: is unknown");
}

TEST(InputError, StaysOneShortLineForAnyValue) {
  const InputError error({}, "x", std::string(500, 'a') + "\n\tb", "is odd");
  const std::string text = error.what();
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_LT(text.size(), 120U);
}

TEST(InputError, StaysOneLineWhateverAFileAKeyOrARuleHolds) {
  const std::string odd = "a\x1B[2J\n" + std::string(100'000, 'b');
  const std::string text = InputError({odd, 1}, odd, "x", odd).what();
  EXPECT_EQ(text.find_first_of("\n\x1B"), std::string::npos);
  EXPECT_LT(text.size(), 7000U);
}

TEST(InputError, CutsAValueBetweenItsCharacters) {
  std::string value(79, 'a');
  EXPECT_STREQ(InputError({}, "", value + "\u20ac\u20ac", "is odd").what(),
               (value + "...: is odd").c_str());
  EXPECT_STREQ(InputError({}, "", value + "b\u20ac", "is odd").what(),
               (value + "b...: is odd").c_str());
}

TEST(Status, TellsWhatIsUsableAndWhatToDo) {
  EXPECT_TRUE(usable(Status::Completed));
  EXPECT_TRUE(usable(Status::Broken));
  for (const Status bad :
       {Status::NotRun, Status::Rejected, Status::InvalidParameter, Status::NonFinite}) {
    EXPECT_FALSE(usable(bad));
    EXPECT_FALSE(advice(bad, false).empty());
    EXPECT_FALSE(name_of(bad).empty());
  }
}

TEST(Status, AdvisesWhatTheRunHas) {
  const auto has = [](bool in_motion, std::string_view word) {
    return advice(Status::NotConverged, in_motion).find(word) != std::string_view::npos;
  };
  EXPECT_TRUE(has(false, "arc_length"));  // of paths alone
  EXPECT_FALSE(has(true, "arc_length"));
  EXPECT_TRUE(has(true, "smaller steps"));
  for (const std::string_view of_motions : {"rho_infinity", "scheme"}) {
    EXPECT_TRUE(has(true, of_motions));
    EXPECT_FALSE(has(false, of_motions));
  }
}

TEST(Dimension, HasANameAndAnSiUnit) {
  EXPECT_EQ(si_unit(Dimension::Stress), "Pa");
  EXPECT_EQ(name_of(Dimension::Strain), "strain");
}

TEST(Version, IsTheProjects) { EXPECT_FALSE(version().empty()); }

}  // namespace
}  // namespace plastica
