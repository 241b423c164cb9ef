#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::cli {

/// What a result file holds.
enum class ResultKind { Fits, Scene, Sweep, SceneFits };

/// @throws InputError if it holds none of them
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
