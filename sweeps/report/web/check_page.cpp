#include "sweeps/report/web/check_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "plastica/report/format.hpp"
#include "plastica/report/web/web_blocks.hpp"
#include "sweeps/check/shown_number.hpp"

namespace plastica::sweeps {
namespace {

using report::Json;
using report::WebPage;
using report::WebTab;

/// A claim with its verdict.
struct JudgedClaim {
  const CheckedFile& checked;
  std::size_t number = 0;

  const CheckFile& file() const { return checked.file; }
  const Claim& claim() const { return checked.file.claims[number]; }
  const ClaimVerdict& verdict() const { return checked.verdicts[number]; }
};

/// "sweep sweeps/tip.toml"; of a scan which points.
std::string about_text(const JudgedClaim& one) {
  const Claim& claim = one.claim();
  switch (claim.subject) {
    case ClaimSubject::Sweep: return "sweep " + one.file().sweeps[claim.of].path;
    case ClaimSubject::Scene: return "scene " + one.file().scenes[claim.of].scene.path;
    case ClaimSubject::Fit: return "fits of " + one.file().fits[claim.of].path;
    case ClaimSubject::Scan: break;
  }
  const std::vector<std::string>& only = claim.scan->only;
  return only.empty() ? "scan, all points" : fmt::format("scan of {}", fmt::join(only, ", "));
}

/// "energy balance", "error of tip, end".
std::string kind_text(const JudgedClaim& one) {
  const Claim& claim = one.claim();
  std::string text(traits_of(claim.kind).word);
  std::ranges::replace(text, '_', ' ');
  const bool of_quantity = claim.kind == ClaimKind::Value || claim.kind == ClaimKind::Error ||
                           claim.kind == ClaimKind::ExtrapolatedError ||
                           claim.kind == ClaimKind::Spread || claim.kind == ClaimKind::Order;
  if (!claim.parameter.empty()) return text + " of " + claim.parameter;
  if (!of_quantity || claim.subject == ClaimSubject::Scan) return text;
  const std::string& quantity = claim.subject == ClaimSubject::Scene
                                    ? one.file().scenes[claim.of].quantity.name
                                    : one.file().sweeps[claim.of].quantity.name;
  return quantity.empty() ? text : text + " of " + quantity;
}

/// Of which cases or fits alone.
std::string only_text(const JudgedClaim& one) {
  const Claim& claim = one.claim();
  std::string text = fmt::format("{}", fmt::join(claim.cases, ", "));
  for (const auto& [axis, values] : claim.only) {
    const Field& field = *one.file().sweeps[claim.of].axes[axis].field;
    std::string words;
    for (const FieldValue& value : values) {
      words += (words.empty() ? "" : " or ") + value_text(field, value);
    }
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", field.path, words);
  }
  return text;
}

std::string verdict_text(const ClaimVerdict& verdict) {
  return verdict.holds ? "holds" : "does not hold";
}

/// What else is to be said: why there is no number, what it is made of.
std::string remark_text(const ClaimVerdict& verdict) {
  if (verdict.reason.empty() || verdict.beside.empty()) return verdict.reason + verdict.beside;
  return verdict.reason + "; " + verdict.beside;
}

Json claims_block(const std::vector<JudgedClaim>& claims) {
  report::WebTable table("");
  table.open_details();
  for (const char* name :
       {"claim", "verdict", "seen", "limit", "what", "about", "where", "remark", "file"}) {
    table.add_words(name);
  }
  table.add_numbers("time", "s", "of what it is about, shared by all claims about that", 3);
  for (const JudgedClaim& one : claims) {
    const ClaimVerdict& verdict = one.verdict();
    table.add_row({one.claim().name, verdict_text(verdict),
                   seen_text(one.file(), one.claim(), verdict), limit_text(one.file(), one.claim()),
                   kind_text(one), about_text(one), verdict.at, remark_text(verdict),
                   one.file().path, report::number(verdict.seconds)});
  }
  return table.block();
}

Json facts_block(const JudgedClaim& one) {
  const Claim& claim = one.claim();
  const ClaimVerdict& verdict = one.verdict();
  return report::web_facts(
      "", {{"verdict", verdict_text(verdict)},
           {"about", about_text(one)},
           {"only", only_text(one)},
           {"law", claim.law},
           {"what", kind_text(one)},
           {"seen", seen_text(one.file(), claim, verdict)},
           {"limit", limit_text(one.file(), claim)},
           {"where", verdict.at},
           {"remark", remark_text(verdict)},
           {"claimed in", fmt::format("{}:{}", claim.where.file, claim.where.line)},
           {"took", report::significant(verdict.seconds, 3) + " s"}});
}

/// Above the numbers of a verdict.
std::string judged_title(const JudgedClaim& one) {
  const ClaimVerdict& verdict = one.verdict();
  const ClaimKind kind = one.claim().kind;
  const bool some = verdict.judged > verdict.worst.size();
  if (kind == ClaimKind::Failed || kind == ClaimKind::Fitted) {
    const bool of_fits = one.claim().subject == ClaimSubject::Fit;
    const std::string what = of_fits ? "fits of no use" : "that failed";
    return some ? fmt::format("The first {} of {} {}", verdict.worst.size(), verdict.judged, what)
                : (of_fits ? "Fits of no use" : "What failed");
  }
  return some ? fmt::format("The worst {} of {}", verdict.worst.size(), verdict.judged)
              : "What it was judged by";
}

/// What the claim was judged by, the worst first; null where that is the one number of the verdict.
Json judged_block(const JudgedClaim& one) {
  const ClaimVerdict& verdict = one.verdict();
  const bool named = std::ranges::any_of(
      verdict.worst, [](const JudgedNumber& number) { return !number.of.empty(); });
  if (!named) return nullptr;
  const bool numbers = std::ranges::any_of(
      verdict.worst, [](const JudgedNumber& number) { return number.number.has_value(); });
  const bool remarks = std::ranges::any_of(
      verdict.worst, [](const JudgedNumber& number) { return !number.remark.empty(); });
  const bool interval = one.claim().kind == ClaimKind::Interval;
  report::WebTable table(judged_title(one));
  table.add_words("of");
  if (numbers) table.add_words(interval ? "outside of the interval by" : "seen");
  if (remarks) table.add_words("remark");
  for (const JudgedNumber& number : verdict.worst) {
    Json cells = {number.of};
    if (numbers) {
      std::string text;
      if (number.number) {
        text = interval ? parameter_text(one.claim(), *number.number)
                        : number_text(one.file(), one.claim(), *number.number);
      }
      cells.push_back(std::move(text));
    }
    if (remarks) cells.push_back(number.remark);
    table.add_row(std::move(cells));
  }
  return table.block();
}

/// The errors of the group that decides; null without two of them.
Json errors_block(const ClaimVerdict& verdict) {
  if (verdict.errors.points.size() < 2) return nullptr;
  report::FigureCurve curve{{}, "errors", report::kBlue, report::Stroke::Symbols};
  for (const auto& [size, error] : verdict.errors.points) {
    curve.points.push_back({size, 100.0 * error});
  }
  report::FigurePanel panel{verdict.at, verdict.errors.over, "size of the error [%]"};
  // With room for the symbols at the ends.
  const auto range = [&](std::size_t column) -> std::array<double, 2> {
    const auto [least, largest] = std::ranges::minmax(
        curve.points, {}, [&](const std::vector<double>& point) { return point[column]; });
    return {least[column] / 1.4, 1.4 * largest[column]};
  };
  panel.x_range = range(0);
  panel.y_range = range(1);
  const report::LogarithmicAxes logarithmic{true, true};
  Json curves = Json::array();
  curves.push_back(report::web_curve(curve, logarithmic, 0));
  Json panels = Json::array();
  panels.push_back(report::web_panel(panel, logarithmic, std::move(curves)));
  return report::web_panels("Errors", std::move(panels));
}

WebTab detail_of(const JudgedClaim& one) {
  WebTab tab{one.claim().name, Json::array()};
  tab.blocks.push_back(facts_block(one));
  if (!one.verdict().warnings.empty()) {
    tab.blocks.push_back(report::web_notes("Warnings", one.verdict().warnings, "warning"));
  }
  for (Json block : {judged_block(one), errors_block(one.verdict())}) {
    if (!block.is_null()) tab.blocks.push_back(std::move(block));
  }
  tab.blocks.push_back(report::web_text("Report", claim_report(one.checked, one.number)));
  return tab;
}

}  // namespace

WebPage check_page(std::span<const CheckedFile> files, std::size_t asked, const io::RunMeta& meta) {
  std::vector<JudgedClaim> claims;
  std::vector<std::string> warnings;
  std::vector<io::InputText> inputs;
  std::string text;
  for (const CheckedFile& checked : files) {
    for (std::size_t k = 0; k < checked.verdicts.size(); ++k) {
      claims.push_back({checked, k});
      for (const std::string& warning : checked.verdicts[k].warnings) {
        if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
      }
    }
    for (io::InputText& input : input_texts(checked.file)) inputs.push_back(std::move(input));
    text += check_report(checked);
  }
  std::string summary = check_summary(files);
  text += summary;
  summary.pop_back();  // its line's end
  WebPage page{files.size() == 1 && asked == 1 ? report::printable(files.front().file.path)
                                               : report::counted(asked, "check file"),
               {summary}};
  page.numbers_in = "";
  if (files.size() < asked) {
    page.lines.push_back(
        fmt::format("interrupted: {} of {} files were judged", files.size(), asked));
  }
  WebTab all{"Claims", Json::array()};
  all.blocks.push_back(claims_block(claims));
  if (!warnings.empty()) all.blocks.push_back(report::web_notes("Warnings", warnings, "warning"));
  page.tabs.push_back(std::move(all));
  WebTab whole{"Report", Json::array()};
  whole.blocks.push_back(report::web_text("Report", text));
  page.tabs.push_back(std::move(whole));
  page.tabs.push_back(report::provenance_tab("", meta, inputs));
  for (const JudgedClaim& one : claims) {
    page.details.push_back(report::part_text(detail_of(one)));
  }
  return page;
}

}  // namespace plastica::sweeps
