#include "calibrate/inference/intervals.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plastica/base/check.hpp"

namespace plastica::calibrate {

void check_intervals(const IntervalOptions& options) {
  const auto require = [](bool holds, std::string_view field, int value, const std::string& rule) {
    if (!holds) throw InputError({}, field, fmt::format("{}", value), rule);
  };
  const auto check_count = [&](std::string_view field, int count) {
    const bool enough = count >= kMinResamples && count <= kMaxResamples;
    require(count == 0 || enough, field, count,
            fmt::format("must be 0, for none, or {} to {}", kMinResamples, kMaxResamples));
  };
  check_count("bootstrap", options.bootstrap);
  check_count("bootstrap_specimens", options.specimens);
  require(options.block >= 1, "bootstrap_block", options.block, "must be at least 1");
}

void add_warnings(const FitIntervals& intervals, std::span<const std::string> names,
                  std::string_view search_again, std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < intervals.profiles.size(); ++i) {
    constexpr double kLower = 0.01;
    const LikelihoodProfile& profile = intervals.profiles[i];
    double least = 0.0;
    for (const double rise : profile.rise) least = std::min(least, rise);
    if (least >= -kLower * profile.threshold) continue;
    warnings.push_back(
        fmt::format("the profile of {} found a lower cost than the search, by {:.2g}: {}", names[i],
                    -least, search_again));
  }
  for (const BootstrapResult* bootstrap : {&intervals.residuals, &intervals.specimens}) {
    constexpr double kMany = 0.05;
    if (bootstrap->failed <= kMany * bootstrap->resamples) continue;
    warnings.push_back(
        fmt::format("{} of {} searches of the {} bootstrap failed: its intervals "
                    "are those of the others",
                    bootstrap->failed, bootstrap->resamples,
                    bootstrap == &intervals.residuals ? "residual" : "specimen"));
  }
}

}  // namespace plastica::calibrate
