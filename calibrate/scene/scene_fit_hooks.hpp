#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::calibrate {

/// How far a fit has come.
struct SceneFitProgress {
  /// "screen", "search" or "polish", or what follows the search: "weights 0", "segments",
  /// "profile", "bootstrap", "bootstrap of specimens".
  std::string_view stage;
  int done = 0;  ///< pieces of the stage that have ended, such as searches
  int total = 0;
  int runs = 0;  ///< of scenes, since the fit began
};

/// What those who run a fit have to do with it. None of it changes a bit of the result.
struct SceneFitHooks {
  /// Once true, no further run is begun, and the fit ends by `FitInterrupted`. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called between batches of runs, by one thread at a time. May be empty.
  std::function<void(const SceneFitProgress&)> progress{};
  /// What an earlier, interrupted fit of the same input kept by this name; null if nothing. May be
  /// empty, as `keep` may.
  std::function<const std::vector<std::byte>*(const std::string& name)> find{};
  /// Called with each piece of work that is finished, by one thread at a time, and not beside
  /// `find`.
  std::function<void(const std::string& name, std::span<const std::byte> bytes)> keep{};

  bool stopped() const { return stop != nullptr && stop->load(); }
};

/// A fit was stopped before its end, as asked for.
class FitInterrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "the fit was interrupted"; }
};

}  // namespace plastica::calibrate
