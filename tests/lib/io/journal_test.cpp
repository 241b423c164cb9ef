#include "plastica/io/journal.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>

#include "plastica/base/check.hpp"
#include "plastica/io/bytes.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kRun = 0x1234;

std::vector<std::byte> payload_of(std::size_t case_number) {
  ByteWriter writer;
  writer.put(std::uint64_t{case_number}).put(std::vector<double>(case_number % 7, 0.5));
  return writer.take();
}

std::string id_of(std::size_t case_number) { return "case-" + std::to_string(case_number); }

void write_cases(const std::string& path, std::size_t count) {
  Journal journal = Journal::create(path, kRun);
  for (std::size_t i = 0; i < count; ++i) journal.append(id_of(i), payload_of(i));
}

void expect_cases(const JournalContent& content, std::size_t count) {
  ASSERT_EQ(content.records.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(content.records[i].id, id_of(i));
    EXPECT_EQ(content.records[i].payload, payload_of(i));
  }
}

TEST(Journal, GivesBackItsRecordsInOrder) {
  const ScratchFolder folder;
  write_cases(folder.file("j"), 20);
  const JournalContent content = read_journal(folder.file("j"), kRun);
  EXPECT_EQ(content.state, JournalState::Usable);
  EXPECT_EQ(content.dropped_bytes, 0U);
  EXPECT_EQ(content.complete_bytes, std::filesystem::file_size(folder.file("j")));
  expect_cases(content, 20);
}

TEST(Journal, CutOffAtAnyByteGivesAllCompleteRecordsAndGoesOn) {
  const ScratchFolder folder;
  write_cases(folder.file("whole"), 6);
  const std::string whole = content_of(folder.file("whole"));
  std::size_t last_count = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const std::string path = folder.write("cut", whole.substr(0, size));
    const JournalContent content = read_journal(path, kRun);
    ASSERT_EQ(content.state, size < 24 ? JournalState::Absent : JournalState::Usable) << size;
    EXPECT_EQ(content.complete_bytes + content.dropped_bytes, size);
    ASSERT_GE(content.records.size(), last_count);
    last_count = content.records.size();
    expect_cases(content, last_count);

    if (size % 37 != 0) continue;  // each resumption waits for the disk
    {
      Journal journal = Journal::resume(path, kRun, content);
      journal.append(id_of(last_count), payload_of(last_count));
    }
    const JournalContent resumed = read_journal(path, kRun);
    EXPECT_EQ(resumed.state, JournalState::Usable);
    EXPECT_EQ(resumed.dropped_bytes, 0U);
    expect_cases(resumed, last_count + 1);
  }
  EXPECT_EQ(last_count, 6U);
}

TEST(Journal, DropsARecordWithAnyByteChanged) {
  const ScratchFolder folder;
  write_cases(folder.file("j"), 3);
  const std::string whole = content_of(folder.file("j"));
  write_cases(folder.file("two"), 2);
  const std::size_t two = content_of(folder.file("two")).size();
  for (std::size_t at = two; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
    const JournalContent content = read_journal(folder.write("bad", damaged), kRun);
    EXPECT_EQ(content.records.size(), 2U) << at;
    EXPECT_EQ(content.dropped_bytes, whole.size() - two) << at;
  }
}

// What a changed bit spoils is one record, not those behind it.
TEST(Journal, LeavesOutADamagedRecordAmongOthers) {
  const ScratchFolder folder;
  write_cases(folder.file("one"), 1);
  write_cases(folder.file("two"), 2);
  write_cases(folder.file("j"), 4);
  const std::string whole = content_of(folder.file("j"));
  const std::size_t begin = content_of(folder.file("one")).size();
  const std::size_t end = content_of(folder.file("two")).size();
  for (std::size_t at = begin; at < end; ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
    const std::string path = folder.write("bad", damaged);
    const JournalContent content = read_journal(path, kRun);
    ASSERT_EQ(content.records.size(), 3U) << at;
    EXPECT_EQ(content.records[0].id, id_of(0));
    EXPECT_EQ(content.records[1].id, id_of(2));
    EXPECT_EQ(content.records[2].id, id_of(3));
    EXPECT_EQ(content.damaged, 1U) << at;
    EXPECT_EQ(content.dropped_bytes, 0U) << at;
    EXPECT_EQ(content.complete_bytes, whole.size()) << at;
    Journal::resume(path, kRun, content).append(id_of(1), payload_of(1));
    EXPECT_EQ(read_journal(path, kRun).records.size(), 4U);
  }
}

TEST(Journal, TakesATailOfZerosForTorn) {
  const ScratchFolder folder;
  write_cases(folder.file("j"), 2);
  const std::string whole = content_of(folder.file("j"));
  const JournalContent content =
      read_journal(folder.write("z", whole + std::string(100, '\0')), kRun);
  expect_cases(content, 2);
  EXPECT_EQ(content.dropped_bytes, 100U);
}

TEST(Journal, OfAnotherRunOrVersionOrKindIsReportedAsSuch) {
  const ScratchFolder folder;
  EXPECT_EQ(read_journal(folder.file("none"), kRun).state, JournalState::Absent);
  write_cases(folder.file("j"), 2);
  const JournalContent other = read_journal(folder.file("j"), kRun + 1);
  EXPECT_EQ(other.state, JournalState::OtherRun);
  EXPECT_EQ(other.run_digest, kRun);
  EXPECT_TRUE(other.records.empty());
  std::string bytes = content_of(folder.file("j"));
  bytes[8] = 99;
  EXPECT_EQ(read_journal(folder.write("v", bytes), kRun).state, JournalState::OtherVersion);
  EXPECT_EQ(read_journal(folder.write("t", "Strain,Stress\n0,0\n"), kRun).state,
            JournalState::NotAJournal);
  EXPECT_THROW(Journal::resume(folder.file("j"), kRun + 1, other), std::logic_error);
}

TEST(Journal, CreateStartsAfreshOverAnOlderOne) {
  const ScratchFolder folder;
  write_cases(folder.file("j"), 5);
  write_cases(folder.file("j"), 1);
  expect_cases(read_journal(folder.file("j"), kRun), 1);
}

TEST(Journal, KeepsAllRecordsOfSeveralThreads) {
  const ScratchFolder folder;
  {
    Journal journal = Journal::create(folder.file("j"), kRun, 1ms);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 4; ++t) {
      threads.emplace_back([&journal, t] {
        for (std::size_t i = 0; i < 100; ++i) journal.append(id_of(t), payload_of(i));
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  const JournalContent content = read_journal(folder.file("j"), kRun);
  EXPECT_EQ(content.dropped_bytes, 0U);
  std::vector<std::size_t> next(4, 0);
  for (const JournalRecord& record : content.records) {
    const auto thread = static_cast<std::size_t>(record.id.back() - '0');
    EXPECT_EQ(record.payload, payload_of(next.at(thread)++));
  }
  EXPECT_EQ(next, std::vector<std::size_t>(4, 100));
}

TEST(Journal, ReachesTheDiskByItselfWithinTheInterval) {
  const ScratchFolder folder;
  EXPECT_LE(Journal::kSyncInterval, 1s);
  Journal journal = Journal::create(folder.file("j"), kRun, 10ms);
  journal.append("a", {});
  for (int i = 0; i < 500 && !journal.synced(); ++i) std::this_thread::sleep_for(1ms);
  EXPECT_TRUE(journal.synced());
}

TEST(Journal, ReachesTheDiskWhenAsked) {
  const ScratchFolder folder;
  Journal journal = Journal::create(folder.file("j"), kRun, 1h);
  EXPECT_TRUE(journal.synced());
  journal.append("a", {});
  EXPECT_FALSE(journal.synced());
  journal.sync();
  EXPECT_TRUE(journal.synced());
}

TEST(Journal, ClosesAtOnceHoweverLongItsInterval) {
  const ScratchFolder folder;
  // To wait for the hour would take the test beyond its time limit.
  Journal::create(folder.file("j"), kRun, 1h);
  EXPECT_EQ(read_journal(folder.file("j"), kRun).state, JournalState::Usable);
}

TEST(Journal, IsGoneWhenRemoved) {
  const ScratchFolder folder;
  Journal journal = Journal::create(folder.file("j"), kRun);
  journal.append("a", {});
  journal.remove();
  EXPECT_FALSE(std::filesystem::exists(folder.file("j")));
}

TEST(Journal, SurvivesAKillAtAnyMoment) {
  const ScratchFolder folder;
  const std::string path = folder.file("j");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Journal journal = Journal::create(path, kRun, 5ms);
    for (std::size_t i = 0;; ++i) journal.append(id_of(i), payload_of(i));
  }
  std::size_t bytes = 0;
  while (bytes < 20'000) {
    std::this_thread::sleep_for(1ms);
    bytes = std::filesystem::exists(path) ? std::filesystem::file_size(path) : 0;
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const JournalContent content = read_journal(path, kRun);
  EXPECT_EQ(content.state, JournalState::Usable);
  EXPECT_GT(content.records.size(), 100U);
  expect_cases(content, content.records.size());
  Journal journal = Journal::resume(path, kRun, content);  // the lock died with the process
  journal.append("next", {});
}

TEST(JournalErrors, AFolderThatIsNotThereIsNamed) {
  const ScratchFolder folder;
  const std::string path = folder.file("none/j");
  EXPECT_EQ(message_from<StorageError>([&] { Journal::create(path, kRun); }),
            path + ": cannot be written: No such file or directory");
}

TEST(JournalErrors, WhatIsNoFileInItsPlaceIsNamed) {
  const ScratchFolder folder;
  const std::string path = folder.file("j");
  const auto said = [&] { return message_from<InputError>([&] { read_journal(path, kRun); }); };
  const std::string rule = " in the place of the journal: move it, or name another output";
  std::filesystem::create_directory(path);
  EXPECT_EQ(said(), path + ": is a folder" + rule);
  std::filesystem::remove(path);
  std::filesystem::create_symlink(folder.write("target", "theirs"), path);
  EXPECT_EQ(said(), path + ": is a link" + rule);
  std::filesystem::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_EQ(said(), path + ": is a named pipe" + rule);
  EXPECT_EQ(content_of(folder.file("target")), "theirs");
}

TEST(JournalErrors, OneThatIsRemovedLeavesTheNextRunsAlone) {
  const ScratchFolder folder;
  const std::string path = folder.file("j");
  Journal first = Journal::create(path, kRun);
  std::filesystem::remove(path);
  Journal second = Journal::create(path, kRun);
  first.remove();
  EXPECT_TRUE(std::filesystem::exists(path));
  second.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(JournalErrors, AJournalInUseIsNotTaken) {
  const ScratchFolder folder;
  const std::string path = folder.file("j");
  Journal journal = Journal::create(path, kRun);
  journal.append("a", {});
  EXPECT_EQ(message_from<StorageError>([&] { Journal::create(path, kRun); }),
            path + ": is in use by another run");
  EXPECT_EQ(read_journal(path, kRun).state, JournalState::InUse);
}

TEST(JournalErrors, AJournalThatGrewSinceItWasReadIsNotResumed) {
  const ScratchFolder folder;
  const std::string path = folder.file("j");
  write_cases(path, 2);
  const JournalContent content = read_journal(path, kRun);
  write_cases(path, 3);
  EXPECT_EQ(message_from<StorageError>([&] { Journal::resume(path, kRun, content); }),
            path + ": has changed while it was read");
}

TEST(JournalErrors, AFullDiskIsReportedAndLeavesTheJournalReadable) {
  const ScratchFolder folder;
  const std::string path = folder.file("j");
  auto journal = std::make_unique<Journal>(Journal::create(path, kRun));
  journal->append(id_of(0), payload_of(0));
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 100;
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      message_from<StorageError>([&] { journal->append("big", std::vector<std::byte>(1000)); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(message, path + ": cannot be written: File too large");
  journal->append(id_of(1), payload_of(1));
  journal.reset();
  const JournalContent content = read_journal(path, kRun);
  EXPECT_EQ(content.dropped_bytes, 0U);
  expect_cases(content, 2);
}

}  // namespace
}  // namespace plastica::io
