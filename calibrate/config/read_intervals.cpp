#include "calibrate/config/read_intervals.hpp"

#include <fmt/format.h>

#include <string_view>

namespace plastica::calibrate {

void read_intervals(const io::TomlTable& fit, IntervalOptions& intervals) {
  if (const auto profile = fit.find("profile")) intervals.profile = profile->boolean();
  const auto resamples = [&](std::string_view key, int& value) {
    const auto found = fit.find(key);
    if (!found) return;
    value = static_cast<int>(found->integer(0, kMaxResamples));
    if (value == 0 || value >= kMinResamples) return;
    throw found->error(fmt::format("must be 0, for none, or at least {}", kMinResamples));
  };
  resamples("bootstrap", intervals.bootstrap);
  resamples("bootstrap_specimens", intervals.specimens);
  if (const auto block = fit.find("bootstrap_block")) {
    intervals.block = static_cast<int>(block->integer(1, kMaxResamples));
  }
}

}  // namespace plastica::calibrate
