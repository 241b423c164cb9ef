#include "calibrate/store/journaled_batch.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "calibrate/fit/fitted_curve.hpp"
#include "calibrate/fit/unseen.hpp"
#include "calibrate/store/case_id.hpp"
#include "calibrate/store/result_bytes.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {
namespace {

/// What of each fit is computed is in its id, so that a change of one target or of the options
/// makes no journal worthless as a whole.
std::uint64_t journal_kind() {
  return io::Digest().text("plastica/fits").integer(kResultVersion).value();
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

/// @param ids  of all cases
std::string id_of_run(std::vector<std::string> ids, std::span<const Target> targets,
                      const FitOptions& options, int threads) {
  // Samples that were dropped decide nothing, but stand in the result.
  std::vector<std::string> raw_ids(targets.size());
  parallel_for(targets.size(), {threads, nullptr}, [&](std::size_t i, int) {
    raw_ids[i] = targets[i].name + ' ' + io::hexadecimal(digest_of(targets[i].raw));
  });
  ids.insert(ids.end(), raw_ids.begin(), raw_ids.end());
  for (const Target& target : targets) {
    // Nor do groups, by which the report takes means.
    for (const auto& [key, value] : target.group) {
      std::string id = target.name;
      ids.push_back(id.append(1, ' ').append(key).append(1, '=').append(value));
    }
  }
  // Nor does what the fit's file says of the material in so many words, which exports take.
  for (const std::string& said : options.stated) ids.push_back("says " + said);
  // What is drawn for a group's mean is no part of a fit.
  return run_id_of(std::move(ids), static_cast<std::uint64_t>(options.intervals.specimens));
}

/// What is told, once targets and options are known to be good: bad ones leave a journal as it is.
JournaledOptions checked(JournaledOptions how, std::span<const Target> targets,
                         const FitOptions& options) {
  check_parameters(options.parameters);
  check_names(targets);
  return how;
}

}  // namespace

JournaledBatch::JournaledBatch(std::span<const Target> targets, const FitOptions& options,
                               JournaledOptions how)
    : JournaledFits(checked(std::move(how), targets, options), journal_kind(), "fits"),
      targets_(targets),
      options_(options),
      cases_(cases_of(targets.size(), options)) {
  ids_ = ids_of(targets, options, cases_, how_.threads);
  deal(id_of_run(ids_, targets, options, how_.threads));
  resume([&](std::size_t i, FitResult& result) {
    if (!may_have_curve(targets[cases_[i].target], result)) return false;
    if (!options.keep_trace) result.trace.leave_out();
    return !options.keep_trace || result.trace.left_out == 0;
  });
}

void JournaledBatch::remake_curves(std::vector<FitResult>& results) const {
  if (how_.counts_curves) return;
  parallel_for(results.size(), {how_.threads, nullptr}, [&](std::size_t i, int) {
    FitResult& result = results[i];
    if (!result.fitted.is_aside()) return;
    result.fitted = remade_curve(targets_[cases_[i].target], options_, result);
  });
}

std::vector<FitResult> JournaledBatch::run() {
  start_run();
  std::vector<std::size_t> missing;
  std::vector<FitCase> to_fit;
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    if (results_[i] || !is_own(i)) continue;
    missing.push_back(i);
    to_fit.push_back(cases_[i]);
  }
  const auto finished = [&](std::size_t k, FitResult& result) {
    keep(missing[k], result);
    if (how_.counts_curves) count_alone(result);
  };
  std::vector<FitResult> fitted;
  share(team(), to_fit.size(), how_.stop, [&](const NextIndex& next) {
    fitted =
        fit_cases(targets_, to_fit, options_,
                  {.threads = how_.threads, .stop = how_.stop, .finished = finished, .next = next});
  });
  gather(false);
  end_run(progress_.done == progress_.total);

  std::vector<FitResult> results = std::move(fitted);
  if (missing.size() < cases_.size()) {
    fitted = std::exchange(results, std::vector<FitResult>(cases_.size()));
    for (std::size_t k = 0; k < missing.size(); ++k) results[missing[k]] = std::move(fitted[k]);
  }
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    if (results_[i]) results[i] = std::move(*results_[i]);
  }
  results_.clear();
  remake_curves(results);
  // Of all fits together, and quick: no part of the journal.
  if (complete() && own() == size()) add_unseen(targets_, cases_, options_, how_.threads, results);
  return results;
}

std::string run_id(std::span<const Target> targets, const FitOptions& options, int threads) {
  const std::vector<FitCase> cases = cases_of(targets.size(), options);
  return id_of_run(ids_of(targets, options, cases, threads), targets, options, threads);
}

}  // namespace plastica::calibrate
