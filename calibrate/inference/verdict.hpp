#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plastica::calibrate {

/// How well curves determine a free parameter.
enum class Verdict {
  Identified,
  Weak,               ///< its interval is wide
  NotIdentified,      ///< no curve depends on it, or only a combination with others
  AtBound,            ///< it would go on beyond its bound
  LimitedBySampling,  ///< a break: where it is between two samples matters more than the noise
  LimitedBySegments,  ///< what the number of segments does to it matters more than the noise
  FromPrior,          ///< its prior determines it more than the curves
};

/// "identified", "weak", "not identified", …
std::string_view name_of(Verdict verdict);

/// From this relative standard error on a parameter is weak.
inline constexpr double kWeak = 0.1;
/// Above this fraction of the information a parameter is determined by its prior.
inline constexpr double kOfPrior = 0.5;

/// From this size on a correlation is named: the curves determine a combination of the two
/// parameters rather than each by itself.
inline constexpr double kStrongCorrelation = 0.95;

/// What a verdict is made of; SI.
struct Evidence {
  double value = 0.0;
  double lower = 0.0, upper = 0.0;  ///< bounds
  bool at_bound = false;
  double noise_error = 0.0;     ///< standard error from the noise alone; NaN if not identified
  double half = 0.0;            ///< half the interval that a break's sampling leaves
  double standard_error = 0.0;  ///< from both
  double segments = 0.0;  ///< half the interval that the number of segments leaves; 0: none known
  double prior = 0.0;     ///< fraction of the information on it that is its prior's [1]
};

struct Judgement {
  Verdict verdict = Verdict::NotIdentified;
  /// The number behind the word: standard error over value; of a bound the bound [SI]; of sampling
  /// half the interval between samples over the value, of segments half theirs; of a prior its
  /// fraction; infinite if not identified.
  double number = 0.0;
};

Judgement judge(const Evidence& evidence);

/// What a reader must not overlook of a parameter: "yield_stress is at its lower bound". Empty for
/// one that is identified, and of segments.
std::string warning_of(std::string_view name, const Judgement& judgement, double lower);

/// A value and the prior that it was fitted with; SI.
struct PriorEvidence {
  std::string name;
  double value = 0.0;
  double mean = 0.0;                ///< of the prior
  double standard_deviation = 0.0;  ///< of the prior
  double fraction = 0.0;     ///< of what is known of the parameter, f, that is the prior's [1]
  double error_alone = 0.0;  ///< standard error of what the curves say without it
};

/// A warning of a prior that the curves contradict: what they say of the parameter without it, d,
/// is further from the prior's mean than three standard errors of both. With x the value, d = mean
/// + (x - mean)/(1 - f). What residuals in runs add does not count: the prior itself may make them.
/// Empty where they agree, or where there is next to nothing but the prior.
std::string contradicts_prior(const PriorEvidence& evidence);

/// Probability of as few runs of one sign as these residuals have, or fewer, if all orders of their
/// signs were alike. Where fewer than 10 have one of the signs, which leaves few orders, twice the
/// lesser of this and of the probability of so few. NaN for fewer than 20 in all.
/// Source: Wald & Wolfowitz, Ann. Math. Stat. 11 (1940) 147.
double runs_test_p(std::span<const double> residual);

/// Below this probability of its runs a curve's residuals are no noise.
inline constexpr double kFewRuns = 1e-3;

}  // namespace plastica::calibrate
