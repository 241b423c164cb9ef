#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/result/scene_fit_record.hpp"

/// How fits through scenes look in everything that people read; not installed.
namespace plastica::calibrate::report {

/// "yield_stress" of "material.yield_stress", printable.
std::string short_name(std::string_view path);
/// What the abscissa of a target is, in one or two words: the probe's name, "time", "support 2".
std::string abscissa_text(const SceneTarget& target);

/// A pair of parameters that the curves determine by their combination rather than by themselves.
struct StrongCorrelation {
  std::size_t a = 0, b = 0;  ///< rows of the fit's parameters, a < b
  double value = 0.0;
};
std::vector<StrongCorrelation> strong_correlations(const SceneFitResult& result);

/// Costs of the searches that ended somewhere, in rising order: the waterfall of the starts.
std::vector<double> sorted_costs(const SceneFitResult& result);
/// How many of them reached the best cost, to a thousandth of it.
std::size_t count_of_best(const std::vector<double>& costs);

}  // namespace plastica::calibrate::report
