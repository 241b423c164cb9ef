#include "sweeps/compare/reference_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "plastica/run/path_stops.hpp"
#include "plastica/run/taken_fibres.hpp"
#include "sweeps/plan/refining.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kNoSize = std::numeric_limits<double>::quiet_NaN();

std::size_t first_of(const std::vector<FieldValue>& values, const FieldValue& value) {
  return static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

/// What an axis says of the problem that a case is of: values that differ by fineness alone have
/// the same number.
std::size_t problem_on(const Axis& axis, std::size_t at, double size) {
  const FieldValue& value = axis.values[at];
  const AxisRole role = axis.apart ? AxisRole::Problem : role_of(*axis.field);
  if (role == AxisRole::Number && size > 0.0) return 0;
  if (role == AxisRole::Word && !is_finest_word(*axis.field, value)) {
    // A coarser word is compared with the first of the finest.
    for (std::size_t k = 0; k < axis.values.size(); ++k) {
      if (is_finest_word(*axis.field, axis.values[k])) return 1 + k;
    }
  }
  return 1 + first_of(axis.values, value);
}

bool differs(const ReferenceSets& all, const ReferenceSet& set, std::size_t axis) {
  const double first = all.size_at(set.cases.front(), axis);
  return std::any_of(set.cases.begin(), set.cases.end(),
                     [&](std::size_t i) { return !same_size(all.size_at(i, axis), first); });
}

bool word_differs(const ReferenceSets& all, const ReferenceSet& set, std::size_t axis) {
  const bool first = all.finest_word_at(set.cases.front(), axis);
  return std::any_of(set.cases.begin(), set.cases.end(),
                     [&](std::size_t i) { return all.finest_word_at(i, axis) != first; });
}

void find_axes(const Sweep& sweep, const ReferenceSets& all, ReferenceSet& set) {
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const Axis& axis = sweep.axes[a];
    const AxisRole role = axis.apart ? AxisRole::Problem : role_of(*axis.field);
    if (axis.values.size() < 2) continue;
    if (role == AxisRole::Number && all.size_at(set.cases.front(), a) > 0.0) {
      (differs(all, set, a) ? set.numbers : set.held).push_back(a);
    }
    if (role == AxisRole::Word && word_differs(all, set, a)) set.words.push_back(a);
  }
}

std::optional<std::size_t> finest_of(const ReferenceSets& all, const ReferenceSet& set,
                                     const std::vector<CaseResult>& results) {
  std::vector<double> least(all.axes, std::numeric_limits<double>::infinity());
  for (const std::size_t i : set.cases) {
    if (!has_outcome(results[i])) continue;
    for (const std::size_t a : set.numbers) least[a] = std::min(least[a], all.size_at(i, a));
  }
  const auto is_finest = [&](std::size_t i) {
    return has_outcome(results[i]) &&
           std::all_of(set.numbers.begin(), set.numbers.end(),
                       [&](std::size_t a) { return same_size(all.size_at(i, a), least[a]); }) &&
           std::all_of(set.words.begin(), set.words.end(),
                       [&](std::size_t a) { return all.finest_word_at(i, a); });
  };
  const auto found = std::find_if(set.cases.begin(), set.cases.end(), is_finest);
  return found == set.cases.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

bool same_size(double a, double b) {
  constexpr double kSame = 1e-9;
  return std::abs(a - b) <= kSame * std::max(std::abs(a), std::abs(b)) ||
         (std::isnan(a) && std::isnan(b));
}

bool has_outcome(const CaseResult& result) {
  return usable(result.status) && (result.value.has_value() || !result.curve.empty());
}

double size_on(const Axis& axis, const Setup& setup) {
  const Refinement refinement = refinement_of(*axis.field);
  if (refinement == Refinement::None) return kNoSize;
  FieldValue value = axis.field->get(setup);
  if (axis.field->path == "solver.time_step") value = taken_time_step(setup.scene, setup.solver);
  if (axis.field->path == "solver.fibres") {
    value = static_cast<double>(taken_fibres(setup.scene, setup.solver));
  }
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || !(*number > 0.0)) return kNoSize;
  return refinement == Refinement::Count ? 1.0 / *number : *number;
}

ReferenceSets reference_sets(const Sweep& sweep, const CaseTable& cases,
                             const std::vector<CaseResult>& results,
                             std::span<const std::string> ids) {
  ReferenceSets all;
  all.axes = sweep.axes.size();
  all.set_of.resize(cases.size());
  all.same_as.resize(cases.size());
  all.size.resize(cases.size() * all.axes, kNoSize);
  all.is_finest.resize(cases.size() * all.axes, false);
  std::map<std::vector<std::size_t>, std::size_t> set_at;
  std::map<std::pair<std::size_t, std::string_view>, std::size_t> first;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::vector<std::size_t> at = cases.position(i);
    const Setup setup = cases.setup(i);
    std::vector<std::size_t> key(all.axes);
    for (std::size_t a = 0; a < all.axes; ++a) {
      const Axis& axis = sweep.axes[a];
      all.size[i * all.axes + a] = size_on(axis, setup);
      all.is_finest[i * all.axes + a] = is_finest_word(*axis.field, axis.values[at[a]]);
      key[a] = problem_on(axis, at[a], all.size[i * all.axes + a]);
    }
    const auto [place, is_new] = set_at.emplace(std::move(key), all.sets.size());
    if (is_new) all.sets.emplace_back();
    all.set_of[i] = place->second;
    const std::string_view id = ids.empty() ? std::string_view() : std::string_view(ids[i]);
    all.same_as[i] = ids.empty() ? i : first.emplace(std::pair(place->second, id), i).first->second;
    if (all.same_as[i] == i) all.sets[place->second].cases.push_back(i);
  }
  for (ReferenceSet& set : all.sets) {
    find_axes(sweep, all, set);
    set.finest = finest_of(all, set, results);
  }
  return all;
}

}  // namespace plastica::sweeps
