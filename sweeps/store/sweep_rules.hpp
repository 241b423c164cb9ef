#pragma once

#include <array>

#include "plastica/io/value_rule.hpp"

/// What the file of a sweep must hold beyond types and shapes: the numbers that are not just
/// finite, or not negative; not installed. What is optional may be missing (NaN) anyway.
namespace plastica::sweeps {

inline constexpr std::array kSweepRules{
    io::may_lack("axes/*/values"),
    io::may_lack("cases/reference"),
    io::may_lack("cases/error"),
    io::anything("cases/energy_balance_error"),
    io::anything("cases/break_joint"),
    io::ValueRule{"cases/break_place", io::kFraction},
    io::ValueRule{"cases/reference_error", io::kNotNegative, io::Order::Any, true},
    io::ValueRule{"curves/time/values", io::kNotNegative},
    io::ValueRule{"groups/size/values", io::kAboveZero},
    io::ValueRule{"meta/case_seconds", io::kNotNegative},
};

/// Largest work of a case, segments times iterations: what is counted exactly as a real number.
inline constexpr std::int64_t kMaxWork = std::int64_t{1} << 53U;

}  // namespace plastica::sweeps
