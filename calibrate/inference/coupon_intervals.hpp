#pragma once

#include <cstdint>
#include <vector>

#include "calibrate/inference/coupon_problem.hpp"
#include "calibrate/inference/intervals.hpp"

/// The parts of fit_intervals.hpp; not installed.
namespace plastica::calibrate {

/// @return one of each free parameter
std::vector<LikelihoodProfile> profile_coupon(CouponProblem& problem, double confidence);

/// @param options  with a block of no more than the samples
BootstrapResult bootstrap_coupon(CouponProblem& problem, const FitOptions& options,
                                 std::uint64_t seed);

}  // namespace plastica::calibrate
