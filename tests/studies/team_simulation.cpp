#include "tests/studies/team_simulation.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "plastica/base/guided_parts.hpp"

namespace plastica::testing {
namespace {

using Part = GuidedParts::Part;

std::vector<Part> parts_of(std::size_t count, std::size_t processes, Dealing dealing) {
  std::vector<Part> parts;
  if (dealing == Dealing::Guided) {
    const GuidedParts guided(count, processes);
    for (std::size_t k = 0; k < guided.size(); ++k) parts.push_back(guided[k]);
    return parts;
  }
  const std::size_t size = dealing == Dealing::Single
                               ? 1
                               : std::max<std::size_t>(1, (count + processes - 1) / processes);
  for (std::size_t begin = 0; begin < count; begin += size) {
    parts.push_back({begin, std::min(count, begin + size)});
  }
  return parts;
}

}  // namespace

TeamRun simulate_team(std::span<const double> seconds, std::size_t processes, Dealing dealing,
                      const TeamCosts& costs) {
  const std::vector<Part> parts = parts_of(seconds.size(), processes, dealing);
  const std::size_t machines = (processes + costs.per_machine - 1) / costs.per_machine;
  const double begin = costs.start + costs.read +
                       costs.read_bytes * static_cast<double>(machines) / costs.server_rate;
  TeamRun run;
  double desk = begin;  // when process 0 has answered all so far
  double end = begin;
  std::size_t next = 0;
  // Who asks next: the time of the question, and of whom.
  using Question = std::pair<double, std::size_t>;
  std::priority_queue<Question, std::vector<Question>, std::greater<>> questions;
  for (std::size_t rank = 0; rank < processes; ++rank) questions.emplace(begin, rank);
  while (!questions.empty()) {
    auto [time, rank] = questions.top();
    questions.pop();
    if (rank > 0) {
      ++run.asked;
      desk = std::max(desk, time + 0.5 * costs.ask) + costs.answer;
      time = desk + 0.5 * costs.ask;
    }
    if (next == parts.size()) {
      end = std::max(end, time);
      continue;
    }
    const Part part = parts[next++];
    for (std::size_t i = part.begin; i < part.end; ++i) time += seconds[i] + costs.keep;
    questions.emplace(time, rank);
  }
  run.shared = end - begin;
  run.whole = end + costs.open * static_cast<double>(processes - 1) +
              costs.merge * static_cast<double>(seconds.size());
  return run;
}

double efficiency(std::span<const double> seconds, std::size_t processes, double whole) {
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  return sum / (static_cast<double>(processes) * whole);
}

}  // namespace plastica::testing
