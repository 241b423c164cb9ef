#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweeps/advise/for_engine/engine_runs.hpp"
#include "sweeps/advise/outcome.hpp"

/// The search for the cheapest setting of an engine; not installed.
namespace plastica::sweeps {

/// What the runs about a setting say of it.
struct EngineVerdict {
  Deviation off{};           ///< from the reference
  double by_segments = 0.0;  ///< by how much twice as many segments move it [1]
  double by_steps = 0.0;     ///< and twice as many steps [1]
  bool within = false;       ///< it is, and so is it with twice as many of each
  std::string reason{};      ///< why it is not
};

/// Finds the fewest segment-steps within an error.
///
/// From a coarse setting segments and steps are doubled, whichever moves the result more, until it
/// is within the error of the reference. Then, for other numbers of segments, the nearest first,
/// the fewest steps are bracketed whose product is less. A setting counts as within only if it
/// stays there with twice as many segments, and with twice as many steps: else errors of both only
/// cancel. A step that is a tenth longer must not blow up, nor change the result as one does that
/// is about to, whatever its error: else a motion that lasts a little longer, or is a little
/// stiffer, may blow up.
class EngineSearch {
 public:
  /// @param allowed  error against the reference [1]
  EngineSearch(EngineRuns& runs, const Outcome& reference, const std::vector<WatchedProbe>& watched,
               double allowed);

  /// Searches with one damping, for less than the best so far. There is none if with this damping
  /// the limit of many segments and steps is off by more than is allowed.
  void search(EngineDamping damping);
  double allowed() const { return allowed_; }
  const std::optional<EngineSetting>& best() const { return best_; }
  /// The last one that was looked at.
  const EngineSetting& last() const { return last_; }
  /// Runs what it needs.
  EngineVerdict judge(const EngineSetting& setting);
  /// How far a setting that was run is off the reference.
  Deviation off(const EngineSetting& setting);

 private:
  double change(const EngineSetting& from, const EngineSetting& to);
  bool is_within(const EngineSetting& setting);
  bool blows_up(const EngineSetting& setting);
  /// Whether its step is too long for an explicit rule: it blows up; or it does not in the time
  /// that the scene lasts, but is off by more than is allowed, and half the step takes most of that
  /// away, or moves it by more than its size. What such a run is off says nothing of its segments.
  bool is_unstable(const EngineSetting& setting);
  /// Why a step that is a tenth longer does not do; empty: it does.
  /// @param by_steps  what half the step of the setting changes [1]
  std::string near_blow_up(const EngineSetting& setting, double by_steps);
  /// With twice as many segments, and steps that are short enough for them, so that they show what
  /// segments do: explicit springs need four times as many, explicit dampers sixteen, implicit ones
  /// no more; some more of them where the first that do not blow up are still unstable.
  EngineSetting with_twice_segments(const EngineSetting& setting);
  bool find_first(EngineDamping damping);
  /// Brackets the least of a number that does, the other as it is.
  /// @param setting  that does; it is the best now
  /// @param few      a number that does not, or that is not looked below
  /// @param ratio    of two numbers that bracket it closely enough, >= 1
  void reduce(EngineSetting setting, int EngineSetting::*number, int few, double ratio);
  /// Whether so many segments are cheaper than the best.
  bool try_segments(int segments);
  void try_other_segments();
  void polish();

  EngineRuns& runs_;
  const Outcome& reference_;
  const std::vector<WatchedProbe>& watched_;
  double allowed_ = 0.0;
  std::optional<EngineSetting> best_{};
  EngineSetting last_{};
};

}  // namespace plastica::sweeps
