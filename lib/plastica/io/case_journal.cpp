#include "plastica/io/case_journal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/base/team.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/merge_shards.hpp"
#include "plastica/io/team_journals.hpp"

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

/// Whether a journal may be gone on from, as far as its state tells. @param force  to start afresh
/// @throws InputError if it is in the way; StorageError if another run has it
bool is_usable(const FoundJournal& found, bool force) {
  const auto refuse = [&](std::string_view rule) {
    throw InputError({found.path, 0}, "", "", rule);
  };
  switch (found.content.state) {
    case JournalState::Absent: return false;
    case JournalState::NotAJournal:
      refuse("is in the place of the journal but is none: move it, or name another output");
      return false;
    case JournalState::OtherRun:
    case JournalState::OtherVersion:
      if (!force) {
        refuse(
            "is the journal of an interrupted run of another version: use --force to start afresh");
      }
      return false;
    case JournalState::InUse: throw StorageError(found.path, "is in use by another run");
    case JournalState::Usable: break;
  }
  return true;
}

void remove_file(const std::string& path) {
  if (::unlink(path.c_str()) == 0 || errno == ENOENT) return;
  throw StorageError(path, std::string("cannot be removed: ") + std::strerror(errno));
}

/// The first of each group of cases that stay together.
std::vector<std::string> first_of_each(std::span<const std::string> ids, std::size_t together) {
  std::vector<std::string> first;
  for (std::size_t i = 0; i < ids.size(); i += together) first.push_back(ids[i]);
  return first;
}

}  // namespace

std::string journal_path(const std::string& output) { return output + ".journal"; }

/// What a journal says of its run beside the cases.
struct CaseJournal::Marks {
  int resumptions = 0;
  std::string instruction_set{};  ///< empty in journals of older versions
  std::optional<ShardMark> shard{};
  bool shard_ended = false;

  /// Takes the marks out of a journal's records.
  void take_out_of(FoundJournal& found) {
    std::erase_if(found.content.records, [&](const JournalRecord& record) {
      if (record.id == kResumption) {
        ++resumptions;
      } else if (record.id == kInstructionSet) {
        instruction_set = text_of(record);
      } else if (record.id == kShardMark) {
        shard = shard_mark_from_bytes(record.payload, found.path);
      } else if (record.id == kShardEnd) {
        shard_ended = true;
      } else {
        return false;
      }
      return true;
    });
  }

  /// Whether to go on from the journals that were found; else they are to be written afresh.
  /// @throws InputError if they may not be overwritten; StorageError if another run has one
  bool shall_go_on(std::span<const FoundJournal> found, const JournalPolicy& policy,
                   std::string_view noun) const {
    std::size_t usable = 0;
    std::size_t records = 0;
    bool damaged = false;
    bool other = false;
    for (const FoundJournal& one : found) {
      if (is_usable(one, policy.force)) {
        ++usable;
      } else if (one.content.state != JournalState::Absent) {
        other = true;
      }
      records += one.content.records.size();
      damaged = damaged || one.content.damaged > 0;
    }
    if (usable == 0 || other) return false;
    if (policy.resume) return true;
    const auto refuse = [&](std::string_view rule) {
      throw InputError({policy.path, 0}, "", "", rule);
    };
    if (records == 0 && damaged && !policy.force) {
      refuse("is a damaged journal: use --resume to go on or --force to start afresh");
    }
    if (records > 0 && !policy.force) {
      const std::string what = shard ? words_of(shard->shard) + " already"
                                     : std::string("the journal of an interrupted run");
      refuse("is " + what + ", with " + std::to_string(records) + " finished " + std::string(noun) +
             ": use --resume to go on or --force to start afresh");
    }
    return false;
  }
};

CaseJournal::CaseJournal(const JournalPolicy& policy, std::uint64_t kind, std::string_view noun)
    : path_(policy.path),
      kind_(kind),
      instruction_set_(policy.instruction_set),
      team_(policy.team),
      shard_(policy.shard) {
  if (policy.merged != nullptr) {
    take_merged(*policy.merged, kind);
    return;
  }
  try {
    if (team_ != nullptr && !team_->leads()) {
      follow();
    } else {
      lead(policy, noun);
    }
  } catch (...) {
    remove_if_empty();  // no destructor follows
    throw;
  }
}

/// Opens the journal of the run.
void CaseJournal::lead(const JournalPolicy& policy, std::string_view noun) {
  std::vector<FoundJournal> found = read_team_journals(path_, kind_);
  Marks marks;
  for (FoundJournal& one : found) marks.take_out_of(one);
  if (marks.shall_go_on(found, policy, noun)) {
    go_on(std::move(found), marks);
  } else {
    journal_.emplace(Journal::create(path_, kind_));
    for (const FoundJournal& other : std::span(found).subspan(1)) remove_file(other.path);
    mark_instruction_set();
  }
  if (team_ == nullptr) return;
  team_->meet();  // the others read it, and nobody writes
  team_->agree(digest_of_found(), "journal: they need one folder");
}

/// Goes on from what earlier runs have left. What other processes of theirs have kept goes to the
/// journal of this one, so that what is kept later is later in the files, too.
void CaseJournal::go_on(std::vector<FoundJournal> found, const Marks& marks) {
  FoundJournal& own = found.front();
  found_shard_ = marks.shard;
  shard_ended_ = marks.shard_ended;
  std::size_t records = 0;
  for (const FoundJournal& one : found) {
    dropped_bytes_ += one.content.dropped_bytes;
    damaged_ += one.content.damaged;
    records += one.content.records.size();
  }
  journal_.emplace(Journal::resume(path_, kind_, own.content));
  if (own.content.state == JournalState::Absent) mark_instruction_set();
  if (records > 0 || marks.shard) {
    if (marks.instruction_set != instruction_set_) other_instruction_set_ = marks.instruction_set;
    empty_ = false;
    if (!shard_ended_) journal_->append(kResumption, {});
    resumptions_ = marks.resumptions + 1;
  }
  for (const FoundJournal& other : std::span(found).subspan(1)) {
    for (const JournalRecord& record : other.content.records) {
      journal_->append(record.id, record.payload);
    }
    journal_->sync();
    remove_file(other.path);
  }
  for (FoundJournal& one : found) take_records(std::move(one.content.records));
}

/// Opens the journal of a process that does not lead.
void CaseJournal::follow() {
  team_->meet();
  FoundJournal run{path_, read_open_journal(path_, kind_)};
  if (run.content.state == JournalState::Usable) {
    Marks marks;
    marks.take_out_of(run);
    take_records(std::move(run.content.records));
  }
  team_->agree(digest_of_found(), {});
  if (run.content.state != JournalState::Usable) {
    throw StorageError(path_, "is not to be seen by process " + std::to_string(team_->rank()) +
                                  ": all processes need one folder");
  }
  journal_.emplace(Journal::create(team_journal_path(path_, team_->rank()), kind_));
  mark_instruction_set();
}

void CaseJournal::mark_instruction_set() {
  if (instruction_set_.empty()) return;
  journal_->append(kInstructionSet, std::as_bytes(std::span(instruction_set_)));
}

/// A case that stands there twice was run again on purpose.
void CaseJournal::take_records(std::vector<JournalRecord> records) {
  for (JournalRecord& record : records) {
    found_.insert_or_assign(std::move(record.id), std::move(record.payload));
  }
}

/// The same for every order of the records.
std::uint64_t CaseJournal::digest_of_found() const {
  std::uint64_t sum = 0;
  for (const auto& [id, payload] : found_) sum += Digest().text(id).bytes(payload).value();
  return sum;
}

std::vector<bool> CaseJournal::begin(const std::string& run, std::span<const std::string> ids,
                                     std::size_t together) {
  if (merged_) check_merged(run, ids, together);
  if (shard_ || found_shard_) return begin_shard(run, ids, together);
  if (team_ != nullptr) {
    team_->agree(Digest().text(instruction_set_).value(),
                 "instruction set: give --isa avx2, or baseline");
    team_->agree(Digest().text(run).value(), "inputs, options or version");
  }
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

CaseJournal::~CaseJournal() { remove_if_empty(); }

void CaseJournal::remove_if_empty() {
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

std::size_t CaseJournal::found_besides(const std::unordered_set<std::string>& ids) const {
  return static_cast<std::size_t>(
      std::count_if(found_.begin(), found_.end(),
                    [&](const auto& record) { return !ids.contains(record.first); }));
}

void CaseJournal::keep(std::string_view id, std::span<const std::byte> payload) {
  if (merged_) throw std::logic_error("CaseJournal::keep: a case of merged shards was computed");
  journal_->append(id, payload);
  empty_ = false;
}

void CaseJournal::sync() {
  if (journal_) journal_->sync();
}

void CaseJournal::gather(bool everyone) {
  if (team_ == nullptr) return;
  sync();
  team_->meet();
  for (std::size_t rank = 0; rank < team_->size(); ++rank) {
    if (rank == team_->rank() || (!everyone && !team_->leads())) continue;
    const std::string path = team_journal_path(path_, rank);
    FoundJournal other{path, read_open_journal(path, kind_)};
    if (other.content.state != JournalState::Usable) throw StorageError(path, "is gone");
    if (other.content.damaged > 0 || other.content.dropped_bytes > 0) {
      throw StorageError(path, "is damaged: --resume runs again what it has lost");
    }
    Marks().take_out_of(other);
    for (const JournalRecord& record : other.content.records) gathered_.insert(record.id);
    take_records(std::move(other.content.records));
  }
  team_->meet();
}

const std::vector<std::byte>* CaseJournal::find_gathered(std::string_view id) const {
  return gathered_.contains(std::string(id)) ? find(id) : nullptr;
}

void CaseJournal::finish() {
  if (!journal_ || (team_ != nullptr && !team_->leads())) return;
  // The run's own goes last: what stands beside none would be in the way of the next run.
  for (std::size_t rank = 1; team_ != nullptr && rank < team_->size(); ++rank) {
    remove_file(team_journal_path(path_, rank));
  }
  journal_->remove();
  journal_.reset();
}

}  // namespace plastica::io
