#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/search/fit_interrupted.hpp"
#include "plastica/base/stop_flag.hpp"

namespace plastica::calibrate {

/// How far a fit has come.
struct SceneFitProgress {
  /// "screen", "search" or "polish", or what follows the search: "weights 0", "segments",
  /// "profile", "bootstrap", "bootstrap of specimens", "parts held out".
  std::string_view stage;
  int done = 0;  ///< tasks of the stage that have ended, such as searches
  int total = 0;
  int runs = 0;  ///< of scenes, since the fit began
};

/// What those who run a fit have to do with it. None of it changes a bit of the result.
struct SceneFitHooks {
  /// Once raised, no further run is begun, one under way ends within a step of its own, and the fit
  /// ends by `FitInterrupted`. May be null.
  StopFlag stop = nullptr;
  /// Called between batches of runs, by one thread at a time. May be empty.
  std::function<void(const SceneFitProgress&)> progress{};
  /// What an earlier, interrupted fit of the same input kept by this name; null if nothing. May be
  /// empty, as `keep` may.
  std::function<const std::vector<std::byte>*(const std::string& name)> find{};
  /// Called with each task that is finished, by one thread at a time, and not beside
  /// `find`.
  std::function<void(const std::string& name, std::span<const std::byte> bytes)> keep{};

  bool stopped() const { return is_raised(stop); }
};

}  // namespace plastica::calibrate
