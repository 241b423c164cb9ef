#include "calibrate/store/journaled_batch.hpp"

#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "calibrate/fit/fit.hpp"
#include "calibrate/store/case_id.hpp"
#include "calibrate/store/record_bytes.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {
namespace {

/// The journal's run digest says what its records are. What each of them was computed from is in
/// its id, so that a change of one target or of the options makes no journal worthless as a whole.
std::uint64_t journal_kind() {
  return io::Digest().text("plastica/fits").integer(kRecordVersion).value();
}

/// Id of the empty record that each resumption leaves in the journal; no fit's id is a lone word.
constexpr std::string_view kResumption = "resumption";

/// Takes the marks of resumptions out of a journal's records and counts them.
int take_resumptions(std::vector<io::JournalRecord>& records) {
  const auto is_mark = [](const io::JournalRecord& record) { return record.id == kResumption; };
  return static_cast<int>(std::erase_if(records, is_mark));
}

/// Names are the identity of a target in journal and file.
void check_names(std::span<const Target> targets) {
  std::unordered_set<std::string_view> names;
  for (const Target& target : targets) {
    if (names.insert(target.name).second) continue;
    throw InputError({target.file, 0}, "name", target.name, "two targets of a batch have it");
  }
}

/// Whether to go on from a journal that was found; else it is to be written afresh.
/// @throws InputError if it may not be overwritten
bool shall_go_on(const io::JournalContent& found, const JournaledOptions& how) {
  const auto refuse = [&](std::string_view rule) {
    throw InputError({how.journal, 0}, "", "", rule);
  };
  switch (found.state) {
    case io::JournalState::Absent: return false;
    case io::JournalState::NotAJournal:
      refuse("is in the place of the journal but is none: move it, or name another output");
      return false;
    case io::JournalState::OtherRun:
    case io::JournalState::OtherVersion:
      if (!how.force) {
        refuse(
            "is the journal of an interrupted run of another version: use --force to start afresh");
      }
      return false;
    case io::JournalState::Usable: break;
  }
  if (how.resume) return true;
  if (!found.records.empty() && !how.force) {
    refuse("is the journal of an interrupted run, with " + std::to_string(found.records.size()) +
           " finished fits: use --resume to go on or --force to start afresh");
  }
  return false;
}

}  // namespace

std::string journal_path(const std::string& output) { return output + ".journal"; }

JournaledBatch::JournaledBatch(std::span<const Target> targets, const FitOptions& options,
                               JournaledOptions how)
    : targets_(targets),
      options_(options),
      how_(std::move(how)),
      ids_(targets.size()),
      results_(targets.size()) {
  check_parameters(options.parameters);
  check_names(targets);
  const std::uint64_t options_digest = digest_of(options);
  parallel_for(targets.size(), {how_.threads, nullptr},
               [&](std::size_t i, int) { ids_[i] = case_id(targets[i], options_digest); });

  io::JournalContent found = io::read_journal(how_.journal, journal_kind());
  const int resumptions = take_resumptions(found.records);
  if (shall_go_on(found, how_)) {
    dropped_bytes_ = found.dropped_bytes;
    kept_ = found.records.size();
    journal_.emplace(io::Journal::resume(how_.journal, journal_kind(), found));
    if (kept_ > 0) {
      journal_->append(kResumption, {});
      resumptions_ = resumptions + 1;
    }
    take_from(found.records);
  } else {
    journal_.emplace(io::Journal::create(how_.journal, journal_kind()));
  }
}

JournaledBatch::~JournaledBatch() {
  if (!journal_ || kept_ > 0) return;
  try {
    journal_->remove();
  } catch (const io::StorageError&) {
    // An empty journal that stays is harmless: the next run writes over it.
  }
}

void JournaledBatch::take_from(const std::vector<io::JournalRecord>& records) {
  std::unordered_map<std::string, const io::JournalRecord*> by_id;
  for (const io::JournalRecord& record : records) by_id.emplace(record.id, &record);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const auto found = by_id.find(ids_[i]);
    if (found == by_id.end()) continue;
    results_[i] = result_from_bytes(found->second->payload);
    ++taken_;
  }
  outdated_ = by_id.size() - taken_;
}

void JournaledBatch::count(const FitResult& result, BatchProgress& progress) const {
  ++progress.done;
  if (result.status == FitStatus::Failed) ++progress.failed;
  if (result.status == FitStatus::Rejected) ++progress.rejected;
}

void JournaledBatch::keep(std::size_t target, const FitResult& result) {
  journal_->append(ids_[target], bytes_of(result));
  ++kept_;
}

std::vector<FitResult> JournaledBatch::run() {
  if (std::exchange(has_run_, true)) {
    throw std::logic_error("JournaledBatch::run: it has run already");
  }
  BatchProgress progress{.taken = taken_, .total = targets_.size()};
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (results_[i]) {
      count(*results_[i], progress);
    } else {
      missing.push_back(i);
    }
  }
  if (how_.progress) how_.progress(progress);

  // A batch wants its targets in a row: those that are missing, unless that is all of them.
  std::vector<Target> gathered;
  if (taken_ > 0) {
    gathered.reserve(missing.size());
    for (const std::size_t i : missing) gathered.push_back(targets_[i]);
  }
  const std::span<const Target> to_fit = taken_ > 0 ? std::span<const Target>(gathered) : targets_;
  const auto finished = [&](std::size_t index, const FitResult& result) {
    keep(missing[index], result);
    count(result, progress);
    if (how_.progress) how_.progress(progress);
  };
  std::vector<FitResult> fitted = fit_batch(
      to_fit, options_, {.threads = how_.threads, .stop = how_.stop, .finished = finished});
  complete_ = progress.done == targets_.size();
  if (!complete_) journal_->sync();

  std::vector<FitResult> results(targets_.size());
  for (std::size_t k = 0; k < missing.size(); ++k) results[missing[k]] = std::move(fitted[k]);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (results_[i]) results[i] = std::move(*results_[i]);
  }
  return results;
}

void JournaledBatch::finish() {
  if (!complete_ || !journal_) {
    throw std::logic_error("JournaledBatch::finish: the batch is not complete");
  }
  journal_->remove();
  journal_.reset();
}

}  // namespace plastica::calibrate
