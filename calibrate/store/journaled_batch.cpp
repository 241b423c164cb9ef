#include "calibrate/store/journaled_batch.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/unseen.hpp"
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

/// Names are the identity of a target in journal and file.
void check_names(std::span<const Target> targets) {
  std::unordered_set<std::string_view> names;
  for (const Target& target : targets) {
    if (names.insert(target.name).second) continue;
    throw InputError({target.file, 0}, "name", target.name, "two targets of a batch have it");
  }
}

/// Who each case is.
std::vector<std::string> ids_of(std::span<const Target> targets, const FitOptions& options,
                                std::span<const FitCase> cases, int threads) {
  std::vector<std::string> ids(cases.size());
  const std::uint64_t options_digest = digest_of(options);
  parallel_for(cases.size(), {threads, nullptr}, [&](std::size_t i, int) {
    const FitCase& one = cases[i];
    const std::uint64_t digest =
        one.law ? io::Digest().integer(options_digest).text(name_of(*one.law)).value()
                : options_digest;
    ids[i] = case_id(targets[one.target], digest);
  });
  return ids;
}

/// The policy, once targets and options are known to be good: bad ones leave a journal as it is.
io::JournalPolicy checked(const io::JournalPolicy& policy, std::span<const Target> targets,
                          const FitOptions& options) {
  check_parameters(options.parameters);
  check_names(targets);
  return policy;
}

}  // namespace

JournaledBatch::JournaledBatch(std::span<const Target> targets, const FitOptions& options,
                               JournaledOptions how)
    : targets_(targets),
      options_(options),
      how_(std::move(how)),
      cases_(cases_of(targets.size(), options)),
      ids_(ids_of(targets, options, cases_, how_.threads)),
      results_(cases_.size()),
      journal_(checked(how_.journal, targets, options), journal_kind(), "fits") {
  take_from_journal();
}

void JournaledBatch::take_from_journal() {
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    const std::vector<std::byte>* bytes = journal_.find(ids_[i]);
    if (bytes == nullptr) continue;
    results_[i] = result_from_bytes(*bytes);
    ++resumed_;
  }
  stale_ = journal_.found() - resumed_;
}

void JournaledBatch::count(const FitResult& result, BatchProgress& progress) const {
  ++progress.done;
  if (result.status == FitStatus::Failed) ++progress.failed;
  if (result.status == FitStatus::Rejected) ++progress.rejected;
}

void JournaledBatch::keep(std::size_t index, const FitResult& result) {
  journal_.keep(ids_[index], bytes_of(result));
}

std::string JournaledBatch::run_id() const {
  io::Digest digest;
  // What is drawn for a group's mean is no part of a fit.
  digest.integer(static_cast<std::uint64_t>(options_.intervals.specimens));
  std::vector<std::string> ids = ids_;
  // Samples that were dropped decide nothing, but stand in the result.
  for (const Target& target : targets_) {
    io::Digest raw;
    raw.reals(target.raw.strain).reals(target.raw.stress);
    ids.push_back(target.name + ' ' + io::hexadecimal(raw.value()));
  }
  std::sort(ids.begin(), ids.end());  // as results are stored: in whatever order they come
  for (const std::string& id : ids) digest.text(id);
  return io::hexadecimal(digest.value());
}

std::vector<FitResult> JournaledBatch::run() {
  if (std::exchange(has_run_, true)) {
    throw std::logic_error("JournaledBatch::run: it has run already");
  }
  BatchProgress progress{.resumed = resumed_, .total = cases_.size()};
  std::vector<std::size_t> missing;
  std::vector<FitCase> to_fit;
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    if (results_[i]) {
      count(*results_[i], progress);
    } else {
      missing.push_back(i);
      to_fit.push_back(cases_[i]);
    }
  }
  if (how_.progress) how_.progress(progress);

  const auto finished = [&](std::size_t index, const FitResult& result) {
    keep(missing[index], result);
    count(result, progress);
    if (how_.progress) how_.progress(progress);
  };
  std::vector<FitResult> fitted =
      fit_cases(targets_, to_fit, options_,
                {.threads = how_.threads, .stop = how_.stop, .finished = finished});
  complete_ = progress.done == cases_.size();
  if (!complete_) journal_.sync();

  std::vector<FitResult> results(cases_.size());
  for (std::size_t k = 0; k < missing.size(); ++k) results[missing[k]] = std::move(fitted[k]);
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    if (results_[i]) results[i] = std::move(*results_[i]);
  }
  // Of all fits together, and quick: no part of the journal.
  if (complete_) add_unseen(targets_, cases_, options_, how_.threads, results);
  return results;
}

void JournaledBatch::finish() {
  if (!complete_) throw std::logic_error("JournaledBatch::finish: the batch is not complete");
  journal_.finish();
}

}  // namespace plastica::calibrate
