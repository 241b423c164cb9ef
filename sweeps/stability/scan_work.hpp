#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/team.hpp"
#include "sweeps/stability/point_run.hpp"

/// What the scan of single fields and that of two have in common; not installed.
namespace plastica::sweeps::stability {

/// From one value of a scan to the next.
inline const double kStep = std::sqrt(10.0);

/// A field's value; NaN where it has no number.
double number_of(const Field& field, const Setup& setup);
/// The value that a field takes for a number.
double whole_value(const Field& field, double value);

ScannedValue scanned(const Field& field, double value);
/// A run that was refused.
JudgedRun refused(const InputError& error);
/// @param at  none for the scene as it is
StabilityRow point_row(const std::string& scene, const Setup& setup, std::vector<ScannedValue> at,
                       const JudgedRun& run);

/// The processes that do a scan together; null: there is one.
Team* team_of(const SceneScanOptions& options);

/// Counts points for the progress, those of other processes included.
class PointCounter {
 public:
  /// To be made before the work is shared, and to outlive it.
  explicit PointCounter(const SceneScanOptions& options);
  void count();

 private:
  void tell() const;

  const SceneScanOptions& options_;
  std::mutex mutex_;
  std::size_t points_ = 0;
  std::size_t others_ = 0;
};

/// Has `take` do 0 … count-1, in threads and with other processes; then each recalls what the
/// others have run. @param is_done  whether one is there
/// @return whether all are; false where any process was stopped
bool share_points(std::size_t count, const SceneScanOptions& options,
                  const std::function<void(std::size_t, Source)>& take,
                  const std::function<bool(std::size_t)>& is_done);

}  // namespace plastica::sweeps::stability
