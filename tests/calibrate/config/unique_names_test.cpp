#include "calibrate/config/unique_names.hpp"

#include <gtest/gtest.h>

namespace plastica::calibrate {
namespace {

TEST(UniqueNames, NumberWhatIsThereAlready) {
  UniqueNames names;
  EXPECT_EQ(names.add("a"), "a");
  EXPECT_EQ(names.add("a"), "a#2");
  EXPECT_EQ(names.add("b"), "b");
  EXPECT_EQ(names.add("a"), "a#3");
}

TEST(UniqueNames, LeaveOutNumbersThatAreTaken) {
  UniqueNames names;
  EXPECT_EQ(names.add("a#2"), "a#2");
  EXPECT_EQ(names.add("a"), "a");
  EXPECT_EQ(names.add("a"), "a#3");
  EXPECT_EQ(names.add("a#2"), "a#2#2");
}

}  // namespace
}  // namespace plastica::calibrate
