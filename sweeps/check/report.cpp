#include "sweeps/check/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plastica/report/format.hpp"
#include "plastica/report/xml_text.hpp"

namespace plastica::sweeps {
namespace {

/// Whether the numbers of a claim are fractions, shown in percent.
bool is_fraction(ClaimKind kind) {
  return kind == ClaimKind::Error || kind == ClaimKind::ExtrapolatedError ||
         kind == ClaimKind::Gci || kind == ClaimKind::Spread || kind == ClaimKind::EnergyBalance;
}

std::string number_text(const CheckFile& file, const Claim& claim, double number) {
  if (is_fraction(claim.kind)) return fmt::format("{:.4g} %", 100.0 * number);
  if (claim.kind != ClaimKind::Value) return fmt::format("{:.6g}", number);
  const std::string& unit = file.sweeps[claim.sweep].quantity.unit;
  return fmt::format("{:.6g}{}", number, unit == "1" ? "" : " " + unit);
}

std::string limit_text(const CheckFile& file, const Claim& claim) {
  const auto text = [&](double number) { return number_text(file, claim, number); };
  if (claim.at_least && claim.at_most) {
    return text(*claim.at_least) + " … " + text(*claim.at_most);
  }
  return claim.at_least ? "at least " + text(*claim.at_least) : "at most " + text(*claim.at_most);
}

std::string finding(const CheckFile& file, const Claim& claim, const ClaimVerdict& verdict) {
  std::string text(kClaimKinds[static_cast<std::size_t>(claim.kind)]);
  std::replace(text.begin(), text.end(), '_', ' ');
  if (verdict.number) text += " " + number_text(file, claim, *verdict.number);
  text += ", " + limit_text(file, claim);
  if (!verdict.reason.empty()) text += "; " + verdict.reason;
  return text;
}

/// A text of the user without the two words.
std::string without_words(std::string text) {
  for (const std::string_view word : {"PASS", "FAIL"}) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word)) {
      std::transform(word.begin(), word.end(), text.begin() + static_cast<std::ptrdiff_t>(at),
                     [](char c) { return static_cast<char>(c - 'A' + 'a'); });
    }
  }
  return text;
}

std::size_t count_held(const CheckedFile& checked) {
  return static_cast<std::size_t>(std::count_if(checked.verdicts.begin(), checked.verdicts.end(),
                                                [](const auto& v) { return v.holds; }));
}

}  // namespace

std::string check_report(const CheckedFile& checked) {
  std::size_t width = 0;
  for (const Claim& claim : checked.file.claims) {
    width = std::max(width, report::width_of(report::printable(claim.name)));
  }
  std::string text = fmt::format("{}\n", without_words(report::printable(checked.file.path)));
  for (std::size_t k = 0; k < checked.file.claims.size(); ++k) {
    const Claim& claim = checked.file.claims[k];
    const ClaimVerdict& verdict = checked.verdicts[k];
    const std::string name = without_words(report::printable(claim.name));
    text += fmt::format("  {}  {}{}  {}\n", verdict.holds ? "PASS" : "FAIL", name,
                        std::string(width - report::width_of(name), ' '),
                        without_words(finding(checked.file, claim, verdict)));
  }
  return text;
}

std::string check_summary(std::span<const CheckedFile> files) {
  std::size_t claims = 0;
  std::size_t held = 0;
  double seconds = 0.0;
  for (const CheckedFile& checked : files) {
    claims += checked.verdicts.size();
    held += count_held(checked);
    seconds += checked.seconds;
  }
  return fmt::format("{} of {} hold, {:.3g} s\n", held, report::counted(claims, "claim"), seconds);
}

std::string junit_xml(std::span<const CheckedFile> files) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const CheckedFile& checked : files) {
    const std::string suite = report::xml_text(checked.file.path);
    text += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"{:.3f}\">\n",
        suite, checked.verdicts.size(), checked.verdicts.size() - count_held(checked),
        checked.seconds);
    for (std::size_t k = 0; k < checked.verdicts.size(); ++k) {
      const Claim& claim = checked.file.claims[k];
      const std::string found = report::xml_text(finding(checked.file, claim, checked.verdicts[k]));
      text += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\">\n", suite,
                          report::xml_text(claim.name));
      text += checked.verdicts[k].holds ? fmt::format("      <system-out>{}</system-out>\n", found)
                                        : fmt::format("      <failure message=\"{}\"/>\n", found);
      text += "    </testcase>\n";
    }
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

}  // namespace plastica::sweeps
