#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"
#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/for_engine/advised_engine.hpp"
#include "sweeps/advise/for_engine/engine_setting.hpp"
#include "sweeps/advise/watched_probes.hpp"

/// Runs of a scene as an engine steps its exported beam; not installed.
namespace plastica::sweeps {

/// Every hinge of a joint moves.
inline constexpr std::array<bool, 3> kAllTurns{true, true, true};

/// What exceeds a limit of its runs is not run: its outcome has the status NotRun.
class EngineRuns {
 public:
  /// @param watched  probes that the engine has, which outlive this
  EngineRuns(const AdvisedEngine& engine, const Setup& setup,
             const std::vector<WatchedProbe>& watched, const AdviceOptions& options);

  /// The fewest segments that the scene's beam may have, and the most that the engine takes.
  int fewest_segments() const { return fewest_; }
  int most_segments() const { return engine_.most_segments; }
  /// The largest number of steps that advice looks at, of a sample.
  int most_steps() const { return 100'000; }
  /// A setting with twice as many segments, and as many steps as these need to be as stable.
  EngineSetting with_twice_segments(const EngineSetting& setting) const;
  /// Whether steps beyond a limit, which falls with the length of segments, are unstable.
  bool has_longest_step() const { return engine_.steps_of_twice_segments > 1; }
  /// About which axes of its joints the beam turns: of a motion in a plane about one, where the
  /// rule is of hinges.
  const std::array<bool, 3>& turns() const { return turns_; }
  void set_turns(const std::array<bool, 3>& turns);
  double time_step(const EngineSetting& setting) const { return sample_time_ / setting.steps; }
  /// Segment-steps of a run.
  std::int64_t work(const EngineSetting& setting) const;

  /// The beam of a setting, as it is exported.
  calibrate::EngineBeam beam(const EngineSetting& setting) const;
  /// The run of a setting; each is run once.
  const Outcome& run(const EngineSetting& setting);
  const std::map<EngineSetting, Outcome>& outcomes() const { return outcomes_; }

  /// Whether runs or work are used up, or it was stopped; then why.
  const std::optional<AdviceEnd>& end() const { return end_; }
  int runs() const { return runs_; }
  std::int64_t total_work() const { return total_work_; }

 private:
  Outcome made(const EngineSetting& setting) const;
  bool is_allowed(const EngineSetting& setting);

  const AdvisedEngine& engine_;
  const Setup& setup_;
  const std::vector<WatchedProbe>& watched_;
  const AdviceOptions& options_;
  int fewest_ = 1;
  std::array<bool, 3> turns_ = kAllTurns;
  double sample_time_ = 0.0;
  std::map<EngineSetting, Outcome> outcomes_;
  Outcome not_run_{};
  std::optional<AdviceEnd> end_{};
  int runs_ = 0;
  std::int64_t total_work_ = 0;
};

}  // namespace plastica::sweeps
