#include "calibrate/report/law_choice.hpp"

#include <algorithm>
#include <string_view>

namespace plastica::calibrate {
namespace {

LawFit law_fit_of(const FitRecord& record) {
  const FitResult& result = record.result;
  LawFit fit;
  fit.law = result.law;
  fit.fitted = result.status == FitStatus::Fitted;
  if (!fit.fitted) return fit;
  fit.curves.push_back({.mean_square = result.misfit_rms * result.misfit_rms,
                        .largest = result.misfit_share > 0.0
                                       ? result.misfit_rms / result.misfit_share
                                       : largest_magnitude(record.target.corrected.stress),
                        .samples = result.effective_samples,
                        .autocorrelation = result.autocorrelation,
                        .noise = {}});
  for (const FittedParameter& p : result.parameters) {
    const bool limit = p.name == "break_strain" || p.name == "break_shear_strain";
    if (p.role != ParameterRole::Free || limit || !p.judgement) continue;
    fit.parameters.push_back(p.name);
    fit.verdicts.push_back(p.judgement->verdict);
  }
  fit.evaluations = result.evaluations();
  fit.misfit_share = result.misfit_share;
  fit.lacks_fit = lacks_fit(result.misfit_share, result.runs_probability);
  return fit;
}

/// Adds one target's fit of a law to that of others.
void add(LawFit&& fit, LawFit& sum) {
  const auto append = [](auto&& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  append(fit.curves, sum.curves);
  append(fit.parameters, sum.parameters);
  append(fit.verdicts, sum.verdicts);
  sum.evaluations += fit.evaluations;
  sum.misfit_share = std::max(sum.misfit_share, fit.misfit_share);
  sum.lacks_fit = sum.lacks_fit || fit.lacks_fit;
}

}  // namespace

std::vector<LawRecords> by_target(std::span<const FitRecord> records) {
  std::vector<LawRecords> targets;
  for (const FitRecord& record : records) {
    // Neighbours as a rule: look at the last target first.
    const auto same = [&](const LawRecords& target) {
      return target.front()->target.name == record.target.name;
    };
    const auto found = std::find_if(targets.rbegin(), targets.rend(), same);
    if (found == targets.rend()) {
      targets.push_back({&record});
    } else {
      found->push_back(&record);
    }
  }
  return targets;
}

bool compares_laws(std::span<const FitRecord> records) {
  // All targets have the same laws.
  return std::ranges::any_of(
      records.subspan(std::min<std::size_t>(records.size(), 1)),
      [&](const FitRecord& record) { return record.target.name == records.front().target.name; });
}

LawComparison compare_laws(const LawRecords& records) {
  std::vector<LawFit> fits;
  for (const FitRecord* record : records) fits.push_back(law_fit_of(*record));
  return compare_laws(std::move(fits));
}

LawComparison compare_laws(std::span<const FitRecord> records) {
  std::vector<LawFit> sums;
  const auto targets = by_target(records);
  const auto fitted = [](const FitRecord* record) {
    return record->result.status == FitStatus::Fitted;
  };
  const bool any_whole = std::ranges::any_of(
      targets, [&](const LawRecords& target) { return std::ranges::all_of(target, fitted); });
  const auto failed_somewhere = [&](Law law) {
    return std::ranges::any_of(records, [&](const FitRecord& record) {
      return record.result.law == law && !fitted(&record);
    });
  };
  for (const LawRecords& target : targets) {
    std::vector<LawFit> fits;
    for (const FitRecord* record : target) fits.push_back(law_fit_of(*record));
    for (const LawFit& fit : fits) {
      const auto same = [&](const LawFit& sum) { return sum.law == fit.law; };
      if (std::ranges::none_of(sums, same)) sums.emplace_back().law = fit.law;
    }
    if (any_whole && !std::ranges::all_of(fits, &LawFit::fitted)) continue;
    for (LawFit& fit : fits) {
      if (!any_whole && failed_somewhere(fit.law)) continue;
      LawFit& sum = *std::ranges::find(sums, fit.law, &LawFit::law);
      sum.fitted = true;
      add(std::move(fit), sum);
    }
  }
  return compare_laws(std::move(sums));
}

std::size_t advised_first(std::vector<FitRecord>& records) {
  if (!compares_laws(records)) return records.size();
  const LawComparison all = compare_laws(std::span<const FitRecord>(records));
  if (all.laws.empty()) return 0;
  const Law law = all.laws[all.advised.value_or(0)].fit.law;
  const auto rest = std::stable_partition(records.begin(), records.end(),
                                          [&](const FitRecord& r) { return r.result.law == law; });
  return static_cast<std::size_t>(rest - records.begin());
}

std::string label_of(const FitRecord& record, bool compared) {
  return compared ? record.target.name + ':' + std::string(name_of(record.result.law))
                  : record.target.name;
}

}  // namespace plastica::calibrate
