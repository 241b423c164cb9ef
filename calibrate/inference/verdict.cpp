#include "calibrate/inference/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace plastica::calibrate {
namespace {

/// ln n! of n up to `most`.
std::vector<double> log_factorials(int most) {
  std::vector<double> logarithms(static_cast<std::size_t>(most) + 1);
  int sign = 1;  // lgamma writes a global, and fits run on several threads
  for (std::size_t n = 0; n < logarithms.size(); ++n) {
    logarithms[n] = lgamma_r(static_cast<double>(n) + 1.0, &sign);
  }
  return logarithms;
}

/// Those that most curves need, made once: they would be a seventh of a fit.
constexpr int kKept = 4096;
const std::vector<double>& kept_log_factorials() {
  static const std::vector<double> kept = log_factorials(kKept);
  return kept;
}

/// Logarithms of binomial coefficients, of those of so many and fewer.
class LogChoices {
 public:
  explicit LogChoices(int most)
      : own_(most > kKept ? log_factorials(most) : std::vector<double>()),
        log_factorial_(most > kKept ? own_ : kept_log_factorials()) {}
  LogChoices(const LogChoices&) = delete;
  LogChoices& operator=(const LogChoices&) = delete;

  /// ln of n over k; of none, minus infinity.
  double operator()(int n, int k) const {
    if (k < 0 || k > n) return -std::numeric_limits<double>::infinity();
    return of(n) - of(k) - of(n - k);
  }

 private:
  double of(int n) const { return log_factorial_[static_cast<std::size_t>(n)]; }

  std::vector<double> own_;
  const std::vector<double>& log_factorial_;
};

/// Of all orders of so many of each sign the fraction with no more runs.
///
/// Of 2 k runs there are k of each sign, which C(a - 1, k - 1) C(b - 1, k - 1) ways make with a
/// above and b below, and either may be first: 2 w_k. Of 2 k + 1 there is one more of either sign,
/// which w_k ((a - k)/k + (b - k)/k) ways make. w_k rises up to k = a b/(a + b) and falls beyond,
/// by the ratio w_(k+1)/w_k = (a - k)(b - k)/k^2: the sum begins there, or at its last term, and
/// ends to both sides where what follows is nothing.
double as_few_runs(int runs, int above, int below) {
  constexpr double kNothing = 1e-18;
  if (above == 0 || below == 0) return 1.0;
  if (runs < 2) return 0.0;
  const double a = above, b = below, all = a + b;
  const int last = runs / 2;
  const int first = std::clamp(static_cast<int>(a * b / all), 1, last);
  const LogChoices log_choices(above + below);
  const double ways =
      std::exp(log_choices(above - 1, first - 1) + log_choices(below - 1, first - 1) -
               log_choices(above + below, above));
  double sum = 0.0;
  const auto add = [&](int at, double ways_of_each) {
    const double k = at;
    const bool odd = at < last || runs % 2 == 1;  // 2 k + 1 are no more runs either
    const double term = ways_of_each * (2.0 + (odd ? (all - 2.0 * k) / k : 0.0));
    sum += term;
    return term > kNothing * sum;
  };
  double of_each = ways;
  for (int k = first; add(k, of_each) && k < last; ++k)
    of_each *= (a - k) * (b - k) / (1.0 * k * k);
  of_each = ways;
  for (int k = first - 1; k >= 1; --k) {
    of_each *= 1.0 * k * k / ((a - k) * (b - k));
    if (!add(k, of_each)) break;
  }
  return std::min(sum, 1.0);
}

/// Probability that no more than so many of all have the rarer of two signs that are alike.
double as_few_of_a_sign(int few, int all) {
  const LogChoices log_choices(all);
  double sum = 0.0;
  for (int k = 0; k <= few; ++k) sum += std::exp(log_choices(all, k) - all * std::log(2.0));
  return std::min(2.0 * sum, 1.0);
}

}  // namespace

std::string contradicts_prior(const PriorEvidence& e) {
  constexpr double kErrors = 3.0, kNothing = 1e-6;  // of what is known, by the curves
  const double curves = 1.0 - e.fraction;
  if (!(curves > kNothing) || !(e.error_alone > 0.0)) return {};
  const double alone = e.mean + (e.value - e.mean) / curves;
  const double both = std::hypot(e.standard_deviation, e.error_alone);
  const double apart = std::abs(alone - e.mean);
  if (!(apart > kErrors * both)) return {};
  return fmt::format(
      "the curves contradict the prior of {}: {:.4g} ± {:.2g} without it, {:.4g} ± {:.2g} by it "
      "(SI), {:.1f} standard errors apart: the value is a mean of unlike ones",
      e.name, alone, e.error_alone, e.mean, e.standard_deviation, apart / both);
}

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
  if (std::isnan(e.standard_error)) {
    return {Verdict::NotIdentified, std::numeric_limits<double>::infinity()};
  }
  const double fraction = e.standard_error / size;
  return {fraction > kWeak ? Verdict::Weak : Verdict::Identified, fraction};
}

std::string warning_of(std::string_view name, const Judgement& judgement, double lower) {
  const double fraction = 100.0 * judgement.number;
  switch (judgement.verdict) {
    case Verdict::Identified:
    case Verdict::LimitedBySegments: break;  // of fits through scenes, which say more of it
    case Verdict::Weak:
      return fmt::format("{} is weak: its standard error is {:.0f} % of it", name, fraction);
    case Verdict::NotIdentified:
      return fmt::format("{} is not identified: the curves do not depend on it by itself", name);
    case Verdict::AtBound:
      return fmt::format("{} is at its {} bound", name,
                         judgement.number == lower ? "lower" : "upper");
    case Verdict::FromPrior:
      return fmt::format(
          "{} is from its prior: of what is known of it, {:.0f} % is the prior's and the rest the "
          "curves'",
          name, fraction);
    case Verdict::LimitedBySampling:
      return fmt::format(
          "{} is limited by sampling: the break lies between two samples, which leaves {:.2g} % of "
          "it open",
          name, fraction);
  }
  return {};
}

double runs_test_p(std::span<const double> residual) {
  constexpr int kMin = 10;
  int above = 0, below = 0, runs = 0;
  bool up = false;
  for (const double r : residual) {
    if (r == 0.0) continue;
    if (above + below == 0 || up != (r > 0.0)) ++runs;
    up = r > 0.0;
    ++(up ? above : below);
  }
  if (above + below < 2 * kMin) return std::numeric_limits<double>::quiet_NaN();
  const double of_runs = as_few_runs(runs, above, below);
  if (std::min(above, below) >= kMin) return of_runs;
  return std::min(1.0,
                  2.0 * std::min(of_runs, as_few_of_a_sign(std::min(above, below), above + below)));
}

}  // namespace plastica::calibrate
