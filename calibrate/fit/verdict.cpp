#include "calibrate/fit/verdict.hpp"

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
    case Verdict::LimitedBySegments: return "limited by segments";
    case Verdict::FromPrior: return "from its prior";
  }
  return "";
}

Judgement judge(const Evidence& e) {
  const double size = std::abs(e.value);
  if (e.at_bound) {
    const bool low = e.value - e.lower < e.upper - e.value;
    return {Verdict::AtBound, low ? e.lower : e.upper};
  }
  if (std::isnan(e.noise_error)) {
    return {Verdict::NotIdentified, std::numeric_limits<double>::infinity()};
  }
  if (e.prior > kOfPrior) return {Verdict::FromPrior, e.prior};
  // Evenly likely over it, a half interval is as wide as a standard error of its 1/sqrt(3).
  const double widest = std::max(e.half, e.segments);
  if (widest > std::sqrt(3.0) * e.noise_error && widest > 0.0) {
    return {e.segments > e.half ? Verdict::LimitedBySegments : Verdict::LimitedBySampling,
            widest / size};
  }
  const double share = e.standard_error / size;
  return {share > kWeak ? Verdict::Weak : Verdict::Identified, share};
}

std::string warning_of(std::string_view name, const Judgement& judgement, double lower) {
  const double share = 100.0 * judgement.number;
  switch (judgement.verdict) {
    case Verdict::Identified:
    case Verdict::LimitedBySegments: break;  // of fits through scenes, which say more of it
    case Verdict::Weak:
      return fmt::format("{} is weak: its standard error is {:.0f} % of it", name, share);
    case Verdict::NotIdentified:
      return fmt::format("{} is not identified: the curves do not depend on it by itself", name);
    case Verdict::AtBound:
      return fmt::format("{} is at its {} bound", name,
                         judgement.number == lower ? "lower" : "upper");
    case Verdict::FromPrior:
      return fmt::format(
          "{} is from its prior: of what is known of it, {:.0f} % is the prior's and the rest the "
          "curves'",
          name, share);
    case Verdict::LimitedBySampling:
      return fmt::format(
          "{} is limited by sampling: the break lies between two samples, which leaves {:.2g} % of "
          "it open",
          name, share);
  }
  return {};
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

}  // namespace plastica::calibrate
