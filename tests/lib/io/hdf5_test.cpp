#include "plastica/io/hdf5.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <type_traits>

#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

using Strings = std::vector<std::string>;

std::vector<double> ramp(std::size_t count) {
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 0.0);
  return values;
}

void fill(Hdf5File& file) {
  Hdf5Group& root = file.root();
  root.set_attribute(".", "schema", "plastica-fit");
  root.set_attribute(".", "version", 1);
  root.write_texts("inputs/names", Strings{"b.csv", "ä µm", ""});
  for (const char* name : {"zeta", "alpha", "mid"}) {
    Hdf5Group group = root.group(std::string("fits/") + name);
    group.write("stress", ramp(5000), {.units = "Pa", .deflate = 4});
    group.write_text("status", "converged");
    group.set_attribute(".", "axes", Strings{"x", "y"});
  }
}

TEST(Hdf5, SaysWhichVersionRuns) {
  const std::string version = hdf5_version();
  EXPECT_TRUE(version.starts_with("1.") || version.starts_with("2.")) << version;
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2) << version;
}

TEST(Hdf5, WritesColumnsPieceByPieceAsAtOnce) {
  const ScratchFolder folder;
  for (const std::size_t count : {0U, 1U, 511U, 512U, 513U, 100'000U, 600'000U}) {
    const std::vector<double> values = ramp(count);
    const DatasetOptions options{.units = "Pa", .deflate = 1};
    Hdf5File whole = Hdf5File::create(folder.file("whole.h5"));
    whole.root().write("values", values, options);
    whole.commit();
    Hdf5File pieces = Hdf5File::create(folder.file("pieces.h5"));
    Hdf5Column column = pieces.root().column("values", count, options);
    const std::span all(values);
    for (std::size_t i = 0; i < count; i += 70'001) {
      column.append(all.subspan(i, std::min<std::size_t>(70'001, count - i)));
    }
    EXPECT_THROW(column.append(ramp(1)), std::logic_error);
    column.finish();
    pieces.commit();
    EXPECT_EQ(content_of(folder.file("whole.h5")), content_of(folder.file("pieces.h5"))) << count;
  }
  Hdf5File file = Hdf5File::create(folder.file("short.h5"));
  Hdf5Column column = file.root().column("values", 2);
  column.append(ramp(1));
  EXPECT_THROW(column.finish(), std::logic_error);
  EXPECT_THROW(column.append(std::vector<float>{1.0F}), std::logic_error);
}

TEST(Hdf5, WritesTablesOfEveryTypePieceByPieceAsAtOnce) {
  const ScratchFolder folder;
  const auto same = [&](const auto& values, std::size_t columns) {
    using T = typename std::remove_cvref_t<decltype(values)>::value_type;
    const DatasetOptions options{.units = "m", .deflate = 1};
    Hdf5File whole = Hdf5File::create(folder.file("whole.h5"));
    whole.root().write_table("a/values", std::span<const T>(values), columns, options);
    whole.commit();
    Hdf5File pieces = Hdf5File::create(folder.file("pieces.h5"));
    const std::size_t shape[] = {values.size() / columns, columns};
    Hdf5Column column = pieces.root().column<T>("a/values", shape, options);
    const std::span all(values);
    for (std::size_t i = 0; i < all.size(); i += 10'007) {
      column.append(all.subspan(i, std::min<std::size_t>(10'007, all.size() - i)));
    }
    column.finish();
    pieces.commit();
    EXPECT_EQ(content_of(folder.file("whole.h5")), content_of(folder.file("pieces.h5")));
  };
  for (const std::size_t rows : {1U, 100U, 100'000U}) {
    const std::vector<double> numbers = ramp(3 * rows);
    same(numbers, 3);
    same(std::vector<float>(numbers.begin(), numbers.end()), 3);
    same(std::vector<std::int32_t>(numbers.begin(), numbers.end()), 3);
  }
}

TEST(Hdf5, GivesBackNumbersOfEveryType) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  const std::vector<std::int64_t> big{std::numeric_limits<std::int64_t>::min(), 7};
  {
    Hdf5File file = Hdf5File::create(path);
    Hdf5Group& root = file.root();
    root.write("double", std::vector<double>{1.5, -0.0, NAN});
    root.write("float", std::vector<float>{0.25F});
    root.write("int32", std::vector<std::int32_t>{-3});
    root.write("int64", big);
    root.write("uint64", std::vector<std::uint64_t>{~std::uint64_t{0}});
    root.write("bool", std::vector<std::uint8_t>{0, 1});
    root.write("scalar", 2.5, {.units = "Pa"});
    root.write("empty", std::vector<double>{});
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  const std::vector<double> doubles = root.read<double>("double");
  EXPECT_EQ(doubles[0], 1.5);
  EXPECT_TRUE(std::signbit(doubles[1]));
  EXPECT_TRUE(std::isnan(doubles[2]));
  EXPECT_EQ(root.read<float>("float"), std::vector<float>{0.25F});
  EXPECT_EQ(root.read<std::int32_t>("int32"), std::vector<std::int32_t>{-3});
  EXPECT_EQ(root.read<std::int64_t>("int64"), big);
  EXPECT_EQ(root.read<std::uint64_t>("uint64").at(0), ~std::uint64_t{0});
  EXPECT_EQ(root.read<std::uint8_t>("bool"), (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(root.read_scalar<double>("scalar"), 2.5);
  EXPECT_EQ(root.text_attribute("scalar", "units"), "Pa");
  EXPECT_TRUE(root.read<double>("empty").empty());
  EXPECT_EQ(root.shape("empty"), std::vector<std::size_t>{0});
  EXPECT_EQ(root.read<double>("int32"), std::vector<double>{-3.0});
}

TEST(Hdf5, GivesBackTablesAndRaggedRows) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  {
    Hdf5File file = Hdf5File::create(path);
    file.root().write_table("flat", std::span<const double>(ramp(6)), 3);
    file.root().write_table("packed", std::span<const double>(ramp(90000)), 3,
                            {.units = "", .deflate = 9});
    Ragged<double> rows;
    rows.push_back(std::vector<double>{1.0, 2.0});
    rows.push_back({});
    rows.push_back(std::vector<double>{3.0});
    file.root().write_ragged("history", rows, {.units = "Pa", .deflate = 1});
    file.commit();
  }
  EXPECT_LT(std::filesystem::file_size(path), 90000U * 8U / 2U);
  const Hdf5File file = Hdf5File::open(path);
  EXPECT_EQ(file.root().shape("flat"), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(file.root().read_array<double>("flat", std::array<std::size_t, 2>{2, 3}), ramp(6));
  EXPECT_EQ(file.root().shape("packed"), (std::vector<std::size_t>{30000, 3}));
  const std::array<std::size_t, 2> any_rows{Hdf5Group::kAnyExtent, 3};
  EXPECT_EQ(file.root().read_array<double>("packed", any_rows), ramp(90000));
  const Ragged<double> rows = file.root().read_ragged<double>("history");
  ASSERT_EQ(rows.rows(), 3U);
  EXPECT_EQ(rows.row(0).size(), 2U);
  EXPECT_TRUE(rows.row(1).empty());
  EXPECT_EQ(rows.row(2)[0], 3.0);
  EXPECT_EQ(file.root().text_attribute("history/values", "units"), "Pa");
}

// Long columns of texts are stored side by side, of one width.
TEST(Hdf5, GivesBackColumnsOfTexts) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  Strings words(20'000, "gauss-newton");
  words[1] = "";
  words[19'999] = "20 °C, ä";
  Strings one_is_long(20'000, "x");
  one_is_long[7] = std::string(100'000, 'y') + " 20 °C";
  const Strings empty(20'000);
  const std::pair<const char*, const Strings*> columns[] = {
      {"words", &words}, {"one_is_long", &one_is_long}, {"empty", &empty}};
  {
    Hdf5File file = Hdf5File::create(path);
    for (const auto& [name, texts] : columns) file.root().write_texts(name, *texts);
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  for (const auto& [name, texts] : columns) {
    EXPECT_EQ(file.root().kind(name), Hdf5Kind::Text);
    EXPECT_EQ(file.root().read_texts(name), *texts) << name;
  }
  // One place each took 16 bytes and more a word.
  EXPECT_LT(std::filesystem::file_size(path), 1'500'000U);
}

TEST(Hdf5, GivesBackTextsAndAttributes) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  {
    Hdf5File file = Hdf5File::create(path);
    Hdf5Group& root = file.root();
    root.write_text("text", "zwei\nZeilen, 20 °C");
    root.write_texts("texts", Strings{"a", "", "ß"});
    root.write_texts("none", Strings{});
    root.set_attribute("text", "real", 1.5);
    root.set_attribute("text", "count", std::int64_t{1} << 40U);
    root.set_attribute("text", "names", Strings{"x", "yy"});
    root.set_attribute("text", "note", "first");
    root.set_attribute("text", "note", "second, and longer");
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  EXPECT_EQ(root.read_text("text"), "zwei\nZeilen, 20 °C");
  EXPECT_EQ(root.read_texts("texts"), (Strings{"a", "", "ß"}));
  EXPECT_TRUE(root.read_texts("none").empty());
  EXPECT_EQ(root.real_attribute("text", "real"), 1.5);
  EXPECT_EQ(root.real_attribute("text", "count"), std::ldexp(1.0, 40));
  EXPECT_EQ(root.integer_attribute("text", "count"), std::int64_t{1} << 40U);
  EXPECT_EQ(root.texts_attribute("text", "names"), (Strings{"x", "yy"}));
  EXPECT_EQ(root.text_attribute("text", "note"), "second, and longer");
  EXPECT_FALSE(root.has_attribute("text", "other"));
}

TEST(Hdf5, ListsGroupsInTheOrderOfWriting) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  {
    Hdf5File file = Hdf5File::create(path);
    fill(file);
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  EXPECT_EQ(root.children(), (Strings{"inputs", "fits"}));
  const Hdf5Group fits = root.open_group("fits");
  EXPECT_EQ(fits.path(), "/fits");
  EXPECT_EQ(fits.children(), (Strings{"zeta", "alpha", "mid"}));
  EXPECT_EQ(fits.kind("mid"), Hdf5Kind::Group);
  EXPECT_EQ(fits.kind("mid/stress"), Hdf5Kind::Real);
  EXPECT_EQ(fits.kind("/inputs/names"), Hdf5Kind::Text);
  EXPECT_EQ(fits.kind("."), Hdf5Kind::Group);
  EXPECT_EQ(fits.kind("nowhere/stress"), Hdf5Kind::None);
  EXPECT_FALSE(fits.exists("mid/strain"));
  EXPECT_EQ(fits.open_group("alpha").read_text("status"), "converged");
}

TEST(Hdf5, TheSameContentGivesTheSameBytes) {
  const ScratchFolder folder;
  for (const char* name : {"a.h5", "b.h5"}) {
    // What lay in memory before must not reach the file.
    const std::vector<char> noise(200'000, name[0]);
    Hdf5File file = Hdf5File::create(folder.file(name));
    fill(file);
    file.commit();
  }
  const std::string first = content_of(folder.file("a.h5"));
  EXPECT_GT(first.size(), 1000U);
  EXPECT_TRUE(first == content_of(folder.file("b.h5")));
}

TEST(Hdf5, AppearsUnderItsNameWhenCommitted) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.h5", "older");
  {
    Hdf5File file = Hdf5File::create(path);
    fill(file);
    EXPECT_EQ(folder.names().size(), 2U);
    EXPECT_EQ(content_of(path), "older");
    file.commit();
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.h5"});
  EXPECT_TRUE(Hdf5File::open(path).root().exists("fits"));
}

TEST(Hdf5, LeavesNothingBehindWithoutACommit) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.h5", "older");
  {
    Hdf5File begun = Hdf5File::create(path);
    fill(begun);
    const Hdf5File moved = std::move(begun);
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.h5"});
  EXPECT_EQ(content_of(path), "older");
}

}  // namespace
}  // namespace plastica::io
