#include "calibrate/inference/scene_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "calibrate/fit/check_scene_fit.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/scene_errors.hpp"
#include "calibrate/problem/target_noise.hpp"
#include "plastica/base/listed.hpp"

namespace plastica::calibrate {

namespace {

/// How many times as many segments leave as much as the noise does: "; about 1.9 times as many …".
std::string enough_segments(const FittedParameter& p, const SegmentsError& segments) {
  constexpr double kMax = 1000.0;
  const double over = segments.error / (std::sqrt(3.0) * p.model_error());
  const double times = std::pow(over, 1.0 / segments.order);
  if (!(times < kMax)) return "";
  return fmt::format("; about {:.1f} times as many segments would make both alike",
                     std::ceil(10.0 * times) / 10.0);
}

/// A break limit of a target's scene.
struct HeldLimit {
  double value = 0.0;   ///< [1]
  double margin = 0.0;  ///< more than this beyond it is no noise
  bool fitted = false;
  bool at_bound = false;

  /// A fitted limit is a mean of those at which targets broke: whether these agree is judged there.
  bool follows_breaks() const { return fitted && !at_bound; }
  std::string words() const {
    return fmt::format("{} {:.4g} %", fitted ? "fitted as" : "held at", 100.0 * value);
  }
};

std::optional<HeldLimit> limit_of(const Field& field, const WeightedTarget& target,
                                  const SceneFitOptions& options,
                                  std::span<const FittedParameter> parameters) {
  constexpr double kErrors = 3.0, kRounding = 1e-3;
  const auto p = std::ranges::find(parameters, field.path, &FittedParameter::path);
  if (p != parameters.end()) {
    const double errors = p->has_error() ? kErrors * p->standard_error : 0.0;
    return HeldLimit{p->value, std::max(errors, kRounding * p->value), true, p->at_bound()};
  }
  const Setup setup = with_fixed(target.setup, options);
  const Material& material = setup.scene.material;
  const std::optional<double>& held = *field.material == MaterialField::BreakStrain
                                          ? material.break_strain
                                          : material.break_shear_strain;
  if (!held) return std::nullopt;
  return HeldLimit{*held, kRounding * *held, false, false};
}

}  // namespace

void judge(double half, const SegmentsError& segments, double prior, FittedParameter& p) {
  const bool trends = segments.trend > SegmentsTrend::Settled;
  p.judgement = calibrate::judge({.value = p.value,
                                  .lower = p.lower,
                                  .upper = p.upper,
                                  .at_bound = p.at_bound(),
                                  .noise_error = p.model_error(),
                                  .half = half,
                                  .standard_error = p.standard_error,
                                  .segments = trends ? segments.error : 0.0,
                                  .prior = prior});
}

void add_warning(const FittedParameter& p, const SegmentsError& segments,
                 std::vector<std::string>& warnings) {
  const std::string name = p.name();
  if (p.verdict() == Verdict::LimitedBySegments) {
    warnings.push_back(fmt::format(
        "{} is limited by segments: what they do to it, {:.2g} % of it, {}{}", name,
        100.0 * p.verdict_number(),
        std::isnan(segments.order) ? "does not fall steadily with their number"
                                   : fmt::format("is more than the noise does, {:.2g} %",
                                                 100.0 * p.model_error() / std::abs(p.value)),
        enough_segments(p, segments)));
    return;
  }
  std::string warning = warning_of(name, {p.verdict(), p.verdict_number()}, p.lower);
  if (!warning.empty()) warnings.push_back(std::move(warning));
}

void add_warning(const TargetFit& of_target, Law law, std::string_view try_next,
                 std::vector<std::string>& warnings) {
  const std::string lack =
      lack_of_fit(phrase_of(law), of_target.misfit_fraction, of_target.runs_test_p, try_next);
  if (!lack.empty()) warnings.push_back(of_target.name + ": " + lack);
}

bool is_met_alone(const SceneProblem& problem, std::span<const TargetsOfOneKind> kinds,
                  std::size_t t) {
  for (const TargetsOfOneKind& kind : kinds) {
    const auto at = std::ranges::find(kind.targets, t);
    if (at == kind.targets.end() || !kind.differ()) continue;
    const auto k = static_cast<std::size_t>(at - kind.targets.begin());
    const std::vector<double> residual = left_alone(problem, kind, k);
    double squares = 0.0;
    for (const double r : residual) squares += r * r;
    const double rms = std::sqrt(squares / static_cast<double>(residual.size()));
    const double largest = largest_size(problem.targets()[t].target.ordinate);
    return !lacks_fit(largest > 0.0 ? rms / largest : 0.0, runs_test_p(residual));
  }
  return false;
}

namespace {

bool warn_of_difference(std::span<const WeightedTarget> targets, const TargetsOfOneKind& kind,
                        std::vector<std::string>& warnings) {
  constexpr std::size_t kShownTargets = 3;
  if (!kind.differ()) return false;
  std::vector<std::string> names;
  for (const std::size_t t : kind.targets) names.push_back(targets[t].target.name);
  warnings.push_back(fmt::format(
      "{} differ by more than their noise does (chi-squared {:.3g} of {:.0f} degrees of freedom): "
      "{}. They are specimens that differ (shared = false fits each by itself), or the model does "
      "not carry over from one to the other",
      listed(names, kShownTargets), kind.chi_squared, kind.degrees,
      kind.tell_scatter() ? "the errors count how they scatter"
                          : "two hardly say how far others would be"));
  return true;
}

}  // namespace

void warn_of_specimens(std::span<const WeightedTarget> targets, std::span<const TargetFit> fits,
                       std::span<const TargetsOfOneKind> kinds,
                       std::vector<std::string>& warnings) {
  constexpr double kFar = 3.0;
  bool said = false;
  for (const TargetsOfOneKind& kind : kinds) {
    said = warn_of_difference(targets, kind, warnings) || said;
  }
  if (said) return;
  for (std::size_t a = 0; a < targets.size(); ++a) {
    for (std::size_t b = 0; b < targets.size(); ++b) {
      const bool alike = are_of_one_kind(targets[a].target, targets[b].target);
      if (!alike || !(fits[b].misfit_fraction > kFar * fits[a].misfit_fraction)) continue;
      if (!lacks_fit(fits[b].misfit_fraction, fits[b].runs_test_p)) continue;
      warnings.push_back(fmt::format(
          "{} is met far less closely than {}, which measured the same: if these are specimens "
          "that differ, shared = false fits each by itself; the errors above know nothing of it",
          fits[b].name, fits[a].name));
      return;
    }
  }
}

void warn_of_limits(const SceneProblem& problem, const SceneFitOptions& options,
                    std::span<const FittedParameter> parameters,
                    std::span<const std::vector<SceneCurve>> curves,
                    std::vector<std::string>& warnings) {
  for (std::size_t t = 0; t < curves.size(); ++t) {
    const WeightedTarget& target = problem.targets()[t];
    const StrainAtBreak& strain = curves[t].front().strain;
    for (const char* name : {"break_strain", "break_shear_strain"}) {
      const Field& field = find_field(name);
      if (!limits(*field.material, problem.model(t), target)) continue;
      const auto limit = limit_of(field, target, options, parameters);
      if (!limit) continue;
      const double broken_at = std::isnan(strain.after) ? strain.at : strain.after;
      if (target.target.broke && !limit->follows_breaks() &&
          broken_at < limit->value - limit->margin) {
        warnings.push_back(fmt::format(
            "{}: the specimen broke at a permanent strain of {:.4g} %, less than {}, which is {}: "
            "the fitted beam is intact where it broke",
            target.target.name, 100.0 * broken_at, name, limit->words()));
        continue;
      }
      if (!(strain.survived > limit->value + limit->margin)) continue;
      const bool only_at_break = target.target.broke && !(strain.survived > strain.before);
      if (limit->follows_breaks() && only_at_break) continue;
      warnings.push_back(fmt::format(
          "{}: the specimen bore a permanent strain of {:.4g} % and {}, more than {} allows, which "
          "is {}",
          target.target.name, 100.0 * strain.survived,
          target.target.broke ? "went on" : "did not break at all", name, limit->words()));
    }
  }
}

}  // namespace plastica::calibrate
