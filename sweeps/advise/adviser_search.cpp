#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sweeps/advise/adviser.hpp"
#include "sweeps/advise/next_setting.hpp"

/// From one candidate to the next.
namespace plastica::sweeps {
namespace {

/// What of the allowed error the estimates may take: the rest is for what they do not see.
constexpr double kShare = 0.75;
/// So many settings may be no better than the best before.
constexpr int kPatience = 5;
/// A cheaper setting is tried if it is expected to cost less than this part.
constexpr double kWorthTrying = 0.7;

}  // namespace

Trial Adviser::next_of(const Candidate& candidate) {
  if (candidate.rests) {
    for (std::size_t k = 0; k < runs_.axes().size(); ++k) models_.forget(k);
    return runs_.scaled(candidate.trial, std::vector<double>(runs_.axes().size(), kRefined));
  }
  const double allowed = within_ - (words_.decided() ? words_.error() : 0.0);
  const bool summed = candidate.numbers + words_.error() <= within_;
  if (!candidate.within && summed && words_.decided()) {
    // The axes together do more than each by itself: their errors must be smaller by that.
    share_ *= std::clamp(within_ / candidate.promised, 0.25, 0.9);
  }
  // Without an order that was seen, planned with that which the method has.
  std::vector<AxisError> planned = candidate.errors;
  for (std::size_t k = 0; k < planned.size(); ++k) {
    AxisError& e = planned[k];
    if (e.seen || !std::isfinite(e.change)) continue;
    e.order = supposed_order(k, candidate.trial);
    e.error = left_of(e.change, e.ratio, e.order);
  }
  Trial next = candidate.trial;
  next.setting = next_setting(runs_.axes(), candidate.trial.setting, planned,
                              share_ * std::max(allowed, 0.1 * within_));
  next = runs_.with_ends_at_probes(runs_.taken(std::move(next)));
  return next == candidate.trial
             ? runs_.scaled(candidate.trial, factors_in_all(candidate, kRefined))
             : next;
}

bool Adviser::diverges(const Candidate& candidate) {
  if (candidate.numbers < 0.9 * least_sum_) {
    least_sum_ = candidate.numbers;
    since_least_ = 0;
    return false;
  }
  return ++since_least_ >= kPatience;
}

bool Adviser::try_own_methods() {
  const Trial other = words_.with_own_methods(now_.trial);
  if (other == now_.trial) return false;
  for (std::size_t k = 0; k < runs_.axes().size(); ++k) models_.forget(k);
  models_.doubt();
  words_.doubt();
  least_sum_ = std::numeric_limits<double>::infinity();
  since_least_ = 0;
  now_ = {.trial = other, .worst = now_.worst};
  return true;
}

void Adviser::begin(double within, const Trial& trial) {
  within_ = within;
  best_.reset();
  end_ = AdviceEnd::AtFinest;
  share_ = kShare;
  decisions_ = since_least_ = 0;
  least_sum_ = std::numeric_limits<double>::infinity();
  words_.doubt();
  now_ = {.trial = trial};
}

void Adviser::look_at(double within, const Trial& trial) {
  begin(within, trial);
  alone_ = true;
  const bool judged = judge(now_);
  alone_ = false;
  if (judged && now_.within) best_ = now_;
  if (!judged && end_ == AdviceEnd::AtFinest) end_ = runs_.end();
}

void Adviser::search(double within, const std::optional<Trial>& start) {
  begin(within, start ? *start : coarsest());
  if (!words_.let_move(now_.trial)) {
    end_ = runs_.end();
    return;
  }
  while (judge(now_)) {
    const bool cheaper = !best_ || runs_.cost(now_.trial) < runs_.cost(best_->trial);
    if (now_.within && cheaper) best_ = now_;
    if (!best_ && diverges(now_)) {
      if (try_own_methods()) continue;
      end_ = AdviceEnd::Diverging;
      return;
    }
    const Trial next = next_of(now_);
    if (best_ &&
        runs_.cost(now_.trial) / runs_.cost(best_->trial) * runs_.expected_cost(now_.trial, next) >
            kWorthTrying) {
      return;
    }
    if (next == now_.trial) return;
    now_ = {.trial = next, .worst = now_.worst};
  }
  if (end_ == AdviceEnd::AtFinest) end_ = runs_.end();
}

}  // namespace plastica::sweeps
