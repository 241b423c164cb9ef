#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/shown_intervals.hpp"
#include "plastica/report/ink.hpp"
#include "plastica/report/table.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;
using Align = Table::Align;

/// An end, or why there is none.
std::string end_text(const ShownParameter& p, const DisplayUnit& unit, double end, double width,
                     ProfileEnd why) {
  switch (why) {
    case ProfileEnd::Crossed: break;
    case ProfileEnd::Bound: return "bound";
    case ProfileEnd::Open:
    case ProfileEnd::NoCurves: return "open";
  }
  const double error = 0.25 * width / unit.scale;
  const double value = end / unit.scale;
  if (!(error >= 1e-6) || std::fabs(value) >= 1e7) return significant(value);
  return fmt::format("{:.{}f}", value, decimals_for(p.value / unit.scale, error));
}

std::string range_text(const ShownParameter& p, const DisplayUnit& unit, double low, double high,
                       ProfileEnd low_end = ProfileEnd::Crossed,
                       ProfileEnd high_end = ProfileEnd::Crossed) {
  if (!std::isfinite(low) || !std::isfinite(high)) return "-";
  // Digits are those of the side that ends.
  double width = high - low;
  if (low_end != ProfileEnd::Crossed) width = 2.0 * (high - p.value);
  if (high_end != ProfileEnd::Crossed) width = 2.0 * (p.value - low);
  return end_text(p, unit, low, width, low_end) + " … " + end_text(p, unit, high, width, high_end);
}

/// Half the interval that the covariance gives, of noise and sampling as the others are; NaN where
/// one of them is not known: older files do not say the degrees of freedom.
double reach_of(const ShownParameter& p, double confidence) {
  if (!std::isfinite(p.noise_error)) return p.noise_error;
  if (!(p.degrees_of_freedom > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const double half = std::sqrt(3.0) * p.sampling_error;
  return theory::half_interval(confidence, p.noise_error, p.degrees_of_freedom, {&half, 1});
}

std::string profile_text(const ShownParameter& p, const DisplayUnit& unit,
                         const LikelihoodProfile& profile) {
  if (!std::isfinite(profile.low) || !std::isfinite(profile.high)) return "-";
  const bool flat =
      profile.low_end != ProfileEnd::Crossed && profile.high_end != ProfileEnd::Crossed;
  if (flat) return "open … open";
  return range_text(p, unit, profile.low, profile.high, profile.low_end, profile.high_end);
}

std::string bootstrap_note(std::string_view of, const BootstrapResult& bootstrap) {
  std::string text =
      fmt::format("{}: percentiles of {}", of,
                  counted(static_cast<std::size_t>(bootstrap.resamples), "resample"));
  if (bootstrap.block > 1) text += fmt::format(", residuals in blocks of {}", bootstrap.block);
  if (bootstrap.failed > 0) text += fmt::format("; {} failed", bootstrap.failed);
  return text;
}

}  // namespace

std::string intervals_text(const ShownIntervals& shown, const ReportOptions& options) {
  const FitIntervals& all = *shown.intervals;
  const std::size_t n = shown.parameters.size();
  const bool profiled = all.profiles.size() == n && n > 0;
  std::vector<Table::Column> columns = {
      {"", Align::Left}, {"", Align::Left}, {"covariance", Align::Range}};
  if (profiled) columns.push_back({"profile", Align::Range});
  std::vector<const BootstrapResult*> bootstraps;
  for (const auto& [name, bootstrap] :
       {std::pair{"residuals", &all.residuals}, std::pair{"specimens", &all.specimens}}) {
    if (bootstrap->resamples == 0 || bootstrap->intervals.size() != n) continue;
    columns.push_back({std::string("bootstrap, ") + name, Align::Range});
    bootstraps.push_back(bootstrap);
  }
  if (!profiled && bootstraps.empty()) return {};
  Table table(std::move(columns));
  for (std::size_t i = 0; i < n; ++i) {
    const ShownParameter& p = shown.parameters[i];
    const DisplayUnit unit = report::display_unit(p);
    const double reach = reach_of(p, options.confidence);
    std::vector<std::string> cells = {short_name(p.path), std::string(unit.name),
                                      range_text(p, unit, p.value - reach, p.value + reach)};
    if (profiled) cells.push_back(profile_text(p, unit, all.profiles[i]));
    for (const BootstrapResult* bootstrap : bootstraps) {
      const BootstrapInterval& interval = bootstrap->intervals[i];
      cells.push_back(range_text(p, unit, interval.low, interval.high));
    }
    table.add(std::move(cells));
  }
  const Ink ink(options.color);
  std::string text =
      '\n' + ink.heading(fmt::format("Intervals of {:.4g} %\n", 100.0 * options.confidence)) +
      table.text(2, kWidth);
  if (profiled) {
    const auto ends = [&](ProfileEnd why) {
      return std::ranges::any_of(all.profiles, [&](const LikelihoodProfile& profile) {
        return std::isfinite(profile.low) && (profile.low_end == why || profile.high_end == why);
      });
    };
    // Student's t of each parameter's own degrees of freedom.
    const auto [least, most] = std::ranges::minmax(all.profiles, {}, &LikelihoodProfile::threshold);
    std::string rise = significant(least.threshold, 3);
    if (const std::string other = significant(most.threshold, 3); other != rise) {
      rise += " to " + other;
    }
    std::string note = "profile: where the least cost has risen by " + rise;
    if (ends(ProfileEnd::Bound)) note += "; bound: it has not, up to the parameter's bound";
    if (ends(ProfileEnd::Open)) note += "; open: it has not, as far as it was followed";
    if (ends(ProfileEnd::NoCurves)) note += "; open: beyond there are no curves";
    text += wrapped("  ", note, kWidth);
  }
  text += wrapped("  ", "none of these holds what segments and lack of fit do", kWidth);
  for (const BootstrapResult* bootstrap : bootstraps) {
    text += wrapped(
        "  ", bootstrap_note(bootstrap == &all.residuals ? "residuals" : "specimens", *bootstrap),
        kWidth);
  }
  return text;
}

}  // namespace plastica::calibrate::report
