#include "plastica/model/check_value.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace plastica::model_detail {

std::string rounded(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string number_text(double value) { return rounded(value, 6); }

std::string figure(double value) { return rounded(value, 3); }

void require(bool holds, const SourceLocation& where, std::string_view field, double value,
             std::string_view rule) {
  if (!holds) throw InputError(where, field, number_text(value), rule);
}

void require_positive(double value, const SourceLocation& where, std::string_view field) {
  require(std::isfinite(value) && value > 0.0, where, field, value, "must be positive and finite");
}

void require_not_negative(double value, const SourceLocation& where, std::string_view field) {
  require(std::isfinite(value) && value >= 0.0, where, field, value,
          "must be finite and not negative");
}

}  // namespace plastica::model_detail
