#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/scene/scene_fit_record.hpp"
#include "calibrate/store/journaled_batch.hpp"

namespace plastica::calibrate {

/// Fits cases through scenes and survives its interruption, as `JournaledBatch` does for curves.
/// Several cases are fitted side by side, a lone one has its scenes run side by side. The searches
/// of a fit that have ended are kept, too, and a stop is heeded between its batches of runs.
class JournaledSceneFits {
 public:
  /// Reads the journal, if one is there, and opens it for writing; computes nothing.
  /// @param cases, options  must outlive the batch; the hooks of the options are not used
  /// @param within  called as a lone fit goes on, see `SceneFitHooks::progress`; may be empty
  /// @throws InputError, io::StorageError as `io::CaseJournal`
  JournaledSceneFits(std::span<const SceneFitCase> cases, const SceneFitOptions& options,
                     JournaledOptions how,
                     std::function<void(const SceneFitProgress&)> within = {});
  JournaledSceneFits(const JournaledSceneFits&) = delete;
  JournaledSceneFits& operator=(const JournaledSceneFits&) = delete;

  std::size_t taken() const { return taken_; }        ///< fits that the journal had
  std::size_t parts() const { return parts_; }        ///< finished parts of others that it had
  std::size_t outdated() const { return outdated_; }  ///< and those of no use
  std::uint64_t dropped_bytes() const { return journal_.dropped_bytes(); }
  int resumptions() const { return journal_.resumptions(); }

  /// Fits what is missing. To be called once. Of several cases one whose input is bad has failed.
  /// @throws InputError for the bad input of a lone case
  std::vector<SceneFitResult> run();
  /// Whether `run` fitted all.
  bool complete() const { return complete_; }
  /// Deletes the journal, once the results of a complete run are stored elsewhere.
  void finish();

 private:
  std::optional<SceneFitResult> fit(std::size_t index, SceneFitOptions options);

  std::span<const SceneFitCase> cases_;
  const SceneFitOptions& options_;
  JournaledOptions how_;
  std::function<void(const SceneFitProgress&)> within_;
  std::vector<std::string> ids_;
  io::CaseJournal journal_;
  std::size_t taken_ = 0;
  std::size_t parts_ = 0;
  std::size_t outdated_ = 0;
  bool complete_ = false;
};

}  // namespace plastica::calibrate
