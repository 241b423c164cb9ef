#include "calibrate/store/journaled_fits.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "calibrate/store/result_bytes.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {

template <typename Result>
JournaledFits<Result>::JournaledFits(JournaledOptions how, std::uint64_t kind,
                                     std::string_view noun)
    : how_(std::move(how)), journal_(how_.journal, kind, noun) {}

template <typename Result>
void JournaledFits<Result>::resume(const std::function<bool(std::size_t, Result&)>& usable) {
  results_.resize(ids_.size());
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const std::vector<std::byte>* bytes = own_[i] ? journal_.find(ids_[i]) : nullptr;
    if (bytes == nullptr) continue;
    Result result = result_from_bytes<Result>(*bytes);
    if (usable && !usable(i, result)) continue;
    results_[i] = std::make_unique<Result>(std::move(result));
    count(*results_[i]);
    ++progress_.resumed;
  }
  stale_ = journal_.found() - progress_.resumed;
  before_ = progress_;
}

template <typename Result>
void JournaledFits<Result>::deal(const std::string& run, std::size_t together) {
  run_id_ = run;
  own_ = journal_.begin(run, ids_, together);
  progress_.total = static_cast<std::size_t>(std::count(own_.begin(), own_.end(), true));
}

template <typename Result>
void JournaledFits<Result>::count(const Result& result) {
  ++progress_.done;
  if (result.status == FitStatus::Failed) ++progress_.failed;
  if (result.status == FitStatus::Rejected) ++progress_.rejected;
}

template <typename Result>
void JournaledFits<Result>::start_run() {
  if (std::exchange(has_run_, true)) throw std::logic_error("JournaledFits: it has run already");
  kept_.assign(ids_.size(), 0);
  if (team() != nullptr) {
    team()->on_report([this](const Team::Counts& others) {
      const std::lock_guard lock(mutex_);
      others_ = others;
      tell();
    });
  }
  tell();
}

template <typename Result>
void JournaledFits<Result>::tell() const {
  if (!how_.progress) return;
  BatchProgress all = progress_;
  all.done += others_[0];
  all.failed += others_[1];
  all.rejected += others_[2];
  how_.progress(all);
}

template <typename Result>
void JournaledFits<Result>::keep(std::size_t index, const Result& result) {
  journal_.keep(ids_[index], bytes_of(result));
  kept_[index] = 1;
  const std::lock_guard lock(mutex_);
  count(result);
  tell();
  if (team() == nullptr) return;
  team()->report({progress_.done - before_.done, progress_.failed - before_.failed,
                  progress_.rejected - before_.rejected});
}

template <typename Result>
void JournaledFits<Result>::gather(bool everyone) {
  if (team() == nullptr) return;
  journal_.gather(everyone);
  if (!everyone && !team()->leads()) return;
  others_ = {};
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (results_[i] || kept_[i] != 0) continue;
    const std::vector<std::byte>* bytes = journal_.find_gathered(ids_[i]);
    if (bytes == nullptr) continue;
    results_[i] = std::make_unique<Result>(result_from_bytes<Result>(*bytes));
    count(*results_[i]);
  }
  tell();
}

template <typename Result>
void JournaledFits<Result>::end_run(bool complete) {
  complete_ = complete;
  if (!complete_) journal_.sync();
}

template <typename Result>
void JournaledFits<Result>::finish() {
  if (!complete_) throw std::logic_error("JournaledFits::finish: the run is not complete");
  journal_.finish();
}

template <typename Result>
void JournaledFits<Result>::end_shard() {
  if (!complete_) throw std::logic_error("JournaledFits::end_shard: the run is not complete");
  journal_.end_shard();
}

template class JournaledFits<FitResult>;
template class JournaledFits<SceneFitResult>;

std::string run_id_of(std::vector<std::string> ids, std::optional<std::uint64_t> besides) {
  std::sort(ids.begin(), ids.end());
  io::Digest digest;
  if (besides) digest.integer(*besides);
  for (const std::string& id : ids) digest.text(id);
  return io::hexadecimal(digest.value());
}

}  // namespace plastica::calibrate
