#include "calibrate/target/group_values.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace plastica::calibrate {
namespace {

using Texts = std::vector<std::string>;

std::vector<Target> targets_of(const std::string& column, const Texts& values) {
  std::vector<Target> targets(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) targets[i].group = {{column, values[i]}};
  return targets;
}

Texts texts_of(const std::vector<Target>& targets) {
  Texts texts;
  for (const Target& target : targets) texts.push_back(target.group.at(0).second);
  return texts;
}

Texts united(const Texts& values) {
  std::vector<Target> targets = targets_of("temperature", values);
  GroupValues().unite(targets);
  return texts_of(targets);
}

TEST(GroupValues, HaveTheFirstTextOfANumber) {
  EXPECT_EQ(united({"20", "20.0", "020", "2e1", "+20", "20,0"}), Texts(6, "20"));
  EXPECT_EQ(united({"2e1", "20", "-5.50", "-5.5"}), (Texts{"2e1", "2e1", "-5.50", "-5.50"}));
  EXPECT_EQ(united({"0", "-0.0", "21", "20.9"}), (Texts{"0", "0", "21", "20.9"}));
}

TEST(GroupValues, StayAsTheyAreWhereTheyAreNoNumbers) {
  const Texts texts{"room", "Room", "nan", "NaN", "inf", "Inf", "", "-", "20 C", "20.0 C", "1e999"};
  EXPECT_EQ(united(texts), texts);
}

TEST(GroupValues, StayAsTheyAreWhereTheNumberIsNotCertain) {
  // One double; 1234 or 1.234.
  const Texts texts{"12345678901234567", "12345678901234568", "1.234", "1,234", "1234"};
  EXPECT_EQ(united(texts), texts);
}

TEST(GroupValues, AreUnitedAcrossBlocksForEachColumnAlone) {
  GroupValues values;
  std::vector<Target> first = targets_of("temperature", {"20.0"});
  std::vector<Target> second = targets_of("temperature", {"20", "room"});
  std::vector<Target> other = targets_of("lot", {"20"});
  for (std::vector<Target>* const block : {&first, &second, &other}) values.unite(*block);
  EXPECT_EQ(texts_of(second), (Texts{"20.0", "room"}));
  EXPECT_EQ(texts_of(other), Texts{"20"});
}

}  // namespace
}  // namespace plastica::calibrate
