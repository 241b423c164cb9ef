#include "sweeps/trade/recommend_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plastica::sweeps {
namespace {

std::string percent(double fraction) { return fmt::format("{:.3g} %", 100.0 * fraction); }

std::string cost_text(const CaseResult& result, CostKind cost) {
  std::string text = fmt::format("{} segment-iterations", result.segment_iterations());
  if (cost == CostKind::Seconds) text += fmt::format(", {:.3g} ms", 1e3 * result.seconds);
  return text;
}

/// What a promised error is made of, where the reference is one of the cases' own.
std::string made_of(const SweepRecord& record, std::size_t index) {
  const auto& own = record.comparison.error[index];
  const auto& of_reference = record.comparison.reference_error[index];
  if (!of_reference || !promised_error(record, index)) return "";
  if (!own) return " (it is the reference itself)";
  return fmt::format(" ({} and {} of the reference)", percent(std::abs(*own)),
                     percent(*of_reference));
}

std::string case_text(const SweepRecord& record, CostKind cost, std::size_t index) {
  const auto error = promised_error(record, index);
  return fmt::format("{}\n    error {}{}, {}\n", setting_text(record, index),
                     error ? percent(*error) : "unknown", made_of(record, index),
                     cost_text(record.results[index], cost));
}

std::string wish_text(CostKind cost, const Wish& wish) {
  if (wish.within) return "within " + percent(*wish.within);
  return cost == CostKind::Seconds ? fmt::format("for {:.3g} ms", 1e3 * *wish.budget)
                                   : fmt::format("for {:.6g} segment-iterations", *wish.budget);
}

/// Why no case has an error that could be promised: what the first says that ran.
std::string why_nothing(const SweepRecord& record) {
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (!usable(record.results[i].status)) continue;
    const std::string& lacks = record.comparison.lacks[i];
    const std::string& own = record.results[i].reason;
    const std::string& reason = own.empty() ? record.comparison.reason[i] : own;
    if (!lacks.empty()) {
      return fmt::format("nothing can be recommended: {}\n",
                         error_alone(record.axes[*record.refined].field->path, lacks));
    }
    if (!reason.empty()) return fmt::format("nothing can be recommended: {}\n", reason);
  }
  return "no case has an error: all failed\n";
}

/// What is not in a promised error, and what is.
std::string notes_text(const SweepRecord& record) {
  std::string text;
  for (const std::string& note : record.comparison.notes) text += "note: " + note + "\n";
  return text;
}

std::string luck_text(const Recommendation& choice) {
  if (!choice.lucky) return {};
  return fmt::format(
      "    by luck: a finer case is off by {}; take a finer one, or look at the plot\n",
      percent(choice.assured_error));
}

/// What the next case that a budget does not allow has over the one that it does.
std::string_view better_of_next(const SweepRecord& record, const Recommendation& choice) {
  const bool is_less =
      promised_error(record, *choice.next) < promised_error(record, *choice.chosen);
  return is_less ? "next more accurate, too costly" : "next whose error is no luck, too costly";
}

std::string none_text(const SweepRecord& record, CostKind cost, const Wish& wish,
                      const Recommendation& choice) {
  switch (choice.why_none) {
    case NoChoice::NoPoints: return "the sweep has no case\n";
    case NoChoice::AllFailed: return why_nothing(record);
    default: break;
  }
  return fmt::format("nothing {}; the nearest is\n  {}", wish_text(cost, wish),
                     case_text(record, cost, *choice.nearest)) +
         luck_text(choice) + notes_text(record);
}

}  // namespace

std::string recommendation_text(const SweepRecord& record, CostKind cost, const Wish& wish,
                                const Recommendation& choice) {
  if (!choice.chosen) return none_text(record, cost, wish, choice);
  std::string text = fmt::format("{} {}: {}", wish.within ? "cheapest" : "most accurate",
                                 wish_text(cost, wish), case_text(record, cost, *choice.chosen));
  text += fmt::format("    margin {:.3g}: {}\n", choice.margin,
                      wish.within ? "the wanted error over its own" : "the budget over its cost");
  text += luck_text(choice);
  if (choice.next) {
    text += fmt::format("{}: {}",
                        wish.within ? "next cheaper, not within" : better_of_next(record, choice),
                        case_text(record, cost, *choice.next));
  } else if (!choice.passed_over) {
    text += wish.within ? "nothing is cheaper\n" : "nothing is more accurate\n";
  }
  if (choice.passed_over) {
    text += "passed over, since a finer case misses what it meets by luck: " +
            case_text(record, cost, *choice.passed_over);
  }
  return text + notes_text(record);
}

}  // namespace plastica::sweeps
