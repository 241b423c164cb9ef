#pragma once

#include <string>

#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

// The table of `sweep_report` with all cases, for documents.

/// A table of GitHub's Markdown for each group, its label above and its order below it. What
/// Markdown would read as its own is escaped.
std::string markdown_table(const SweepRecord& record);

/// One `tabular` that needs no package; the groups lie below each other, with label and order as
/// lines across it. What LaTeX would read as its own is escaped.
std::string latex_table(const SweepRecord& record);

}  // namespace plastica::sweeps
