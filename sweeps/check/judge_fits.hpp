#pragma once

#include "sweeps/check/fit_subject.hpp"
#include "sweeps/check/verdict.hpp"

namespace plastica::sweeps {

/// Judges a claim on fits. A fit that failed, or that is of no use, has no number: such a claim
/// does not hold, but one on how many there are. Nor has a parameter that is fixed, that the curves
/// do not identify, or that ended at a bound other than 0.
ClaimVerdict judge(const Claim& claim, const FittedRecords& fits);

}  // namespace plastica::sweeps
