#include "sweeps/check/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "plastica/report/format.hpp"
#include "plastica/report/xml_text.hpp"
#include "sweeps/check/shown_number.hpp"

namespace plastica::sweeps {
namespace {

/// The kind of claim, and what was found: "extrapolated error 1 %".
std::string found_text(const CheckFile& file, const Claim& claim, const ClaimVerdict& verdict) {
  std::string text(traits_of(claim.kind).word);
  std::replace(text.begin(), text.end(), '_', ' ');
  const std::string seen = seen_text(file, claim, verdict);
  return seen.empty() ? text : text + " " + seen;
}

/// What was found of a claim that holds: "order 1.99997, 1.98 … 2.02".
std::string finding(const CheckFile& file, const Claim& claim, const ClaimVerdict& verdict) {
  return found_text(file, claim, verdict) + ", " + limit_text(file, claim);
}

/// What is wrong with one that does not: "error 1.95 % at beam.segments = 5 (tip, end -0.75 m,
/// reference -0.735 m); wanted at most 0.01 %".
std::string failing(const CheckFile& file, const Claim& claim, const ClaimVerdict& verdict) {
  std::string text = found_text(file, claim, verdict);
  if (!verdict.at.empty()) text += " " + verdict.at;
  if (!verdict.reason.empty()) text += ": " + verdict.reason;
  if (!verdict.beside.empty()) text += " (" + verdict.beside + ")";
  return text + "; wanted " + limit_text(file, claim);
}

std::string place_of(const Claim& claim) {
  return fmt::format("{}:{}", claim.where.file, claim.where.line);
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

/// @param width  of all names
std::string claim_line(const CheckedFile& checked, std::size_t k, std::size_t width) {
  const Claim& claim = checked.file.claims[k];
  const ClaimVerdict& verdict = checked.verdicts[k];
  std::string name = without_words(report::printable(claim.name));
  const std::size_t own = report::width_of(name);
  if (own < width) name += std::string(width - own, ' ');
  const std::string found = verdict.holds
                                ? finding(checked.file, claim, verdict)
                                : failing(checked.file, claim, verdict) + "; " + place_of(claim);
  return fmt::format("  {}  {}  {}\n", verdict.holds ? "PASS" : "FAIL", name,
                     without_words(report::printable(found)));
}

std::string warning_line(const std::string& warning) {
  return "        warning: " + without_words(report::printable(warning)) + "\n";
}

std::size_t count_held(const CheckedFile& checked) {
  return static_cast<std::size_t>(std::count_if(checked.verdicts.begin(), checked.verdicts.end(),
                                                [](const auto& v) { return v.holds; }));
}

}  // namespace

std::string check_report(const CheckedFile& checked, CheckLines lines) {
  const bool all = lines == CheckLines::All;
  std::size_t width = 0;
  for (const Claim& claim : checked.file.claims) {
    if (all) width = std::max(width, report::width_of(report::printable(claim.name)));
  }
  std::string text;
  std::set<std::string> said;
  if (all) text = fmt::format("{}\n", without_words(report::printable(checked.file.path)));
  for (std::size_t k = 0; k < checked.file.claims.size(); ++k) {
    const ClaimVerdict& verdict = checked.verdicts[k];
    if (verdict.holds && !all) continue;
    text += claim_line(checked, k, width);
    for (const std::string& warning : verdict.warnings) {
      // Of several claims on a scene, or a sweep, once.
      if (said.insert(warning).second) text += warning_line(warning);
    }
  }
  return text;
}

std::string claim_report(const CheckedFile& checked, std::size_t claim) {
  std::string text = claim_line(checked, claim, 0);
  for (const std::string& warning : checked.verdicts[claim].warnings) {
    text += warning_line(warning);
  }
  return text;
}

std::string seen_text(const CheckFile& file, const Claim& claim, const ClaimVerdict& verdict) {
  if (!verdict.found.empty()) return verdict.found;
  return verdict.number ? number_text(file, claim, *verdict.number) : std::string();
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
  return fmt::format("{} of {} {}, {:.3g} s\n", held, report::counted(claims, "claim"),
                     claims == 1 ? "holds" : "hold", seconds);
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
      const ClaimVerdict& verdict = checked.verdicts[k];
      text += fmt::format(
          "    <testcase classname=\"{}\" name=\"{}\" file=\"{}\" line=\"{}\" "
          "time=\"{:.3f}\">\n",
          suite, report::xml_text(claim.name), report::xml_text(claim.where.file), claim.where.line,
          verdict.seconds);
      if (verdict.holds) {
        text += fmt::format("      <system-out>{}</system-out>\n",
                            report::xml_text(finding(checked.file, claim, verdict)));
      } else {
        const std::string why = report::xml_text(failing(checked.file, claim, verdict));
        text += fmt::format("      <failure message=\"{}\">{}; {}</failure>\n", why, why,
                            report::xml_text(place_of(claim)));
      }
      text += "    </testcase>\n";
    }
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

namespace {

/// A text as GitHub's workflow commands take it: line ends and the percent sign by their codes; in
/// a property also the signs that part properties.
std::string for_github(std::string_view text, bool in_property) {
  std::string out;
  for (const char c : text) {
    const bool parts = in_property && (c == ':' || c == ',');
    if (c == '%' || c == '\r' || c == '\n' || parts) {
      out += fmt::format("%{:02X}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string github_annotations(const CheckedFile& checked) {
  std::string text;
  for (std::size_t k = 0; k < checked.verdicts.size(); ++k) {
    if (checked.verdicts[k].holds) continue;
    const Claim& claim = checked.file.claims[k];
    text +=
        fmt::format("::error file={},line={},title={}::{}\n", for_github(claim.where.file, true),
                    claim.where.line, for_github(claim.name, true),
                    for_github(failing(checked.file, claim, checked.verdicts[k]), false));
  }
  return text;
}

}  // namespace plastica::sweeps
