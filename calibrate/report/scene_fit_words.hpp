#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/result/scene_fit_record.hpp"

/// How fits through scenes look in everything that people read; not installed.
namespace plastica::calibrate::report {

/// What the abscissa of a target is, in one or two words: the probe's name, "time", "support 2".
std::string abscissa_text(const SceneTarget& target);

/// Whether the targets of a fit have several laws, as their scenes may where none are compared.
bool has_several_laws(const SceneFitResult& result);
/// The laws of a fit's targets, each once: "ideal", "ideal, linear".
std::string laws_text(const SceneFitResult& result);

/// Costs of the searches that ended somewhere, in rising order: the waterfall of the starts.
std::vector<double> sorted_costs(const SceneFitResult& result);
/// How many of them reached the best cost, to a thousandth of it.
std::size_t count_of_best(const std::vector<double>& costs);

}  // namespace plastica::calibrate::report
