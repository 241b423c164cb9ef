#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"
#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/for_engine/advised_engine.hpp"
#include "sweeps/advise/for_engine/engine_setting.hpp"

namespace plastica::sweeps {

/// Runs by an engine's rule, which are cheap, for each of ours that is allowed.
inline constexpr int kRuleRunsPerRun = 3;

/// What of the allowed error the run that an engine's are compared with may be off by itself.
inline constexpr double kReferenceShare = 0.25;

/// A setting of an engine that was run.
struct TriedEngineSetting {
  EngineSetting setting{};
  double time_step = 0.0;  ///< [s]
  double error = 0.0;      ///< against the reference [1]; infinite where they cannot be compared
  std::string reason{};    ///< why they cannot, or why it does not do although it is within
  std::int64_t work = 0;   ///< segment-steps
};

/// Why there is no advice, where there is none.
enum class EngineAdviceEnd {
  Found,
  NoReference,  ///< our own runs came to no advice, see `reference.end`
  AtLimit,      ///< no number of segments and steps comes within what is allowed
  TooManyRuns,
  TooMuchWork,
  Interrupted,
};

/// Segments, joints and step of a beam for an engine.
struct EngineAdvice {
  EngineAdviceEnd end = EngineAdviceEnd::AtLimit;
  const AdvisedEngine* engine = nullptr;  ///< of `advised_engines()`
  EngineSetting setting{};                ///< advised; else the last one
  double time_step = 0.0;                 ///< [s]
  calibrate::EngineBeam beam{};           ///< of the setting, for `engine_text`
  double error = 0.0;                     ///< against the reference [1]
  double reference_error = 0.0;           ///< of the reference itself [1]
  double promised = 0.0;                  ///< the sum of both: the error is at most this [1]
  double by_segments = 0.0;               ///< what twice as many segments change [1]
  double by_steps = 0.0;                  ///< what half the step changes [1]
  std::string worst{};                    ///< quantity whose error is the largest
  std::int64_t work = 0;                  ///< segment-steps
  std::optional<TriedEngineSetting> next_cheaper{};  ///< the dearest of those that do not do
  std::vector<TriedEngineSetting> tried{};
  std::string reason{};             ///< why the reference cannot be used, where that is its status
  Advice reference{};               ///< our own, for a quarter of the error
  std::string reference_setting{};  ///< of the run that the engine's are compared with
  std::vector<std::string> left_out{};  ///< probes that an engine has not
  std::vector<std::string> notes{};     ///< what whoever runs the beam has to do, a sentence each
  bool cut_short = false;       ///< whether runs or work were used up before the search had ended
  int runs = 0;                 ///< by the engine's rule
  std::int64_t total_work = 0;  ///< of these, segment-steps
};

/// Finds segments and time step at which an engine's run of a scene's exported beam is within an
/// error of the scene, with the fewest segment-steps.
///
/// The engine is stood for by its rule (`HingeChain`). The scene's truth is a run of ours that is
/// finer than `advise` asks for a quarter of the error, richest in every model; what it is off
/// itself is added to what is promised. The scene's loads act there as a program sets them
/// before each step.
/// @param options  budget: unused; max_runs is that of our runs, those by the rule may be
///                 `kRuleRunsPerRun` times as many, and `progress` counts each anew;
///                 max_work that of each
/// @throws InputError as `advise`, and for a scene that no export for the engine holds: that rests,
///         yields, breaks, or is held otherwise than at its start
EngineAdvice advise_for_engine(const AdvisedEngine& engine, const Setup& setup,
                               const AdviceOptions& options);

}  // namespace plastica::sweeps
