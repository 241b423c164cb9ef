#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweeps/advise/watched_probes.hpp"
#include "sweeps/stability/scene_scan.hpp"

/// Parts of the scan of a user's scene; not installed.
namespace plastica::sweeps::stability {

/// A run of one setup, judged.
struct JudgedRun {
  Verdict verdict{};
  Status status = Status::NotRun;
  Level level = Level::Auto;
  bool as_own = false;     ///< whether it gave what the scene as it is gives, bit by bit
  double deviation = 0.0;  ///< from the finer run [1]
  std::string quantity{};  ///< whose that is
  bool compared = false;   ///< whether there was one
  double energy_balance_error = 0.0;
  double segment_steps = 0.0;
  double seconds = 0.0;
  std::vector<std::string> warnings{};  ///< where they are asked for, see `run_warnings`
};

/// Where a point comes from.
enum class Source {
  Run,     ///< it is run, unless the journal has it
  Recall,  ///< the journal alone: another process has run it
};

/// Runs setups that differ from a scene, and judges them; of what is kept in the options' journal,
/// none is run again.
class PointRunner {
 public:
  /// @throws InputError if the scene has no probe to look at
  PointRunner(const Setup& setup, const SceneScanOptions& options);

  /// The scene as it is; to be run first. @throws InputError if it is bad input
  JudgedRun run_own();
  /// One that differs; nothing if it was stopped or, recalled, is not known.
  /// @throws io::StorageError
  std::optional<JudgedRun> run(const Setup& setup, Source source) const;
  /// Segments times steps that a run is estimated to take [1].
  double work(const Setup& setup) const;
  double own_work() const { return own_work_; }

 private:
  /// @param outcome  of the run
  JudgedRun judged(const Setup& setup, Outcome& outcome, bool warned) const;
  BatchRow simulated(const Setup& setup, double& steps) const;
  bool is_own(const Outcome& outcome) const;
  void compare_with_finer(const Setup& setup, const Outcome& outcome, JudgedRun& run) const;
  /// Where there are errors of first and second order (`has_first_order_errors`), they may cancel
  /// between a run and a finer one: the limit of both and of one between them may be further off.
  /// @return whether it is; `run` has that then
  bool is_further_off_limit(const Setup& setup, const Setup& fine, const Outcome& outcome,
                            const Outcome& of_fine, JudgedRun& run) const;

  const Setup& setup_;
  const SceneScanOptions& options_;
  std::vector<WatchedProbe> watched_;
  double own_work_ = 0.0;
  Outcome own_{};  ///< of the scene as it is
};

}  // namespace plastica::sweeps::stability
