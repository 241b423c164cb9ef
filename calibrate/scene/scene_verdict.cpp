#include "calibrate/scene/scene_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Identified: return "identified";
    case Verdict::Weak: return "weak";
    case Verdict::NotIdentified: return "not identified";
    case Verdict::AtBound: return "at bound";
    case Verdict::LimitedBySampling: return "limited by sampling";
  }
  return "";
}

void judge(double noise_error, double half, SceneParameter& parameter) {
  const double size = std::abs(parameter.value);
  if (parameter.at_bound) {
    parameter.verdict = Verdict::AtBound;
    const bool low = parameter.value - parameter.lower < parameter.upper - parameter.value;
    parameter.verdict_number = low ? parameter.lower : parameter.upper;
  } else if (std::isnan(noise_error)) {
    parameter.verdict = Verdict::NotIdentified;
    parameter.verdict_number = std::numeric_limits<double>::infinity();
  } else if (half > std::sqrt(3.0) * noise_error && half > 0.0) {
    parameter.verdict = Verdict::LimitedBySampling;
    parameter.verdict_number = half / size;
  } else {
    parameter.verdict_number = parameter.standard_error / size;
    parameter.verdict = parameter.verdict_number > kWeak ? Verdict::Weak : Verdict::Identified;
  }
}

double runs_probability(std::span<const double> residual) {
  constexpr double kFewest = 10.0;
  double above = 0.0, below = 0.0, runs = 0.0;
  bool up = false;
  for (const double r : residual) {
    if (r == 0.0) continue;
    if (above + below == 0.0 || up != (r > 0.0)) runs += 1.0;
    up = r > 0.0;
    (up ? above : below) += 1.0;
  }
  const double all = above + below;
  if (all < 2.0 * kFewest) return std::numeric_limits<double>::quiet_NaN();
  if (above < kFewest || below < kFewest) {
    const double few = std::min(above, below);
    return 2.0 * theory::normal_cdf((few + 0.5 - 0.5 * all) / (0.5 * std::sqrt(all)));
  }
  const double mean = 1.0 + 2.0 * above * below / all;
  const double variance = (mean - 1.0) * (mean - 2.0) / (all - 1.0);
  return theory::normal_cdf((runs + 0.5 - mean) / std::sqrt(variance));
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
