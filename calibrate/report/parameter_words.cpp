#include "calibrate/report/parameter_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plastica::calibrate::report {

std::string short_name(std::string_view path) { return printable(last_part(path)); }

DisplayUnit display_unit(const FittedParameter& parameter) {
  return display_unit_of(parameter.path, parameter.dimension, parameter.value);
}

std::string_view word_of_bound(const FittedParameter& parameter) {
  return parameter.at_lower ? "lower" : parameter.at_upper ? "upper" : "";
}

std::string value_text(const FittedParameter& parameter, const DisplayUnit& unit) {
  const double value = parameter.value / unit.scale;
  if (!std::isfinite(parameter.standard_error)) return significant(value);
  return with_error(value, parameter.standard_error / unit.scale);
}

std::string interval_text(const FittedParameter& parameter, const DisplayUnit& unit) {
  const double low = parameter.interval_low / unit.scale;
  const double high = parameter.interval_high / unit.scale;
  if (!std::isfinite(low) || !std::isfinite(high)) return {};
  const double error = 0.25 * (high - low);
  if (!(error >= 1e-6) || std::max(std::fabs(low), std::fabs(high)) >= 1e7) {
    return significant(low) + " … " + significant(high);
  }
  const int decimals = decimals_for(parameter.value / unit.scale, error);
  return fmt::format("{:.{}f} … {:.{}f}", low, decimals, high, decimals);
}

std::string verdict_text(const FittedParameter& p) {
  if (!p.judgement) return std::string(word_of(p.role));
  std::string word(name_of(p.verdict()));
  const std::string fraction = fmt::format("{:.2g} %", 100.0 * p.verdict_number());
  switch (p.verdict()) {
    case Verdict::Identified:
    case Verdict::Weak: return word + ", error " + fraction;
    case Verdict::NotIdentified: return word;
    case Verdict::AtBound: {
      const DisplayUnit unit = display_unit_of(p.path, p.dimension, p.verdict_number());
      return fmt::format("{}, {} {}", word, p.verdict_number() == p.lower ? "lower" : "upper",
                         quantity(brief(p.verdict_number() / unit.scale), unit.name));
    }
    case Verdict::LimitedBySegments:
    case Verdict::LimitedBySampling: return word + ", ± " + fraction;
    case Verdict::FromPrior: return word + ", " + fraction + " of it";
  }
  return word;
}

}  // namespace plastica::calibrate::report
