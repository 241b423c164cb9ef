#include <algorithm>
#include <map>
#include <utility>

#include "sweeps/compare/comparison.hpp"
#include "sweeps/compare/reference_sets.hpp"
#include "sweeps/plan/refining.hpp"

namespace plastica::sweeps {
namespace {

/// Whether an axis refines with the refined one.
bool moves_along(const Sweep& sweep, std::size_t axis) {
  const std::string& group = sweep.axes[*sweep.refined].group;
  const bool together = !group.empty() && sweep.axes[axis].group == group;
  return axis == *sweep.refined ||
         (together && refinement_of(*sweep.axes[axis].field) != Refinement::None);
}

std::string label_of(const Sweep& sweep, const std::vector<std::size_t>& at) {
  std::string label;
  for (std::size_t a = 0; a < at.size(); ++a) {
    const Axis& axis = sweep.axes[a];
    if (moves_along(sweep, a) || axis.values.size() == 1) continue;
    if (!label.empty()) label += ", ";
    label += std::string(axis.field->path) + " = " + value_text(*axis.field, axis.values[at[a]]);
  }
  return label;
}

void sort_by_size(RefinementGroup& group) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < group.cases.size(); ++k) {
    order.emplace_back(-group.size[k], group.cases[k]);
  }
  std::sort(order.begin(), order.end());
  group.cases.clear();
  group.size.clear();
  for (const auto& [minus_size, index] : order) {
    group.cases.push_back(index);
    group.size.push_back(-minus_size);
  }
}

}  // namespace

std::vector<std::size_t> RefinementGroup::distinct() const {
  constexpr double kSame = 1e-9;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < size.size(); ++k) {
    if (places.empty() || size[k] < size[places.back()] * (1.0 - kSame)) places.push_back(k);
  }
  return places;
}

std::vector<RefinementGroup> refinement_groups(const Sweep& sweep, const CaseTable& cases) {
  std::vector<RefinementGroup> groups;
  if (!sweep.refined) return groups;
  std::map<std::vector<std::size_t>, std::size_t> group_at;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::vector<std::size_t> at = cases.position(i);
    const Setup setup = cases.setup(i);
    std::vector<std::size_t> key = at;
    for (std::size_t a = 0; a < key.size(); ++a) {
      const auto& values = sweep.axes[a].values;
      // Zipped axes repeat their values.
      const auto same = std::find(values.begin(), values.end(), values[key[a]]);
      const bool along = moves_along(sweep, a) && size_on(sweep.axes[a], setup) > 0.0;
      key[a] = along ? 0 : 1 + static_cast<std::size_t>(same - values.begin());
    }
    const auto [place, is_new] = group_at.emplace(std::move(key), groups.size());
    if (is_new) groups.push_back({label_of(sweep, at), {}, {}});
    groups[place->second].cases.push_back(i);
    groups[place->second].size.push_back(size_on(sweep.axes[*sweep.refined], setup));
  }
  for (RefinementGroup& group : groups) sort_by_size(group);
  return groups;
}

}  // namespace plastica::sweeps
