#include "sweeps/advise/advice_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {
namespace {

std::string percent(double fraction) {
  return std::isfinite(fraction) ? fmt::format("{:.3g} %", 100.0 * fraction) : "unknown";
}

std::string cost_text(std::int64_t work, double seconds) {
  return fmt::format("{} segment-iterations, {:.3g} ms", work, 1e3 * seconds);
}

std::string error_text(const TriedSetting& one) {
  return std::isfinite(one.error) ? "error " + percent(one.error) : "no error: " + one.reason;
}

/// Why nothing was found.
std::string why_nothing(const Advice& advice) {
  switch (advice.end) {
    case AdviceEnd::Interrupted: return "interrupted";
    case AdviceEnd::AtFinest: return "not at the finest there is";
    case AdviceEnd::TooMuchWork: return "not for the work that is allowed (--max-work)";
    case AdviceEnd::Diverging: return "refinement does not make the error smaller";
    case AdviceEnd::TooManyRuns:
    case AdviceEnd::Found: break;
  }
  return "not in the runs that are allowed (--max-runs)";
}

std::string head(const Advice& advice, const AdviceOptions& options, const std::string& name) {
  const std::string within = percent(options.within);
  if (advice.end == AdviceEnd::Found) return fmt::format("{}, within {}:\n", name, within);
  return fmt::format("{}: nothing within {}: {}; the last setting:\n", name, within,
                     why_nothing(advice));
}

std::string budget_text(const Advice& advice) {
  std::string text;
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    const std::string value = value_text(*advice.axes[k].field, advice.setting[k]);
    text += fmt::format("  {:<18} = {:<10}", advice.axes[k].field->path, value);
    if (k < advice.budget.size()) {
      const BudgetLine& line = advice.budget[k];
      text += fmt::format("  error {}", percent(line.error));
      if (line.error > 0.0 && std::isfinite(line.error)) {
        text += line.order_seen ? fmt::format(", order {:.2g}", line.order)
                                : fmt::format(", order {:.2g} supposed", line.order);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace

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
  std::string text = head(advice, options, name) + budget_text(advice);
  if (!advice.reason.empty()) text += fmt::format("  not converged: {}\n", advice.reason);
  if (!advice.worst.empty()) text += fmt::format("  the largest is of {}\n", advice.worst);
  if (advice.end == AdviceEnd::Found) {
    text += fmt::format("  together at most {}; a run that is twice as fine in each is {} off\n",
                        percent(advice.promised), percent(advice.verified));
    text += fmt::format("  cost {}\n", cost_text(advice.work, advice.seconds));
  }
  if (advice.next_cheaper) {
    text += fmt::format("next cheaper, not within: {}\n  {}, {}\n",
                        setting_text(advice.axes, advice.next_cheaper->setting),
                        error_text(*advice.next_cheaper),
                        cost_text(advice.next_cheaper->work, advice.next_cheaper->seconds));
  }
  if (!advice.own.setting.empty() && advice.end == AdviceEnd::Found) {
    text +=
        fmt::format("the file's own: {}\n  {}, {}\n", setting_text(advice.axes, advice.own.setting),
                    error_text(advice.own), cost_text(advice.own.work, advice.own.seconds));
  }
  text +=
      fmt::format("the advice took {} runs, {:.3g} ms", advice.runs, 1e3 * advice.total_seconds);
  if (advice.end == AdviceEnd::Found && advice.work > 0) {
    text += fmt::format(", {:.3g} times the work of the advised one",
                        static_cast<double>(advice.total_work) / static_cast<double>(advice.work));
  }
  text += '\n';
  for (const std::string& probe : advice.left_out) {
    text += fmt::format("note: {} is not looked at: it is given, or an error itself\n", probe);
  }
  return text;
}

}  // namespace plastica::sweeps
