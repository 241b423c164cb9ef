#include "plastica/io/toml_edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "plastica/io/toml.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using testing::message_of;

using Written = std::map<std::string, std::string>;

/// Every value of a text that is no table, by its full key, as it is written.
void collect(const TomlValue& value, Written& values) {
  if (value.is_table()) {
    for (const std::string& name : value.table().keys()) collect(value.table().at(name), values);
    return;
  }
  const bool tables = value.is_array() && !value.array().empty() && value.array()[0].is_table();
  if (!tables) {
    values[value.key()] = value.written();
    return;
  }
  for (const TomlValue& item : value.array()) collect(item, values);
}

Written values_of(const std::string& text) {
  const TomlTable root = TomlDocument::parse(text, "edited").root();
  Written values;
  for (const std::string& name : root.keys()) collect(root.at(name), values);
  return values;
}

/// Sets a value, and checks that the result is TOML that has it and all that it had before.
std::string set(const std::string& text, const std::string& path, const std::string& value) {
  std::string edited = set_toml_value(text, path, value);
  Written expected = values_of(text);
  expected[path] = value;
  EXPECT_EQ(values_of(edited), expected) << edited;
  EXPECT_TRUE(has_toml_key(edited, path));
  return edited;
}

TEST(TomlEdit, ReplacesAValueWhereItStands) {
  EXPECT_EQ(set("# a\n[beam]  # b\nlength = \"1 m\"   # c\nsegments= 8# d\n\n[solver]\nsteps = 4\n",
                "beam.segments", "32"),
            "# a\n[beam]  # b\nlength = \"1 m\"   # c\nsegments= 32# d\n\n[solver]\nsteps = 4\n");
  EXPECT_EQ(set("a = 'x'\nb = 2", "b", "\"20 mm\""), "a = 'x'\nb = \"20 mm\"");
  EXPECT_EQ(set("[a]\nb.c = 1\nb.d = 2\n", "a.b.c", "7"), "[a]\nb.c = 7\nb.d = 2\n");
  EXPECT_EQ(set("[a.b]\nc = 1\n[a]\nd = 2\n", "a.b.c", "7"), "[a.b]\nc = 7\n[a]\nd = 2\n");
}

TEST(TomlEdit, ReplacesTheValueOfAnOldKey) {
  EXPECT_EQ(set_toml_value("[solver]\nmost_iterations = 5\n", "solver.max_iterations", "9"),
            "[solver]\nmost_iterations = 9\n");
}

TEST(TomlEdit, ReplacesInsideInlineTables) {
  const std::string text = "[beam]\nsection = { shape = \"rectangle\", height = \"20 mm\" }\n";
  EXPECT_EQ(set(text, "beam.section.height", "\"25 mm\""),
            "[beam]\nsection = { shape = \"rectangle\", height = \"25 mm\" }\n");
  EXPECT_EQ(set("a = {b={c=1,d=2}, e = 3}", "a.b.c", "4"), "a = {b={c=4,d=2}, e = 3}");
}

TEST(TomlEdit, ReplacesWholeInlineTablesAndLists) {
  EXPECT_EQ(set_toml_value("a = { b = 1 } # c\n", "a", "{ b = 2, d = 3 }"),
            "a = { b = 2, d = 3 } # c\n");
  EXPECT_EQ(set("a = [ [1, 2], [3] ]\nb = 0\n", "a", "[5]"), "a = [5]\nb = 0\n");
  EXPECT_EQ(set("a = []\n", "a", "[5]"), "a = [5]\n");
}

TEST(TomlEdit, ReplacesValuesThatSpanLines) {
  EXPECT_EQ(set("a = [\n  1,  # one\n  2,\n]  # end\nb = 1\n", "a", "[3]"),
            "a = [3]  # end\nb = 1\n");
  EXPECT_EQ(set("a = \"\"\"\nx\n[y]\n\"\"\"\nb = 1\n", "a", "\"z\""), "a = \"z\"\nb = 1\n");
  EXPECT_EQ(set("a = 1\nb = 2\n", "a", "[\n  1,\n]"), "a = [\n  1,\n]\nb = 2\n");
}

TEST(TomlEdit, CountsCharactersNotBytes) {
  EXPECT_EQ(set("a = { m = \"\u00b5\u2126\", n = 1 } # \u00b5\n", "a.n", "2"),
            "a = { m = \"\u00b5\u2126\", n = 2 } # \u00b5\n");
  EXPECT_EQ(set("a = 1\n", "a", "\"\u00b5m\""), "a = \"\u00b5m\"\n");
}

TEST(TomlEdit, KeepsLineEndsAndByteOrderMark) {
  EXPECT_EQ(set("[a]\r\nb = 1  # x\r\n\r\n[c]\r\nd = 2\r\n", "a.b", "3"),
            "[a]\r\nb = 3  # x\r\n\r\n[c]\r\nd = 2\r\n");
  EXPECT_EQ(set("[a]\r\nb = 1\r\n\r\n[c]\r\nd = 2\r\n", "a.n", "3"),
            "[a]\r\nb = 1\r\nn = 3\r\n\r\n[c]\r\nd = 2\r\n");
  EXPECT_EQ(set("\xEF\xBB\xBF"
                "a = 1\n",
                "a", "2"),
            "\xEF\xBB\xBF"
            "a = 2\n");
  EXPECT_EQ(set("\xEF\xBB\xBF"
                "[a]\nb = 1",
                "a.c", "2"),
            "\xEF\xBB\xBF"
            "[a]\nb = 1\nc = 2\n");
}

TEST(TomlEdit, AddsAKeyAtTheEndOfItsTable) {
  EXPECT_EQ(set("[a]\nb = 1 # x\n\n# of c\n[c]\nd = 2\n", "a.n", "3"),
            "[a]\nb = 1 # x\nn = 3\n\n# of c\n[c]\nd = 2\n");
  EXPECT_EQ(set("[a]\n  b = [\n    1,\n    2,\n  ]\n[c]\n", "a.n", "3"),
            "[a]\n  b = [\n    1,\n    2,\n  ]\n  n = 3\n[c]\n");
  EXPECT_EQ(set("[a]\n\n[c]\nd = 2", "a.n", "3"), "[a]\nn = 3\n\n[c]\nd = 2");
  EXPECT_EQ(set("[a]\n\n[c]\nd = 2", "c.n", "3"), "[a]\n\n[c]\nd = 2\nn = 3\n");
  EXPECT_EQ(set("[a.b]\nc = 1\n[a]\nd = 2\n[e]\n", "a.n", "3"),
            "[a.b]\nc = 1\n[a]\nd = 2\nn = 3\n[e]\n");
}

TEST(TomlEdit, AddsAKeyInsideBraces) {
  EXPECT_EQ(set("a = { b = 1 } # x\n", "a.n", "3"), "a = { b = 1, n = 3 } # x\n");
  EXPECT_EQ(set("a = {b=1}\n", "a.n.m", "3"), "a = {b=1, n.m = 3}\n");
  EXPECT_EQ(set("a = {}\n", "a.n", "3"), "a = { n = 3 }\n");
  EXPECT_EQ(set("a = {  }\n", "a.n", "3"), "a = { n = 3 }\n");
  EXPECT_EQ(set("a = { b.c = 1 }\n", "a.b.n", "3"), "a = { b.c = 1, b.n = 3 }\n");
}

TEST(TomlEdit, AddsAKeyToATableOfDottedKeys) {
  EXPECT_EQ(set("[a]\nb.c = 1\nd = 2\n[e]\n", "a.b.n", "3"), "[a]\nb.c = 1\nd = 2\nb.n = 3\n[e]\n");
  EXPECT_EQ(set("a.b.c = 1\n[e]\n", "a.b.n", "3"), "a.b.c = 1\na.b.n = 3\n[e]\n");
  EXPECT_EQ(set("a.b.c = 1\n[e]\n", "a.n.m", "3"), "a.b.c = 1\na.n.m = 3\n[e]\n");
}

TEST(TomlEdit, AddsATopLevelKeyAboveAllHeaders) {
  EXPECT_EQ(set("a = 1\n\n[b]\nc = 2\n", "n", "3"), "a = 1\nn = 3\n\n[b]\nc = 2\n");
  EXPECT_EQ(set("# title\n\n# of b\n[b]\nc = 2\n", "n", "3"),
            "# title\n\nn = 3\n\n# of b\n[b]\nc = 2\n");
  EXPECT_EQ(set("# title\n[b]\nc = 2\n", "n", "3"), "n = 3\n\n# title\n[b]\nc = 2\n");
  EXPECT_EQ(set("# title", "n", "3"), "# title\nn = 3\n");
  EXPECT_EQ(set("", "n", "3"), "n = 3\n");
}

TEST(TomlEdit, AddsATableBeforeTheFirstListOfTables) {
  EXPECT_EQ(set("[a]\nb = 1\n\n# of c\n[[c]]\nd = 1\n[[c]]\nd = 2\n", "n.m", "3"),
            "[a]\nb = 1\n\n[n]\nm = 3\n\n# of c\n[[c]]\nd = 1\n[[c]]\nd = 2\n");
  EXPECT_EQ(set("[a]\nb = 1", "n.m.o", "3"), "[a]\nb = 1\n\n[n.m]\no = 3\n");
  EXPECT_EQ(set("[a]\nb = 1\n", "a.m.o", "3"), "[a]\nb = 1\n\n[a.m]\no = 3\n");
  EXPECT_EQ(set("# title\n\n# of c\n[[c]]\nd = 1\n", "n.m", "3"),
            "# title\n\n[n]\nm = 3\n\n# of c\n[[c]]\nd = 1\n");
  EXPECT_EQ(set("# title\n", "n.m", "3"), "# title\n\n[n]\nm = 3\n");
  EXPECT_EQ(set("", "n.m", "3"), "[n]\nm = 3\n");
}

TEST(TomlEdit, AddsAHeaderWhereTablesBelowHaveThem) {
  EXPECT_EQ(set("[e]\n\n# of b\n[a.b]\nc = 1\n", "a.n", "3"),
            "[e]\n\n[a]\nn = 3\n\n# of b\n[a.b]\nc = 1\n");
  EXPECT_EQ(set("[[s]]\n[s.a.b]\nc = 1\n[[s]]\n[s.a.b]\nc = 2\n", "s[1].a.n", "3"),
            "[[s]]\n[s.a]\nn = 3\n\n[s.a.b]\nc = 1\n[[s]]\n[s.a.b]\nc = 2\n");
}

TEST(TomlEdit, GoesThroughElementsOfLists) {
  const std::string text = "[[s]]\na = 1\n[[s]]\na = 2\n[s.b]\nc = 3\n[[s]]\na = 4\nv = [5, 6]\n";
  EXPECT_EQ(set(text, "s[2].a", "7"),
            "[[s]]\na = 1\n[[s]]\na = 7\n[s.b]\nc = 3\n[[s]]\na = 4\nv = [5, 6]\n");
  EXPECT_EQ(set(text, "s[2].n", "7"),
            "[[s]]\na = 1\n[[s]]\na = 2\nn = 7\n[s.b]\nc = 3\n[[s]]\na = 4\nv = [5, 6]\n");
  EXPECT_EQ(set(text, "s[2].b.n", "7"),
            "[[s]]\na = 1\n[[s]]\na = 2\n[s.b]\nc = 3\nn = 7\n[[s]]\na = 4\nv = [5, 6]\n");
  EXPECT_EQ(set(text, "s[1].b.n", "7"),
            "[[s]]\na = 1\nb.n = 7\n[[s]]\na = 2\n[s.b]\nc = 3\n[[s]]\na = 4\nv = [5, 6]\n");
  EXPECT_EQ(set_toml_value("v = [5, 6]", "v[2]", "7"), "v = [5, 7]");
  EXPECT_EQ(set_toml_value("v = [{a = 1}, {a = 2}]", "v[2].b", "7"),
            "v = [{a = 1}, {a = 2, b = 7}]");
}

TEST(TomlEdit, TakesNoBracketOfAValueForAHeader) {
  const std::string text = "[a]\nb = [\n[1],\n  [2]\n]\nc = '''\n[d]\n'''\n";
  EXPECT_EQ(set(text, "a.n", "3"), text + "n = 3\n");
}

TEST(TomlEdit, KnowsWhichKeysThereAre) {
  const std::string text = "a = { b = 1 }\n[c]\nd.e = 2\n[[s]]\nv = [1]\n";
  for (const char* path : {"a", "a.b", "c", "c.d", "c.d.e", "s", "s[1]", "s[1].v", "s[1].v[1]"}) {
    EXPECT_TRUE(has_toml_key(text, path)) << path;
  }
  for (const char* path : {"b", "a.c", "a.b.c", "c.e", "s.v", "s[2]", "s[1].v[2]", "a[1]"}) {
    EXPECT_FALSE(has_toml_key(text, path)) << path;
  }
}

TEST(TomlEditErrors, SayWhyAValueCannotBeSet) {
  const auto error = [](const std::string& text, const std::string& path,
                        const std::string& value) {
    return message_of([&] { set_toml_value(text, path, value); });
  };
  EXPECT_EQ(error("a = 1\n", "a.b", "2"), "a: is no table");
  EXPECT_EQ(error("[a]\nb = 1\n", "a", "2"), "a = 2: is a table and cannot become a value");
  EXPECT_EQ(error("a.b = 1\n", "a", "2"), "a = 2: is a table and cannot become a value");
  EXPECT_EQ(error("[[a]]\n", "a.b", "2"), "a: is a list: name the element, a[1]");
  EXPECT_EQ(error("[[a]]\n", "a[2].b", "2"), "a: has no element 2");
  EXPECT_EQ(error("b = 1\n", "a[1]", "2"), "a: has no element 1");
  for (const char* path : {"", ".", "a.", "a..b", "a b", "a[0]", "a[x]", "a]", "[1]", "a[1][2]"}) {
    EXPECT_EQ(error("a = 1\n", path, "2"), std::string(path) + (*path == '\0' ? "" : ": ") +
                                               "must be names with points between, beam.segments");
  }
  for (const char* value : {"", "1\nb = 2", "1 # c", "word", "1 2", "[1", "\"x"}) {
    EXPECT_NE(error("a = 1\n", "a", value).find("is not a TOML value"), std::string::npos) << value;
  }
  EXPECT_NE(error("a = 1\nb = = 2\n", "a", "2").find("is not TOML"), std::string::npos);
}

TEST(TomlEdit, ChangesOneValueOfASceneAndNothingElse) {
  const std::string folder = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/";
  for (const char* scene : {"cantilever", "crash_bumper", "report_proposal5_wood"}) {
    const TomlDocument document = TomlDocument::read(folder + scene + ".toml");
    const Written values = values_of(document.text());
    ASSERT_GE(values.size(), 10U);
    for (const auto& [path, written] : values) {
      const std::string edited = set(document.text(), path, "\"edited\"");
      EXPECT_EQ(edited.size() - 8, document.text().size() - written.size()) << path;
      EXPECT_EQ(set(edited, path, written), document.text()) << path;
      const std::size_t point = path.rfind('.');
      if (point == std::string::npos) continue;
      const std::string added = set(document.text(), path.substr(0, point) + ".added", "[1, 2]");
      EXPECT_GT(added.size(), document.text().size()) << path;
    }
    set(document.text(), "new.table.added", "1");
    set(document.text(), "added", "1");
  }
}

}  // namespace
}  // namespace plastica::io
