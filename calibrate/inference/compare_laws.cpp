#include "calibrate/inference/compare_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "calibrate/inference/lack_of_fit.hpp"

namespace plastica::calibrate {
namespace {

/// Differences of BIC below this are none.
constexpr double kBareMention = 2.0;
/// A misfit below this fraction of the largest value is none.
constexpr double kNothingLeft = 1e-6;

/// Samples of a curve, by what they are worth, below which information does not compare laws.
constexpr double kLeastWorth = 10.0;
/// Specimens that must have been predicted by others.
constexpr std::size_t kFewSpecimens = 3;
/// How much larger than the best law's the misfit of parts may be, as a factor, of laws that are as
/// good: if the difference is within its standard error; whatever its standard error is.
constexpr double kAlikeByError = 1.1;
constexpr double kAlike = 1.02;

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
    deviance += residual.prior;
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

double mean_of(std::span<const double> values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

const std::vector<double>& unseen_of(const LawFit& fit, RankedBy by) {
  return by == RankedBy::Parts ? fit.parts : fit.specimens;
}

double unseen_of(const ComparedLaw& law, RankedBy by) {
  return by == RankedBy::Parts ? law.held_out : law.unseen;
}

/// What a law leaves more of what it has not seen than another one, and the standard error.
struct Difference {
  double more = 0.0;
  double error = 0.0;
};
Difference difference(const LawFit& law, const LawFit& other, RankedBy by) {
  const std::vector<double>& a = unseen_of(law, by);
  const std::vector<double>& b = unseen_of(other, by);
  Difference d{mean_of(a) - mean_of(b), 0.0};
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(a[i] - b[i] - d.more, 2);
  const auto n = static_cast<double>(a.size());
  d.error = std::sqrt(squares / (n * std::max(1.0, n - 1.0)));
  return d;
}

/// Whether a law leaves no more of what it has not seen than the best one.
bool are_alike(const LawFit& law, const LawFit& best, RankedBy by) {
  const double own = best.parts.empty() ? mean_of(unseen_of(best, by)) : mean_of(best.parts);
  const Difference d = difference(law, best, by);
  const auto within = [&](double factor) {
    return d.more <= std::max((factor * factor - 1.0) * own, kNothingLeft * kNothingLeft);
  };
  return within(kAlike) || (within(kAlikeByError) && d.more <= d.error);
}

/// "BIC lower by 12 than ideal", "specimens not seen are 1.2 % off, by ideal 3 %".
std::string gain_of(const ComparedLaw& best, const ComparedLaw& next, RankedBy by,
                    bool is_simpler) {
  if (by != RankedBy::Information) {
    return fmt::format("{}{} are {:.3g} % off, by {} {:.3g} %", is_simpler ? "simpler, and " : "",
                       name_of(by), 100.0 * unseen_of(best, by), name_of(next.fit.law),
                       100.0 * unseen_of(next, by));
  }
  const double gain = next.bic - best.bic;
  return gain >= kBareMention
             ? fmt::format("BIC lower by {:.3g} than {}", gain, name_of(next.fit.law))
             : fmt::format("simpler than {}, whose BIC is {} by {:.2g} only", name_of(next.fit.law),
                           gain < 0.0 ? "lower" : "higher", std::fabs(gain));
}

/// Of a law with more parameters than the advised one.
std::string why_it_gains_nothing(const ComparedLaw& law, const ComparedLaw& best, RankedBy by) {
  std::string doubts = doubts_on(law.fit);
  if (!doubts.empty()) return doubts;
  if (by == RankedBy::Information) {
    return fmt::format("its misfit is {}, that of {} {}", fraction_text(law.fit.misfit_fraction),
                       name_of(best.fit.law), fraction_text(best.fit.misfit_fraction));
  }
  return fmt::format("{} are {:.3g} % off", name_of(by), 100.0 * unseen_of(law, by));
}

/// What speaks against the parameters of the advised law, beside the best of the simpler laws that
/// have none such; empty if nothing does.
std::string doubts_on_advised(const LawComparison& comparison, const ComparedLaw& best) {
  const std::string doubts = doubts_on(best.fit);
  if (doubts.empty()) return {};
  for (const ComparedLaw& law : comparison.laws) {
    const bool is_simpler = law.fit.parameters.size() < best.fit.parameters.size();
    if (!law.fit.fitted || !is_simpler || !doubts_on(law.fit).empty()) continue;
    return fmt::format("; yet {}: none of {}, whose misfit is {} for {}", doubts,
                       name_of(law.fit.law), fraction_text(law.fit.misfit_fraction),
                       fraction_text(best.fit.misfit_fraction));
  }
  return "; yet " + doubts;
}

/// A law that foretells specimens clearly better than the one that information advises; null if
/// there is none.
const ComparedLaw* better_on_specimens(const LawComparison& comparison, const ComparedLaw& best) {
  if (comparison.ranked_by != RankedBy::Information) return nullptr;
  if (best.fit.specimens.size() < kFewSpecimens) return nullptr;
  const ComparedLaw* better = nullptr;
  for (const ComparedLaw& law : comparison.laws) {
    if (law.fit.specimens.size() != best.fit.specimens.size()) continue;
    const auto [more, error] = difference(best.fit, law.fit, RankedBy::Specimens);
    const bool clear = more > 2.0 * error && best.unseen > kAlike * law.unseen;
    if (clear && (better == nullptr || law.unseen < better->unseen)) better = &law;
  }
  return better;
}

std::string advice_of(const LawComparison& comparison, std::size_t advised) {
  const std::vector<ComparedLaw>& laws = comparison.laws;
  const ComparedLaw& best = laws[advised];
  const RankedBy by = comparison.ranked_by;
  std::string text(name_of(best.fit.law));
  const std::size_t other = advised == 0 ? 1 : 0;
  if (other < laws.size() && laws[other].fit.fitted) {
    text += ": " + gain_of(best, laws[other], by, advised > 0);
    for (const ComparedLaw& law : laws) {
      if (law.fit.parameters.size() <= best.fit.parameters.size() || !law.fit.fitted) continue;
      text += fmt::format("; {} gains nothing: {}", name_of(law.fit.law),
                          why_it_gains_nothing(law, best, by));
    }
  }
  text += doubts_on_advised(comparison, best);
  if (const ComparedLaw* better = better_on_specimens(comparison, best)) {
    text += fmt::format("; yet specimens not seen are {:.3g} % off, by {} {:.3g} %",
                        100.0 * best.unseen, name_of(better->fit.law), 100.0 * better->unseen);
  }
  if (by == RankedBy::Information && !comparison.is_informed) {
    text += fmt::format(
        "; yet BIC rests on samples worth {:.2g}, and nothing was cross-validated: "
        "not comparable, calibrate again",
        comparison.samples);
  }
  if (best.fit.lacks_fit) {
    text += fmt::format("; even so it does not describe the curve (misfit {} of the largest value)",
                        fraction_text(best.fit.misfit_fraction));
  }
  return text;
}

/// Takes from fits what not all of them have: laws are compared by the same parts and
/// the same specimens.
void keep_common(std::vector<LawFit>& fits) {
  for (const auto member : {&LawFit::parts, &LawFit::specimens}) {
    const auto first = std::ranges::find_if(fits, &LawFit::fitted);
    const auto differs = [&](const LawFit& fit) {
      return fit.fitted && (fit.*member).size() != ((*first).*member).size();
    };
    if (std::ranges::none_of(fits, differs)) continue;
    for (LawFit& fit : fits) (fit.*member).clear();
  }
}

/// Adds one target's fit of a law to that of others.
void add(LawFit&& fit, LawFit& sum) {
  const auto append = [](auto&& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  append(fit.curves, sum.curves);
  append(fit.parameters, sum.parameters);
  append(fit.verdicts, sum.verdicts);
  append(fit.parts, sum.parts);
  append(fit.specimens, sum.specimens);
  sum.evaluations += fit.evaluations;
  sum.runs += fit.runs;
  sum.seconds = sum.fitted ? sum.seconds + fit.seconds : fit.seconds;
  sum.misfit_fraction = std::max(sum.misfit_fraction, fit.misfit_fraction);
  sum.lacks_fit = sum.lacks_fit || fit.lacks_fit;
  sum.fitted = true;
}

/// By what the laws are to be ranked.
RankedBy ranked_by(const LawComparison& comparison) {
  const auto is_fitted = [](const ComparedLaw& law) { return law.fit.fitted; };
  const bool any = std::ranges::any_of(comparison.laws, is_fitted);
  const auto all_have = [&](auto member, std::size_t least) {
    return any && std::ranges::all_of(comparison.laws, [&](const ComparedLaw& law) {
             return !law.fit.fitted || (law.fit.*member).size() >= least;
           });
  };
  if (comparison.is_informed) return RankedBy::Information;
  if (all_have(&LawFit::specimens, kFewSpecimens)) return RankedBy::Specimens;
  return all_have(&LawFit::parts, 1) ? RankedBy::Parts : RankedBy::Information;
}

/// Whether a law is worth no less than the best one.
bool are_alike(const ComparedLaw& law, const ComparedLaw& best, RankedBy by) {
  return by == RankedBy::Information ? law.bic - best.bic < kBareMention
                                     : are_alike(law.fit, best.fit, by);
}

}  // namespace

double unseen_misfit(std::span<const double> squares) { return std::sqrt(mean_of(squares)); }

LawComparison compare_laws_over(std::vector<std::vector<LawFit>> targets) {
  for (std::vector<LawFit>& fits : targets) keep_common(fits);
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
  keep_common(fits);
  const std::vector<double> worth = worth_of(fits);
  for (const double n : worth) comparison.samples += n;
  comparison.is_informed = comparison.samples >= kLeastWorth * static_cast<double>(worth.size());
  for (LawFit& fit : fits) {
    ComparedLaw law{std::move(fit)};
    law.held_out = unseen_misfit(law.fit.parts);
    law.unseen = unseen_misfit(law.fit.specimens);
    law.aic = law.aicc = law.bic = std::numeric_limits<double>::infinity();
    if (law.fit.fitted) set_criteria(worth, comparison.samples, law);
    comparison.laws.push_back(std::move(law));
  }
  const RankedBy by = comparison.ranked_by = ranked_by(comparison);
  std::vector<ComparedLaw>& laws = comparison.laws;
  std::ranges::stable_sort(laws, {}, [by](const ComparedLaw& law) {
    return by == RankedBy::Information || !law.fit.fitted ? law.bic : unseen_of(law, by);
  });
  if (laws.empty() || !laws.front().fit.fitted) return comparison;
  std::size_t advised = 0;
  for (std::size_t i = 1; i < laws.size(); ++i) {
    const bool alike = laws[i].fit.fitted && are_alike(laws[i], laws.front(), by);
    if (alike && laws[i].fit.parameters.size() < laws[advised].fit.parameters.size()) advised = i;
  }
  comparison.advised = advised;
  comparison.advice = advice_of(comparison, advised);
  return comparison;
}

std::string_view name_of(RankedBy by) {
  switch (by) {
    case RankedBy::Information: return "BIC";
    case RankedBy::Parts: return "parts of the curve held out";
    case RankedBy::Specimens: return "specimens not seen";
  }
  return {};
}

}  // namespace plastica::calibrate
