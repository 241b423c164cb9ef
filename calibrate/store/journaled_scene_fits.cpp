#include "calibrate/store/journaled_scene_fits.hpp"

#include <mutex>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "calibrate/scene/scene_fit_digest.hpp"
#include "calibrate/scene/search_record.hpp"
#include "calibrate/store/scene_result_bytes.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {
namespace {

std::uint64_t journal_kind() {
  return io::Digest()
      .text("plastica/scene-fits")
      .integer(kSceneResultVersion)
      .integer(kSearchRecordVersion)
      .value();
}

/// Who a fit is: its name, and a digest of all that can change the result's bits. Its scenes are
/// at rest or step by kernels of the instruction set that they name.
std::string id_of(const SceneFitCase& one, const SceneFitOptions& options) {
  io::Digest digest;
  digest.text(version()).integer(digest_of(one.parts, options));
  return one.name + " " + io::hexadecimal(digest.value());
}

/// Who a finished part of a fit is.
std::string part_of(const std::string& id, std::string_view name) {
  return id + "/" + std::string(name);
}

}  // namespace

JournaledSceneFits::JournaledSceneFits(std::span<const SceneFitCase> cases,
                                       const SceneFitOptions& options, JournaledOptions how,
                                       std::function<void(const SceneFitProgress&)> within)
    : cases_(cases),
      options_(options),
      how_(std::move(how)),
      within_(std::move(within)),
      journal_(how_.journal, journal_kind(), "fits and parts of fits") {
  std::size_t done_with = 0;  // parts of finished fits
  for (const SceneFitCase& one : cases) {
    ids_.push_back(id_of(one, options));
    const std::size_t parts = journal_.found_under(part_of(ids_.back(), ""));
    const bool whole = journal_.find(ids_.back()) != nullptr;
    if (whole) ++taken_;
    (whole ? done_with : parts_) += parts;
  }
  outdated_ = journal_.found() - taken_ - parts_ - done_with;
}

/// @return nothing if it was stopped
std::optional<SceneFitResult> JournaledSceneFits::fit(std::size_t index, SceneFitOptions options) {
  const std::string& id = ids_[index];
  options.hooks = {};
  options.hooks.stop = how_.stop;
  options.hooks.find = [&](const std::string& name) { return journal_.find(part_of(id, name)); };
  options.hooks.keep = [&](const std::string& name, std::span<const std::byte> bytes) {
    journal_.keep(part_of(id, name), bytes);
  };
  const bool alone = cases_.size() == 1;
  if (alone) options.hooks.progress = within_;
  try {
    return fit_scenes(cases_[index].parts, options);
  } catch (const FitInterrupted&) {
    return std::nullopt;
  } catch (const InputError& error) {
    if (alone) throw;
    SceneFitResult failed;
    failed.reason = error.what();
    return failed;
  }
}

std::vector<SceneFitResult> JournaledSceneFits::run() {
  std::vector<SceneFitResult> results(cases_.size());
  BatchProgress progress{.taken = taken_, .total = cases_.size()};
  std::vector<std::size_t> missing;
  const auto count = [&](const SceneFitResult& result) {
    ++progress.done;
    if (result.status == FitStatus::Failed) ++progress.failed;
  };
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    const std::vector<std::byte>* bytes = journal_.find(ids_[i]);
    if (bytes == nullptr) {
      missing.push_back(i);
      continue;
    }
    results[i] = scene_result_from_bytes(*bytes);
    count(results[i]);
  }
  if (how_.progress) how_.progress(progress);
  SceneFitOptions options = options_;
  options.threads = missing.size() > 1 ? 1 : how_.threads;
  std::mutex mutex;
  parallel_for(missing.size(), {missing.size() > 1 ? how_.threads : 1, how_.stop},
               [&](std::size_t k, int) {
                 const std::size_t i = missing[k];
                 std::optional<SceneFitResult> result = fit(i, options);
                 if (!result) return;
                 results[i] = std::move(*result);
                 journal_.keep(ids_[i], bytes_of(results[i]));
                 const std::lock_guard lock(mutex);
                 count(results[i]);
                 if (how_.progress) how_.progress(progress);
               });
  complete_ = progress.done == cases_.size();
  if (!complete_) journal_.sync();
  return results;
}

void JournaledSceneFits::finish() {
  if (!complete_) throw std::logic_error("JournaledSceneFits::finish: it is not complete");
  journal_.finish();
}

}  // namespace plastica::calibrate
