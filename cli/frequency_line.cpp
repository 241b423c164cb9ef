#include "cli/frequency_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "plastica/report/format.hpp"
#include "plastica/run/natural_frequencies.hpp"

namespace plastica::cli {
namespace {

/// About a tenth of a second.
constexpr int kMostFreedoms = 600;
constexpr std::size_t kShown = 3;

/// "1", "1 and 2", "1, 2 and 3".
std::string listed(const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += i + 1 == values.size() ? " and " : ", ";
    text += report::significant(values[i], 3);
  }
  return text;
}

}  // namespace

std::string frequency_line(const Model& model, const Setup& setup) {
  const int freedoms = chain_freedoms(model);
  if (freedoms > kMostFreedoms) {
    return fmt::format("natural frequencies are not sought of more than {} ways to move: {}\n",
                       kMostFreedoms, freedoms);
  }
  std::vector<double> frequencies = natural_frequencies(model, freedoms);
  const auto first = std::find_if(frequencies.begin(), frequencies.end(),
                                  [](double frequency) { return frequency > 0.0; });
  const auto free = static_cast<std::size_t>(first - frequencies.begin());
  frequencies.erase(frequencies.begin(), first);
  frequencies.resize(std::min(frequencies.size(), kShown));
  const auto& supports = setup.scene.supports;
  const bool pillars = std::any_of(supports.begin(), supports.end(), [](const Support& support) {
    return support.kind == SupportKind::Pillar;
  });
  const std::string unresisted =
      free == 0 ? ""
                : fmt::format("nothing{} resists {} to move", pillars ? " but pillars" : "",
                              report::counted(free, "way"));
  if (frequencies.empty()) return unresisted + "\n";
  const SolverOptions& solver = setup.solver;
  std::vector<double> steps;
  steps.reserve(frequencies.size());
  for (const double frequency : frequencies) steps.push_back(1.0 / (frequency * solver.time_step));
  return fmt::format("unloaded, it swings at {} Hz: {}{} steps a period{}{}\n", listed(frequencies),
                     solver.step_error > 0.0 ? "at least " : "", listed(steps),
                     free == 0 ? "" : "; ", unresisted);
}

}  // namespace plastica::cli
