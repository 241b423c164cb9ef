#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/config/fit_file.hpp"
#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/base/stop_flag.hpp"

namespace plastica::sweeps {

/// Fits of either kind.
struct FittedRecords {
  std::vector<calibrate::FitRecord> curves;
  std::vector<calibrate::SceneFitRecord> scenes;
};

/// A fit file that a check runs, as `plastica calibrate` does, or a result of it.
struct FitSubject {
  std::string path;
  /// Of a fit file of curves, with what was imported; or of one through scenes.
  std::optional<calibrate::FitFile> curves{};
  std::vector<calibrate::Target> targets{};
  std::optional<calibrate::SceneFitFile> scenes{};
  /// Of a result.
  std::optional<FittedRecords> result{};

  /// Names of the fits, each once.
  std::vector<std::string> names() const;
  /// How many fits a run has; 0 of a result.
  std::size_t fits() const;
  /// Old names in them, each with the new one.
  std::vector<std::string> notes() const;
};

/// Reads a fit file with its curves and scenes. @throws InputError for the first thing that is
/// wrong
FitSubject read_fit_subject(const std::string& path);

/// Reads a result of fits. @throws InputError if it is none, or damaged
FitSubject read_fit_result(const std::string& path);

/// What a subject has been or is fitted to, with the laws, errors and intervals that `calibrate`
/// finds.
/// @param threads   0: as many as the machine has; changes no bit
/// @param stop      may be null
/// @param progress  told after each fit how many are done, one call at a time; may be empty
/// @return none if it was stopped
std::optional<FittedRecords> run_fits(const FitSubject& subject, int threads, StopFlag stop,
                                      const std::function<void(std::size_t done)>& progress);

}  // namespace plastica::sweeps
