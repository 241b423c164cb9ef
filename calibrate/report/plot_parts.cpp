#include "calibrate/report/plot_parts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/summary.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate::report {
namespace {

std::string measured_parameter(const FitResult& result, std::string_view name,
                               std::string_view symbol, std::string_view remark) {
  const FittedParameter* parameter = find_parameter(result, name);
  if (parameter == nullptr || !parameter->identified) return {};
  const DisplayUnit unit = display_unit(*parameter);
  const double value = parameter->value / unit.scale;
  const std::string number = parameter->has_error()
                                 ? with_error(value, parameter->standard_error / unit.scale)
                                 : significant(value, 4);
  return fmt::format("{} {} {}{}", symbol, number, unit.name, remark);
}

}  // namespace

const FittedParameter* find_parameter(const FitResult& result, std::string_view name) {
  for (const FittedParameter& parameter : result.parameters) {
    if (parameter.name() == name) return &parameter;
  }
  return nullptr;
}

void require_curves(std::span<const FitRecord> records) {
  for (const FitRecord& record : records) {
    if (!record.target.raw.is_aside() && !record.target.corrected.is_aside() &&
        !record.result.fitted.is_aside()) {
      continue;
    }
    throw std::logic_error(record.name() + ": its curves are asked for, but are not here");
  }
}

bool is_fitted(const FitRecord& record) { return record.result.status == FitStatus::Fitted; }

const Curve& measured_of(const FitRecord& record) {
  return record.target.corrected.size() > 0 ? record.target.corrected : record.target.raw;
}

std::vector<std::string> facts_of(const FitRecord& record) {
  if (!is_fitted(record)) {
    return {fmt::format("{}: {}", word_of(record.result.status), reason_of(record))};
  }
  const FitResult& result = record.result;
  std::vector<std::string> facts = {
      measured_parameter(result, "youngs_modulus", "E", ""),
      measured_parameter(result, "yield_stress", "σ_y", ""),
      measured_parameter(result, "shear_yield_stress", "τ_y", ""),
      measured_parameter(result, "break_strain", "ε_break", " permanent"),
      measured_parameter(result, "break_shear_strain", "γ_break", " permanent"),
      fmt::format("misfit {} %", significant(100.0 * result.misfit_fraction, 2))};
  std::erase(facts, std::string());
  return facts;
}

std::string strain_label(const Target& target) {
  return fmt::format("{}{} strain [%]", word_of(target.measure),
                     target.test == Test::Torsion ? " shear" : "");
}

std::string stress_label(const Target& target) {
  return fmt::format("{}{} stress [MPa]", word_of(target.measure),
                     target.test == Test::Torsion ? " shear" : "");
}

std::optional<std::vector<double>> yield_point(const FitResult& result) {
  const FittedParameter* yield = find_parameter(result, "yield_stress");
  if (yield == nullptr) yield = find_parameter(result, "shear_yield_stress");
  const FittedParameter* modulus = find_parameter(result, "youngs_modulus");
  if (yield == nullptr || !yield->identified) return std::nullopt;
  if (modulus != nullptr && yield->name() == "yield_stress" && modulus->value > 0.0) {
    return std::vector<double>{100.0 * yield->value / modulus->value, 1e-6 * yield->value};
  }
  for (std::size_t i = 0; i < result.fitted.size(); ++i) {
    if (result.fitted.stress[i] >= yield->value * (1.0 - 1e-9)) {
      return std::vector<double>{100.0 * result.fitted.strain[i], 1e-6 * yield->value};
    }
  }
  return std::nullopt;
}

Curve fitted_with_fall(const FitResult& result) {
  Curve curve = result.fitted;
  if (!result.break_strain_total) return curve;
  const double strain = *result.break_strain_total;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const bool falls = curve.stress[i] == 0.0 && curve.stress[i - 1] != 0.0;
    const auto [low, high] = std::minmax(curve.strain[i - 1], curve.strain[i]);
    if (!falls || !(low < strain && strain < high)) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    curve.strain.insert(curve.strain.begin() + at, 2, strain);
    curve.stress.insert(curve.stress.begin() + at, {curve.stress[i - 1], 0.0});
    break;
  }
  return curve;
}

Curve fitted_with_break(const FitResult& result) {
  Curve curve = fitted_with_fall(result);
  if (!result.break_strain_total || curve.size() == 0) return curve;
  const double strain = *result.break_strain_total;
  const bool falls = std::any_of(curve.stress.begin() + 1, curve.stress.end(),
                                 [](double stress) { return stress == 0.0; });
  if (falls) return curve;
  const double stress = curve.stress.back();
  if (strain > curve.strain.back()) {
    curve.strain.push_back(strain);
    curve.stress.push_back(stress);
  }
  curve.strain.push_back(curve.strain.back());
  curve.stress.push_back(0.0);
  return curve;
}

void add_break(const FitRecord& record, std::vector<std::vector<double>>& rows) {
  const std::optional<BreakObservation>& observed = record.target.characteristics.observed_break;
  if (observed) rows.push_back({100.0 * observed->strain(), 1e-6 * observed->last_intact_stress});
}

Curve fitted_until_break(const FitResult& result) {
  Curve curve = result.fitted;
  while (curve.size() > 1 && curve.stress.back() == 0.0) {
    curve.strain.pop_back();
    curve.stress.pop_back();
  }
  return curve;
}

std::string label_of_all(std::span<const FitRecord> records, std::span<const std::size_t> members,
                         std::string (*label)(const Target&)) {
  std::vector<std::string> labels;
  for (const std::size_t i : members) {
    std::string own = label(records[i].target);
    if (std::ranges::find(labels, own) == labels.end()) labels.push_back(std::move(own));
  }
  return fmt::format("{}", fmt::join(labels, ", "));
}

std::pair<double, double> largest_of(std::span<const FitRecord> records) {
  std::pair<double, double> most = {0.0, 0.0};
  const bool any_counts = std::ranges::any_of(records, counts_in_group);
  for (const FitRecord& record : records) {
    // A unit that is taken for another one would leave the others a line along the axis.
    if (any_counts && !counts_in_group(record)) continue;
    for (const Curve* curve : {&measured_of(record), &record.result.fitted}) {
      for (std::size_t i = 0; i < curve->size(); ++i) {
        if (std::isfinite(curve->strain[i])) most.first = std::max(most.first, curve->strain[i]);
        if (std::isfinite(curve->stress[i])) most.second = std::max(most.second, curve->stress[i]);
      }
    }
  }
  return most;
}

bool any_cyclic(std::span<const FitRecord> records) {
  return std::any_of(records.begin(), records.end(), [](const FitRecord& record) {
    return record.target.loading == Loading::Cyclic;
  });
}

GroupCurves curves_of(std::span<const FitRecord> records, const std::vector<std::size_t>& members) {
  GroupCurves curves;
  for (const std::size_t i : members) {
    const FitRecord& record = records[i];
    if (!counts_in_group(record) || measured_of(record).size() < 2) continue;
    curves.drawn.push_back(&record);
    curves.measured.push_back(&measured_of(record));
  }
  return curves;
}

std::vector<std::vector<std::size_t>> drawable_groups(std::span<const FitRecord> records) {
  std::vector<std::vector<std::size_t>> groups = group_indices(records);
  std::erase_if(groups, [&](const std::vector<std::size_t>& members) {
    return curves_of(records, members).drawn.empty();
  });
  if (groups.empty()) {
    const std::string reason = reason_of(records.front());
    throw InputError({}, "--what", "overview",
                     "no specimen has a curve to draw; " + records.front().target.name + ": " +
                         (reason.empty() ? "no samples" : reason));
  }
  return groups;
}

std::vector<FittedParameter> free_parameters(std::span<const FitRecord> records) {
  std::vector<FittedParameter> shown;
  for (const FitRecord& record : records) {
    if (!is_fitted(record)) continue;
    for (const FittedParameter& parameter : record.result.parameters) {
      // One that no curve determines has no point.
      const bool seen = std::ranges::any_of(records, [&](const FitRecord& each) {
        const FittedParameter* found =
            is_fitted(each) ? find_parameter(each.result, parameter.name()) : nullptr;
        return found != nullptr && found->identified;
      });
      if (parameter.role == ParameterRole::Free && seen) shown.push_back(parameter);
    }
    break;
  }
  if (shown.empty()) throw InputError({}, "--what", "parameters", "there is no fitted specimen");
  return shown;
}

GroupValues values_of(std::span<const FitRecord> records,
                      const std::vector<std::vector<std::size_t>>& groups,
                      const FittedParameter& parameter) {
  const DisplayUnit unit = display_unit(parameter);
  GroupValues all;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::vector<double> values;
    for (std::size_t k = 0; k < groups[g].size(); ++k) {
      const FitRecord& record = records[groups[g][k]];
      if (!is_fitted(record)) continue;
      const FittedParameter* found = find_parameter(record.result, parameter.name());
      if (found == nullptr || !found->identified) continue;
      values.push_back(found->value / unit.scale);
      // Spread sideways by the golden ratio: even, and the same in each picture.
      const double spread = std::fmod(0.6180339887 * static_cast<double>(k + 1), 1.0) - 0.5;
      all.points.push_back({static_cast<double>(g + 1) + 0.36 * spread, values.back(),
                            (found->has_error() ? found->standard_error : 0.0) / unit.scale});
    }
    const Statistic statistic = statistic_of(std::move(values));
    if (statistic.n > 1) {
      all.means.push_back({static_cast<double>(g + 1) + 0.3, statistic.mean,
                           statistic.standard_deviation.value_or(0.0)});
    }
  }
  return all;
}

}  // namespace plastica::calibrate::report
