#include "plastica/io/merge_shards.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/listed.hpp"
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

std::optional<ShardMark> mark_of(const JournalContent& content, const std::string& path) {
  std::optional<ShardMark> mark;
  for (const JournalRecord& record : content.records) {
    if (record.id == kShardMark) mark = shard_mark_from_bytes(record.payload, path);
  }
  return mark;
}

/// @throws InputError for what is no shard, damaged or not complete
ReadShard read_shard(const std::string& path) {
  JournalContent content = read_any_journal(path);
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
  std::optional<ShardMark> mark = mark_of(content, path);
  if (!mark) {
    refuse(path, content.damaged + content.dropped_bytes > 0
                     ? "is damaged: it does not say of which run it is a shard"
                     : "is the journal of an interrupted run, not a shard");
  }
  const bool ended = std::ranges::any_of(
      content.records, [](const JournalRecord& record) { return record.id == kShardEnd; });
  if (!ended || content.dropped_bytes > 0) {
    refuse(path, "is " + words_of(mark->shard) + ", and not complete: --resume of it goes on");
  }
  std::erase_if(content.records, [](const JournalRecord& record) {
    return record.id == kShardMark || record.id == kShardEnd;
  });
  return {path, content.run_digest, std::move(*mark), std::move(content.records)};
}

[[noreturn]] void refuse_both(const ReadShard& a, const ReadShard& b, const std::string& rule) {
  throw InputError({}, "shards", "", a.path + " and " + b.path + " " + rule);
}

void check_alike(const ReadShard& a, const ReadShard& b) {
  if (a.mark.instruction_set != b.mark.instruction_set) {
    refuse_both(a, b,
                "were computed with unlike instruction sets, " + a.mark.instruction_set + " and " +
                    b.mark.instruction_set + ": give all shards the same --isa");
  }
  if (a.kind != b.kind) refuse_both(a, b, "are of unlike runs, or versions of plastica");
  if (a.mark.shard.count != b.mark.shard.count) {
    refuse_both(a, b, "are " + words_of(a.mark.shard) + " and " + words_of(b.mark.shard));
  }
  if (a.mark.run != b.mark.run) {
    refuse_both(a, b, "are of unlike runs: of other inputs, options (--isa, too) or versions");
  }
}

/// @param shards  in the order of their numbers
void check_together(std::span<const ReadShard> shards) {
  constexpr std::size_t kShown = 8;
  const ReadShard& first = shards.front();
  std::vector<const ReadShard*> at(first.mark.shard.count, nullptr);
  for (const ReadShard& one : shards) {
    check_alike(first, one);
    const ReadShard*& place = at[one.mark.shard.index - 1];
    if (place != nullptr) refuse_both(*place, one, "are both " + words_of(one.mark.shard));
    place = &one;
  }
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] == nullptr) missing.push_back(std::to_string(i + 1));
  }
  if (missing.empty()) return;
  const bool one = missing.size() == 1;
  throw InputError({}, "shards", "",
                   (one ? "shard " : "shards ") + listed(missing, kShown) + " of " +
                       std::to_string(at.size()) + (one ? " is" : " are") + " missing");
}

}  // namespace

bool is_shard(const std::string& path) {
  std::array<char, kJournalMagic.size()> begin{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(begin.data(), begin.size()) ||
      std::string_view(begin.data(), begin.size()) != kJournalMagic) {
    return false;
  }
  try {
    return mark_of(read_any_journal(path), path).has_value();
  } catch (const std::exception&) {  // whoever reads it says so
    return false;
  }
}

MergedShards merge_shards(std::span<const std::string> paths) {
  std::vector<ReadShard> shards;
  shards.reserve(paths.size());
  for (const std::string& one : paths) shards.push_back(read_shard(one));
  if (shards.empty()) throw InputError({}, "shards", "", "must be named");
  std::ranges::stable_sort(shards, {}, [](const ReadShard& one) { return one.mark.shard.index; });
  check_together(shards);
  MergedShards merged{std::move(shards.front().mark), shards.front().kind, {}};
  for (ReadShard& one : shards) {
    std::ranges::move(one.records, std::back_inserter(merged.records));
  }
  return merged;
}

}  // namespace plastica::io
