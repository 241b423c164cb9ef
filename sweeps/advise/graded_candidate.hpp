#pragma once

#include <optional>

#include "sweeps/advise/fill_advice.hpp"

/// Graded segments in the place of even ones; not installed.
namespace plastica::sweeps {

/// Tries fewer, graded segments in the place of a candidate's even ones: as many of them first, for
/// how far they are off the run that verified it; then as many as these are expected to need,
/// beside a run with each divided into two. What is promised is as of any other candidate, the
/// error along the segments being what the two differ by and leave, by the order that even ones
/// have shown.
/// @param even    within the error, and verified
/// @param within  the error that is allowed [1]
/// @return a candidate that costs less than 0.8 of the even one and is within; empty: there is
/// none,
///         runs are used up, or the beam breaks (where it does goes with the joints)
std::optional<Candidate> with_graded_segments(AdviceRuns& runs, const Candidate& even,
                                              double within);

}  // namespace plastica::sweeps
