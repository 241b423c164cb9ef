#include "plastica/io/merge_shards.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "plastica/base/check.hpp"
#include "plastica/io/case_journal.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/sanitized.hpp"

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

  std::string said_of(const std::vector<std::string>& shards) const {
    return message_from<InputError>([&] { merge_shards(shards); });
  }
  /// What a run takes in place of its journal.
  JournalPolicy merging(const MergedShards& merged, const std::string& isa = "avx2") const {
    JournalPolicy taken{folder_.file("out.journal"), false, false, isa, {}};
    taken.merged = &merged;
    return taken;
  }

  ScratchFolder folder_;
};

TEST_F(MergeShards, HaveAllCasesOfTheRun) {
  const MergedShards merged = merge_shards(std::vector{make({3, 3}), make({1, 3}), make({2, 3})});
  EXPECT_EQ(merged.mark.run, "run");
  EXPECT_EQ(merged.mark.shard, (Shard{1, 3}));
  EXPECT_EQ(merged.mark.words, (std::vector<std::string>{"calibrate", "fit.toml"}));
  const std::vector<std::string> names = folder_.names();
  {
    CaseJournal journal(merging(merged), kKind, "fits");
    EXPECT_EQ(journal.merged_shards(), 3U);
    EXPECT_EQ(journal.found(), kCases.size());
    EXPECT_EQ(journal.begin("run", kCases), std::vector<bool>(kCases.size(), true));
    for (const std::string& id : kCases) {
      ASSERT_NE(journal.find(id), nullptr) << id;
      EXPECT_EQ(*journal.find(id), result_of(id));
    }
    EXPECT_THROW(journal.keep("a", result_of("a")), std::logic_error);
    journal.finish();
  }
  EXPECT_EQ(folder_.names(), names);
}

// Whatever changes what is computed changes the run: a result of two halves would be of neither.
TEST_F(MergeShards, AreNoneOfARunThatHasChangedSince) {
  const MergedShards merged = merge_shards(std::vector{make({1, 1})});
  CaseJournal journal(merging(merged), kKind, "fits");
  const auto said = [&](const std::string& run, const std::vector<std::string>& ids) {
    return message_from<InputError>([&] { journal.begin(run, ids); });
  };
  EXPECT_TRUE(said("other", kCases).starts_with("shards: were computed of other inputs"));
  EXPECT_EQ(said("run", {"a", "f"}),
            "shards: shard 1 of 1 has lost what it had, by damage: --resume of it runs that again");
  EXPECT_EQ(message_from<InputError>([&] { CaseJournal(merging(merged), kKind + 1, "fits"); }),
            "shards: were computed by another version of plastica: merge them by that one");
  EXPECT_EQ(
      message_from<InputError>([&] { CaseJournal(merging(merged, "avx512"), kKind, "fits"); }),
      "shards: were computed with the instruction set avx2, and here it is avx512: merge them "
      "on a machine like theirs, or give all the same --isa");
}

// The journal of an interrupted run, or one that is under way, is not the merger's.
TEST_F(MergeShards, LeaveAJournalAlone) {
  const MergedShards merged = merge_shards(std::vector{make({1, 1})});
  const std::string path = folder_.file("out.journal");
  CaseJournal other({path, false, false, "", {}}, kKind, "fits");
  other.keep("a", result_of("a"));
  EXPECT_EQ(message_from<StorageError>([&] { CaseJournal(merging(merged), kKind, "fits"); }),
            path + ": is in use by another run");
  const std::string before = content_of(path);
  {
    CaseJournal elsewhere({folder_.file("copy"), false, false, "", {}}, kKind, "fits");
    elsewhere.keep("a", result_of("a"));
  }
  std::filesystem::copy(folder_.file("copy"), folder_.file("idle.journal"));
  JournalPolicy idle = merging(merged);
  idle.path = folder_.file("idle.journal");
  {
    CaseJournal journal(idle, kKind, "fits");
    journal.begin("run", kCases);
    journal.finish();
  }
  EXPECT_EQ(content_of(idle.path), content_of(folder_.file("copy")));
  EXPECT_EQ(content_of(path), before);
}

TEST_F(MergeShards, RefuseToBeIncompleteOrTwice) {
  const std::string one = make({1, 3});
  const std::string three = make({3, 3});
  EXPECT_EQ(said_of({one, three}), "shards: shard 2 of 3 is missing");
  EXPECT_EQ(said_of({three}), "shards: shards 1 and 2 of 3 are missing");
  const std::string copy = folder_.write("copy", content_of(one));
  EXPECT_EQ(said_of({one, copy}), "shards: " + one + " and " + copy + " are both shard 1 of 3");
  EXPECT_EQ(said_of({make({40, 64})}),
            "shards: shards 1, 2, 3, 4, 5, 6, 7, 8 and 55 more of 64 are missing");
}

TEST_F(MergeShards, RefuseThoseOfOtherRuns) {
  const std::string one = make({1, 2});
  const auto beside = [&](const std::string& other) {
    const std::string both = "shards: " + one + " and " + other + " ";
    const std::string said = said_of({other, one});
    EXPECT_TRUE(said.starts_with(both)) << said;
    std::filesystem::remove(other);
    return said.substr(std::min(both.size(), said.size()));
  };
  EXPECT_EQ(beside(make({2, 2}, "other run")),
            "are of unlike runs: of other inputs, options (--isa, too) or versions");
  EXPECT_EQ(beside(make({2, 4})), "are shard 1 of 2 and shard 2 of 4");
  EXPECT_EQ(beside(make({2, 2}, "run", kKind + 1)), "are of unlike runs, or versions of plastica");
  const std::string avx512 = folder_.file("wide");
  {
    CaseJournal journal({avx512, false, false, "avx512", ShardOfRun{{2, 2}, {}}}, kKind, "fits");
    journal.begin("other run", kCases);
    journal.end_shard();
  }
  EXPECT_EQ(beside(avx512),
            "were computed with unlike instruction sets, avx2 and avx512: give all shards the same "
            "--isa");
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
// What a changed byte spoils is one record, which --resume runs again.
TEST_F(MergeShards, RefuseOneThatIsDamagedAnywhereUntilItIsResumed) {
  const std::string path = make({1, 1});
  const std::string whole = content_of(path);
  const MergedShards sound = merge_shards(std::vector{path});
  const auto refused = [&](const std::string& file) {
    return message_from<InputError>([&] {
             const MergedShards merged = merge_shards(std::vector{file});
             CaseJournal(merging(merged), kKind, "fits").begin("run", kCases);
           }) != "no error";
  };
  EXPECT_FALSE(refused(path));
  std::size_t lost = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    EXPECT_TRUE(refused(folder_.write("cut", whole.substr(0, at)))) << at;
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    folder_.write("out.shard-1-of-1", bytes);
    const std::size_t found = [&] {
      if (at < 24) return std::size_t{0};
      return CaseJournal(policy({1, 1}, true), kKind, "fits").found();
    }();
    // The instruction set stands in the shard's mark, too.
    EXPECT_TRUE(refused(path) || found == kCases.size()) << at;
    if (at < 24) continue;
    EXPECT_GE(found + 1, kCases.size()) << at;
    {
      CaseJournal journal(policy({1, 1}, true), kKind, "fits");
      journal.begin("run", kCases);
      for (const std::string& id : kCases) {
        if (journal.find(id) != nullptr) continue;
        EXPECT_FALSE(journal.shard_ended());
        journal.keep(id, result_of(id));
        ++lost;
      }
      journal.end_shard();
    }
    EXPECT_FALSE(refused(path)) << at;
  }
  EXPECT_GT(lost, 100U);
}

// A record that is lost behind the end mark is missed by its id, and runs again.
TEST_F(MergeShards, RefuseOneThatHasLostARecordSinceItEnded) {
  const std::string path = make({1, 1});
  const std::string whole = content_of(path);
  const std::size_t at = whole.find("ccc");
  ASSERT_NE(at, std::string::npos);
  std::string bytes = whole;
  bytes[at] = 'x';
  folder_.write("out.shard-1-of-1", bytes);
  const MergedShards merged = merge_shards(std::vector{path});
  EXPECT_EQ(message_from<InputError>(
                [&] { CaseJournal(merging(merged), kKind, "fits").begin("run", kCases); }),
            "shards: shard 1 of 1 has lost what it had, by damage: --resume of it runs that again");
  CaseJournal journal(policy({1, 1}, true), kKind, "fits");
  journal.begin("run", kCases);
  EXPECT_FALSE(journal.shard_ended());
  EXPECT_EQ(journal.find("c"), nullptr);
}

// Numbers that look like lengths, as far as the file is long: to read what stands behind each would
// take hours, and the test's time limit ends it.
TEST_F(MergeShards, AreReadInTimeWhateverTheyAreFilledWith) {
  const std::string whole = content_of(make({1, 1}));
  std::string filled = whole.substr(0, whole.find("ccc"));
  const std::uint64_t numbers = testing::kSanitized ? 200'000 : 2'000'000;
  for (std::uint64_t i = 0; i < numbers; ++i) {
    filled.append(reinterpret_cast<const char*>(&i), sizeof i);
  }
  folder_.write("out.shard-1-of-1", filled);
  EXPECT_NE(said_of({policy({1, 1}).path}), "no error");
}

TEST_F(MergeShards, RefuseFilesThatAreNone) {
  EXPECT_EQ(said_of({folder_.file("none")}), folder_.file("none") + ": is not there");
  std::filesystem::create_directory(folder_.file("folder"));
  EXPECT_EQ(said_of({folder_.file("folder")}),
            folder_.file("folder") + ": is a folder: must be a file");
  std::filesystem::create_symlink(make({1, 1}), folder_.file("link"));
  EXPECT_EQ(said_of({folder_.file("link")}), "no error");
  const std::string text = folder_.write("text", "Strain,Stress\n");
  EXPECT_EQ(said_of({text}), text + ": is no shard of a run");
  const std::string journal = folder_.file("journal");
  {
    CaseJournal one({journal, false, false, "", {}}, kKind, "fits");
    one.keep("a", result_of("a"));
  }
  EXPECT_EQ(said_of({journal}), journal + ": is the journal of an interrupted run, not a shard");
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
  EXPECT_EQ(merge_shards(std::vector{policy({1, 1}).path}).mark.run, "run");
}

// More shards than cases: an array of jobs must not fail for it.
TEST_F(MergeShards, MayHaveNoCase) {
  std::vector<std::string> shards;
  for (std::size_t index = 1; index <= 8; ++index) shards.push_back(make({index, 8}));
  const MergedShards merged = merge_shards(shards);
  CaseJournal journal(merging(merged), kKind, "fits");
  EXPECT_EQ(journal.found(), kCases.size());
  journal.begin("run", kCases);
}

}  // namespace
}  // namespace plastica::io
