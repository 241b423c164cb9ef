#pragma once

#include <optional>
#include <string>

#include "plastica/run/warning_facts.hpp"

/// Not installed.
namespace plastica::run_detail {

/// The lowest frequency of the unloaded beam that something resists [Hz]; empty: there is none.
std::optional<double> lowest_frequency(const Model& model);

/// Samples of a motion that are too far apart for the beam's slowest swing.
std::optional<std::string> sample_warning(const Facts& facts);

}  // namespace plastica::run_detail
