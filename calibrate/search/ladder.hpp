#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/problem/parameter.hpp"

namespace plastica::calibrate {

/// Values of some free parameters that a search is to begin from [SI]. What it does not name begins
/// at its start.
using StartPoint = std::vector<std::pair<const Field*, double>>;

/// A cost above a simpler law's by more than this fraction of it is not the least.
inline constexpr double kNoBetter = 1e-6;

/// A free parameter that a law's search moves, and how far [SI].
struct SearchedParameter {
  const Parameter* parameter = nullptr;
  double lower = 0.0;
  double upper = 0.0;
};

/// Where the search of a law begins besides its start: where a simpler law that it contains ended,
/// once with its own parameters at their starts, once where these have the least effect
/// (`min_effect_value`), so that it ends no worse.
/// @param found  what the simpler law's fit found of a path [SI]; empty for what it does not have
std::vector<StartPoint> starts_from_simpler(
    std::span<const SearchedParameter> parameters,
    const std::function<std::optional<double>(std::string_view path)>& found);

}  // namespace plastica::calibrate
