#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/model/field.hpp"
#include "plastica/run/response.hpp"

namespace plastica::sweeps::stability {

/// Whether a run's result can be relied on.
enum class Validity {
  Valid,       ///< energy is balanced, every audit passes and every reference is met
  Inaccurate,  ///< off, and the run says so: see `judge`
  Failed,      ///< refused as input, or ended with a status that says that it is not usable
  Undetected,  ///< off, and nothing says so: a defect
};

/// The words of files for the classes, in their order.
inline constexpr std::array<std::string_view, 4> kValidity{"valid", "inaccurate", "failed",
                                                           "undetected"};

struct Verdict {
  Validity validity = Validity::Valid;
  std::string reason{};  ///< one line; empty for a valid run
};

/// A number that a run must give.
struct Reference {
  std::string what;                   ///< "tip deflection"
  std::size_t probe = 0;              ///< of the scene
  std::size_t sample = kLast;         ///< of the response
  double value = 0.0;                 ///< of the chain of N segments with its steps
  double size = 0.0;                  ///< what a miss is compared with; 0: the value's own
  double tolerance = 0.01;            ///< largest miss of `value` over `size` [1]
  std::optional<double> continuum{};  ///< of the beam that the chain stands for

  static constexpr std::size_t kLast = static_cast<std::size_t>(-1);
};

/// A number that a motion must keep.
struct Kept {
  std::string what;  ///< "angular momentum"
  std::size_t probe = 0;
  double size = 0.0;       ///< what a change is compared with, in the probe's unit
  double tolerance = 0.0;  ///< largest change from the first sample over `size` [1]
};

/// What is known of a scene's result beforehand.
struct Expectation {
  std::vector<Reference> references{};
  std::vector<Kept> kept{};
  /// Load factor beyond which there is no equilibrium [1]; met within 1 %.
  std::optional<double> limit{};
  /// Whether an elastic beam may lose its equilibrium: its loads are not conservative, or it snaps.
  bool may_reverse = false;
  bool breaks = false;  ///< whether the run must end broken
  /// Whether the equilibrium that an even path leads to is unstable, so that the run must not pass
  /// it off as completed.
  bool unstable = false;
};

/// What a reference may be missed by against the continuum, and what of the energy a scheme may
/// dissipate, for the run to be valid [1].
inline constexpr double kAccurate = 0.01;

/// Judges a run against what is known of it.
///
/// - Failed: the status is not usable (`plastica::usable`): the run has said so.
/// - Undetected: the status is usable and yet a number is not finite; the recorded beam is no chain
///   of rigid segments, is out of balance (statics) or has a joint beyond its cap (`audit`); the
///   scheme made energy, or a kept quantity or a reference of the chain is missed, and neither the
///   energy balance nor a warning says so.
/// - Inaccurate: energy is not balanced (`kBalanceTolerance`), or the scheme dissipated more than
///   `kAccurate` of the energy, which the energy balance states; or a reference of the chain is
///   missed and a warning of `scene_warnings` names the steps; or the chain's reference is met and
///   the continuum's is not, by more than `kAccurate`: the price of few segments.
/// - Valid: none of these.
/// @param setup  what was run; its probes are those that the expectation numbers
Verdict judge(const Setup& setup, const Response& response, const Expectation& expected);

}  // namespace plastica::sweeps::stability
