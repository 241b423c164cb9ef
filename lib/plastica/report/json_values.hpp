#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>

/// What JSON summaries are made of.
namespace plastica::report {

using Json = nlohmann::ordered_json;

/// Null where there is none, or it is not finite.
inline Json number(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

inline Json numbers(std::span<const double> values) {
  Json all = Json::array();
  for (const double value : values) all.push_back(number(value));
  return all;
}

inline Json text_or_null(std::string_view text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

}  // namespace plastica::report
