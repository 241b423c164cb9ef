#include "sweeps/advise/for_engine/engine_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sweeps/advise/advice_text.hpp"

namespace plastica::sweeps {
namespace {

constexpr int kFirstSegments = 8;
/// From one number of segments that is tried to the next.
constexpr double kSegmentRatio = 1.25;
/// Steps are bracketed this closely before the number of segments is settled, then both this
/// closely, or to one.
constexpr double kStepRatio = 1.2;
constexpr double kFineRatio = 1.02;
/// Numbers of segments in a row that are no cheaper, after which no others are tried.
constexpr int kFailures = 2;
/// By how much a step that is advised is shorter than one that blows up.
constexpr double kStepMargin = 1.1;
/// How often steps are halved once more if twice as many segments are not stable. Explicit dampers
/// of a scene need sixteen times as many steps, four of which an explicit rule has anyway: two
/// halvings more, and two from a step that does not blow up to one that shows what segments do.
constexpr int kMoreSteps = 4;
/// Half a step takes this part of the error away only if that was no error of a step's size. The
/// rules are of first order: it would be half. Even where an error of segments cancels part of it,
/// a setting that is within with half the step, too, does not come to a quarter so.
constexpr double kStableFall = 4.0;
/// Nor does half a step move a stable run by more than the size of what is watched [1].
constexpr double kStableMove = 1.0;
/// Doubling both moves the result by less than this part of what is too much: it has come to its
/// limit.
constexpr double kOfGap = 0.1;

std::vector<int> segment_numbers(int fewest, int most) {
  std::vector<int> numbers{fewest};
  while (numbers.back() < most) {
    const int next = static_cast<int>(std::ceil(kSegmentRatio * numbers.back()));
    numbers.push_back(std::min(next, most));
  }
  return numbers;
}

}  // namespace

EngineSearch::EngineSearch(EngineRuns& runs, const Outcome& reference,
                           const std::vector<WatchedProbe>& watched, double allowed)
    : runs_(runs), reference_(reference), watched_(watched), allowed_(allowed) {}

Deviation EngineSearch::off(const EngineSetting& setting) {
  return deviation(runs_.run(setting), reference_, watched_, "our own");
}

double EngineSearch::change(const EngineSetting& from, const EngineSetting& to) {
  if (from == to) return 0.0;
  return deviation(runs_.run(from), runs_.run(to), watched_).largest;
}

EngineVerdict EngineSearch::judge(const EngineSetting& setting) {
  last_ = setting;
  EngineVerdict verdict;
  verdict.off = off(setting);
  if (verdict.off.largest > allowed_) {
    verdict.reason = verdict.off.reason;
    return verdict;
  }
  // The rule takes more segments than the engine's file may have.
  const EngineSetting segments = with_twice_segments(setting);
  EngineSetting steps = setting;
  steps.steps *= 2;
  verdict.by_segments = change(setting, segments);
  verdict.by_steps = change(setting, steps);
  const double off_segments = off(segments).largest;
  const double off_steps = off(steps).largest;
  verdict.within = std::max(off_segments, off_steps) <= allowed_;
  if (verdict.within) {
    verdict.reason = near_blow_up(setting, verdict.by_steps);
    verdict.within = verdict.reason.empty();
  } else {
    verdict.reason =
        off_segments > allowed_
            ? fmt::format("with twice as many segments it is {} off", error_percent(off_segments))
            : fmt::format("with half the step it is {} off", error_percent(off_steps));
  }
  return verdict;
}

bool EngineSearch::is_within(const EngineSetting& setting) { return judge(setting).within; }

bool EngineSearch::blows_up(const EngineSetting& setting) {
  const Status status = runs_.run(setting).status;
  // Finite numbers may be too large for their squares.
  return status == Status::NonFinite || (usable(status) && !std::isfinite(off(setting).largest));
}

bool EngineSearch::is_unstable(const EngineSetting& setting) {
  if (blows_up(setting)) return true;
  const double error = off(setting).largest;
  if (!runs_.has_longest_step() || error <= allowed_) return false;
  EngineSetting half = setting;
  half.steps = std::min(2 * half.steps, runs_.most_steps());
  if (half == setting) return false;
  if (blows_up(half)) return true;
  const double moved = change(setting, half);
  return kStableFall * off(half).largest < error || (std::isfinite(moved) && moved > kStableMove);
}

std::string EngineSearch::near_blow_up(const EngineSetting& setting, double by_steps) {
  EngineSetting longer = setting;
  longer.steps = static_cast<int>(setting.steps / kStepMargin);
  if (longer.steps < 1) return {};
  if (blows_up(longer)) return "with a step that is little longer it blows up";
  // Of first or second order it would be four times what half the step changes at most, where the
  // longer one is twice as long for want of whole numbers between.
  const double changed = change(setting, longer);
  if (!std::isfinite(changed) || changed <= allowed_ + 4.0 * by_steps) return {};
  return fmt::format("with a step that is little longer it is {} off, about to blow up",
                     error_percent(off(longer).largest));
}

EngineSetting EngineSearch::with_twice_segments(const EngineSetting& setting) {
  EngineSetting twice = runs_.with_twice_segments(setting);
  for (int i = 0; i < kMoreSteps && is_unstable(twice); ++i) twice.steps *= 2;
  return twice;
}

bool EngineSearch::find_first(EngineDamping damping) {
  EngineSetting at{damping, std::max(kFirstSegments, runs_.fewest_segments()), 1};
  at.segments = std::min(at.segments, runs_.most_segments());
  int at_limit = 0;
  while (!runs_.end()) {
    if (best_ && runs_.work(at) >= runs_.work(*best_)) return false;
    const EngineVerdict verdict = judge(at);
    if (verdict.within) {
      best_ = at;
      return true;
    }
    EngineSetting steps = at;
    steps.steps = std::min(2 * at.steps, runs_.most_steps());
    // Of what it shows nothing is due to its segments.
    if (is_unstable(at)) {
      if (steps == at) return false;
      at = steps;
      continue;
    }
    EngineSetting segments = at.segments == runs_.most_segments() ? at : with_twice_segments(at);
    segments.segments = std::min(segments.segments, runs_.most_segments());
    segments.steps = std::min(segments.steps, runs_.most_steps());
    if (segments == at && steps == at) return false;
    const double by_segments = change(at, segments);
    const double by_steps = change(at, steps);
    const double gap = verdict.off.largest - allowed_;
    at_limit = by_segments + by_steps < kOfGap * gap ? at_limit + 1 : 0;
    if (at_limit >= 2) return false;
    const bool refine_segments = segments != at && !(2.0 * by_segments < by_steps);
    const bool refine_steps = steps != at && !(2.0 * by_steps < by_segments && segments != at);
    const int times = refine_steps || !refine_segments ? 2 : 1;
    if (refine_segments) at = segments;
    at.steps = std::min(times * at.steps, runs_.most_steps());
  }
  return false;
}

void EngineSearch::reduce(EngineSetting setting, int EngineSetting::*number, int few,
                          double ratio) {
  best_ = setting;
  while (setting.*number > few + 1 && setting.*number > ratio * few && !runs_.end()) {
    EngineSetting middle = setting;
    const double mean = std::sqrt(static_cast<double>(std::max(few, 1)) * setting.*number);
    middle.*number = std::clamp(static_cast<int>(std::lround(mean)), few + 1, setting.*number - 1);
    if (is_within(middle)) {
      setting = middle;
      best_ = setting;
    } else {
      few = middle.*number;
    }
  }
}

bool EngineSearch::try_segments(int segments) {
  const double most = static_cast<double>(best_->segments) * best_->steps / segments;
  const EngineSetting setting{best_->damping, segments, static_cast<int>(std::ceil(most)) - 1};
  if (setting.steps < 1 || !is_within(setting)) return false;
  reduce(setting, &EngineSetting::steps, 0, kStepRatio);
  return true;
}

void EngineSearch::try_other_segments() {
  const int first = best_->segments;
  std::vector<int> fewer;
  std::vector<int> more;
  for (const int n : segment_numbers(runs_.fewest_segments(), runs_.most_segments())) {
    if (n < first) fewer.insert(fewer.begin(), n);
    if (n > first) more.push_back(n);
  }
  for (const std::vector<int>& numbers : {fewer, more}) {
    int failed = 0;
    for (const int segments : numbers) {
      if (runs_.end() || failed == kFailures) break;
      failed = try_segments(segments) ? 0 : failed + 1;
    }
  }
}

void EngineSearch::polish() {
  for (bool better = true; better && !runs_.end();) {
    better = false;
    for (int EngineSetting::*const number : {&EngineSetting::steps, &EngineSetting::segments}) {
      const int fewest = number == &EngineSetting::steps ? 1 : runs_.fewest_segments();
      EngineSetting less = *best_;
      less.*number -= std::max(1, static_cast<int>((kFineRatio - 1.0) * less.*number));
      if (less.*number < fewest || !is_within(less)) continue;
      const int far = static_cast<int>(less.*number / kSegmentRatio);
      reduce(less, number, std::max(far, fewest - 1), kFineRatio);
      better = true;
    }
  }
}

void EngineSearch::search(EngineDamping damping) {
  if (!find_first(damping)) return;
  reduce(*best_, &EngineSetting::steps, 0, kStepRatio);
  try_other_segments();
  polish();
}

}  // namespace plastica::sweeps
