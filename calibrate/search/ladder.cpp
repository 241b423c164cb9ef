#include "calibrate/search/ladder.hpp"

#include <algorithm>

#include "calibrate/problem/law.hpp"

namespace plastica::calibrate {

std::vector<StartPoint> starts_from_simpler(
    std::span<const SearchedParameter> parameters,
    const std::function<std::optional<double>(std::string_view path)>& found) {
  StartPoint shared, alone;
  for (const SearchedParameter& p : parameters) {
    const Field* field = p.parameter->field;
    if (const std::optional<double> value = found(field->path)) {
      shared.emplace_back(field, std::clamp(*value, p.lower, p.upper));
      continue;
    }
    // Without a stress to reach, its rate has no effect, whatever it is; only its own start shows a
    // way up from there.
    const bool rate = field->material == MaterialField::SaturationRate;
    const auto least = min_effect_value(*p.parameter, p.lower, p.upper);
    if (least && !rate) alone.emplace_back(field, *least);
  }
  alone.insert(alone.end(), shared.begin(), shared.end());
  return {std::move(shared), std::move(alone)};
}

}  // namespace plastica::calibrate
