#include "plastica/io/shard.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "plastica/base/check.hpp"
#include "plastica/io/storage_error.hpp"
#include "tests/lib/io/message_from.hpp"

namespace plastica::io {
namespace {

std::vector<std::string> some_ids(std::size_t count) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < count; ++i) ids.push_back("specimen-" + std::to_string(i));
  return ids;
}

std::vector<bool> own_cases(const std::vector<std::string>& ids, const Shard& shard) {
  std::vector<bool> own;
  for (const std::size_t index : dealt(ids, shard.count)) own.push_back(index == shard.index);
  return own;
}

TEST(Shard, IsReadFromItsNumberAndTheirs) {
  EXPECT_EQ(parse_shard("--shard", "2/7"), (Shard{2, 7}));
  EXPECT_EQ(parse_shard("--shard", "1/1"), (Shard{1, 1}));
  EXPECT_EQ(shard_path("fit.h5", {2, 7}), "fit.h5.shard-2-of-7");
  EXPECT_EQ(words_of(Shard{2, 7}), "shard 2 of 7");
}

TEST(Shard, RefusesWhatIsNoNumberOfOne) {
  const auto said = [](const std::string& text) {
    return message_from<InputError>([&] { parse_shard("--shard", text); });
  };
  for (const char* text : {"", "2", "2/", "/7", "a/7", "2/b", "2/7/9", "-1/7", "2 / 7", "2.0/7",
                           "99999999999999999999999/7"}) {
    EXPECT_EQ(said(text),
              std::string("--shard") + (*text != '\0' ? " = " : "") + text +
                  ": must be the number of a shard and how many there are, such as 2/7");
  }
  EXPECT_EQ(said("0/7"), "--shard = 0/7: the number of a shard must be 1 … 7");
  EXPECT_EQ(said("8/7"), "--shard = 8/7: the number of a shard must be 1 … 7");
  EXPECT_EQ(said("1/0"), "--shard = 1/0: there must be 1 … 100000 shards");
  EXPECT_EQ(said("1/100001"), "--shard = 1/100001: there must be 1 … 100000 shards");
}

TEST(Shard, ShardsHaveEachCaseOnceAndAsManyAsOneAnother) {
  for (const std::size_t cases : {0U, 1U, 5U, 43U, 1000U}) {
    const std::vector<std::string> ids = some_ids(cases);
    for (const std::size_t count : {1U, 2U, 3U, 7U, 64U}) {
      std::vector<int> times(cases, 0);
      for (std::size_t index = 1; index <= count; ++index) {
        const std::vector<bool> own = own_cases(ids, {index, count});
        ASSERT_EQ(own.size(), cases);
        const auto many = static_cast<std::size_t>(std::count(own.begin(), own.end(), true));
        EXPECT_GE(many, cases / count);
        EXPECT_LE(many, (cases + count - 1) / count);
        for (std::size_t i = 0; i < cases; ++i) times[i] += own[i] ? 1 : 0;
      }
      EXPECT_EQ(times, std::vector<int>(cases, 1)) << cases << " in " << count;
    }
  }
}

TEST(Shard, IsTheSameOfCasesInWhateverOrder) {
  std::vector<std::string> ids = some_ids(50);
  const std::vector<bool> own = own_cases(ids, {3, 7});
  std::reverse(ids.begin(), ids.end());
  std::vector<bool> reversed = own_cases(ids, {3, 7});
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(reversed, own);
}

// Every fourth case is one that takes long, as in a sweep whose last axis has four numbers of
// segments: dealt in turn, one of four shards would have them all.
TEST(Shard, DoesNotFollowTheAxesOfASweep) {
  const std::vector<std::string> ids = some_ids(400);
  for (std::size_t index = 1; index <= 4; ++index) {
    const std::vector<bool> own = own_cases(ids, {index, 4});
    int slow = 0;
    for (std::size_t i = 3; i < ids.size(); i += 4) slow += own[i] ? 1 : 0;
    EXPECT_GT(slow, 10) << index;
    EXPECT_LT(slow, 40) << index;
  }
}

TEST(ShardMark, ComesBackFromItsBytes) {
  const ShardMark mark{{2, 7}, "00ff", "avx2", {"calibrate", "a b.toml", "--laws=ideal"}};
  const ShardMark back = shard_mark_from_bytes(bytes_of(mark), "x");
  EXPECT_EQ(back.shard, mark.shard);
  EXPECT_EQ(back.run, mark.run);
  EXPECT_EQ(back.instruction_set, mark.instruction_set);
  EXPECT_EQ(back.words, mark.words);
}

TEST(ShardMark, RefusesBytesThatAreNone) {
  std::vector<std::byte> bytes = bytes_of(ShardMark{{2, 7}, "00ff", "avx2", {}});
  bytes[0] = std::byte{8};
  EXPECT_EQ(message_from<StorageError>([&] { shard_mark_from_bytes(bytes, "x"); }),
            "x: says that it is shard 8 of 7");
  bytes.pop_back();
  EXPECT_NE(message_from<StorageError>([&] { shard_mark_from_bytes(bytes, "x"); }), "no error");
}

}  // namespace
}  // namespace plastica::io
