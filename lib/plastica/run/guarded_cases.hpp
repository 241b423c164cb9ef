#pragma once

#include <cstddef>
#include <span>

#include "plastica/run/response.hpp"

namespace plastica {

/// Runs cases side by side, and where one of them throws each on its own: what cannot be run then
/// has an empty response, NotRun, and the others have theirs.
/// @param run_cases  (first, responses): fills the responses of the cases from number `first` on,
///                   whatever was in them; a case has the same response in whichever company
template <class RunCases>
void run_guarded(std::size_t first, std::span<Response> responses, RunCases&& run_cases) {
  try {
    run_cases(first, responses);
    return;
  } catch (...) {
    // Out of memory, or a defect.
    if (responses.size() == 1) {
      responses[0] = {};
      return;
    }
  }
  for (std::size_t k = 0; k < responses.size(); ++k) {
    run_guarded(first + k, responses.subspan(k, 1), run_cases);
  }
}

}  // namespace plastica
