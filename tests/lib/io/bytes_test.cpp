#include "plastica/io/bytes.hpp"

#include <gtest/gtest.h>

#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

enum class Colour : std::int32_t { Red = 7 };

ByteWriter everything() {
  ByteWriter writer;
  writer.put(true).put(-1.5).put(std::int32_t{-3}).put(Colour::Red).put("text").put(std::string());
  writer.put(std::vector<double>{1.0, 2.0}).put(std::vector<std::string>{"a", "", "c"});
  writer.put(std::optional<double>(0.25)).put(std::optional<double>());
  return writer;
}

TEST(Bytes, ComeBackAsTheyWerePut) {
  const ByteWriter writer = everything();
  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.get<bool>(), true);
  EXPECT_EQ(reader.get<double>(), -1.5);
  EXPECT_EQ(reader.get<std::int32_t>(), -3);
  EXPECT_EQ(reader.get<Colour>(), Colour::Red);
  EXPECT_EQ(reader.get<std::string>(), "text");
  EXPECT_EQ(reader.get<std::string>(), "");
  EXPECT_EQ(reader.get<std::vector<double>>(), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(reader.get<std::vector<std::string>>(), (std::vector<std::string>{"a", "", "c"}));
  EXPECT_EQ(reader.get<std::optional<double>>(), 0.25);
  EXPECT_EQ(reader.get<std::optional<double>>(), std::nullopt);
  EXPECT_EQ(reader.remaining(), 0U);
  EXPECT_NO_THROW(reader.expect_end());
}

TEST(Bytes, AreLittleEndianWithoutPadding) {
  ByteWriter writer;
  writer.put(std::uint8_t{9}).put(std::uint32_t{0x01020304}).put("x");
  const std::vector<int> wanted{9, 4, 3, 2, 1, 1, 0, 0, 0, 0, 0, 0, 0, 'x'};
  std::vector<int> bytes;
  for (const std::byte byte : writer.bytes()) bytes.push_back(std::to_integer<int>(byte));
  EXPECT_EQ(bytes, wanted);
}

TEST(Bytes, ARecordCutAnywhereIsAnError) {
  const std::vector<std::byte> whole = everything().take();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ByteReader reader({whole.data(), size}, "case 7");
    const auto read_all = [&] {
      reader.get<bool>();
      reader.get<double>();
      reader.get<std::int32_t>();
      reader.get<Colour>();
      reader.get<std::string>();
      reader.get<std::string>();
      reader.get<std::vector<double>>();
      reader.get<std::vector<std::string>>();
      reader.get<std::optional<double>>();
      reader.get<std::optional<double>>();
    };
    EXPECT_EQ(message_from<StorageError>(read_all), "case 7: ends in the middle of a value")
        << size;
  }
}

TEST(Bytes, AnAbsurdLengthIsAnErrorAndAsksForNoMemory) {
  ByteWriter writer;
  writer.put(~std::uint64_t{0});
  const auto get = [&]<typename T>(T) {
    return message_from<StorageError>([&] { ByteReader(writer.bytes()).get<T>(); });
  };
  EXPECT_EQ(get(std::string()), "record: ends in the middle of a value");
  EXPECT_EQ(get(std::vector<double>()), "record: ends in the middle of a value");
  EXPECT_EQ(get(std::vector<std::string>()), "record: ends in the middle of a value");
}

TEST(Bytes, SomethingLeftIsAnErrorWhereTheEndIsExpected) {
  ByteWriter writer;
  writer.put(std::uint8_t{1}).put(std::uint16_t{2});
  ByteReader reader(writer.bytes());
  reader.get<std::uint8_t>();
  EXPECT_EQ(message_from<StorageError>([&] { reader.expect_end(); }),
            "record: has 2 bytes too many");
}

}  // namespace
}  // namespace plastica::io
