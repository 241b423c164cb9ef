#include "sweeps/check/shown_number.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plastica/report/format.hpp"

namespace plastica::sweeps {

std::string number_text(const CheckFile& file, const Claim& claim, double number) {
  if (traits_of(claim.kind).fraction) return fmt::format("{:.4g} %", 100.0 * number);
  if (claim.kind != ClaimKind::Value) return fmt::format("{:.6g}", number);
  if (claim.subject == ClaimSubject::Fit) return parameter_text(claim, number);
  const Sweep& of =
      claim.subject == ClaimSubject::Scene ? file.scenes[claim.of] : file.sweeps[claim.of];
  const std::string& unit = of.quantity.unit;
  return fmt::format("{:.6g}{}", number, unit == "1" ? "" : " " + unit);
}

std::string parameter_text(const Claim& claim, double value) {
  const report::DisplayUnit unit = report::display_unit(
      claim.dimension, std::fabs(value), claim.parameter.find("modulus") != std::string::npos);
  return report::quantity(fmt::format("{:.6g}", value / unit.scale), unit.name);
}

std::string limit_text(const CheckFile& file, const Claim& claim) {
  if (claim.kind == ClaimKind::Interval) return "to hold " + parameter_text(claim, claim.truth);
  if (claim.kind == ClaimKind::Status) {
    std::string words;
    for (const Status status : claim.statuses) {
      words += (words.empty() ? "" : " or ") + std::string(name_of(status));
    }
    return words;
  }
  const auto text = [&](double number) { return number_text(file, claim, number); };
  if (claim.at_least && claim.at_most) {
    return text(*claim.at_least) + " … " + text(*claim.at_most);
  }
  return claim.at_least ? "at least " + text(*claim.at_least) : "at most " + text(*claim.at_most);
}

}  // namespace plastica::sweeps
