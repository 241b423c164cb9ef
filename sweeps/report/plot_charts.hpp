#pragma once

#include "sweeps/report/plot_chart.hpp"
#include "sweeps/report/plot_lines.hpp"

/// The pictures of a sweep, each as a chart or a script; not installed.
namespace plastica::sweeps {

/// Whether a sweep has a picture.
bool has_convergence(const SweepRecord& record);
bool has_values(const SweepRecord& record);
bool has_trade(const SweepRecord& record);
bool has_curves(const SweepRecord& record);

/// The size of the error over what is refined, a line a group, its order in the legend; points at
/// the round-off floor are open. @throws InputError if no picked case has an error
Chart convergence_chart(const PlotCases& cases);

/// What is compared over the refined axis, or else the first one of numbers, of sampled ones that
/// which moves it most, or else the first of words; the reference, where it is the same for all, as
/// a line. @throws InputError if no picked case has a value
Chart value_chart(const PlotCases& cases);

/// The size of the error over the cost, the cases of a group joined; the Pareto front of all, and
/// lines at 1, 0.1 and 0.01 %. @throws InputError if no picked case has an error
Chart trade_chart(const PlotCases& cases);

/// Curves of the picked cases, or of the finest of each group where all cases are too many.
/// @throws InputError if these are too many as well
Chart curve_chart(const PlotCases& cases);

/// The error, the value or the status over two axes of numbers, as coloured fields; a panel for
/// each of the other axes' values. @throws InputError if these are too many
report::PlotScript map_page(const PlotCases& cases, const report::Sheet& sheet = {});
report::PlotScript map_terminal(const PlotCases& cases);

}  // namespace plastica::sweeps
