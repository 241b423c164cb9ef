#pragma once

#include <string_view>

namespace plastica {

/// How a simulation ended. A numerical outcome is a status in the response, never an exception.
enum class Status {
  NotRun,            ///< `run` has not been called on this response
  Completed,         ///< went to the end of the drive or path; the response is complete
  Broken,            ///< the beam broke on the way (see the break event); a coupon went to the end
  Rejected,          ///< the scene is bad input; nothing was computed, the reason is in the row
  InvalidParameter,  ///< a parameter is outside of its field's range, or two contradict each other
                     ///< (tangent modulus not below E, Q not above -yield); nothing was computed
  NonFinite,         ///< a number overflowed or became NaN; the response ends before that sample
  LimitLoad,         ///< it gives way beyond (see `Response::limit`); valid up to there
  Mechanism,         ///< the supports leave the beam free to move; nothing was computed
  HeldTwice,         ///< a support holds a motion that is held already; nothing was computed
  Interrupted,       ///< stopped from outside (see `Workspace`); valid up to there
  NotConverged,      ///< no equilibrium was found, nor shown to be none; valid up to there
  Unstable,          ///< went to the end over equilibria that are not stable, which a beam would
                     ///< leave at the least push (see `Response::critical`)
  NotBalanced,       ///< a motion went to its end, but its energy or momentum is off by more than
                ///< 1 % (`Response::energy_balance_error`, `momentum_error`): complete, not to be
                ///< trusted
};

/// One word for tables and files: "completed", "broken", …
std::string_view name_of(Status status);

/// Whether the response may be used.
constexpr bool usable(Status status) {
  return status == Status::Completed || status == Status::Broken || status == Status::LimitLoad;
}

/// Whether a run went to its end, so that all of its samples are there: those of `NotBalanced`,
/// too.
constexpr bool is_complete(Status status) {
  return usable(status) || status == Status::NotBalanced;
}

/// What to change when a run ended this way; empty where nothing needs to change.
/// @param in_motion  whether the run was one in time, and not a path of equilibria or a coupon
std::string_view advice(Status status, bool in_motion);

}  // namespace plastica
