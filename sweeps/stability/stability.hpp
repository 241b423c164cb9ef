#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plastica/base/status.hpp"
#include "plastica/base/stop_flag.hpp"
#include "plastica/model/motion.hpp"
#include "plastica/model/rules.hpp"
#include "sweeps/stability/verdict.hpp"

namespace plastica::sweeps::stability {

/// A number of a scan at a point.
struct ScannedValue {
  std::string axis;  ///< "time step"
  std::string unit;  ///< of SI
  double value = 0.0;
};

/// One point of the study.
struct StabilityRow {
  std::string id;     ///< "planar tip force/modulus=1000"; stable, of content
  std::string scene;  ///< "planar tip force"
  Level level = Level::Planar;
  Analysis analysis = Analysis::Statics;
  std::vector<ScannedValue> at;  ///< none (the normal point), one or two
  bool begun = false;            ///< false after a stop
  Verdict verdict{};
  /// Of a scan of a user's scene: how far it is off a finer run [1], and of which quantity; none
  /// where none was run.
  std::optional<double> deviation{};
  std::string quantity{};
  Status status = Status::NotRun;
  double energy_balance_error = 0.0;  ///< of a motion [1]
  double segment_steps = 0.0;         ///< segments times steps that were taken [1]
  double seconds = 0.0;               ///< with preparation [s]
};

/// Which points of the stability study are run, and how.
struct StabilityOptions {
  /// Points whose id contains one of these are run: "planar", "twist spin/", "time step="; empty:
  /// all.
  std::vector<std::string> only{};
  std::size_t sample = 0;  ///< so many of them, drawn at random; 0: all
  std::uint64_t seed = 1;  ///< of the sample
  /// Points beyond this estimate are left out, segments times steps [1].
  double max_segment_steps = 1e9;
  /// A point is stopped, as failed, when it has taken four times its estimated segment-steps, but
  /// not before so many [1].
  double min_segment_steps = 2e5;
  /// A point that takes longer ends as failed, "interrupted" [s].
  double max_seconds = 60.0;
  int threads = 0;  ///< 0: as many as the machine has
  /// Once raised, no further point is begun, and those under way end within a step and count as not
  /// begun. May be null.
  StopFlag stop = nullptr;
  /// Told after each point, with how many of how many are done; from any thread, one call at a
  /// time.
  std::function<void(const StabilityRow& row, std::size_t finished, std::size_t all)> progress{};
};

/// Scans scenes towards the edge and judges each point (`judge`): E from 1 kPa to 1 TPa, N from 2
/// to 100 000, steps from 10 ns to 1 s, and so on (`axes`), one or two at a time from the normal
/// values of each of the scenes (`base_scenes`). Rows are in the order of `stability_points`, the
/// same for every number of threads but for times.
std::vector<StabilityRow> run_stability(const StabilityOptions& options = {});

}  // namespace plastica::sweeps::stability
