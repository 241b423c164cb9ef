#include "calibrate/report/shown_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/report/csv_cells.hpp"
#include "calibrate/report/parameter_words.hpp"

namespace plastica::calibrate::report {
namespace {

Json bootstrap_of(const BootstrapResult& bootstrap, const ShownIntervals& shown) {
  if (bootstrap.resamples == 0) return nullptr;
  Json intervals = Json::object();
  for (std::size_t i = 0; i < bootstrap.intervals.size(); ++i) {
    const BootstrapInterval& interval = bootstrap.intervals[i];
    intervals[short_name(shown.parameters.at(i).path)] = {
        {"standard_error", number(interval.standard_error)},
        {"interval", {number(interval.low), number(interval.high)}}};
  }
  return {{"resamples", bootstrap.resamples},
          {"failed", bootstrap.failed},
          {"block", bootstrap.block},
          {"parameters", std::move(intervals)}};
}

template <double LikelihoodProfile::*member>
std::string of_profile(const FitIntervals& all, std::size_t i) {
  return i < all.profiles.size() ? cell_of(all.profiles[i].*member) : std::string();
}

template <ProfileEnd LikelihoodProfile::*member>
std::string end_of_profile(const FitIntervals& all, std::size_t i) {
  return i < all.profiles.size() ? std::string(name_of(all.profiles[i].*member)) : std::string();
}

template <double BootstrapInterval::*member>
std::string of_bootstrap(const FitIntervals& all, std::size_t i) {
  const auto& intervals = all.residuals.intervals;
  return i < intervals.size() ? cell_of(intervals[i].*member) : std::string();
}

bool has_profiles(const FitIntervals& all) { return !all.profiles.empty(); }
bool has_bootstrap(const FitIntervals& all) { return all.residuals.resamples > 0; }

constexpr IntervalColumn kColumns[] = {
    {".profile_low", true, has_profiles, of_profile<&LikelihoodProfile::low>},
    {".profile_high", true, has_profiles, of_profile<&LikelihoodProfile::high>},
    {".profile_low_end", false, has_profiles, end_of_profile<&LikelihoodProfile::low_end>},
    {".profile_high_end", false, has_profiles, end_of_profile<&LikelihoodProfile::high_end>},
    {".bootstrap_low", true, has_bootstrap, of_bootstrap<&BootstrapInterval::low>},
    {".bootstrap_high", true, has_bootstrap, of_bootstrap<&BootstrapInterval::high>}};

}  // namespace

ShownIntervals shown_intervals(const FitOutcome& fit, std::string name) {
  ShownIntervals shown{.name = std::move(name), .parameters = {}, .intervals = &fit.intervals};
  for (const FittedParameter* p : fit.free_parameters()) {
    shown.parameters.push_back({p->path, p->dimension, p->value, p->noise_error, p->scatter_error(),
                                p->sampling_error, p->degrees_of_freedom});
  }
  return shown;
}

DisplayUnit display_unit(const ShownParameter& parameter) {
  return display_unit_of(parameter.path, parameter.dimension, parameter.value);
}

Json intervals_json(const ShownIntervals& shown) {
  const FitIntervals& all = *shown.intervals;
  Json profiles = nullptr;
  for (std::size_t i = 0; i < all.profiles.size(); ++i) {
    const LikelihoodProfile& profile = all.profiles[i];
    profiles[short_name(shown.parameters.at(i).path)] = {
        {"interval", {number(profile.low), number(profile.high)}},
        {"ends", {name_of(profile.low_end), name_of(profile.high_end)}},
        {"threshold", number(profile.threshold)},
        {"value", numbers(profile.value)},
        {"rise", numbers(profile.rise)}};
  }
  return {{"profile", std::move(profiles)},
          {"bootstrap", bootstrap_of(all.residuals, shown)},
          {"bootstrap_specimens", bootstrap_of(all.specimens, shown)}};
}

std::vector<IntervalColumn> interval_columns(std::span<const FitIntervals* const> fits) {
  std::vector<IntervalColumn> columns;
  for (const IntervalColumn& column : kColumns) {
    const bool any =
        std::ranges::any_of(fits, [&](const FitIntervals* fit) { return column.there(*fit); });
    if (any) columns.push_back(column);
  }
  return columns;
}

}  // namespace plastica::calibrate::report
