#include "plastica/io/case_journal.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/io/merge_shards.hpp"

namespace plastica::io {
namespace {

// Ids of records that are no cases; no case has them.

/// An empty record that each resumption leaves in the journal.
constexpr std::string_view kResumption = "resumption";
/// The name of the instruction set of the run that began the journal.
constexpr std::string_view kInstructionSet = "instruction set";

std::string text_of(const JournalRecord& record) {
  return {reinterpret_cast<const char*>(record.payload.data()), record.payload.size()};
}

/// What a journal says of its run beside the cases.
struct Marks {
  int resumptions = 0;
  std::string instruction_set{};  ///< empty in journals of older versions
  std::optional<ShardMark> shard{};
  bool shard_ended = false;
};

/// Takes the marks out of a journal's records.
Marks take_marks(std::vector<JournalRecord>& records, const std::string& path) {
  Marks marks;
  std::erase_if(records, [&](const JournalRecord& record) {
    if (record.id == kResumption) {
      ++marks.resumptions;
    } else if (record.id == kInstructionSet) {
      marks.instruction_set = text_of(record);
    } else if (record.id == kShardMark) {
      marks.shard = shard_mark_from_bytes(record.payload, path);
    } else if (record.id == kShardEnd) {
      marks.shard_ended = true;
    } else {
      return false;
    }
    return true;
  });
  return marks;
}

/// Whether to go on from a journal that was found; else it is to be written afresh.
/// @throws InputError if it may not be overwritten; StorageError if another run has it
bool shall_go_on(const JournalContent& found, const Marks& marks, const JournalPolicy& policy,
                 std::string_view noun) {
  const auto refuse = [&](std::string_view rule) {
    throw InputError({policy.path, 0}, "", "", rule);
  };
  switch (found.state) {
    case JournalState::Absent: return false;
    case JournalState::NotAJournal:
      refuse("is in the place of the journal but is none: move it, or name another output");
      return false;
    case JournalState::OtherRun:
    case JournalState::OtherVersion:
      if (!policy.force) {
        refuse(
            "is the journal of an interrupted run of another version: use --force to start afresh");
      }
      return false;
    case JournalState::InUse: throw StorageError(policy.path, "is in use by another run");
    case JournalState::Usable: break;
  }
  if (policy.resume) return true;
  if (found.records.empty() && found.damaged > 0 && !policy.force) {
    refuse("is a damaged journal: use --resume to go on or --force to start afresh");
  }
  if (!found.records.empty() && !policy.force) {
    const std::string what = marks.shard ? words_of(marks.shard->shard) + " already"
                                         : std::string("the journal of an interrupted run");
    refuse("is " + what + ", with " + std::to_string(found.records.size()) + " finished " +
           std::string(noun) + ": use --resume to go on or --force to start afresh");
  }
  return false;
}

/// The first of each group of cases that stay together.
std::vector<std::string> first_of_each(std::span<const std::string> ids, std::size_t together) {
  std::vector<std::string> first;
  for (std::size_t i = 0; i < ids.size(); i += together) first.push_back(ids[i]);
  return first;
}

}  // namespace

std::string journal_path(const std::string& output) { return output + ".journal"; }

CaseJournal::CaseJournal(const JournalPolicy& policy, std::uint64_t kind, std::string_view noun)
    : path_(policy.path), instruction_set_(policy.instruction_set), shard_(policy.shard) {
  if (policy.merged != nullptr) {
    take_merged(*policy.merged, kind);
    return;
  }
  JournalContent content = read_journal(policy.path, kind);
  const Marks marks = take_marks(content.records, policy.path);
  if (!shall_go_on(content, marks, policy, noun)) {
    journal_.emplace(Journal::create(policy.path, kind));
    if (!policy.instruction_set.empty()) {
      journal_->append(kInstructionSet, std::as_bytes(std::span(policy.instruction_set)));
    }
    return;
  }
  dropped_bytes_ = content.dropped_bytes;
  found_shard_ = marks.shard;
  damaged_ = content.damaged;
  shard_ended_ = marks.shard_ended;
  journal_.emplace(Journal::resume(policy.path, kind, content));
  if (content.records.empty() && !marks.shard) return;
  if (marks.instruction_set != policy.instruction_set) {
    other_instruction_set_ = marks.instruction_set;
  }
  empty_ = false;
  if (!shard_ended_) journal_->append(kResumption, {});
  resumptions_ = marks.resumptions + 1;
  // A case that stands there twice was run again on purpose.
  for (JournalRecord& record : content.records) {
    found_.insert_or_assign(std::move(record.id), std::move(record.payload));
  }
}

std::vector<bool> CaseJournal::begin(const std::string& run, std::span<const std::string> ids,
                                     std::size_t together) {
  if (merged_) check_merged(run, ids, together);
  if (shard_ || found_shard_) return begin_shard(run, ids, together);
  return std::vector<bool>(ids.size(), true);
}

void CaseJournal::take_merged(const MergedShards& merged, std::uint64_t kind) {
  const auto refuse = [](const std::string& rule) { throw InputError({}, "shards", "", rule); };
  if (is_in_use(path_)) throw StorageError(path_, "is in use by another run");
  if (merged.kind != kind) {
    refuse("were computed by another version of plastica: merge them by that one");
  }
  if (merged.mark.instruction_set != instruction_set_) {
    refuse("were computed with the instruction set " + merged.mark.instruction_set +
           ", and here it is " + instruction_set_ +
           ": merge them on a machine like theirs, or give all the same --isa");
  }
  merged_ = merged.mark;
  for (const JournalRecord& record : merged.records) {
    if (record.id == kResumption || record.id == kInstructionSet) continue;
    found_.insert_or_assign(record.id, record.payload);
  }
}

/// Nothing is to be computed where shards are merged.
void CaseJournal::check_merged(const std::string& run, std::span<const std::string> ids,
                               std::size_t together) const {
  const auto refuse = [](const std::string& rule) { throw InputError({}, "shards", "", rule); };
  if (merged_->run != run) {
    refuse(
        "were computed of other inputs, options or version than are here: run merge where they "
        "ran, or in a copy of that folder");
  }
  const auto lost =
      std::ranges::find_if(ids, [&](const std::string& id) { return !found_.contains(id); });
  if (lost == ids.end()) return;
  const auto at = static_cast<std::size_t>(lost - ids.begin()) / together;
  const std::size_t index = dealt(first_of_each(ids, together), merged_->shard.count)[at];
  refuse(words_of(Shard{index, merged_->shard.count}) +
         " has lost what it had, by damage: --resume of it runs that again");
}

std::vector<bool> CaseJournal::begin_shard(const std::string& run, std::span<const std::string> ids,
                                           std::size_t together) {
  const auto refuse = [&](const std::string& what) {
    throw InputError({path_, 0}, "", "", "is " + what + ": use --force to start afresh");
  };
  if (!shard_) refuse(words_of(found_shard_->shard) + " of a run");
  const std::vector<std::size_t> shards = dealt(first_of_each(ids, together), shard_->shard.count);
  std::vector<bool> own(ids.size());
  bool has_all = true;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    own[i] = shards[i / together] == shard_->shard.index;
    has_all = has_all && (!own[i] || found_.contains(ids[i]));
  }
  shard_ended_ = shard_ended_ && has_all;
  if (found_shard_) {
    if (found_shard_->shard != shard_->shard) refuse(words_of(found_shard_->shard));
    if (found_shard_->run != run) refuse("a shard of a run of other inputs, options or version");
    return own;
  }
  journal_->append(kShardMark, bytes_of({shard_->shard, run, instruction_set_, shard_->words}));
  empty_ = false;
  return own;
}

void CaseJournal::end_shard() {
  if (!journal_) throw std::logic_error("CaseJournal::end_shard: there is no shard");
  if (!shard_ended_) journal_->append(kShardEnd, {});
  journal_->sync();
}

CaseJournal::~CaseJournal() {
  if (!journal_ || !empty_) return;
  try {
    journal_->remove();
  } catch (const StorageError&) {
    // An empty journal that stays is harmless: the next run writes over it.
  }
}

const std::vector<std::byte>* CaseJournal::find(std::string_view id) const {
  const auto record = found_.find(std::string(id));
  return record == found_.end() ? nullptr : &record->second;
}

std::size_t CaseJournal::found_under(std::string_view beginning) const {
  return static_cast<std::size_t>(
      std::count_if(found_.begin(), found_.end(),
                    [&](const auto& record) { return record.first.starts_with(beginning); }));
}

void CaseJournal::keep(std::string_view id, std::span<const std::byte> payload) {
  if (merged_) throw std::logic_error("CaseJournal::keep: a case of merged shards was computed");
  journal_->append(id, payload);
  empty_ = false;
}

void CaseJournal::sync() {
  if (journal_) journal_->sync();
}

void CaseJournal::finish() {
  if (!journal_) return;
  journal_->remove();
  journal_.reset();
}

}  // namespace plastica::io
