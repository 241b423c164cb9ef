#include "calibrate/target/correct.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace plastica::calibrate {
namespace {

using Mode = CorrectionChoice::Mode;

BreakFound broken_after(const Curve& curve, std::size_t last, const char* rule) {
  BreakFound found;
  found.whole = last + 1;
  found.observation.last_whole_strain = curve.strain[last];
  found.observation.last_whole_stress = curve.stress[last];
  found.observation.first_broken_strain = std::max(curve.strain[last], curve.strain[last + 1]);
  found.observation.rule = rule;
  return found;
}

std::optional<BreakFound> cyclic_break(const Curve& curve) {
  const std::size_t n = curve.size();
  double largest = 0.0;
  for (const double stress : curve.stress) largest = std::max(largest, std::abs(stress));
  if (n >= 2 && curve.stress[n - 1] == 0.0 && std::abs(curve.stress[n - 2]) > 0.5 * largest) {
    return broken_after(curve, n - 2, "fall-to-zero");
  }
  return std::nullopt;
}

void shift(Curve& curve, double amount) {
  for (double& strain : curve.strain) strain -= amount;
}

Correction off(const char* kind, const char* unit) { return {kind, false, 0.0, unit, "off"}; }

}  // namespace

std::optional<BreakFound> find_break(const Curve& curve, Loading loading, double modulus,
                                     bool goes_on, const TargetOptions& options) {
  if (loading == Loading::Cyclic) return cyclic_break(curve);
  const auto& strain = curve.strain;
  const auto& stress = curve.stress;
  const std::size_t n = curve.size();
  if (n < 2) return std::nullopt;
  const auto peak = std::max_element(stress.begin(), stress.end());
  const double rm = *peak;
  const double zero = options.zero_share * rm;
  std::size_t run = static_cast<std::size_t>(peak - stress.begin());  // start of the steep fall
  for (std::size_t i = run; i + 1 < n; ++i) {
    const double fall = stress[i] - stress[i + 1];
    const double step = std::max(0.0, strain[i + 1] - strain[i]);
    if (!(fall > 0.5 * modulus * step)) {
      run = i + 1;
    } else if (stress[run] - stress[i + 1] >= options.drop_share * rm) {
      std::size_t last = run;
      while (stress[last + 1] > (1.0 - options.drop_share) * stress[run]) ++last;
      return broken_after(curve, last, stress[i + 1] <= zero ? "fall-to-zero" : "load-drop");
    }
    if (stress[i + 1] <= zero) return broken_after(curve, i, "fall-to-zero");
    if (fall >= 0.5 * rm) return broken_after(curve, i, "load-drop");
  }
  if (!goes_on && stress[n - 1] <= options.end_share * rm) {
    BreakFound found;
    found.whole = n;
    const double step = std::max(0.0, strain[n - 1] - strain[n - 2]);
    found.observation = {strain[n - 1], stress[n - 1], strain[n - 1] + step, "end-of-data"};
    return found;
  }
  return std::nullopt;
}

void trim_at_break(Target& target, double modulus, bool goes_on, const TargetOptions& options) {
  Curve& curve = target.corrected;
  if (options.trim.mode == Mode::Off) {
    target.corrections.push_back(off("trim-at-break", "samples"));
    return;
  }
  std::optional<BreakFound> found;
  if (options.trim.mode == Mode::Set) {
    std::size_t last = 0;
    while (last + 1 < curve.size() && curve.strain[last + 1] <= options.trim.amount) ++last;
    if (last + 1 < curve.size()) found = broken_after(curve, last, "set");
  } else {
    found = find_break(curve, target.loading, modulus, goes_on, options);
  }
  if (!found) {
    const char* why = goes_on ? "the strain ends before the break"
                              : "no load drop, no fall to zero, and the data end under load";
    target.corrections.push_back({"trim-at-break", false, 0.0, "samples", why});
    return;
  }
  const std::size_t cut = curve.size() - found->whole;
  curve.strain.resize(found->whole);
  curve.stress.resize(found->whole);
  std::string text = "rule: " + found->observation.rule;
  target.corrections.push_back(
      {"trim-at-break", cut > 0, static_cast<double>(cut), "samples", std::move(text)});
  target.characteristics.observed_break = std::move(found->observation);
}

double shift_strain(Target& target, const ElasticLine& line, const TargetOptions& options) {
  Curve& curve = target.corrected;
  Correction toe{"toe", false, 0.0, "1", ""};
  Correction preload{"preload-offset", false, 0.0, "1", ""};
  double total = 0.0;
  for (auto [choice, correction] :
       {std::pair{&options.toe, &toe}, std::pair{&options.preload, &preload}}) {
    if (choice->mode == Mode::Off) correction->text = "off";
    if (choice->mode == Mode::Set) {
      *correction = {correction->kind, true, choice->amount, "1", "set by the user"};
      total += choice->amount;
    }
  }

  // With a given modulus the line goes through the first sample, and only a coarse offset counts.
  const bool given = options.youngs_modulus.has_value();
  const double zero = given ? curve.strain[0] - curve.stress[0] / line.modulus : line.zero_strain;
  const double share = given ? options.given_modulus_threshold : options.shift_threshold;
  const double threshold =
      std::max(share * line.yield_stress / line.modulus, 6.0 * line.zero_strain_stderr);
  const char* why_not = nullptr;
  if (total != 0.0) {
    why_not = "another strain shift is set";
  } else if (target.loading == Loading::Cyclic) {
    why_not = "a cyclic curve keeps its measured zero";
  } else if (!(std::abs(zero) > threshold)) {
    why_not = "the elastic line meets the origin within the threshold";
  }
  // Zeroed at another load, the whole curve lies beside its place, from the first sample on.
  const double first_beside = curve.strain[0] - curve.stress[0] / line.modulus - zero;
  const bool is_preload = std::abs(first_beside) < 0.5 * std::abs(zero);
  if (!why_not && !is_preload && std::abs(zero) > line.yield_stress / line.modulus) {
    why_not = "the elastic line misses the origin by more than the yield strain: no foot";
  }
  Correction& candidate = is_preload ? preload : toe;
  const Mode mode = is_preload ? options.preload.mode : options.toe.mode;
  if (!why_not && mode == Mode::Automatic) {
    total += zero;
    candidate.applied = true;
    candidate.amount = zero;
    candidate.text = is_preload ? "the curve starts on an elastic line beside the origin"
                                : "the elastic line beyond the foot misses the origin";
  }
  for (Correction* correction : {&toe, &preload}) {
    if (!correction->text.empty()) continue;
    correction->text = why_not      ? why_not
                       : is_preload ? "the first sample is on the elastic line: no foot"
                                    : "the first sample is not on the elastic line: a foot";
  }
  target.corrections.push_back(std::move(toe));
  target.corrections.push_back(std::move(preload));
  if (total == 0.0) return 0.0;
  shift(curve, total);
  if (auto& broken = target.characteristics.observed_break) {
    broken->last_whole_strain -= total;
    broken->first_broken_strain -= total;
  }
  return total;
}

bool convert_to_true(Target& target, const TargetOptions& options) {
  if (!options.convert_to_true || target.measure == Measure::True) return true;
  if (target.test != Test::Tension) {
    target.status = TargetStatus::Rejected;
    target.reason = "only a tension curve can be converted to true stress and strain";
    return false;
  }
  Curve& curve = target.corrected;
  auto& broken = target.characteristics.observed_break;
  if (!options.force_true) {
    const auto peak = std::max_element(curve.stress.begin(), curve.stress.end());
    const auto keep = static_cast<std::size_t>(peak - curve.stress.begin()) + 1;
    if (keep < curve.size()) {
      target.warnings.push_back(std::to_string(curve.size() - keep) +
                                " samples beyond Rm refused: true strain is unknown in a neck");
      curve.strain.resize(keep);
      curve.stress.resize(keep);
      broken.reset();
    }
  }
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!(curve.strain[i] > -1.0)) {
      target.status = TargetStatus::Rejected;
      target.reason = "an engineering strain of -1 or less has no true strain";
      return false;
    }
    curve.stress[i] *= 1.0 + curve.strain[i];
    curve.strain[i] = std::log1p(curve.strain[i]);
  }
  if (broken) {
    broken->last_whole_stress *= 1.0 + broken->last_whole_strain;
    broken->last_whole_strain = std::log1p(broken->last_whole_strain);
    broken->first_broken_strain = std::log1p(broken->first_broken_strain);
  }
  target.measure = Measure::True;
  target.corrections.push_back({"true-measure", true, static_cast<double>(curve.size()), "samples",
                                options.force_true ? "forced beyond Rm" : "up to Rm"});
  return true;
}

}  // namespace plastica::calibrate
