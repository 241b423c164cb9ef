#include "plastica/io/merge_shards.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "plastica/base/check.hpp"
#include "plastica/io/case_journal.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

constexpr std::uint64_t kKind = 0x77;
const std::vector<std::string> kCases{"a", "b", "c", "d", "e"};

std::vector<std::byte> result_of(const std::string& id) {
  return std::vector<std::byte>(3, static_cast<std::byte>(id.front()));
}

class MergeShards : public ::testing::Test {
 protected:
  JournalPolicy policy(const Shard& shard, bool resume = false) const {
    return {shard_path(folder_.file("out"), shard), resume, false, "avx2",
            ShardOfRun{shard, {"calibrate", "fit.toml"}}};
  }

  /// Computes a shard to its end. @return its path
  std::string make(const Shard& shard, const std::string& run = "run",
                   std::uint64_t kind = kKind) const {
    CaseJournal journal(policy(shard), kind, "fits");
    const std::vector<bool> own = journal.begin(run, kCases);
    for (std::size_t i = 0; i < kCases.size(); ++i) {
      if (own[i]) journal.keep(kCases[i], result_of(kCases[i]));
    }
    journal.end_shard();
    return policy(shard).path;
  }

  std::string merged() const { return folder_.file("merged"); }
  std::string said_of(const std::vector<std::string>& shards) const {
    const std::string said =
        message_from<InputError>([&] { merge_shards(shards, merged(), false); });
    EXPECT_FALSE(std::filesystem::exists(merged())) << said;
    return said;
  }

  ScratchFolder folder_;
};

TEST_F(MergeShards, HaveAllCasesOfTheRun) {
  const std::vector<std::string> shards{make({3, 3}), make({1, 3}), make({2, 3})};
  const ShardMark mark = merge_shards(shards, merged(), false);
  EXPECT_EQ(mark.run, "run");
  EXPECT_EQ(mark.cases, kCases.size());
  EXPECT_EQ(mark.noun, "fits");
  EXPECT_EQ(mark.words, (std::vector<std::string>{"calibrate", "fit.toml"}));
  CaseJournal journal({merged(), true, false, "avx2", {}}, kKind, "fits");
  EXPECT_EQ(journal.found(), kCases.size());
  EXPECT_EQ(journal.begin("run", kCases), std::vector<bool>(kCases.size(), true));
  for (const std::string& id : kCases) {
    ASSERT_NE(journal.find(id), nullptr) << id;
    EXPECT_EQ(*journal.find(id), result_of(id));
  }
}

// Whatever changes what is computed changes the run: a result of two halves would be of neither.
TEST_F(MergeShards, AreNoneOfARunThatHasChangedSince) {
  merge_shards(std::vector{make({1, 1})}, merged(), false);
  CaseJournal journal({merged(), true, false, "avx2", {}}, kKind, "fits");
  const auto said = [&](const std::string& run, const std::vector<std::string>& ids) {
    return message_from<InputError>([&] { journal.begin(run, ids); });
  };
  EXPECT_TRUE(said("other", kCases).starts_with("shards: were computed of other inputs"));
  EXPECT_TRUE(said("run", {"a", "f"}).starts_with("shards: were computed of other inputs"));
}

TEST_F(MergeShards, RefuseToBeIncompleteOrTwice) {
  const std::string one = make({1, 3});
  const std::string three = make({3, 3});
  EXPECT_EQ(said_of({one, three}), "shards: lack shard 2 of 3");
  EXPECT_EQ(said_of({three}), "shards: lack shards 1 and 2 of 3");
  const std::string copy = folder_.write("copy", content_of(one));
  EXPECT_EQ(said_of({one, copy}), copy + ": is shard 1 of 3, as " + one + " is");
  EXPECT_EQ(said_of({make({40, 64})}),
            "shards: lack shards 1, 2, 3, 4, 5, 6, 7, 8 and 55 more of 64");
}

TEST_F(MergeShards, RefuseThoseOfOtherRuns) {
  const std::string one = make({1, 2});
  const std::string other = make({2, 2}, "other run");
  EXPECT_EQ(said_of({one, other}), other + ": is a shard of another run than " + one +
                                       ": of other inputs, options or version");
  std::filesystem::remove(other);
  const std::string avx512 = folder_.file("wide");
  {
    CaseJournal journal({avx512, false, false, "avx512", ShardOfRun{{2, 2}, {}}}, kKind, "fits");
    journal.begin("other run", kCases);
    journal.end_shard();
  }
  EXPECT_EQ(said_of({one, avx512}), avx512 +
                                        ": was computed with the instruction set avx512, while " +
                                        one + " was with avx2: give all shards the same --isa");
  const std::string quarter = make({2, 4});
  EXPECT_EQ(said_of({one, quarter}),
            quarter + ": is shard 2 of 4, while " + one + " is shard 1 of 2");
  const std::string kind = make({2, 2}, "run", kKind + 1);
  EXPECT_TRUE(said_of({one, kind}).starts_with(kind + ": is a shard of another run"));
}

TEST_F(MergeShards, RefuseOneThatHasNotEnded) {
  const std::string one = make({1, 2});
  const std::string two = policy({2, 2}).path;
  {
    CaseJournal journal(policy({2, 2}), kKind, "fits");
    journal.begin("run", kCases);
    EXPECT_EQ(said_of({one, two}), two + ": is in use by another run: its shard has not ended");
  }
  EXPECT_EQ(said_of({one, two}),
            two + ": is shard 2 of 2, and not complete: --resume of it goes on");
}

// At whatever byte a shard is cut off, or changed, it is refused: none of its cases is lost unsaid.
TEST_F(MergeShards, RefuseOneThatIsDamagedAnywhere) {
  const std::string whole = content_of(make({1, 1}));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    const std::string cut = folder_.write("cut", whole.substr(0, at));
    EXPECT_NE(said_of({cut}), "no error") << at;
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    const std::string changed = folder_.write("changed", bytes);
    // Bytes 16 … 23 say what its records are, which the run that takes them checks.
    if (at >= 16 && at < 24) continue;
    EXPECT_NE(said_of({changed}), "no error") << at;
  }
}

TEST_F(MergeShards, RefuseFilesThatAreNone) {
  EXPECT_EQ(said_of({folder_.file("none")}), folder_.file("none") + ": is not there");
  const std::string text = folder_.write("text", "Strain,Stress\n");
  EXPECT_EQ(said_of({text}), text + ": is no shard of a run");
  const std::string journal = folder_.file("journal");
  {
    CaseJournal one({journal, false, false, "", {}}, kKind, "fits");
    one.keep("a", result_of("a"));
  }
  EXPECT_EQ(said_of({journal}), journal + ": is the journal of an interrupted run, not a shard");
}

TEST_F(MergeShards, KeepAJournalThatHasOtherThings) {
  const std::vector<std::string> shards{make({1, 1})};
  {
    CaseJournal one({merged(), false, false, "", {}}, kKind, "fits");
    one.keep("a", result_of("a"));
  }
  const std::string before = content_of(merged());
  EXPECT_EQ(message_from<InputError>([&] { merge_shards(shards, merged(), false); }),
            merged() + ": is the journal of an interrupted run: use --force to give it up");
  EXPECT_EQ(content_of(merged()), before);
  merge_shards(shards, merged(), true);
  merge_shards(shards, merged(), false);  // over one that was merged
}

TEST_F(MergeShards, GoOnWhereTheyWereInterrupted) {
  {
    CaseJournal journal(policy({1, 1}), kKind, "fits");
    journal.begin("run", kCases);
    journal.keep("c", result_of("c"));
  }
  EXPECT_EQ(message_from<InputError>([&] {
              CaseJournal(policy({1, 1}), kKind, "fits");
            }),
            policy({1, 1}).path +
                ": is shard 1 of 1 already, with 1 finished fits: use --resume to go on or --force "
                "to start afresh");
  {
    CaseJournal journal(policy({1, 1}, true), kKind, "fits");
    EXPECT_FALSE(journal.shard_ended());
    EXPECT_EQ(message_from<InputError>([&] { journal.begin("other run", kCases); }),
              policy({1, 1}).path +
                  ": is a shard of a run of other inputs, options or version: use --force to start "
                  "afresh");
    journal.begin("run", kCases);
    EXPECT_NE(journal.find("c"), nullptr);
    for (const char* id : {"a", "b", "d", "e"}) journal.keep(id, result_of(id));
    journal.end_shard();
  }
  EXPECT_TRUE(CaseJournal(policy({1, 1}, true), kKind, "fits").shard_ended());
  EXPECT_EQ(merge_shards(std::vector{policy({1, 1}).path}, merged(), false).cases, 5U);
}

// More shards than cases: an array of jobs must not fail for it.
TEST_F(MergeShards, MayHaveNoCase) {
  std::vector<std::string> shards;
  for (std::size_t index = 1; index <= 8; ++index) shards.push_back(make({index, 8}));
  merge_shards(shards, merged(), false);
  CaseJournal journal({merged(), true, false, "avx2", {}}, kKind, "fits");
  EXPECT_EQ(journal.found(), kCases.size());
}

}  // namespace
}  // namespace plastica::io
