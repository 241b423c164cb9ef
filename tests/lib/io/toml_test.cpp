#include "plastica/io/toml.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using testing::message_of;

TomlTable parsed(const std::string& text) { return TomlDocument::parse(text, "f.toml").root(); }

std::string parse_error(const std::string& text) {
  return message_of([&] { TomlDocument::parse(text, "f.toml"); });
}

TEST(Toml, GivesValuesOfEveryKind) {
  const TomlTable root = parsed(
      "word = 'tension'\nwhole = 12\nreal = 1_0.5\nyes = true\nlist = ['a', 'b']\n"
      "[table]\nkey = 1\n");
  EXPECT_EQ(root.at("word").string(), "tension");
  EXPECT_EQ(root.at("whole").integer(0, 20), 12);
  EXPECT_EQ(root.at("whole").number(), 12.0);
  EXPECT_EQ(root.at("real").number(), 10.5);
  EXPECT_TRUE(root.at("yes").boolean());
  EXPECT_EQ(root.at("list").strings(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(root.at("word").strings(), (std::vector<std::string>{"tension"}));
  EXPECT_EQ(root.find_table("table")->at("key").integer(0, 1), 1);
  EXPECT_FALSE(root.find("absent"));
  EXPECT_FALSE(root.find_table("absent"));
  EXPECT_TRUE(root.find_tables("absent").empty());
}

TEST(Toml, ReadsQuantitiesInSi) {
  const TomlTable root = parsed("a = '355 MPa'\nb = '0.2 %'\nc = 0.002\nd = 3\n");
  EXPECT_DOUBLE_EQ(root.at("a").quantity(Dimension::Stress), 355e6);
  EXPECT_DOUBLE_EQ(root.at("b").quantity(Dimension::Strain), 0.002);
  EXPECT_EQ(root.at("c").quantity(Dimension::Strain), 0.002);
  EXPECT_EQ(root.at("d").quantity(Dimension::None), 3.0);
}

TEST(Toml, KnowsFullKeyLineAndWrittenTextOfAValue) {
  const TomlTable root = parsed(
      "# \u00e9\n[[target]]\nfiles = 'a.csv'\n[[target]]\nstress = { unit = '\u00b5Pa', \"c\" = "
      "1e3 }\n"
      "many = [\n  1,\n  2.50,\n]\n");
  const auto targets = root.find_tables("target");
  ASSERT_EQ(targets.size(), 2U);
  const TomlValue stress = targets[1].at("stress");
  EXPECT_EQ(stress.key(), "target[2].stress");
  EXPECT_EQ(stress.where().line, 5);
  EXPECT_EQ(stress.where().file, "f.toml");
  EXPECT_EQ(stress.written(), "{ unit = '\u00b5Pa', \"c\" = 1e3 }");
  EXPECT_EQ(stress.table().at("c").written(), "1e3");
  EXPECT_EQ(stress.table().at("c").key(), "target[2].stress.c");
  EXPECT_EQ(targets[1].at("many").array()[1].where().line, 8);
  EXPECT_EQ(targets[1].at("many").array()[1].written(), "2.50");
  EXPECT_EQ(targets[1].at("many").array()[1].key(), "target[2].many[2]");
}

TEST(Toml, DoesNotCountAByteOrderMark) {
  EXPECT_EQ(parsed("\xEF\xBB\xBF"
                   "one = 12\n")
                .at("one")
                .written(),
            "12");
}

TEST(Toml, ListsKeysInTheOrderOfTheFile) {
  EXPECT_EQ(parsed("z = 1\na = 2\nm = 3\n").keys(), (std::vector<std::string>{"z", "a", "m"}));
}

TEST(Toml, ValuesOutliveTheDocument) {
  const TomlValue value = [] { return TomlDocument::parse("a = 'x'", "f").root().at("a"); }();
  EXPECT_EQ(value.string(), "x");
}

TEST(TomlErrors, AFileThatCannotBeReadIsNamed) {
  EXPECT_EQ(message_of([] { TomlDocument::read("no/such.toml"); }),
            "no/such.toml: cannot be read: No such file or directory");
  EXPECT_EQ(message_of([] { TomlDocument::read("/"); }), "/: cannot be read: Is a directory");
}

TEST(TomlErrors, BrokenSyntaxIsOneLineWithTheLineItself) {
  EXPECT_EQ(parse_error("a = 1\nb = \n"),
            "f.toml:2: b =: is not TOML (column 5): key-value pair: expected value, saw '\\n'");
  EXPECT_EQ(parse_error("[fit\n"),
            "f.toml:1: [fit: is not TOML (column 5): table header: expected ']', saw '\\n'");
  EXPECT_EQ(parse_error("a = 1\na = 2\n"),
            "f.toml:2: a = 2: is not TOML (column 5): key-value pair: cannot redefine existing "
            "integer 'a'");
  EXPECT_EQ(parse_error("a = \"\xff\"\n").find('\xff'), std::string::npos);
}

TEST(TomlErrors, AQuantityWithoutQuotesIsExplained) {
  EXPECT_EQ(parse_error("\nyield = 355 MPa\n"),
            "f.toml:2: yield = 355 MPa: is not TOML (column 13): key-value pair: expected a "
            "comment or whitespace, saw 'M'; words and quantities stand in quotes, \"355 MPa\"");
}

TEST(TomlErrors, AWrongKindIsShownAsWritten) {
  const TomlTable root = parsed("[t]\na = '5'\nb = 5\nc = inf\nd = ''\ne = []\nf = [1]\n");
  const TomlTable t = *root.find_table("t");
  EXPECT_EQ(message_of([&] { (void)t.at("a").number(); }),
            "f.toml:2: t.a = '5': must be a number without quotes");
  EXPECT_EQ(message_of([&] { (void)t.at("b").string(); }),
            "f.toml:3: t.b = 5: must be a text in quotes");
  EXPECT_EQ(message_of([&] { (void)t.at("b").boolean(); }),
            "f.toml:3: t.b = 5: must be true or false");
  EXPECT_EQ(message_of([&] { (void)t.at("b").array(); }),
            "f.toml:3: t.b = 5: must be a list in brackets");
  EXPECT_EQ(message_of([&] { (void)t.at("b").table(); }),
            "f.toml:3: t.b = 5: must be a table, { key = value, ... }");
  EXPECT_EQ(message_of([&] { (void)t.find_table("b"); }),
            "f.toml:3: t.b = 5: must be a table, [t.b]");
  EXPECT_EQ(message_of([&] { (void)t.find_tables("b"); }),
            "f.toml:3: t.b = 5: must be a list of tables, each with the header [[t.b]]");
  EXPECT_EQ(message_of([&] { (void)t.at("c").number(); }),
            "f.toml:4: t.c = inf: must be a finite number");
  EXPECT_EQ(message_of([&] { (void)t.at("d").string(); }),
            "f.toml:5: t.d = '': must be a text that is not empty");
  EXPECT_EQ(message_of([&] { (void)t.at("e").strings(); }),
            "f.toml:6: t.e = []: must be a text in quotes, or a list of such");
  EXPECT_EQ(message_of([&] { (void)t.at("f").strings(); }),
            "f.toml:7: t.f[1] = 1: must be a text in quotes");
}

TEST(TomlErrors, ANumberOutOfItsRangeIsRefused) {
  const TomlTable root = parsed("a = 5\nb = 1.5\n");
  EXPECT_EQ(message_of([&] { (void)root.at("a").integer(0, 4); }),
            "f.toml:1: a = 5: must be an integer from 0 to 4");
  EXPECT_EQ(message_of([&] { (void)root.at("b").integer(0, 4); }),
            "f.toml:2: b = 1.5: must be an integer from 0 to 4");
  EXPECT_EQ(message_of([&] { (void)root.at("b").number_within(0, 1, false); }),
            "f.toml:2: b = 1.5: must be above 0 and below 1");
  EXPECT_EQ(root.at("b").number_within(0, 1.5, true), 1.5);
}

TEST(TomlErrors, AWordThatIsNotOneOfThoseIsRefused) {
  static constexpr std::array<std::string_view, 2> kWords{"tension", "bending"};
  const TomlTable root = parsed("a = 'pull'\nb = 'bending'\n");
  EXPECT_EQ(root.at("b").word(kWords), 1U);
  EXPECT_EQ(message_of([&] { (void)root.at("a").word(kWords); }),
            "f.toml:1: a = 'pull': must be one of \"tension\", \"bending\"");
}

TEST(TomlErrors, AQuantityNeedsTheRightUnit) {
  const TomlTable root = parsed("[m]\na = 355\nb = '355 mm'\nc = true\n");
  const TomlTable m = *root.find_table("m");
  EXPECT_EQ(message_of([&] { (void)m.at("a").quantity(Dimension::Stress); }),
            "f.toml:2: m.a = 355: a stress needs a unit (examples: Pa, MPa, ksi)");
  EXPECT_EQ(message_of([&] { (void)m.at("b").quantity(Dimension::Stress); }),
            "f.toml:3: m.b = 355 mm: \"mm\" is not a unit of stress (examples: Pa, MPa, ksi)");
  EXPECT_EQ(message_of([&] { (void)m.at("c").quantity(Dimension::Stress); }),
            "f.toml:4: m.c = true: must be a stress in quotes, \"1 Pa\"");
}

TEST(TomlErrors, AMissingKeyIsNamedWithTheLineOfItsTable) {
  const TomlTable root = parsed("\n[[target]]\nx = 1\n");
  EXPECT_EQ(message_of([&] { (void)root.find_tables("target")[0].at("files"); }),
            "f.toml:2: target[1].files: is missing");
}

TEST(TomlErrors, AMissingKeyThatIsOnlyMistypedIsRecognized) {
  const TomlTable root = parsed("[[target]]\nflies = 'a'\n");
  EXPECT_EQ(message_of([&] { (void)root.find_tables("target")[0].at("files"); }),
            "f.toml:1: target[1].files: is missing; is it \"flies\" on line 2?");
}

TEST(TomlErrors, AKeyThatNobodyAskedForIsRefusedWithTheNearestKnownOne) {
  const TomlTable root = parsed("[fit]\nobjektive = 'x'\n");
  (void)root.find_table("fit")->find("objective");
  (void)root.find_table("fit")->find("seed");
  EXPECT_EQ(message_of([&] { root.check_unused(); }),
            "f.toml:2: fit.objektive = 'x': is not a key of fit; did you mean objective?");
}

TEST(TomlErrors, AKeyUnlikeAnyKnownOneIsRefusedWithTheListOfThem) {
  const TomlTable root = parsed("[fit]\ncolour = 1\n[[other]]\n");
  const TomlTable fit = *root.find_table("fit");
  (void)fit.find("objective");
  (void)fit.find("seed");
  EXPECT_EQ(message_of([&] { root.check_unused(); }),
            "f.toml:2: fit.colour = 1: is not a key of fit; its keys are objective, seed");
  (void)fit.find("colour");
  EXPECT_EQ(message_of([&] { root.check_unused(); }),
            "f.toml:3: other: is not a key; its keys are fit");
}

TEST(TomlErrors, KeysInListsOfTablesAreCheckedToo) {
  const TomlTable root = parsed("[[t]]\na = 1\n[[t]]\na = 1\nb = 2\n");
  for (const TomlTable& t : root.find_tables("t")) (void)t.find("a");
  EXPECT_EQ(message_of([&] { root.check_unused(); }),
            "f.toml:5: t[2].b = 2: is not a key of t[2]; its keys are a");
}

}  // namespace
}  // namespace plastica::io
