#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "sweeps/advise/discretization.hpp"
#include "sweeps/advise/outcome.hpp"

namespace plastica::sweeps {

struct AdviceOptions {
  double within = 0.01;               ///< the error that is allowed [1], 0 … 1
  std::vector<std::string> probes{};  ///< names; empty: all of the scene
  int max_runs = 60;                  ///< >= 4
  double max_work = 3e8;              ///< of all runs, segment-iterations: about a minute
  int threads = 0;                    ///< 0: as many as the machine has
  StopFlag stop = nullptr;            ///< may be null
  /// Called after each run with their number, from any thread, one call at a time.
  std::function<void(int runs)> progress{};
};

/// What one axis adds to the error of the advised setting.
struct BudgetLine {
  double error = 0.0;       ///< estimate [1]
  double order = 0.0;       ///< with which it falls [1]
  bool order_seen = false;  ///< else it is supposed: 1, which is safe
};

/// A setting that was run, and how far it is off the finest run of the advice.
struct TriedSetting {
  Setting setting;
  double error = 0.0;     ///< [1]; infinite where the two cannot be compared
  std::string reason{};   ///< why they cannot
  std::int64_t work = 0;  ///< segment-iterations
  double seconds = 0.0;
};

enum class AdviceEnd {
  Found,        ///< the setting is within what was asked for
  TooManyRuns,  ///< none was within it when the runs were used up
  TooMuchWork,  ///< the next runs would have taken more work than is allowed
  Diverging,    ///< refinement does not make the error smaller
  AtFinest,     ///< none was within it at the finest values of the axes
  Interrupted,
};

struct Advice {
  AdviceEnd end = AdviceEnd::TooManyRuns;
  std::vector<FinenessAxis> axes;
  Setting setting;                 ///< advised; else the last one (n_axes)
  std::vector<BudgetLine> budget;  ///< (n_axes)
  double promised = 0.0;           ///< the error is at most this, of the worst quantity [1]
  double verified = 0.0;           ///< difference from a run that is finer in every axis [1]
  std::string worst;               ///< quantity whose error is the largest
  std::string reason;              ///< why no error can be said, where it cannot
  std::int64_t work = 0;           ///< of the setting, segment-iterations
  double seconds = 0.0;
  std::optional<TriedSetting> next_cheaper;  ///< the dearest of the cheaper ones that do not do
  TriedSetting own;                          ///< the scene's file as it is
  std::vector<std::string> left_out;         ///< probes that are given, or errors themselves
  int runs = 0;
  double total_seconds = 0.0;   ///< CPU time of all runs
  std::int64_t total_work = 0;  ///< of all runs
};

/// Finds the cheapest discretization of a scene whose error is within what is allowed.
///
/// It begins coarse. Each setting is run together with one that is finer in each axis alone; their
/// differences say what each axis adds (`left_of`), two settings the order with which it falls.
/// From these follows the next setting (`next_setting`). Where the sum is small enough, the setting
/// is run once more, finer in every axis at once: what is promised is the larger of the sum and of
/// what that run shows. Errors are the largest of `deviation`'s quantities.
/// @throws InputError for a coupon, a probe that is not there, a scene that cannot be run
Advice advise(const Setup& setup, const AdviceOptions& options);

}  // namespace plastica::sweeps
