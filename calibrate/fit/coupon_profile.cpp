#include <algorithm>
#include <cmath>

#include "calibrate/fit/coupon_intervals.hpp"
#include "calibrate/fit/not_a_number.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

/// The profile of one free parameter.
class Profiler {
 public:
  Profiler(CouponProblem& problem, const CouponProblem::Free& free, double confidence)
      : problem_(problem),
        free_(free),
        confidence_(confidence),
        factor_(theory::student_t_quantile(0.5 + 0.5 * confidence, problem.degrees_of_freedom())) {
    profile_.threshold = factor_ * factor_;
    profile_.low = profile_.high = kNan;
  }

  LikelihoodProfile run() {
    if (!free_.is_break && !free_.coordinate) return profile_;  // idle
    set_best();
    if (free_.is_break && !moves_) {
      // Its sampling alone.
      for (const bool up : {false, true}) set_end(best_.value, up, ProfileEnd::Crossed);
      return profile_;
    }
    ProfileOptions how;
    how.rise = factor_ * factor_ * ratio_;
    const ProfileSide low = side(false, how), high = side(true, how);
    set_end(low.end, false, low.why);
    set_end(high.end, true, high.why);
    for (const ProfilePoint& point : low.points) add(point);
    add({best_.value, best_.cost, best_.x});
    for (const ProfilePoint& point : high.points) add(point);
    return std::move(profile_);
  }

 private:
  void set_best() {
    best_.x = problem_.solution();
    best_.cost = problem_.cost();
    best_.value = free_.is_break ? problem_.limit() : best_.x[*free_.coordinate];
    std::vector<double> gradient(best_.x.size(), 0.0);
    if (free_.is_break) {
      gradient = problem_.limit_slope();
    } else {
      gradient[*free_.coordinate] = 1.0;
    }
    moves_ = std::ranges::any_of(gradient, [](double g) { return g != 0.0; });
    if (auto moments = problem_.moments(gradient)) {
      ratio_ = moments->squared_error / moments->inverse;
      best_.step = factor_ * std::sqrt(moments->squared_error);
      best_.along = std::move(moments->along);
      return;
    }
    // Not determined: without a scale of its own.
    constexpr double kShare = 0.02;
    best_.step = kShare * std::abs(best_.value);
    if (free_.coordinate) {
      const LeastSquaresProblem& squares = problem_.squares();
      best_.step = kShare * (squares.upper[*free_.coordinate] - squares.lower[*free_.coordinate]);
    }
  }

  ProfileSide side(bool up, const ProfileOptions& how) {
    if (free_.is_break) return profile_function(problem_.with_limit(), best_, up, how);
    return profile_coordinate(problem_.squares(), best_, *free_.coordinate, up, how);
  }

  void set_end(double end, bool up, ProfileEnd why) {
    double to = end;
    if (free_.is_break) {
      const double half = problem_.limit_half();
      const double reach = theory::half_interval(confidence_, std::abs(end - best_.value) / factor_,
                                                 problem_.degrees_of_freedom(), {&half, 1});
      const double open = best_.value + (up ? reach : -reach);
      to = std::clamp(open, free_.fitted->lower, free_.fitted->upper);
      if (to != open) why = ProfileEnd::Bound;
    } else {
      // The bound itself, where coordinates have rounded it.
      const FittedParameter& p = *free_.fitted;
      to = why == ProfileEnd::Bound ? (up ? p.upper : p.lower)
                                    : problem_.value(*free_.coordinate, end);
    }
    (up ? profile_.high : profile_.low) = to;
    (up ? profile_.high_end : profile_.low_end) = why;
  }

  void add(const ProfilePoint& point) {
    profile_.value.push_back(free_.is_break ? point.value
                                            : problem_.value(*free_.coordinate, point.value));
    profile_.rise.push_back((point.cost - best_.cost) / ratio_);
    for (std::size_t i = 0; i < point.x.size(); ++i) {
      profile_.searched.push_back(problem_.value(i, point.x[i]));
    }
  }

  CouponProblem& problem_;
  const CouponProblem::Free& free_;
  double confidence_;
  double factor_;
  double ratio_ = 1.0;  ///< squared error over that of the squares' curvature
  bool moves_ = true;
  ProfileStart best_;
  LikelihoodProfile profile_;
};

}  // namespace

std::vector<LikelihoodProfile> profile_coupon(CouponProblem& problem, double confidence) {
  std::vector<LikelihoodProfile> profiles;
  for (const CouponProblem::Free& free : problem.free()) {
    profiles.push_back(Profiler(problem, free, confidence).run());
  }
  return profiles;
}

}  // namespace plastica::calibrate
