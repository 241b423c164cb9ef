#include <utility>

#include "calibrate/inference/coupon_intervals.hpp"
#include "calibrate/inference/not_a_number.hpp"
#include "calibrate/inference/parameter_profile.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

ProfiledParameter profiled(const CouponProblem& problem, const CouponProblem::Free& free) {
  ProfiledParameter p;
  p.lower = free.fitted->lower;
  p.upper = free.fitted->upper;
  p.is_break = free.is_break;
  p.gradient.assign(problem.solution().size(), 0.0);
  if (free.is_break) {
    p.limit = problem.limit();
    p.halves = {problem.limit_half()};
    p.gradient = problem.limit_slope();
  } else {
    p.coordinate = *free.coordinate;
    p.gradient[p.coordinate] = 1.0;
  }
  p.squared_error = p.inverse = kNan;
  if (auto moments = problem.moments(p.gradient)) {
    p.squared_error = moments->squared_error;
    p.inverse = moments->inverse;
    p.along = std::move(moments->along);
  }
  p.degrees_of_freedom = free.degrees_of_freedom;
  p.value_of = [&problem](std::size_t i, double at) { return problem.value(i, at); };
  return p;
}

}  // namespace

std::vector<LikelihoodProfile> profile_coupon(CouponProblem& problem, double confidence) {
  std::vector<LikelihoodProfile> profiles;
  for (const CouponProblem::Free& free : problem.free()) {
    if (!free.is_break && !free.coordinate) {  // idle
      LikelihoodProfile none;
      const double factor =
          theory::student_t_quantile(0.5 + 0.5 * confidence, free.degrees_of_freedom);
      none.threshold = factor * factor;
      none.low = none.high = kNan;
      profiles.push_back(std::move(none));
      continue;
    }
    const ParameterProfile profile(profiled(problem, free), problem.squares(), problem.solution(),
                                   problem.cost(), confidence);
    if (!profile.depends()) {
      profiles.push_back(profile.unmoved());
      continue;
    }
    const LeastSquaresProblem squares = free.is_break ? problem.with_limit() : problem.squares();
    profiles.push_back(profile.profile(profile.side(squares, false), profile.side(squares, true)));
  }
  return profiles;
}

}  // namespace plastica::calibrate
