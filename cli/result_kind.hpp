#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::cli {

/// What a result file holds.
enum class ResultKind { Fits, Scene, Sweep, SceneFits };

/// Says on the standard error where a result file has no digest, so that damage cannot be detected,
/// and makes sure that reading it ends.
/// @throws InputError if it cannot be read or is damaged
void check_without_digest(const std::string& path);

/// Tells where it has no digest, too. @throws InputError if it holds none of them
ResultKind kind_of_result(const std::string& path);

/// An option of a command that reads results.
struct ResultOption {
  std::string name;               ///< "--joint"
  bool given = false;             ///< whether the command line has it
  std::vector<ResultKind> kinds;  ///< of results that it goes with
};

/// Refuses the first option that does not go with what a file holds. @throws InputError
void refuse_options_of_others(ResultKind kind, std::span<const ResultOption> options);

}  // namespace plastica::cli
