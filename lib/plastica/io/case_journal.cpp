#include "plastica/io/case_journal.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "plastica/base/check.hpp"

namespace plastica::io {
namespace {

// Ids of records that are no cases; no case has them.

/// An empty record that each resumption leaves in the journal.
constexpr std::string_view kResumption = "resumption";
/// The name of the instruction set of the run that began the journal.
constexpr std::string_view kInstructionSet = "instruction set";

/// What a journal says of its run beside the cases.
struct Marks {
  int resumptions = 0;
  std::string instruction_set{};  ///< empty in journals of older versions
};

/// Takes the marks out of a journal's records.
Marks take_marks(std::vector<JournalRecord>& records) {
  Marks marks;
  std::erase_if(records, [&marks](const JournalRecord& record) {
    if (record.id == kResumption) ++marks.resumptions;
    if (record.id == kInstructionSet) {
      marks.instruction_set.assign(reinterpret_cast<const char*>(record.payload.data()),
                                   record.payload.size());
    }
    return record.id == kResumption || record.id == kInstructionSet;
  });
  return marks;
}

/// Whether to go on from a journal that was found; else it is to be written afresh.
/// @throws InputError if it may not be overwritten; StorageError if another run has it
bool shall_go_on(const JournalContent& found, const JournalPolicy& policy, std::string_view noun) {
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
  if (!found.records.empty() && !policy.force) {
    refuse("is the journal of an interrupted run, with " + std::to_string(found.records.size()) +
           " finished " + std::string(noun) + ": use --resume to go on or --force to start afresh");
  }
  return false;
}

}  // namespace

std::string journal_path(const std::string& output) { return output + ".journal"; }

CaseJournal::CaseJournal(const JournalPolicy& policy, std::uint64_t kind, std::string_view noun) {
  JournalContent content = read_journal(policy.path, kind);
  const Marks marks = take_marks(content.records);
  if (!shall_go_on(content, policy, noun)) {
    journal_.emplace(Journal::create(policy.path, kind));
    if (!policy.instruction_set.empty()) {
      journal_->append(kInstructionSet, std::as_bytes(std::span(policy.instruction_set)));
    }
    return;
  }
  dropped_bytes_ = content.dropped_bytes;
  journal_.emplace(Journal::resume(policy.path, kind, content));
  if (content.records.empty()) return;
  if (marks.instruction_set != policy.instruction_set) {
    other_instruction_set_ = marks.instruction_set;
  }
  empty_ = false;
  journal_->append(kResumption, {});
  resumptions_ = marks.resumptions + 1;
  // A case that stands there twice was run again on purpose.
  for (JournalRecord& record : content.records) {
    found_.insert_or_assign(std::move(record.id), std::move(record.payload));
  }
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
  journal_->append(id, payload);
  empty_ = false;
}

void CaseJournal::sync() { journal_->sync(); }

void CaseJournal::finish() {
  journal_->remove();
  journal_.reset();
}

}  // namespace plastica::io
