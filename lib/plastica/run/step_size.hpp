#pragma once

#include <algorithm>
#include <cmath>

#include "plastica/solve/motion_options.hpp"
#include "plastica/solve/scheme.hpp"

namespace plastica {

/// How long the next step is, on the way from one stop to the next.
///
/// Fixed steps divide the interval evenly, by no more than the time step; one that fails is halved,
/// and its successors grow back. Adaptive steps follow h (tolerance/error)^(1/(order + 1)), by a
/// factor of 0.2 … 2 at a time, with 0.9 for safety (Hairer & Wanner, Solving Ordinary Differential
/// Equations I, II.4).
class StepSize {
 public:
  explicit StepSize(const solve::MotionOptions& options)
      : options_(options), adapted_(options.time_step) {}

  /// Adaptive steps go on as long as they were before.
  void begin(double from, double stop) {
    const double parts = std::ceil((stop - from) / options_.time_step - 1e-9);
    stop_ = stop;
    even_ = (stop - from) / std::max(parts, 1.0);
    step_ = adapts() ? std::min(adapted_, even_) : even_;
  }

  bool done(double time) const { return time >= stop_; }

  /// @return the next step, which ends at the stop if nearly there
  double next(double time) {
    const double left = stop_ - time;
    now_ = std::min(step_, left);
    // No crumbs: what is left after the step is nothing or at least half of it.
    if (left - now_ < 1e-9 * now_) {
      now_ = left;
    } else if (left - now_ < 0.5 * now_) {
      now_ = 0.5 * left;
    }
    return now_;
  }

  /// Adaptive steps: takes an error, over its tolerance's unit. @return whether the step may stay
  bool judge(double error) {
    const int order = solve::claims_of(options_.scheme, options_.rho_infinity).order;
    const double ratio = options_.step_error / std::max(error, 1e-300);
    factor_ = std::clamp(0.9 * std::pow(ratio, 1.0 / (order + 1)), 0.2, 2.0);
    return error <= options_.step_error;
  }

  /// After a failure. @return whether there is a shorter step
  bool cut() {
    if (now_ <= smallest()) return false;
    step_ = std::max(now_ * std::min(factor_, 0.5), smallest());
    factor_ = 1.0;
    return true;
  }

  void accepted() {
    if (adapts()) {
      // A step that a stop has shortened says little of what the next may be.
      adapted_ = now_ < step_ ? std::max(step_, now_ * factor_) : now_ * factor_;
      adapted_ = std::clamp(adapted_, smallest(), options_.time_step);
      step_ = std::min(adapted_, even_);
    } else {
      step_ = std::min(even_, std::max(step_, 2.0 * now_));
    }
    factor_ = 1.0;
  }

 private:
  bool adapts() const { return options_.step_error > 0.0; }
  double smallest() const { return options_.smallest_step * options_.time_step; }

  const solve::MotionOptions& options_;
  double stop_ = 0.0;
  double even_ = 0.0;  ///< the longest step in this interval
  double step_ = 0.0;
  double adapted_;  ///< of the last adaptive step that no stop has shortened
  double now_ = 0.0;
  double factor_ = 1.0;
};

}  // namespace plastica
