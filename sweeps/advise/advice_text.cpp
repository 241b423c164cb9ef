#include "sweeps/advise/advice_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plastica/report/format.hpp"
#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {
namespace {

std::string cost_text(std::int64_t work, double seconds) {
  return fmt::format("{} segment-iterations, {:.3g} ms", work, 1e3 * seconds);
}

std::string error_text(const TriedSetting& one) {
  return std::isfinite(one.error) ? "error " + error_percent(one.error)
         : one.reason.empty()     ? "error unknown"
                                  : "error unknown: " + one.reason;
}

/// Why nothing was found.
std::string why_nothing(const Advice& advice) {
  switch (advice.end) {
    case AdviceEnd::Interrupted: return "interrupted";
    case AdviceEnd::AtFinest: return "not at the finest there is";
    case AdviceEnd::TooMuchWork: return "not for the work that is allowed (--max-work)";
    case AdviceEnd::TooDear: return "what is cheapest takes longer";
    case AdviceEnd::Diverging: return "refinement does not make the error smaller";
    case AdviceEnd::TooManyRuns:
    case AdviceEnd::Found: break;
  }
  return "not in the runs that are allowed (--max-runs)";
}

std::string head(const Advice& advice, const AdviceOptions& options, const std::string& name) {
  const std::string wish = options.budget > 0.0 ? fmt::format("for {:.3g} ms", 1e3 * options.budget)
                                                : "within " + error_percent(options.within);
  if (advice.end == AdviceEnd::Found) return fmt::format("{}, {}:\n", name, wish);
  return fmt::format("{}: nothing {}: {}; the {} setting:\n", name, wish, why_nothing(advice),
                     advice.end == AdviceEnd::TooDear ? "cheapest" : "last");
}

std::string line_of(const Field& field, const std::string& value) {
  return fmt::format("  {:<18} = {:<10}", field.path, value);
}

std::string numbers_text(const Advice& advice) {
  std::string text;
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    text += line_of(*advice.axes[k].field, value_text(*advice.axes[k].field, advice.setting[k]));
    if (k < advice.budget.size()) {
      const BudgetLine& line = advice.budget[k];
      text += fmt::format("  error {}", error_percent(line.error));
      if (line.error > 0.0 && std::isfinite(line.error)) {
        text += line.order_seen ? fmt::format(", order {:.2g}", line.order)
                                : fmt::format(", order {:.2g} supposed", line.order);
      }
    }
    text += '\n';
  }
  return text;
}

std::string graded_text(const Advice& advice) {
  if (advice.fractions.empty()) return {};
  const auto [shortest, longest] = std::ranges::minmax(advice.fractions);
  std::string text = fmt::format("  beam.segment_lengths: {}, from {} to {} of the length",
                                 advice.even ? "graded" : "with ends at the probes",
                                 error_percent(shortest), error_percent(longest));
  if (advice.even && advice.cost > 0.0) {
    text += fmt::format("; {:.0f} even ones would be {:.2g} times the cost",
                        advice.even->setting.front(), advice.even->cost / advice.cost);
  }
  return text + "\n";
}

/// The word that is told beside the chosen one: of models the next simpler one, else the next
/// richer; of methods the cheapest of the others.
const OtherWord* told(const WordAxis& axis, std::size_t chosen, const WordLine& line) {
  const OtherWord* found = nullptr;
  for (const OtherWord& other : line.others) {
    const bool nearer = axis.kind == WordKind::Method ? found == nullptr || other.cost < found->cost
                                                      : other.choice < chosen || found == nullptr;
    if (nearer) found = &other;
  }
  return found;
}

std::string other_text(const WordAxis& axis, std::size_t chosen, const OtherWord& other) {
  const std::string word = axis.choices[other.choice].text();
  if (!std::isfinite(other.error)) return fmt::format("; {} will not do: {}", word, other.reason);
  std::string text = fmt::format("; {} would be {:.2g} times the cost", word, other.cost);
  if (axis.kind == WordKind::Method) return text;
  return other.choice < chosen ? text + fmt::format(" and {} off", error_percent(other.error))
                               : text;
}

std::string words_text(const Advice& advice) {
  std::string text;
  for (std::size_t w = 0; w < advice.word_axes.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    const std::size_t chosen = advice.words[w];
    text += line_of(axis.field(), axis.choices[chosen].text());
    if (!advice.word_budget.empty()) {
      const WordLine& line = advice.word_budget[w];
      text += axis.kind == WordKind::Model ? fmt::format("  error {}", error_percent(line.error))
                                           : "  its error is in the numbers";
      if (const OtherWord* other = told(axis, chosen, line))
        text += other_text(axis, chosen, *other);
    }
    text += '\n';
    if (!axis.note.empty()) text += fmt::format("    {}\n", axis.note);
  }
  return text;
}

}  // namespace

std::string error_percent(double fraction) {
  return std::isfinite(fraction) ? fmt::format("{:.3g} %", 100.0 * fraction) : "unknown";
}

std::string setting_text(const Advice& advice, const TriedSetting& one) {
  std::string text = setting_text(advice.axes, one.setting);
  for (std::size_t w = 0; w < one.words.size(); ++w) {
    if (one.words[w] == advice.words[w]) continue;
    const WordAxis& axis = advice.word_axes[w];
    text += fmt::format(", {} = {}", axis.field().path, axis.choices[one.words[w]].text());
  }
  if (!one.fractions.empty()) text += ", uneven";
  return text;
}

std::string setting_text(const std::vector<FinenessAxis>& axes, const Setting& setting) {
  std::string text;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", axes[k].field->path,
                        value_text(*axes[k].field, setting[k]));
  }
  return text;
}

std::string advice_text(const Advice& advice, const AdviceOptions& options,
                        const std::string& name) {
  std::string text =
      head(advice, options, name) + numbers_text(advice) + graded_text(advice) + words_text(advice);
  if (!advice.reason.empty()) text += fmt::format("  not converged: {}\n", advice.reason);
  if (!advice.worst.empty()) text += fmt::format("  the largest is of {}\n", advice.worst);
  if (advice.end == AdviceEnd::Found) {
    text += fmt::format(
        "  together at most {}; a run that is finer in each, and richest, is {}{} off\n",
        error_percent(advice.promised), advice.words_settled ? "at most " : "",
        error_percent(advice.verified));
  }
  if (advice.end == AdviceEnd::Found || advice.end == AdviceEnd::TooDear) {
    text += fmt::format("  cost {} (median of such runs' time for that work)\n",
                        cost_text(advice.work, advice.expected_seconds));
  }
  if (advice.cut_short) {
    text += fmt::format("  a more accurate one may fit: the search for it was ended by {}\n",
                        *advice.cut_short == AdviceEnd::TooManyRuns ? "--max-runs" : "--max-work");
  }
  if (advice.next_cheaper) {
    text +=
        fmt::format("next cheaper, not within: {}\n  {}, {}\n",
                    setting_text(advice, *advice.next_cheaper), error_text(*advice.next_cheaper),
                    cost_text(advice.next_cheaper->work, advice.next_cheaper->seconds));
  }
  if (!advice.own.setting.empty() && advice.end == AdviceEnd::Found) {
    text += fmt::format(
        "the file's own: {}\n  {}{}\n", setting_text(advice, advice.own), error_text(advice.own),
        advice.own.work > 0 ? ", " + cost_text(advice.own.work, advice.own.seconds) : "");
  }
  text +=
      fmt::format("the advice took {} runs, {:.3g} ms", advice.runs, 1e3 * advice.total_seconds);
  if (advice.end == AdviceEnd::Found && advice.work > 0) {
    text += fmt::format(", {:.3g} times the work of the advised one",
                        static_cast<double>(advice.total_work) / static_cast<double>(advice.work));
  }
  text += '\n';
  for (const std::string& probe : advice.left_out) {
    text += fmt::format(
        "note: {} is not looked at: it is given, an error itself, or falls with a joint's length\n",
        probe);
  }
  for (const std::string& warning : advice.warnings) {
    text += "warning: " + report::printable(warning) + "\n";
  }
  return text;
}

}  // namespace plastica::sweeps
