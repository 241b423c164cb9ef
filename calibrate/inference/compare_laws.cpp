#include "calibrate/inference/compare_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibrate/inference/material_interval.hpp"

namespace plastica::calibrate {
namespace {

/// Differences of BIC below this are none.
constexpr double kBareMention = 2.0;
/// A misfit below this fraction of the largest value is none.
constexpr double kNothingLeft = 1e-6;
/// Misfits, as fractions of the largest value, above which a law may lack something: with residuals
/// in long runs; without a count of runs.
constexpr double kLacking = 0.01;
constexpr double kLackingForSure = 0.05;

double square_of(const CurveResidual& residual) {
  const double least = kNothingLeft * residual.largest;
  return std::max(residual.mean_square, least * least);
}

/// What the samples of each curve are worth, by the law that leaves least of it.
std::vector<double> worth_of(const std::vector<LawFit>& fits) {
  std::vector<double> worth;
  std::vector<double> least;
  for (const LawFit& fit : fits) {
    if (!fit.fitted) continue;
    worth.resize(fit.curves.size());
    least.resize(fit.curves.size(), std::numeric_limits<double>::infinity());
    for (std::size_t c = 0; c < fit.curves.size(); ++c) {
      const CurveResidual& residual = fit.curves[c];
      if (!(residual.mean_square < least[c])) continue;
      least[c] = residual.mean_square;
      worth[c] = std::max(1.0, samples_worth(residual.samples, residual.autocorrelation));
    }
  }
  return worth;
}

void set_criteria(const std::vector<double>& worth, double samples, ComparedLaw& law) {
  double deviance = 0.0;
  auto parameters = static_cast<double>(law.fit.parameters.size());
  for (std::size_t c = 0; c < law.fit.curves.size(); ++c) {
    const CurveResidual& residual = law.fit.curves[c];
    if (residual.noise) {
      deviance += worth[c] * residual.mean_square / (*residual.noise * *residual.noise);
    } else {
      deviance += worth[c] * std::log(square_of(residual));
      parameters += 1.0;
    }
  }
  law.aic = deviance + 2.0 * parameters;
  const double spare = samples - parameters - 1.0;
  law.aicc = spare > 0.0 ? law.aic + 2.0 * parameters * (parameters + 1.0) / spare
                         : std::numeric_limits<double>::infinity();
  law.bic = deviance + parameters * std::log(samples);
}

/// "2 parameters weak", "1 parameter at bound and 1 not identified".
std::string doubts_on(const LawFit& fit) {
  std::string text;
  for (const Verdict doubt : {Verdict::NotIdentified, Verdict::AtBound, Verdict::Weak}) {
    const auto count = std::ranges::count(fit.verdicts, doubt);
    if (count == 0) continue;
    text += text.empty() ? fmt::format("{} of its parameters {} ", count, count == 1 ? "is" : "are")
                         : fmt::format(", {} ", count);
    text += name_of(doubt);
  }
  return text;
}

std::string fraction_text(double fraction) { return fmt::format("{:.2g} %", 100.0 * fraction); }

std::string advice_of(const std::vector<ComparedLaw>& laws, std::size_t advised) {
  const ComparedLaw& best = laws[advised];
  std::string text(name_of(best.fit.law));
  const std::size_t other = advised == 0 ? 1 : 0;
  if (other < laws.size() && laws[other].fit.fitted) {
    const ComparedLaw& next = laws[other];
    const double gain = next.bic - best.bic;
    if (gain >= kBareMention) {
      text += fmt::format(": BIC lower by {:.3g} than {}", gain, name_of(next.fit.law));
    } else {
      text += fmt::format(": simpler than {}, whose BIC is {} by {:.2g} only",
                          name_of(next.fit.law), gain < 0.0 ? "lower" : "higher", std::fabs(gain));
    }
    for (const ComparedLaw& law : laws) {
      if (law.fit.parameters.size() <= best.fit.parameters.size() || !law.fit.fitted) continue;
      const std::string doubts = doubts_on(law.fit);
      text += fmt::format("; {} gains nothing: {}", name_of(law.fit.law),
                          !doubts.empty() ? doubts
                                          : fmt::format("its misfit is {}, that of {} {}",
                                                        fraction_text(law.fit.misfit_fraction),
                                                        name_of(best.fit.law),
                                                        fraction_text(best.fit.misfit_fraction)));
    }
  }
  if (best.fit.lacks_fit) {
    text += fmt::format("; even so it does not describe the curve (misfit {} of the largest value)",
                        fraction_text(best.fit.misfit_fraction));
  }
  return text;
}

/// Adds one target's fit of a law to that of others.
void add(LawFit&& fit, LawFit& sum) {
  const auto append = [](auto&& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  append(fit.curves, sum.curves);
  append(fit.parameters, sum.parameters);
  append(fit.verdicts, sum.verdicts);
  sum.evaluations += fit.evaluations;
  sum.runs += fit.runs;
  sum.seconds = sum.fitted ? sum.seconds + fit.seconds : fit.seconds;
  sum.misfit_fraction = std::max(sum.misfit_fraction, fit.misfit_fraction);
  sum.lacks_fit = sum.lacks_fit || fit.lacks_fit;
  sum.fitted = true;
}

}  // namespace

LawComparison compare_laws_over(std::vector<std::vector<LawFit>> targets) {
  std::vector<LawFit> sums;
  const bool any_complete = std::ranges::any_of(targets, [](const std::vector<LawFit>& fits) {
    return std::ranges::all_of(fits, &LawFit::fitted);
  });
  std::vector<Law> failed_somewhere;
  for (const std::vector<LawFit>& fits : targets) {
    for (const LawFit& fit : fits) {
      if (!fit.fitted) failed_somewhere.push_back(fit.law);
      if (std::ranges::find(sums, fit.law, &LawFit::law) == sums.end()) {
        sums.emplace_back().law = fit.law;
      }
    }
  }
  for (std::vector<LawFit>& fits : targets) {
    if (any_complete && !std::ranges::all_of(fits, &LawFit::fitted)) continue;
    for (LawFit& fit : fits) {
      const bool failed = std::ranges::find(failed_somewhere, fit.law) != failed_somewhere.end();
      if (!any_complete && failed) continue;
      add(std::move(fit), *std::ranges::find(sums, fit.law, &LawFit::law));
    }
  }
  return compare_laws(std::move(sums));
}

LawComparison compare_laws(std::vector<LawFit> fits) {
  LawComparison comparison;
  const std::vector<double> worth = worth_of(fits);
  for (const double n : worth) comparison.samples += n;
  for (LawFit& fit : fits) {
    ComparedLaw law{std::move(fit)};
    law.aic = law.aicc = law.bic = std::numeric_limits<double>::infinity();
    if (law.fit.fitted) set_criteria(worth, comparison.samples, law);
    comparison.laws.push_back(std::move(law));
  }
  std::vector<ComparedLaw>& laws = comparison.laws;
  std::ranges::stable_sort(laws, {}, &ComparedLaw::bic);
  if (laws.empty() || !laws.front().fit.fitted) return comparison;
  std::size_t advised = 0;
  for (std::size_t i = 1; i < laws.size(); ++i) {
    const bool alike = laws[i].bic - laws.front().bic < kBareMention;
    if (alike && laws[i].fit.parameters.size() < laws[advised].fit.parameters.size()) advised = i;
  }
  comparison.advised = advised;
  comparison.advice = advice_of(laws, advised);
  return comparison;
}

double effective_samples(std::span<const double> weight) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double w : weight) {
    sum += w;
    squares += w * w;
  }
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

double autocorrelation(std::span<const double> residual) {
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    squares += residual[i] * residual[i];
    if (i > 0) products += residual[i] * residual[i - 1];
  }
  return squares > 0.0 ? products / squares : 0.0;
}

double samples_worth(double samples, double autocorrelation) {
  constexpr double kMaxAlike = 0.999;  // more alike would leave no samples
  const double alike = std::clamp(autocorrelation, 0.0, kMaxAlike);
  return samples * (1.0 - alike) / (1.0 + alike);
}

bool lacks_fit(double fraction, double runs_test_p) {
  return std::isnan(runs_test_p) ? fraction > kLackingForSure
                                 : runs_test_p < kFewRuns && fraction > kLacking;
}

std::string_view misfit_word(double fraction, double runs_test_p, double autocorrelation) {
  if (lacks_fit(fraction, runs_test_p)) return "poor";
  const bool is_noise = !std::isnan(runs_test_p) && !are_in_runs(runs_test_p, autocorrelation);
  return is_noise || fraction < kLacking ? "close" : "fair";
}

std::string lack_of_fit(std::string_view law, double fraction, double runs_test_p,
                        std::string_view try_next) {
  if (!lacks_fit(fraction, runs_test_p)) return {};
  const bool counted = !std::isnan(runs_test_p);
  std::string text = fmt::format("{} does not describe this curve (misfit {} of the largest value",
                                 law, fraction_text(fraction));
  if (counted) text += fmt::format(", runs test p {:.1g}", runs_test_p);
  text += "): errors are widened for it, and rough";
  if (!try_next.empty()) text += fmt::format("; try --laws {}", try_next);
  return text;
}

}  // namespace plastica::calibrate
