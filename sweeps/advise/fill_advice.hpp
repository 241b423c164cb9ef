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
  std::optional<Trial> finest{};    ///< the run that verified it
  double verified = 0.0;            ///< difference from that [1]
  double of_finest = 0.0;           ///< what the numbers of that leave, at most [1]
  bool words_settled = false;       ///< whether that has the candidate's words, not the richest
  double of_words = 0.0;            ///< what its words leave out, at most; of the richest 0 [1]
  double promised = 0.0;
  std::string worst{};
  std::string reason{};
  bool within = false;
  bool rests =
      false;  ///< a probe that moves in finer runs is at rest in it, and where it is verified
  std::optional<Trial> even{};  ///< whose place it takes, where its segments are graded
};

/// What can be promised of a candidate: the larger of what its axes add, the words included, and of
/// what the run that verified shows [1]. Changes are over a finer run's value f_h, not over the
/// limit f: |f_h| <= |f| (1 + error).
/// @param words  error of the words [1]
double promise(const Candidate& candidate, double words);

/// The advice of a candidate; its end is for the caller to say. Runs the scene as its file has it,
/// unless that would take more than twice the work of the candidate.
/// @param finest  the run that others are compared with; empty: none was verified
Advice filled_advice(AdviceRuns& runs, const Candidate& candidate,
                     const std::optional<Trial>& finest, double within);

}  // namespace plastica::sweeps
