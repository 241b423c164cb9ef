#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweeps/advise/advice_runs.hpp"
#include "sweeps/advise/next_setting.hpp"

/// From the runs of an advice to what it says; not installed.
namespace plastica::sweeps {

/// A way to run the scene, with what the runs beside it say of it.
struct Candidate {
  Trial trial{};
  std::vector<AxisError> errors{};  ///< (n_axes of the runs)
  std::vector<WordLine> lines{};    ///< (n_word_axes); empty: the words were not measured there
  double numbers = 0.0;             ///< the sum of `errors`
  double verified = 0.0;
  double promised = 0.0;
  std::string worst{};
  std::string reason{};
  bool within = false;
};

/// The advice of a candidate; its end is for the caller to say. Runs the scene as its file has it,
/// unless that would take more than twice the work of the candidate.
/// @param finest  the run that others are compared with; empty: none was verified
Advice filled_advice(AdviceRuns& runs, const Candidate& candidate,
                     const std::optional<Trial>& finest, double within);

}  // namespace plastica::sweeps
