#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// The cases that a text picks: by an id or its first digits, or by values of axes as reports show
/// them, "rules.end_rule = equal, beam.segments = 20"; the last part of a path will do.
/// @return their numbers, rising; never none
/// @throws InputError where it picks none, or digits begin the ids of cases that differ
std::vector<std::size_t> select_cases(const SweepRecord& record, const std::string& text);

}  // namespace plastica::sweeps
