#pragma once

#include "sweeps/advise/advice_runs.hpp"
#include "sweeps/advise/fill_advice.hpp"
#include "sweeps/advise/word_chooser.hpp"

/// What words leave out at numbers where the richest are not run; not installed.
namespace plastica::sweeps {

/// Whether what the words of a candidate leave out is the same, but for little, as the numbers are
/// refined.
struct SettledWords {
  bool are_so = false;
  double error = 0.0;  ///< what they leave out at finer numbers, at most [1]
};

/// Measures what a candidate's words leave out, all together: at its own numbers, where the words
/// were decided, and there finer in each number that matters but was not refined since. What they
/// leave out changes with a number's size h at first order or a higher one: of the change from h to
/// h/r no more than 1/(r - 1) is still to come. The words have settled if the changes come to no
/// more than a fifth of what they leave out, or a twentieth of what is allowed, and if what they
/// leave out at most has room beside the candidate's numbers.
/// @param within  the error that is allowed [1]
/// @param worth   nothing is run that is foreseen to cost more; by `kernel_cost`
/// @param found   not settled where nothing was run
/// @return false if runs or work are used up, see `AdviceRuns::end`
bool measure_settled(AdviceRuns& runs, const WordChooser& words, const Candidate& candidate,
                     double within, double worth, SettledWords& found);

}  // namespace plastica::sweeps
