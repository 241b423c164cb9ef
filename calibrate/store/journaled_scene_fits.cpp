#include "calibrate/store/journaled_scene_fits.hpp"

#include <mutex>
#include <stdexcept>

#include "calibrate/scene/scene_fit_digest.hpp"
#include "calibrate/store/scene_result_bytes.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {
namespace {

std::uint64_t journal_kind() {
  return io::Digest().text("plastica/scene-fits").integer(kSceneResultVersion).value();
}

/// Who a fit is: its name, and a digest of all that can change the result's bits. Its scenes are
/// at rest or step by kernels of the instruction set that they name.
std::string id_of(const SceneFitCase& one, const SceneFitOptions& options) {
  io::Digest digest;
  digest.text(version()).integer(digest_of(one.parts, options));
  return one.name + " " + io::hexadecimal(digest.value());
}

}  // namespace

JournaledSceneFits::JournaledSceneFits(std::span<const SceneFitCase> cases,
                                       const SceneFitOptions& options, JournaledOptions how)
    : cases_(cases),
      options_(options),
      how_(std::move(how)),
      journal_(how_.journal, journal_kind(), "fits") {
  for (const SceneFitCase& one : cases) {
    ids_.push_back(id_of(one, options));
    if (journal_.find(ids_.back()) != nullptr) ++taken_;
  }
  outdated_ = journal_.found() - taken_;
}

SceneFitResult JournaledSceneFits::fit(std::size_t index, const SceneFitOptions& options) const {
  if (cases_.size() == 1) return fit_scenes(cases_[index].parts, options);
  try {
    return fit_scenes(cases_[index].parts, options);
  } catch (const InputError& error) {
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
                 results[i] = fit(i, options);
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
