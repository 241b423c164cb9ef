#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "calibrate/trial/scene_model.hpp"
#include "plastica/base/parallel_for.hpp"

/// Which runs a model makes, and side by side with which.
namespace plastica::calibrate {
namespace {

SceneCurve failed(std::string reason) {
  SceneCurve curve;
  curve.reason = std::move(reason);
  return curve;
}

/// Points that are run together, the lead first.
using Group = std::vector<std::size_t>;

std::vector<Group> groups_of(std::span<const std::size_t> leads) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < leads.size(); ++i) {
    if (leads[i] != i) continue;
    Group& group = groups.emplace_back(Group{i});
    for (std::size_t k = i + 1; k < leads.size(); ++k) {
      if (leads[k] == i) group.push_back(k);
    }
  }
  return groups;
}

/// In parts that have each a lead of their own: for threads that would have no work, and where the
/// companions of one would be too many. A lead counts once, however many parts run it.
std::vector<Group> dealt(const std::vector<Group>& groups, int threads, std::size_t most) {
  std::vector<Group> parts;
  for (const Group& group : groups) {
    const std::size_t companions = group.size() - 1;
    const std::size_t free_threads = static_cast<std::size_t>(threads) / groups.size();
    const std::size_t count =
        std::max(std::min(free_threads, companions), (companions + most - 1) / most);
    for (std::size_t part = 0; part < count; ++part) {
      Group& own = parts.emplace_back(Group{group.front()});
      for (std::size_t k = part; k < companions; k += count) own.push_back(group[1 + k]);
    }
  }
  return parts;
}

}  // namespace

std::vector<SceneCurve> SceneModel::run(std::span<const double> values, std::size_t count,
                                        int threads, StopFlag stop,
                                        std::span<const std::size_t> leads) const {
  BatchOptions how;
  how.threads = threads;
  how.stop = stop;
  std::vector<std::size_t> own(count);
  std::iota(own.begin(), own.end(), std::size_t{0});
  if (leads.empty() || !has_companions()) leads = own;
  std::vector<SceneCurve> curves = run(false, values, leads, how);
  if (extended_) extend(values, leads, how, curves);
  return curves;
}

std::string SceneModel::slopes_from() const {
  if (has_companions()) return "companions";
  const std::string_view why = why_no_companion(model_);
  return fmt::format("runs of their own: {}", why.empty() ? "it is too large for companions" : why);
}

/// Runs those again whose path ends early.
void SceneModel::extend(std::span<const double> values, std::span<const std::size_t> leads,
                        const BatchOptions& how, std::vector<SceneCurve>& curves) const {
  std::vector<std::size_t> early;
  std::vector<std::size_t> their_leads;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i].ends_early) continue;
    const auto lead = std::ranges::find(early, leads[i]);
    their_leads.push_back(static_cast<std::size_t>(lead - early.begin()));  // or its own number
    early.push_back(i);
  }
  if (early.empty()) return;
  std::vector<SceneCurve> extended = run(true, values_of(values, early), their_leads, how);
  for (std::size_t k = 0; k < early.size(); ++k) {
    SceneCurve& curve = curves[early[k]];
    if (!extended[k].was_run) {
      curve.reason = std::move(extended[k].reason);
      continue;
    }
    extended[k].segment_iterations += curve.segment_iterations;
    if (!extended[k].usable) {
      extended[k].reason += fmt::format(" (its ramps going on to {} times their ends)", kMaxTimes);
    }
    curve = std::move(extended[k]);
  }
}

std::vector<SceneCurve> SceneModel::run(bool is_extended, std::span<const double> values,
                                        std::span<const std::size_t> leads,
                                        const BatchOptions& how) const {
  std::vector<Group> together = groups_of(leads);
  std::vector<std::size_t> alone;
  std::erase_if(together, [&](const Group& group) {
    if (group.size() == 1) alone.push_back(group.front());
    return group.size() == 1;
  });
  std::vector<SceneCurve> curves(leads.size());
  std::vector<SceneCurve> own = run_alone(is_extended, values, alone, how);
  for (std::size_t i = 0; i < alone.size(); ++i) curves[alone[i]] = std::move(own[i]);
  const Model& model = is_extended ? *extended_ : model_;
  const std::vector<Group> parts =
      dealt(together, resolved_threads(how.threads), most_companions(model));
  std::vector<std::vector<SceneCurve>> found(parts.size());
  parallel_for(parts.size(), {how.threads, how.stop}, [&](std::size_t k, int) {
    found[k] = run_together(is_extended, values, parts[k], how.stop);
  });
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (std::size_t i = 0; i < found[k].size(); ++i) {
      curves[parts[k][i]] = std::move(found[k][i]);
    }
  }
  return curves;
}

std::vector<double> SceneModel::values_of(std::span<const double> values,
                                          std::span<const std::size_t> which) const {
  std::vector<double> own;
  for (const std::size_t i : which) {
    const std::span<const double> at = values.subspan(i * fields_.size(), fields_.size());
    own.insert(own.end(), at.begin(), at.end());
  }
  return own;
}

SceneCurve SceneModel::curve_at(bool is_extended, std::span<const double> values,
                                const Response& response) const {
  const Setup& setup = is_extended ? *extended_setup_ : setup_;
  const Model& model = is_extended ? *extended_ : model_;
  return curve_of(response, joints_of_the_limit(setup, model, values), is_extended);
}

SceneCurve SceneModel::curve_at(bool is_extended, std::span<const double> values,
                                const BatchRow& row) const {
  return row.reason.empty() ? curve_at(is_extended, values, row.response) : failed(row.reason);
}

BatchCase SceneModel::case_at(bool is_extended, std::span<const double> values,
                              std::size_t number) const {
  const Setup at = setup_at(is_extended ? *extended_setup_ : setup_, values);
  return {std::to_string(number), at.scene, at.solver};
}

std::vector<SceneCurve> SceneModel::run_alone(bool is_extended, std::span<const double> values,
                                              std::span<const std::size_t> which,
                                              const BatchOptions& how) const {
  std::vector<SceneCurve> curves(which.size());
  if (which.empty()) return curves;
  const std::vector<double> own = values_of(values, which);
  const std::size_t n = fields_.size();
  const auto at = [&](std::size_t i) { return std::span<const double>(own).subspan(i * n, n); };
  if (prepared_) {
    run_batch(
        is_extended ? *extended_ : model_, own, which.size(),
        [&](std::size_t i, Response&& response) {
          curves[i] = curve_at(is_extended, at(i), response);
        },
        how);
    return curves;
  }
  run_batch(
      which.size(), [&](std::size_t i) { return case_at(is_extended, at(i), i); },
      [&](std::size_t i, BatchRow&& row) { curves[i] = curve_at(is_extended, at(i), row); }, how);
  return curves;
}

/// A lead that ends at a limit load may have a curve all the same: its companions run alone then.
std::vector<SceneCurve> SceneModel::run_together(bool is_extended, std::span<const double> values,
                                                 std::span<const std::size_t> which,
                                                 StopFlag stop) const {
  const std::vector<double> own = values_of(values, which);
  const std::size_t n = fields_.size();
  const auto at = [&](std::size_t i) { return std::span<const double>(own).subspan(i * n, n); };
  std::vector<BatchRow> rows;
  if (prepared_) {
    const Model& model = is_extended ? *extended_ : model_;
    for (Response& response : run_with_companions(model, own, which.size(), stop)) {
      rows.emplace_back().response = std::move(response);
    }
  } else {
    std::vector<BatchCase> cases;
    for (std::size_t i = 0; i < which.size(); ++i) cases.push_back(case_at(is_extended, at(i), i));
    rows = run_with_companions(cases, stop);
  }
  std::vector<SceneCurve> curves{curve_at(is_extended, at(0), rows.front())};
  std::vector<std::size_t> left;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool was_run = rows[i].response.status != Status::NotRun;
    curves.push_back(was_run ? curve_at(is_extended, at(i), rows[i])
                             : failed(curves.front().reason));
    curves.back().was_run = was_run;
    if (!was_run) left.push_back(i);
  }
  if (!curves.front().usable) return curves;
  std::vector<std::size_t> their_points;
  their_points.reserve(left.size());
  for (const std::size_t i : left) their_points.push_back(which[i]);
  std::vector<SceneCurve> alone =
      run_alone(is_extended, values, their_points, {.threads = 1, .stop = stop});
  for (std::size_t k = 0; k < left.size(); ++k) curves[left[k]] = std::move(alone[k]);
  return curves;
}

}  // namespace plastica::calibrate
