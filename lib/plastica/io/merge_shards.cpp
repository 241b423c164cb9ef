#include "plastica/io/merge_shards.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/journal.hpp"

namespace plastica::io {
namespace {

struct ReadShard {
  std::string path;
  std::uint64_t kind = 0;
  ShardMark mark;
  std::vector<JournalRecord> records;
};

[[noreturn]] void refuse(const std::string& path, const std::string& rule) {
  throw InputError({path, 0}, "", "", rule);
}

/// @throws InputError for what is no shard, or not complete
ReadShard read_shard(const std::string& path) {
  JournalContent content = read_journal(path, {});
  switch (content.state) {
    case JournalState::Usable: break;
    case JournalState::InUse: refuse(path, "is in use by another run: its shard has not ended");
    case JournalState::OtherVersion: refuse(path, "is of another version of the format");
    case JournalState::Absent:
      if (content.dropped_bytes == 0) refuse(path, "is not there");
      [[fallthrough]];
    case JournalState::OtherRun:
    case JournalState::NotAJournal: refuse(path, "is no shard of a run");
  }
  std::optional<ShardMark> mark;
  bool ended = false;
  for (const JournalRecord& record : content.records) {
    if (record.id == kShardMark) mark = shard_mark_from_bytes(record.payload, path);
    if (record.id == kShardEnd) ended = true;
  }
  if (!mark) refuse(path, "is the journal of an interrupted run, not a shard");
  std::erase_if(content.records, [](const JournalRecord& record) {
    return record.id == kShardMark || record.id == kShardEnd;
  });
  if (content.dropped_bytes > 0) {
    refuse(path, "is damaged: " + std::to_string(content.dropped_bytes) +
                     " bytes at its end are no records; --resume of its shard runs what they had");
  }
  if (!ended) {
    refuse(path, "is " + words_of(mark->shard) + ", and not complete: --resume of it goes on");
  }
  return {path, content.run_digest, std::move(*mark), std::move(content.records)};
}

/// "2, 5 and 7", or of many "2, 5, 7 and 12 more".
std::string list_of(const std::vector<std::size_t>& numbers) {
  constexpr std::size_t kShown = 8;
  const std::size_t shown = numbers.size() <= kShown + 1 ? numbers.size() : kShown;
  std::string list;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == numbers.size();
    list += (i == 0 ? "" : last ? " and " : ", ") + std::to_string(numbers[i]);
  }
  if (shown < numbers.size()) list += " and " + std::to_string(numbers.size() - shown) + " more";
  return list;
}

void check_together(std::span<const ReadShard> shards) {
  const ReadShard& first = shards.front();
  std::vector<const ReadShard*> at(first.mark.shard.count, nullptr);
  for (const ReadShard& one : shards) {
    if (one.mark.instruction_set != first.mark.instruction_set) {
      refuse(one.path, "was computed with the instruction set " + one.mark.instruction_set +
                           ", while " + first.path + " was with " + first.mark.instruction_set +
                           ": give all shards the same --isa");
    }
    if (one.mark.run != first.mark.run || one.kind != first.kind) {
      refuse(one.path, "is a shard of another run than " + first.path +
                           ": of other inputs, options or version");
    }
    if (one.mark.shard.count != first.mark.shard.count) {
      refuse(one.path, "is " + words_of(one.mark.shard) + ", while " + first.path + " is " +
                           words_of(first.mark.shard));
    }
    const ReadShard*& place = at[one.mark.shard.index - 1];
    if (place != nullptr) {
      refuse(one.path, "is " + words_of(one.mark.shard) + ", as " + place->path + " is");
    }
    place = &one;
  }
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] == nullptr) missing.push_back(i + 1);
  }
  if (missing.empty()) return;
  throw InputError({}, "shards", "",
                   (missing.size() == 1 ? "lack shard " : "lack shards ") + list_of(missing) +
                       " of " + std::to_string(at.size()));
}

/// A journal in the place of the merged one goes only if the shards have all that it has.
void check_place(const std::string& path, bool force) {
  const JournalContent found = read_journal(path, {});
  if (found.state == JournalState::Absent) return;
  if (found.state == JournalState::InUse) throw StorageError(path, "is in use by another run");
  const bool merged =
      std::ranges::any_of(found.records, [](const auto& one) { return one.id == kMergedMark; });
  if (merged || (force && found.state != JournalState::NotAJournal)) return;
  refuse(path, found.state == JournalState::NotAJournal
                   ? "is in the place of the journal but is none: move it, or name another output"
                   : "is the journal of an interrupted run: use --force to give it up");
}

}  // namespace

bool begins_as_journal(const std::string& path) {
  std::array<char, kJournalMagic.size()> begin{};
  std::ifstream file(path, std::ios::binary);
  return file.read(begin.data(), begin.size()) &&
         std::string_view(begin.data(), begin.size()) == kJournalMagic;
}

ShardMark merge_shards(std::span<const std::string> paths, const std::string& path, bool force) {
  std::vector<ReadShard> shards;
  shards.reserve(paths.size());
  for (const std::string& one : paths) shards.push_back(read_shard(one));
  check_together(shards);
  check_place(path, force);
  Journal journal = Journal::create(path, shards.front().kind);
  const std::string& run = shards.front().mark.run;
  journal.append(kMergedMark, std::as_bytes(std::span(run)));
  for (const ReadShard& one : shards) {
    for (const JournalRecord& record : one.records) journal.append(record.id, record.payload);
  }
  journal.sync();
  return std::move(shards.front().mark);
}

}  // namespace plastica::io
