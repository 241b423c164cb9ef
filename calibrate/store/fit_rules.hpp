#pragma once

#include <array>
#include <string_view>

#include "plastica/io/value_rule.hpp"

/// What files of fits, of curves or through scenes, must hold beyond types and shapes: the numbers
/// that are not just finite, or not negative; not installed. What is optional may be missing (NaN)
/// anyway.
namespace plastica::calibrate::store {

inline constexpr Range kBelowOne{0.0, 1.0, true, true};

/// A standard error, or degrees of freedom: not known, not negative, or beyond all bounds.
constexpr io::ValueRule unsigned_or_none(std::string_view path) {
  return {path, io::kNotNegative, io::Order::Any, true, true};
}

inline constexpr std::array kFitRules{
    io::anything("fits/seed"),
    io::may_lack("fits/misfit_fraction"),
    io::may_lack("fits/runs_test_p"),
    io::may_lack("fits/autocorrelation"),
    io::anything("fits/effective_samples"),
    io::may_lack("correlation/values"),
    io::anything("curves/raw/strain"),
    io::anything("curves/raw/stress"),
    io::anything("evaluations/cost"),
    io::may_lack("evaluations/values"),
    io::may_lack("properties/value"),
    io::may_lack("corrections/amount"),
    io::anything("stages/cost"),
    // Through scenes.
    unsigned_or_none("fits/degrees_of_freedom"),
    io::ValueRule{"targets/break_half_interval", io::kNotNegative},
    io::ValueRule{"targets/weight", io::kNotNegative},
    io::anything("targets/cost"),
    io::anything("targets/noise"),
    unsigned_or_none("targets/degrees_of_freedom"),
    io::may_lack("targets/misfit_fraction"),
    io::may_lack("targets/runs_test_p"),
    io::may_lack("targets/break_strain"),
    io::may_lack("segments/at_half"),
    io::may_lack("segments/at_own"),
    io::may_lack("segments/at_twice"),
    io::anything("segments/observed_order"),
    io::anything("segments/order"),
    io::anything("segments/safety_factor"),
    io::may_lack("segments/extrapolated"),
    io::anything("segments/extrapolated_error"),
    io::anything("segments/error"),
    io::may_lack("curves/fitted"),
    io::may_lack("curves/fitted_error"),
    io::ValueRule{"starts/cost", io::kNotNegative, io::Order::Any, true, true},
    io::may_lack("starts/to/values"),
    // Parameters: a table each, or, through scenes, one of all until version 4.
    io::anything("parameters/*/lower"),
    io::anything("parameters/*/upper"),
    unsigned_or_none("parameters/*/standard_error"),
    unsigned_or_none("parameters/*/noise_error"),
    unsigned_or_none("parameters/*/sampling_error"),
    unsigned_or_none("parameters/*/misfit_error"),
    unsigned_or_none("parameters/*/degrees_of_freedom"),
    io::anything("parameters/*/interval_low"),
    io::anything("parameters/*/interval_high"),
    io::anything("parameters/*/verdict_number"),
    io::anything("parameters/lower"),
    io::anything("parameters/upper"),
    unsigned_or_none("parameters/standard_error"),
    unsigned_or_none("parameters/noise_error"),
    unsigned_or_none("parameters/sampling_error"),
    unsigned_or_none("parameters/misfit_error"),
    io::anything("parameters/interval_low"),
    io::anything("parameters/interval_high"),
    unsigned_or_none("parameters/degrees_of_freedom"),
    io::anything("parameters/verdict_number"),
    // Profiles and bootstraps.
    io::anything("profiles/low"),
    io::anything("profiles/high"),
    io::may_lack("profiles/threshold"),
    io::anything("profiles/rise/values"),
    io::may_lack("profiles/searched/values"),
    io::may_lack("bootstraps/values/values"),
    io::anything("bootstraps/standard_error/values"),
    io::anything("bootstraps/low/values"),
    io::anything("bootstraps/high/values"),
    // Options and meta.
    io::ValueRule{"options/noise", io::kAboveZero, io::Order::Any, true},
    io::ValueRule{"options/weights/from", io::kNotNegative, io::Order::RisesStrictly},
    io::ValueRule{"options/weights/weight", io::kNotNegative},
    io::ValueRule{"options/break_weight", io::kNotNegative},
    io::ValueRule{"options/parameter_tolerance", io::kNotNegative},
    io::ValueRule{"options/cost_tolerance", io::kNotNegative},
    io::ValueRule{"options/confidence", kBelowOne},
    io::anything("options/seed"),
    io::ValueRule{"meta/fit_seconds", io::kNotNegative, io::Order::Any, true},
};

}  // namespace plastica::calibrate::store
