#include "calibrate/scene/scene_verdict.hpp"

#include <fmt/format.h>

namespace plastica::calibrate {

void judge(double noise_error, double half, SceneParameter& p) {
  const Judgement judgement = calibrate::judge({.value = p.value,
                                                .lower = p.lower,
                                                .upper = p.upper,
                                                .at_bound = p.at_bound,
                                                .noise_error = noise_error,
                                                .half = half,
                                                .standard_error = p.standard_error});
  p.verdict = judgement.verdict;
  p.verdict_number = judgement.number;
}

void add_warning(const SceneParameter& p, std::vector<std::string>& warnings) {
  const std::string name = p.path.substr(p.path.rfind('.') + 1);
  switch (p.verdict) {
    case Verdict::Identified: return;
    case Verdict::Weak:
      warnings.push_back(fmt::format("{} is weak: its standard error is {:.0f} % of it", name,
                                     100.0 * p.verdict_number));
      return;
    case Verdict::NotIdentified:
      warnings.push_back(name + " is not identified: the curves do not depend on it by itself");
      return;
    case Verdict::AtBound:
      warnings.push_back(name + " is at its " + (p.verdict_number == p.lower ? "lower" : "upper") +
                         " bound");
      return;
    case Verdict::LimitedBySampling:
      warnings.push_back(
          fmt::format("{} is limited by sampling: the break lies between two samples, "
                      "which leaves {:.2g} % of it open",
                      name, 100.0 * p.verdict_number));
  }
}

void add_warning(const ScenePartFit& part, std::vector<std::string>& warnings) {
  if (part.runs_probability < kFewRuns) {
    warnings.push_back(
        fmt::format("{}: the residuals lie in long runs of one sign (misfit {:.2g} % of the "
                    "largest value): they "
                    "are no noise, and standard errors are too small",
                    part.name, 100.0 * part.misfit_share));
  }
}

}  // namespace plastica::calibrate
