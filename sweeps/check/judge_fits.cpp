#include "sweeps/check/judge_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/model/field.hpp"
#include "sweeps/check/shown_number.hpp"
#include "sweeps/check/worst.hpp"

namespace plastica::sweeps {
namespace {

/// What of a fit claims are about.
struct JudgedFit {
  std::string name;
  calibrate::FitOutcome outcome;
  double misfit = 0.0;   ///< of the worst target [1]
  std::string no_use{};  ///< why it is of no use; empty: it may be used
};

std::string why_not(const calibrate::FitOutcome& outcome, const std::string& no_use) {
  if (outcome.is_fitted()) return no_use.empty() ? "" : "is of no use: " + no_use;
  const std::string ended(calibrate::name_of(outcome.status));
  return outcome.reason.empty() ? "is " + ended : "is " + ended + ": " + outcome.reason;
}

JudgedFit judged(const calibrate::FitRecord& record) {
  const calibrate::FitResult& result = record.result;
  return {record.target.name, result, result.misfit_fraction,
          why_not(result, calibrate::why_unusable(result))};
}

JudgedFit judged(const calibrate::SceneFitRecord& record) {
  JudgedFit fit{record.name, record.result, 0.0,
                why_not(record.result, calibrate::why_unusable(record.result))};
  for (const calibrate::TargetFit& target : record.result.targets) {
    fit.misfit = std::isnan(target.misfit_fraction) ? target.misfit_fraction
                                                    : std::max(fit.misfit, target.misfit_fraction);
  }
  return fit;
}

template <typename Record>
void add_fits(const Claim& claim, std::span<const Record> records, std::vector<JudgedFit>& fits) {
  if (records.empty()) return;
  const auto add = [&](const Record& record) {
    JudgedFit fit = judged(record);
    const bool named =
        std::find(claim.cases.begin(), claim.cases.end(), fit.name) != claim.cases.end();
    if (claim.cases.empty() || named) fits.push_back(std::move(fit));
  };
  if (claim.law.empty()) {
    for (const Record& record : calibrate::of_law(records, "")) add(record);
    return;
  }
  for (const Record& record : records) {
    if (calibrate::name_of(record.result.law) == claim.law) add(record);
  }
}

/// A number of a parameter, or why there is none.
struct ParameterNumber {
  std::optional<double> number{};
  std::string otherwise{};
};

ParameterNumber number_of(const Claim& claim, const JudgedFit& fit) {
  const calibrate::FittedParameter* parameter = fit.outcome.find_parameter(claim.parameter);
  const std::string name(calibrate::last_part(claim.parameter));
  if (parameter == nullptr) return {std::nullopt, "has no parameter " + name};
  std::string why = calibrate::why_no_answer(*parameter);
  if (!why.empty()) {
    if (parameter->identified && parameter->at_bound()) {
      why += ", " + parameter_text(claim, parameter->value);
    }
    return {std::nullopt, why};
  }
  switch (claim.kind) {
    case ClaimKind::Value: return {parameter->value, name + " has no value"};
    case ClaimKind::Error:
      return {std::abs(parameter->value - claim.truth) / std::abs(claim.truth),
              name + " has no value"};
    default: break;
  }
  // How far the truth lies outside of the interval; NaN where there is none.
  const double low = parameter->interval_low;
  const double high = parameter->interval_high;
  if (!std::isfinite(low) || !std::isfinite(high)) {
    return {std::nullopt, name + " has no confidence interval"};
  }
  return {std::max({0.0, low - claim.truth, claim.truth - high}), ""};
}

/// "yield_stress 277.8 MPa", or its interval.
std::string found_of(const Claim& claim, const JudgedFit& fit) {
  const calibrate::FittedParameter* parameter = fit.outcome.find_parameter(claim.parameter);
  if (parameter == nullptr) return "";
  const auto text = [&](double number) { return parameter_text(claim, number); };
  if (claim.kind == ClaimKind::Interval) {
    return text(parameter->interval_low) + " … " + text(parameter->interval_high);
  }
  return parameter->name() + " " + text(parameter->value);
}

ClaimVerdict judge_count(const Claim& claim, const std::vector<JudgedFit>& fits) {
  const auto is_bad = [](const JudgedFit& fit) { return !fit.no_use.empty(); };
  const auto bad = static_cast<std::size_t>(std::count_if(fits.begin(), fits.end(), is_bad));
  Worst worst(claim);
  const std::size_t counted = claim.kind == ClaimKind::Failed ? bad : fits.size() - bad;
  worst.add(static_cast<double>(counted), 0, "");
  ClaimVerdict verdict = worst.verdict();
  const auto first = std::find_if(fits.begin(), fits.end(), is_bad);
  if (!verdict.holds && first != fits.end()) verdict.beside = first->name + " " + first->no_use;
  verdict.worst.clear();
  verdict.judged = bad;
  for (const JudgedFit& fit : fits) {
    if (!is_bad(fit) || verdict.worst.size() == kMostJudged) continue;
    verdict.worst.push_back({fit.name, std::nullopt, fit.no_use});
  }
  return verdict;
}

}  // namespace

ClaimVerdict judge(const Claim& claim, const FittedRecords& records) {
  std::vector<JudgedFit> fits;
  add_fits(claim, std::span<const calibrate::FitRecord>(records.curves), fits);
  add_fits(claim, std::span<const calibrate::SceneFitRecord>(records.scenes), fits);
  if (fits.empty()) {
    ClaimVerdict none;
    none.reason = claim.law.empty() ? "there is no fit" : "no fit is by the law " + claim.law;
    return none;
  }
  if (claim.kind == ClaimKind::Failed || claim.kind == ClaimKind::Fitted) {
    return judge_count(claim, fits);
  }
  Worst worst(claim);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    if (!fits[k].no_use.empty()) {
      worst.add(std::nullopt, k, fits[k].no_use);
    } else if (claim.kind == ClaimKind::Misfit) {
      worst.add(fits[k].misfit, k, "has no misfit");
    } else {
      const ParameterNumber found = number_of(claim, fits[k]);
      worst.add(found.number, k, found.otherwise);
    }
  }
  ClaimVerdict verdict = worst.verdict([&](std::size_t k) { return fits[k].name; });
  const JudgedFit& decisive = fits[worst.whose().value_or(0)];
  verdict.at = "of " + decisive.name;
  if (verdict.number && claim.kind == ClaimKind::Interval)
    verdict.found = found_of(claim, decisive);
  if (verdict.number && claim.kind == ClaimKind::Error) verdict.beside = found_of(claim, decisive);
  return verdict;
}

}  // namespace plastica::sweeps
