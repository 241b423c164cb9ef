#include "calibrate/report/law_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "calibrate/fit/scene_laws.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/target/curve_spool.hpp"

namespace plastica::calibrate {
namespace {

LawFit law_fit_of(const FitRecord& record) {
  const FitResult& result = record.result;
  LawFit fit;
  fit.law = result.law;
  fit.fitted = result.status == FitStatus::Fitted;
  if (!fit.fitted) return fit;
  fit.curves.push_back(
      {.mean_square = result.misfit_rms * result.misfit_rms,
       .largest = result.misfit_fraction > 0.0
                      ? result.misfit_rms / result.misfit_fraction
                      : largest_magnitude(with_samples(record.target.corrected).stress),
       .samples = result.effective_samples,
       .autocorrelation = result.autocorrelation,
       .noise = result.noise});
  for (const FittedParameter& p : result.parameters) {
    if (p.role != ParameterRole::Free || p.is_break() || !p.judgement) continue;
    fit.parameters.push_back(p.name());
    fit.verdicts.push_back(p.judgement->verdict);
  }
  fit.evaluations = result.evaluations() + result.simpler_evaluations;
  fit.misfit_fraction = result.misfit_fraction;
  fit.lacks_fit = lacks_fit(result.misfit_fraction, result.runs_test_p);
  const FittedParameter* modulus = result.find_parameter("material.youngs_modulus");
  double& squared = fit.curves.back().prior;
  if (result.stated_priors) squared = result.stated_priors->squared;
  if (const auto& prior = result.modulus_prior; prior && modulus != nullptr) {
    const double off = modulus->value - prior->mean;
    squared += std::pow(off / prior->standard_deviation, 2);
  }
  fit.parts = result.held_out;
  if (result.unseen) fit.specimens.push_back(*result.unseen);
  return fit;
}

template <typename Record>
using Records = std::vector<const Record*>;

template <typename Record>
std::vector<Records<Record>> targets_of(std::span<const Record> records) {
  std::vector<Records<Record>> targets;
  std::unordered_map<std::string_view, std::size_t> index;
  for (const Record& record : records) {
    const auto [at, is_new] = index.try_emplace(name_of(record), targets.size());
    if (is_new) targets.emplace_back();
    targets[at->second].push_back(&record);
  }
  return targets;
}

template <typename Record>
bool has_laws(std::span<const Record> records) {
  // All targets have the same laws.
  return std::ranges::any_of(
      records.subspan(std::min<std::size_t>(records.size(), 1)),
      [&](const Record& record) { return name_of(record) == name_of(records.front()); });
}

template <typename Record>
std::vector<LawFit> law_fits(const Records<Record>& records) {
  std::vector<LawFit> fits;
  for (const Record* record : records) fits.push_back(law_fit_of(*record));
  return fits;
}

template <typename Record>
LawComparison compare_all(std::span<const Record> records) {
  std::vector<std::vector<LawFit>> targets;
  for (const auto& target : targets_of(records)) targets.push_back(law_fits(target));
  return compare_laws_over(std::move(targets));
}

template <typename Record>
std::size_t to_the_front(std::vector<Record>& records) {
  const std::span<const Record> all(records);
  if (!has_laws(all)) return records.size();
  const LawComparison laws = compare_all(all);
  if (laws.laws.empty()) return 0;
  const Law law = laws.laws[laws.advised.value_or(0)].fit.law;
  const auto rest = std::stable_partition(records.begin(), records.end(),
                                          [&](const Record& r) { return r.result.law == law; });
  return static_cast<std::size_t>(rest - records.begin());
}

template <typename Record>
std::vector<Record> select(std::span<const Record> records, const std::string& law) {
  std::vector<Record> chosen(records.begin(), records.end());
  if (law.empty()) {
    chosen.resize(to_the_front(chosen));
    return chosen;
  }
  std::erase_if(chosen, [&](const Record& r) { return calibrate::name_of(r.result.law) != law; });
  if (!chosen.empty()) return chosen;
  std::vector<std::string> names;
  for (const Record& record : records) {
    const std::string name(calibrate::name_of(record.result.law));
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  throw InputError({}, "--law", law,
                   fmt::format("is no law of this file; it has {}", fmt::join(names, ", ")));
}

template <typename Record>
std::string label(const Record& record, bool compared) {
  return compared ? name_of(record) + ':' + std::string(calibrate::name_of(record.result.law))
                  : name_of(record);
}

template <typename Record>
void split(std::span<const Record> records, std::string& name, std::string& law) {
  if (!has_laws(records)) return;
  for (const Record& record : records) {
    if (label(record, true) != name) continue;
    law = calibrate::name_of(record.result.law);
    name = name_of(record);
    return;
  }
}

}  // namespace

std::vector<LawRecords> by_target(std::span<const FitRecord> records) {
  return targets_of(records);
}
std::vector<SceneLawRecords> by_target(std::span<const SceneFitRecord> records) {
  return targets_of(records);
}

bool compares_laws(std::span<const FitRecord> records) { return has_laws(records); }
bool compares_laws(std::span<const SceneFitRecord> records) { return has_laws(records); }

LawComparison compare_laws(const LawRecords& records) { return compare_laws(law_fits(records)); }
LawComparison compare_laws(const SceneLawRecords& records) {
  return compare_laws(law_fits(records));
}

LawComparison compare_laws(std::span<const FitRecord> records) { return compare_all(records); }
LawComparison compare_laws(std::span<const SceneFitRecord> records) { return compare_all(records); }

std::size_t advised_first(std::vector<FitRecord>& records) { return to_the_front(records); }
std::size_t advised_first(std::vector<SceneFitRecord>& records) { return to_the_front(records); }

std::vector<FitRecord> of_law(std::span<const FitRecord> records, const std::string& law) {
  return select(records, law);
}
std::vector<SceneFitRecord> of_law(std::span<const SceneFitRecord> records,
                                   const std::string& law) {
  return select(records, law);
}

void split_label(std::span<const FitRecord> records, std::string& name, std::string& law) {
  split(records, name, law);
}
void split_label(std::span<const SceneFitRecord> records, std::string& name, std::string& law) {
  split(records, name, law);
}

std::string label_of(const FitRecord& record, bool compared) { return label(record, compared); }
std::string label_of(const SceneFitRecord& record, bool compared) {
  return label(record, compared);
}

}  // namespace plastica::calibrate
