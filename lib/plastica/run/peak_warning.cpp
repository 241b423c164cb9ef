#include "plastica/run/peak_warning.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace plastica {

std::vector<std::string> peak_warnings(const Response& response) {
  const std::vector<double>& time = response.chain.time;
  const std::vector<double>& factor = response.chain.factor;
  const std::size_t samples = std::min({response.samples, time.size(), factor.size()});
  for (std::size_t i = 1; i < samples; ++i) {
    if (time[i] >= time[i - 1]) continue;
    return {fmt::format(
        "the path passes a peak at a factor of {:.4g}: beyond it less is needed for equilibrium, "
        "and a beam that keeps its loads would not stay there; solver.control = \"load\" ends at "
        "the peak",
        factor[i - 1])};
  }
  return {};
}

}  // namespace plastica
