#include "calibrate/problem/scene_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "plastica/base/parallel_for.hpp"
#include "plastica/model/region.hpp"

namespace plastica::calibrate {
Setup with_fixed(const Setup& setup, const SceneFitOptions& options) {
  Setup fixed = setup;
  for (const Parameter& p : options.parameters) {
    if (p.role == ParameterRole::Fixed) set_everywhere(fixed, *p.field, *p.value);
  }
  for (const Parameter& p : options.parameters) {
    if (p.role != ParameterRole::Tied) continue;
    for (const Parameter& base : options.parameters) {
      if (base.field != p.tied_to || base.role != ParameterRole::Fixed) continue;
      set_everywhere(fixed, *p.field, p.factor * *base.value);
    }
  }
  return fixed;
}

namespace {

RunCounters counters_of(const SceneCurve& curve) {
  if (!curve.was_run) return {};
  return {curve.is_extended ? 2 : 1, curve.usable ? 0 : 1, curve.segment_iterations};
}

/// Of the samples of one target.
std::vector<double> weights_of(const WeightedTarget& weighted, Objective objective) {
  std::vector<double> weights = sample_weights(weighted.target.abscissa, objective);
  for (double& weight : weights) weight *= weighted.weight;
  return weights;
}

}  // namespace

SceneProblem::SceneProblem(std::span<const WeightedTarget> targets, const SceneFitOptions& options)
    : targets_(targets),
      options_(options),
      parameters_(options.parameters, targets.front().setup),
      noise_(targets.size()) {
  for (const WeightedTarget& weighted : targets) {
    models_.emplace_back(with_fixed(weighted.setup, options), weighted.target,
                         parameters_.fields());
    weights_.push_back(weights_of(weighted, options.objective));
    first_.push_back(squares_.residuals);
    squares_.residuals += weighted.target.ordinate.size();
  }
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Coordinate& coordinate = parameters_.coordinate(i);
    squares_.lower.push_back(coordinate.at(coordinate.lower));
    squares_.upper.push_back(coordinate.at(coordinate.upper));
    squares_.start.push_back(0.0);
    if (!parameters_.parameter(i).prior) continue;
    priors_.push_back(i);
    ++squares_.residuals;
  }
  if (std::ranges::any_of(options.parameters, [](const Parameter& p) {
        return p.role == ParameterRole::Free && is_hinge_length(p);
      })) {
    add_known_breaks();
  }
  squares_.has_companions = std::ranges::all_of(models_, &SceneModel::has_companions);
  squares_.evaluate = [this](std::span<const double> points, std::span<double> residuals,
                             std::span<bool> found) { set_residuals(points, residuals, found); };
}

std::size_t SceneProblem::samples() const {
  return squares_.residuals - priors_.size() - known_breaks_.size();
}

void SceneProblem::add_known_breaks() {
  for (std::size_t t = 0; t < targets_.size(); ++t) {
    const bool bends = models_[t].level() == Level::Planar;
    const Setup setup = with_fixed(targets_[t].setup, options_);
    const std::optional<double>& strain = setup.scene.material.break_strain;
    const bool breaks = bends && models_[t].takes_a_limit();
    if (targets_[t].target.broke && breaks && strain) known_breaks_.push_back({t, *strain});
  }
  squares_.residuals += known_breaks_.size();
  if (!known_breaks_.empty()) return;
  throw InputError({}, "rules.hinge_length", "",
                   "is fitted to where a beam in bending broke, by a break strain that its scene "
                   "has or that is fixed");
}

bool SceneProblem::add_breaks(const std::vector<std::vector<SceneCurve>>& curves, std::size_t point,
                              std::span<double> residuals) const {
  constexpr double kMin = 1e-3;
  std::size_t next = samples() + priors_.size();
  for (const KnownBreak& known : known_breaks_) {
    const StrainAtBreak& strain = curves[known.target][point].strain;
    if (std::isnan(strain.at) || std::isnan(strain.before)) return false;
    const double half =
        std::isnan(strain.after) ? strain.at - strain.before : 0.5 * (strain.after - strain.before);
    const double deviation = std::max(half / std::sqrt(3.0), kMin * strain.at);
    if (!(deviation > 0.0)) return false;
    residuals[next++] = (strain.at - known.strain) / deviation;
  }
  return true;
}

std::vector<double> SceneProblem::point(std::span<const double> points, std::size_t index) const {
  const std::span<const double> x = points.subspan(index * parameters_.size(), parameters_.size());
  return {x.begin(), x.end()};
}

std::vector<std::size_t> SceneProblem::leads_of(std::span<const double> points,
                                                std::size_t count) const {
  if (squares_.has_companions) return leads_among(points, count);
  std::vector<std::size_t> own(count);
  std::iota(own.begin(), own.end(), std::size_t{0});
  return own;
}

std::vector<std::vector<SceneCurve>> SceneProblem::curves(std::span<const double> points,
                                                          std::size_t count) {
  const std::vector<std::size_t> leads = leads_of(points, count);
  const auto key = [&](std::size_t i) {
    std::vector<double> both = point(points, leads[i]);
    const std::vector<double> own = point(points, i);
    both.insert(both.end(), own.begin(), own.end());
    return both;
  };
  // What is missing, each behind its lead, which is run again for its companions.
  const auto find_missing = [&] {
    std::vector<std::size_t> missing;
    std::set<std::vector<double>> named;
    for (std::size_t i = 0; i < count; ++i) {
      if (known_.contains(key(i)) || !named.insert(key(i)).second) continue;
      if (named.insert(key(leads[i])).second) missing.push_back(leads[i]);
      missing.push_back(i);
    }
    return missing;
  };
  std::vector<std::size_t> missing = find_missing();
  if (!missing.empty() && known_.size() > kMaxKnown) {
    known_.clear();
    missing = find_missing();
  }
  std::vector<std::vector<double>> to_run;
  std::vector<std::size_t> their_leads;
  for (const std::size_t i : missing) {
    to_run.push_back(point(points, i));
    const auto lead = std::ranges::find(missing, leads[i]);
    their_leads.push_back(static_cast<std::size_t>(lead - missing.begin()));
  }
  std::vector<std::vector<SceneCurve>> found = run(to_run, their_leads);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    std::vector<SceneCurve>& of_targets = known_[key(missing[i])];
    of_targets.clear();
    for (std::vector<SceneCurve>& of_target : found) of_targets.push_back(std::move(of_target[i]));
  }
  std::vector<std::vector<SceneCurve>> curves(models_.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<SceneCurve>& of_targets = known_.at(key(i));
    for (std::size_t t = 0; t < curves.size(); ++t) curves[t].push_back(of_targets[t]);
  }
  return curves;
}

std::vector<std::vector<SceneCurve>> SceneProblem::run(
    const std::vector<std::vector<double>>& points, std::span<const std::size_t> leads) {
  std::vector<std::vector<SceneCurve>> curves(models_.size());
  if (points.empty()) return curves;
  if (options_.hooks.stopped()) throw FitInterrupted();
  std::vector<double> values;
  for (const std::vector<double>& x : points) {
    const std::vector<double> at = parameters_.values(x);
    values.insert(values.end(), at.begin(), at.end());
  }
  // A lone point has its targets side by side, several points each target's runs.
  const bool by_target = points.size() == 1;
  const int threads = options_.threads;
  parallel_for(models_.size(), {by_target ? threads : 1}, [&](std::size_t t, int) {
    curves[t] =
        models_[t].run(values, points.size(), by_target ? 1 : threads, options_.hooks.stop, leads);
  });
  // What was not begun has no curve, and must not count as a scene without one.
  if (options_.hooks.stopped()) throw FitInterrupted();
  for (const std::vector<SceneCurve>& of_target : curves) {
    for (const SceneCurve& curve : of_target) {
      counters_.add(counters_of(curve));
      if (!curve.usable) reason_ = curve.reason;
    }
  }
  return curves;
}

void SceneProblem::set_residuals(std::span<const double> points, std::span<double> residuals,
                                 std::span<bool> found) {
  const std::vector<PointRun> runs = compare(curves(points, found.size()), points, residuals);
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = runs[i].found;
}

std::vector<PointRun> SceneProblem::evaluate(std::span<const double> points, std::size_t count,
                                             std::span<double> residuals,
                                             std::span<const std::size_t> leads) {
  std::vector<std::vector<double>> each;
  for (std::size_t i = 0; i < count; ++i) each.push_back(point(points, i));
  const std::vector<std::size_t> own = leads_of(points, count);
  return compare(run(each, leads.empty() ? own : leads), points, residuals);
}

std::vector<PointRun> SceneProblem::compare(const std::vector<std::vector<SceneCurve>>& curves,
                                            std::span<const double> points,
                                            std::span<double> residuals) const {
  const std::size_t n = parameters_.size();
  const std::size_t m = squares_.residuals;
  std::vector<PointRun> all(curves.front().size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    PointRun& here = all[i];
    const std::span<double> to = residuals.subspan(i * m, m);
    here.found = true;
    for (std::size_t t = 0; t < curves.size(); ++t) {
      const SceneCurve& curve = curves[t][i];
      here.runs.add(counters_of(curve));
      if (here.found && !curve.usable) {
        here.found = false;
        here.reason = curve.reason;
        here.reversed = curve.reverses;
      }
      if (here.found) add_residuals(t, curve, to);
    }
    if (here.found && !add_breaks(curves, i, to)) {
      here.found = false;
      here.reason = "the scene does not yield up to where the target broke";
    }
    add_priors(points.subspan(i * n, n), to);
  }
  return all;
}

void SceneProblem::add_priors(std::span<const double> x, std::span<double> residuals) const {
  for (std::size_t k = 0; k < priors_.size(); ++k) {
    const std::size_t p = priors_[k];
    const Prior& prior = *parameters_.parameter(p).prior;
    const double value = parameters_.value(p, x[p]);
    residuals[samples() + k] = (value - prior.mean) / prior.standard_deviation;
  }
}

void SceneProblem::add_residuals(std::size_t t, const SceneCurve& curve,
                                 std::span<double> residuals) const {
  const std::vector<double>& measured = targets_[t].target.ordinate;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    residuals[first_[t] + i] =
        std::sqrt(weights_[t][i]) / scale(t) * (curve.ordinate[i] - measured[i]);
  }
}

std::vector<double> SceneProblem::unscaled(std::size_t t, std::span<const double> residuals) const {
  std::vector<double> unscaled;
  unscaled.reserve(weights_[t].size());
  for (std::size_t i = 0; i < weights_[t].size(); ++i) {
    unscaled.push_back(scale(t) / std::sqrt(weights_[t][i]) * residuals[first_[t] + i]);
  }
  return unscaled;
}

}  // namespace plastica::calibrate
