#include "cli/frequency_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/model/support_kind.hpp"
#include "plastica/report/format.hpp"
#include "plastica/run/natural_frequencies.hpp"

namespace plastica::cli {
namespace {

constexpr int kShown = 3;
/// Modes of motion that nothing resists, of a rigid body.
constexpr int kMaxFree = 6;
/// Frequencies that are the same to three figures.
constexpr double kSame = 5e-4;

/// "1", "1 and 2", "1, 2 and 3".
std::string listed(const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += i + 1 == values.size() ? " and " : ", ";
    text += report::significant(values[i], 3);
  }
  return text;
}

/// Those about the equilibrium under what acts at time 0, where there is one, and they are others.
std::string loaded_line(const Setup& setup, const std::vector<double>& unloaded) {
  LoadedFrequencies loaded;
  try {
    loaded = natural_frequencies(setup.scene, setup.solver, static_cast<int>(unloaded.size()));
  } catch (const InputError&) {
    return {};  // it flies, or its loads have no potential
  }
  if (loaded.status != Status::Completed) return {};
  bool same = true;
  for (std::size_t i = 0; i < unloaded.size(); ++i) {
    same = same && std::fabs(loaded.frequency[i] - unloaded[i]) <= kSame * unloaded[i];
  }
  return same ? std::string()
              : fmt::format("about its equilibrium under what acts at time 0, at {} Hz\n",
                            listed(loaded.frequency));
}

}  // namespace

std::string frequency_line(const Model& model, const Setup& setup) {
  std::vector<double> frequencies =
      unloaded_frequencies(model, std::min(chain_freedoms(model), kMaxFree + kShown));
  const auto first = std::find_if(frequencies.begin(), frequencies.end(),
                                  [](double frequency) { return frequency > 0.0; });
  const auto free = static_cast<std::size_t>(first - frequencies.begin());
  frequencies.erase(frequencies.begin(), first);
  frequencies.resize(std::min(frequencies.size(), std::size_t{kShown}));
  const auto& supports = setup.scene.supports;
  const bool pillars = std::any_of(supports.begin(), supports.end(), [](const Support& support) {
    return traits_of(support).one_sided;
  });
  const std::string unresisted =
      free == 0 ? ""
                : fmt::format("nothing{} resists {} of motion", pillars ? " but pillars" : "",
                              report::counted(free, "mode"));
  if (frequencies.empty()) return unresisted + "\n";
  const SolverOptions& solver = setup.solver;
  std::vector<double> steps;
  steps.reserve(frequencies.size());
  for (const double frequency : frequencies) steps.push_back(1.0 / (frequency * solver.time_step));
  return fmt::format("unloaded, it swings at {} Hz: {}{} steps a period{}{}\n", listed(frequencies),
                     solver.step_error > 0.0 ? "at least " : "", listed(steps),
                     free == 0 ? "" : "; ", unresisted) +
         (free == 0 ? loaded_line(setup, frequencies) : std::string());
}

}  // namespace plastica::cli
