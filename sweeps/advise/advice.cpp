#include "sweeps/advise/advice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "plastica/model/scene.hpp"
#include "sweeps/advise/next_setting.hpp"
#include "sweeps/advise/watched_probes.hpp"

namespace plastica::sweeps {
namespace {

/// What of the allowed error the estimates may take: the rest is for what they do not see.
constexpr double kShare = 0.75;
constexpr double kRefined = 0.5;  ///< factor on a size that is made finer
constexpr double kSupposedOrder = 1.0;
constexpr double kHighestOrder = 2.0;
/// Sizes that differ by less show no order.
constexpr double kLeastRatio = 1.3;
/// So many settings may be no better than the best before.
constexpr int kPatience = 5;
/// A cheaper setting is tried if it is expected to cost less than this part.
constexpr double kWorthTrying = 0.7;

class Adviser {
 public:
  Adviser(const Setup& setup, const AdviceOptions& options)
      : setup_(setup),
        options_(options),
        axes_(fineness_axes(setup)),
        probes_(watched_probes(setup, options.probes)) {}

  Advice run();

 private:
  /// A setting with the runs that say how good it is.
  struct Candidate {
    Setting setting;
    std::vector<AxisError> errors{};
    double sum = 0.0;
    double verified = 0.0;
    double promised = 0.0;
    std::string worst{};
    std::string reason{};
    bool within = false;
  };

  Setting coarsest() const;
  Setting finer(const Setting& setting, std::size_t axis) const;
  Setting finer_in_all(const Setting& setting) const;
  const Outcome& outcome(const Setting& setting) { return outcomes_.at(setting); }
  /// Runs the settings that were not run yet. False: runs or work are used up, or it was stopped;
  /// `end_` says which.
  bool run_all(std::vector<Setting> settings);
  bool estimate(Candidate& candidate);
  bool verify(Candidate& candidate);
  AxisError error_along(const Candidate& candidate, std::size_t axis);
  double expected_work(const Setting& from, const Setting& to) const;
  /// Estimates, and verifies what is good enough; then `candidate.within` says whether it does.
  bool judge(Candidate& candidate);
  TriedSetting tried(const Setting& setting);
  void fill(const Candidate& best, Advice& advice);
  double foreseen_work(const std::vector<Setting>& settings) const;
  /// Whether refinement has stopped to help: the sum has not fallen for some settings.
  bool diverges(const Candidate& candidate);

  struct SeenChange {
    double size = 0.0;
    double change = 0.0;
  };

  const Setup& setup_;
  const AdviceOptions& options_;
  std::vector<FinenessAxis> axes_;
  WatchedProbes probes_;
  std::map<Setting, Outcome> outcomes_;
  std::vector<std::vector<SeenChange>> seen_;  ///< by axis, in the order of the settings
  std::optional<Setting> finest_{};            ///< of the last verification
  double share_ = kShare;
  int runs_ = 0;
  double work_ = 0.0;  ///< of all runs, segment-iterations
  AdviceEnd end_ = AdviceEnd::AtFinest;
  double least_sum_ = std::numeric_limits<double>::infinity();
  int since_least_ = 0;  ///< settings whose sum was not less
};

Setting Adviser::coarsest() const {
  Setting setting;
  for (const FinenessAxis& axis : axes_) setting.push_back(axis.coarsest);
  return taken_setting(setup_, axes_, std::move(setting));
}

Setting Adviser::finer(const Setting& setting, std::size_t axis) const {
  Setting made = setting;
  made[axis] = axes_[axis].scaled(setting[axis], kRefined);
  return taken_setting(setup_, axes_, std::move(made));
}

Setting Adviser::finer_in_all(const Setting& setting) const {
  Setting made = setting;
  for (std::size_t k = 0; k < axes_.size(); ++k) made[k] = axes_[k].scaled(setting[k], kRefined);
  return taken_setting(setup_, axes_, std::move(made));
}

bool Adviser::run_all(std::vector<Setting> settings) {
  std::erase_if(settings, [&](const Setting& s) { return outcomes_.count(s) > 0; });
  if (runs_ + static_cast<int>(settings.size()) > options_.max_runs) {
    end_ = AdviceEnd::TooManyRuns;
    return false;
  }
  if (work_ + foreseen_work(settings) > options_.max_work) {
    end_ = AdviceEnd::TooMuchWork;
    return false;
  }
  std::vector<BatchCase> cases;
  for (const Setting& setting : settings) {
    const Setup at = setup_at(setup_, axes_, setting);
    cases.push_back({std::to_string(cases.size()), at.scene, at.solver});
  }
  BatchOptions how{.threads = options_.threads, .stop = options_.stop};
  if (options_.progress) {
    how.progress = [&](std::size_t done) { options_.progress(runs_ + static_cast<int>(done)); };
  }
  const std::vector<BatchRow> rows = run_batch(cases, how);
  if (is_raised(options_.stop)) {
    end_ = AdviceEnd::Interrupted;
    return false;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Outcome& made =
        outcomes_.emplace(settings[i], outcome_of(rows[i], probes_.watched)).first->second;
    work_ += static_cast<double>(made.work);
  }
  runs_ += static_cast<int>(rows.size());
  return true;
}

AxisError Adviser::error_along(const Candidate& candidate, std::size_t axis) {
  const Setting made = finer(candidate.setting, axis);
  AxisError error;
  const double size = axes_[axis].size(candidate.setting[axis]);
  error.ratio = size / axes_[axis].size(made[axis]);
  if (!(error.ratio > 1.0)) {  // it is at its finest, and nothing says what it is off
    error.change = error.error = std::numeric_limits<double>::infinity();
    return error;
  }
  error.change = deviation(outcome(candidate.setting), outcome(made), probes_.watched).largest;
  error.order = kSupposedOrder;
  for (const SeenChange& before : seen_[axis]) {
    const double ratio = before.size / size;
    const bool tells = (ratio > kLeastRatio || ratio < 1.0 / kLeastRatio) && before.change > 0.0 &&
                       error.change > 0.0 && std::isfinite(error.change);
    if (!tells) continue;
    error.order = seen_order(before.size, before.change, size, error.change, kHighestOrder);
    error.seen = true;
  }
  if (std::isfinite(error.change)) seen_[axis].push_back({size, error.change});
  error.error = left_of(error.change, error.ratio, error.order);
  return error;
}

bool Adviser::estimate(Candidate& candidate) {
  std::vector<Setting> settings{candidate.setting};
  for (std::size_t k = 0; k < axes_.size(); ++k) settings.push_back(finer(candidate.setting, k));
  if (!run_all(settings)) return false;
  candidate.errors.clear();
  candidate.sum = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    candidate.errors.push_back(error_along(candidate, k));
    candidate.sum += candidate.errors.back().error;
    const Deviation off =
        deviation(outcome(candidate.setting), outcome(settings[k + 1]), probes_.watched);
    if (!off.reason.empty()) candidate.reason = off.reason;
    if (candidate.errors.back().error >= largest) candidate.worst = off.quantity;
    largest = std::max(largest, candidate.errors.back().error);
    if (off.reason.empty() && off.quantities == 0) {
      throw InputError({}, "probe", "",
                       "stays within rounding, whatever is probed: advice needs "
                       "a probe of something that moves");
    }
  }
  return true;
}

bool Adviser::verify(Candidate& candidate) {
  const Setting all = finer_in_all(candidate.setting);
  if (!run_all({all})) return false;
  finest_ = all;
  const Deviation off = deviation(outcome(candidate.setting), outcome(all), probes_.watched);
  candidate.worst = off.quantity;
  candidate.reason = off.reason;
  candidate.verified = off.largest;
  // What the finer run itself is off: by the axis that falls the slowest of those that matter.
  double left = 1.0;
  for (const AxisError& e : candidate.errors) {
    if (e.error > 0.05 * candidate.sum) left = std::max(left, left_of(1.0, e.ratio, e.order));
  }
  // Changes are over a finer run's value f_h, not over the limit f: |f_h| <= |f| (1 + error).
  const double most = std::max(candidate.sum, off.largest * left);
  candidate.promised = most * (1.0 + most);
  candidate.within = candidate.promised <= options_.within;
  return true;
}

bool Adviser::judge(Candidate& candidate) {
  if (!estimate(candidate)) return false;
  return candidate.sum > options_.within || verify(candidate);
}

double Adviser::expected_work(const Setting& from, const Setting& to) const {
  double factor = 1.0;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    factor *= axes_[k].size(from[k]) / axes_[k].size(to[k]);
  }
  return factor;
}

TriedSetting Adviser::tried(const Setting& setting) {
  const Outcome& of = outcome(setting);
  TriedSetting one{setting, 0.0, {}, of.work, of.seconds};
  if (!finest_) return one;
  bool is_as_fine = true;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    is_as_fine = is_as_fine && axes_[k].size(setting[k]) <= axes_[k].size((*finest_)[k]);
  }
  if (is_as_fine) {
    one.error = std::numeric_limits<double>::infinity();
    one.reason = "it is as fine as the run that verifies";
  } else {
    const Deviation off = deviation(of, outcome(*finest_), probes_.watched);
    one.error = off.largest;
    one.reason = off.reason;
  }
  return one;
}

void Adviser::fill(const Candidate& best, Advice& advice) {
  advice.setting = best.setting;
  for (const AxisError& e : best.errors) advice.budget.push_back({e.error, e.order, e.seen});
  advice.promised = best.promised;
  advice.verified = best.verified;
  advice.worst = best.worst;
  advice.reason = best.reason;
  if (const auto found = outcomes_.find(best.setting); found != outcomes_.end()) {
    advice.work = found->second.work;
    advice.seconds = found->second.seconds;
  }
  for (const auto& [setting, of] : outcomes_) {
    advice.total_work += of.work;
    advice.total_seconds += of.seconds;
    if (!finest_ || of.work >= advice.work || !usable(of.status)) continue;
    const TriedSetting one = tried(setting);
    const bool dearer = !advice.next_cheaper || one.work > advice.next_cheaper->work;
    if (one.error > options_.within && dearer) advice.next_cheaper = one;
  }
}

double Adviser::foreseen_work(const std::vector<Setting>& settings) const {
  double work = 0.0;
  for (const Setting& setting : settings) {
    double least = outcomes_.empty() ? 0.0 : std::numeric_limits<double>::infinity();
    for (const auto& [ran, of] : outcomes_) {
      least = std::min(least, static_cast<double>(of.work) * expected_work(ran, setting));
    }
    work += least;
  }
  return work;
}

bool Adviser::diverges(const Candidate& candidate) {
  if (candidate.sum < 0.9 * least_sum_) {
    least_sum_ = candidate.sum;
    since_least_ = 0;
    return false;
  }
  return ++since_least_ >= kPatience;
}

Advice Adviser::run() {
  Advice advice;
  advice.axes = axes_;
  advice.left_out = probes_.left_out;
  seen_.resize(axes_.size());
  const Setting own = own_setting(setup_, axes_);
  Candidate now{.setting = coarsest()};
  std::optional<Candidate> best;
  // The scene's own setting says whether it runs at all.
  bool runs_left = run_all({own});
  if (runs_left && outcome(own).status == Status::Rejected) {
    check_scene(setup_.scene, setup_.solver);  // throws what is wrong, with its place
    throw InputError({}, "scene", "", outcome(own).reason);
  }
  while (runs_left && judge(now)) {
    if (now.within && (!best || expected_work(best->setting, now.setting) < 1.0)) best = now;
    if (!now.within && now.sum <= options_.within) {
      // The axes together do more than each by itself: their errors must be smaller by that.
      share_ *= std::clamp(options_.within / now.promised, 0.25, 0.9);
    }
    Candidate next{
        .setting = taken_setting(
            setup_, axes_, next_setting(axes_, now.setting, now.errors, share_ * options_.within))};
    if (next.setting == now.setting) next.setting = finer_in_all(now.setting);
    if (best && expected_work(best->setting, next.setting) > kWorthTrying) break;
    if (!best && diverges(now)) {
      end_ = AdviceEnd::Diverging;
      break;
    }
    if (next.setting == now.setting) break;
    now = std::move(next);
  }
  if (best) {
    advice.end = AdviceEnd::Found;
    fill(*best, advice);
  } else {
    advice.end = end_;
    fill(now, advice);
  }
  if (outcomes_.count(own) > 0) advice.own = tried(own);
  advice.runs = runs_;
  return advice;
}

}  // namespace

Advice advise(const Setup& setup, const AdviceOptions& options) {
  return Adviser(setup, options).run();
}

}  // namespace plastica::sweeps
