#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/model/field.hpp"
#include "sweeps/stability/stability.hpp"

/// How far the numbers of a user's own scene may go from their values. What is judged is a run
/// against all that its response must keep (`judge`), and against a run that is finer in every
/// axis of its discretization (advise/outcome.hpp): four times in segments, twice in step, fibres
/// and recorded steps.
namespace plastica::sweeps::stability {

class PointJournal;

struct SceneScanOptions {
  double within = 0.05;  ///< largest deviation from the finer run of a valid one [1], 0 ... 1
  double reach = 1e3;    ///< no value is followed by more than this factor, > 1
  /// Runs that are estimated to take more than so many times the work of the scene's own are left
  /// out, >= 1; one that takes twenty times its estimate is stopped, as failed.
  double max_work = 64.0;
  int threads = 0;  ///< 0: as many as the machine has; changes nothing but times
  /// Once raised, no further run is begun, and those under way end within a step. May be null.
  StopFlag stop = nullptr;
  /// Keeps every point, and has the processes that do the scan together; null: nothing is kept.
  PointJournal* journal = nullptr;
  /// Told after each point how many there have been, those of other processes and of earlier runs
  /// included, one call at a time; may be empty. Of a team only the leader's has them all.
  std::function<void(std::size_t points)> progress{};
};

/// Why a field was not followed further in a direction.
enum class ScanEnd {
  Verdict,  ///< the next value is not valid
  Range,    ///< there the field's range ends
  Reach,    ///< so far it was followed
  Work,     ///< the next run would take too much work
  Whole,    ///< there is no whole number beyond
  Samples,  ///< beyond, a time step is cut to the samples, and the run is the same
};

/// How far a field may go in one direction.
struct ScanLimit {
  double value = 0.0;  ///< the last one that is valid [SI]
  ScanEnd end = ScanEnd::Reach;
  double next = 0.0;     ///< Verdict: the next value that was run
  Verdict verdict{};     ///< of that
  bool changes = false;  ///< whether any value in this direction has another result
};

struct ScannedField {
  const Field* field = nullptr;
  double value = 0.0;  ///< the scene's own [SI]
  ScanLimit below;
  ScanLimit above;

  /// Whether the result depends on it at all, as far as it was followed.
  bool matters() const { return below.changes || above.changes; }
};

struct SceneScan {
  std::string scene;
  Verdict own{};  ///< of the scene as it is; nothing else is run unless it is valid
  /// Of the scene as it is: how far it is off the finer run [1], and of which quantity; none where
  /// nothing is finer.
  std::optional<double> deviation{};
  std::string quantity{};
  std::vector<std::string> warnings{};  ///< of the scene as it is, see `run_warnings`
  std::vector<ScannedField> fields;
  std::vector<StabilityRow> rows;  ///< every point that was run
  bool complete = false;           ///< false after a stop, of whichever process
};

/// A grid of two fields.
struct PairScan {
  std::vector<StabilityRow> rows;  ///< every point that was run
  bool complete = false;           ///< false after a stop, of whichever process
};

/// The fields of names, or, without names, all numbers of the scene that are set and not 0, the
/// derived ones of loads and motions included.
/// @throws InputError for what is no field, no number, not set or 0 in the scene, or named twice
std::vector<const Field*> scanned_fields(const Setup& setup, const std::vector<std::string>& names);

/// Follows each field from its value both ways, in factors of the root of ten, then in ever smaller
/// ones between the last valid value and the next. Where several processes do it together, each has
/// the whole scan in the end.
/// @throws InputError if the scene has no probe to look at; io::StorageError and TeamLeft of the
///         journal
SceneScan scan_scene(const std::string& name, const Setup& setup,
                     const std::vector<const Field*>& fields, const SceneScanOptions& options);

/// Runs a grid of two fields that were scanned, from one end of each to the other and a step beyond
/// what is not valid; rows have both. Throws as above.
PairScan scan_pair(const std::string& name, const Setup& setup, const ScannedField& first,
                   const ScannedField& second, const SceneScanOptions& options);

}  // namespace plastica::sweeps::stability
