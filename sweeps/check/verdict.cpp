#include "sweeps/check/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sweeps/check/worst.hpp"
#include "sweeps/compare/convergence.hpp"
#include "sweeps/plan/refining.hpp"
#include "sweeps/trade/setting.hpp"

namespace plastica::sweeps {
namespace {

bool is_chosen(const Claim& claim, const SweepRecord& record, std::size_t index) {
  return std::all_of(claim.only.begin(), claim.only.end(), [&](const auto& wanted) {
    const auto& [axis, values] = wanted;
    return std::find(values.begin(), values.end(), record.at(index, axis)) != values.end();
  });
}

/// The chosen cases: by groups of refinement, or all together where nothing refines.
std::vector<RefinementGroup> chosen_groups(const Claim& claim, const SweepRecord& record) {
  std::vector<RefinementGroup> groups;
  if (!record.refined) {
    RefinementGroup all;
    for (std::size_t i = 0; i < record.cases(); ++i) {
      if (is_chosen(claim, record, i)) all.cases.push_back(i);
    }
    if (!all.cases.empty()) groups.push_back(std::move(all));
  }
  for (const RefinementGroup& group : record.groups) {
    RefinementGroup kept{group.label, {}, {}};
    for (std::size_t k = 0; k < group.cases.size(); ++k) {
      if (!is_chosen(claim, record, group.cases[k])) continue;
      kept.cases.push_back(group.cases[k]);
      kept.size.push_back(group.size[k]);
    }
    if (!kept.cases.empty()) groups.push_back(std::move(kept));
  }
  return groups;
}

/// What a case without a number says of itself.
std::string why(const SweepRecord& record, std::size_t i) {
  const CaseResult& result = record.results[i];
  if (!usable(result.status)) {
    const std::string ended = "ended as " + std::string(name_of(result.status));
    return result.reason.empty() ? ended : ended + ": " + result.reason;
  }
  if (!result.reason.empty()) return result.reason;
  if (!record.comparison.reason[i].empty()) return record.comparison.reason[i];
  return "has no value";
}

/// An order is one along an axis at the finest of the others: where groups at the finest are among
/// those of the claim, the others have no say.
void keep_finest_of_others(const Claim& claim, const SweepRecord& record,
                           std::vector<RefinementGroup>& groups) {
  if (claim.kind != ClaimKind::Order && claim.kind != ClaimKind::Correlation) return;
  const auto stops = [&](const RefinementGroup& group) {
    return !convergence_of(group, record.results, record.comparison).stops_at.empty();
  };
  if (std::all_of(groups.begin(), groups.end(), stops)) return;
  groups.erase(std::remove_if(groups.begin(), groups.end(), stops), groups.end());
}

/// Why a group has no order.
std::string no_order(const GroupConvergence& found) {
  if (found.stops_at.empty()) return "there is no order";
  return "there is no order: its errors stop at that of " + found.stops_at;
}

/// Of one group: what claims of order and extrapolation ask for.
/// @param g  its number
void add_group(const Claim& claim, const SweepRecord& record, const RefinementGroup& group,
               std::size_t g, Worst& worst) {
  for (const std::size_t i : group.cases) {
    const bool unconverged = record.comparison.reason[i].starts_with(kNotConverged);
    if (unconverged || !usable(record.results[i].status)) {
      worst.add(std::nullopt, g, setting_text(record, i) + " " + why(record, i));
      return;
    }
  }
  const GroupConvergence found = convergence_of(group, record.results, record.comparison);
  if (claim.kind == ClaimKind::Order) {
    worst.add(found.fit.order, g, no_order(found));
  } else if (claim.kind == ClaimKind::Correlation) {
    worst.add(found.fit.correlation, g, no_order(found));
  } else if (claim.kind == ClaimKind::Gci) {
    worst.add(found.grid ? found.grid->fine_index : std::nullopt, g, "there is no index");
  } else {
    const std::string& lacks = record.comparison.lacks[group.cases.back()];
    if (!lacks.empty()) {
      worst.add(std::nullopt, g, error_alone(record.axes[*record.refined].field->path, lacks));
      return;
    }
    std::optional<double> error;
    const auto& reference = record.comparison.reference[group.cases.back()];
    if (found.grid && found.grid->extrapolated && reference) {
      const double scale = record.error_scale.value_or(std::abs(*reference));
      error = std::abs(*found.grid->extrapolated - *reference) / scale;
    }
    worst.add(error, g, "nothing can be extrapolated");
  }
}

/// About how far a case is off that is the reference itself, or its run; none of other cases.
std::optional<double> error_of_reference(const SweepRecord& record, std::size_t i) {
  const std::string& reason = record.comparison.reason[i];
  if (reason != kIsReference && reason != kIsRunOfReference) return std::nullopt;
  return record.comparison.reference_error[i];
}

/// The size of a case's error, where it is that of all axes.
std::optional<double> size_of_error(const SweepRecord& record, std::size_t i) {
  const auto& error = record.comparison.error[i];
  return error ? std::optional(std::abs(*error)) : error_of_reference(record, i);
}

void add_case(const Claim& claim, const SweepRecord& record, std::size_t i, Worst& worst) {
  const CaseResult& result = record.results[i];
  const std::string& lacks = record.comparison.lacks[i];
  if (claim.kind == ClaimKind::Error && !lacks.empty()) {
    worst.add(std::nullopt, i, error_alone(record.axes[*record.refined].field->path, lacks));
    return;
  }
  // Motions whose energy is not balanced have values, too, and are not to be trusted.
  std::optional<double> number;
  if (usable(result.status)) {
    switch (claim.kind) {
      case ClaimKind::Error: number = size_of_error(record, i); break;
      case ClaimKind::Value: number = result.value; break;
      case ClaimKind::EnergyBalance: number = result.energy_balance_error; break;
      default: number = static_cast<double>(result.segment_iterations());
    }
  }
  worst.add(number, i, number ? "" : why(record, i));
}

/// (largest - least)/|mean| of the values of a group.
/// @param g  its number
void add_spread(const SweepRecord& record, const RefinementGroup& group, std::size_t g,
                Worst& worst) {
  std::vector<double> values;
  for (const std::size_t i : group.cases) {
    const CaseResult& result = record.results[i];
    if (!result.value || !usable(result.status)) {
      worst.add(std::nullopt, g, setting_text(record, i) + " " + why(record, i));
      return;
    }
    values.push_back(*result.value);
  }
  if (values.size() < 2) {
    worst.add(std::nullopt, g, "is one case: a spread is of two and more");
    return;
  }
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  worst.add(mean != 0.0 ? std::optional((*largest - *least) / std::abs(mean)) : std::nullopt, g,
            "the values have the mean 0");
}

std::string at(const std::string& place) { return place.empty() ? "" : "at " + place; }

/// A value with the unit of what is compared.
std::string shown(const SweepRecord& record, double value) {
  return fmt::format("{:.6g}{}", value,
                     record.quantity.unit == "1" ? "" : " " + record.quantity.unit);
}

/// What a case's error is made of: "tip, end -0.75 m, reference -0.735 m".
std::string made_of(const SweepRecord& record, std::size_t i) {
  const auto& value = record.results[i].value;
  const auto& reference = record.comparison.reference[i];
  if (!value || !reference) return "";
  return fmt::format("{} {}, reference {}", record.quantity.name, shown(record, *value),
                     shown(record, *reference));
}

/// Has a verdict on a count name what was counted.
template <typename Counted, typename NameOf>
void name_counted(const Counted& counted, ClaimVerdict& verdict, const NameOf& name) {
  verdict.worst.clear();
  verdict.judged = counted.size();
  for (const auto& one : counted) {
    if (verdict.worst.size() == kMostJudged) return;
    verdict.worst.push_back(name(one));
  }
}

/// Of the chosen cases those that failed, the first of them with its reason.
ClaimVerdict judge_failures(const Claim& claim, const SweepRecord& record,
                            const std::vector<RefinementGroup>& groups) {
  std::vector<std::size_t> failed;
  bool any = false;
  for (const RefinementGroup& group : groups) {
    for (const std::size_t i : group.cases) {
      any = true;
      if (!usable(record.results[i].status)) failed.push_back(i);
    }
  }
  Worst worst(claim);
  if (any) worst.add(static_cast<double>(failed.size()), 0, "");
  ClaimVerdict verdict = worst.verdict();
  if (!verdict.holds && !failed.empty()) {
    const std::string of = setting_text(record, failed.front());
    verdict.beside = (of.empty() ? "" : of + " ") + why(record, failed.front());
  }
  name_counted(failed, verdict, [&](std::size_t i) {
    return JudgedNumber{setting_text(record, i), std::nullopt, why(record, i)};
  });
  return verdict;
}

/// How the chosen cases ended, or the first that ended otherwise than it should.
ClaimVerdict judge_statuses(const Claim& claim, const SweepRecord& record,
                            const std::vector<RefinementGroup>& groups) {
  ClaimVerdict verdict;
  std::vector<Status> ended;
  std::vector<std::size_t> others;  // that ended otherwise
  for (const RefinementGroup& group : groups) {
    for (const std::size_t i : group.cases) {
      const CaseResult& result = record.results[i];
      const auto allowed = [&](const std::vector<Status>& all) {
        return std::find(all.begin(), all.end(), result.status) != all.end();
      };
      if (!allowed(claim.statuses)) others.push_back(i);
      if (!allowed(ended)) ended.push_back(result.status);
    }
  }
  name_counted(others, verdict, [&](std::size_t i) {
    return JudgedNumber{setting_text(record, i), std::nullopt, why(record, i)};
  });
  if (!others.empty()) {
    const CaseResult& first = record.results[others.front()];
    verdict.found = name_of(first.status);
    verdict.at = at(setting_text(record, others.front()));
    verdict.beside = first.reason;
    return verdict;
  }
  if (ended.empty()) verdict.reason = "no case is chosen";
  verdict.holds = !ended.empty();
  for (const Status status : ended) {
    verdict.found.append(verdict.found.empty() ? "" : ", ").append(name_of(status));
  }
  return verdict;
}

/// The errors of a group over what is refined in it.
JudgedErrors errors_of(const SweepRecord& record, const RefinementGroup& group) {
  const Field& field = *record.axes[*record.refined].field;
  const std::string_view unit = si_unit(field.dimension);
  JudgedErrors errors{std::string(field.path)};
  if (unit != "1") errors.over += fmt::format(" [{}]", unit);
  const bool count = refinement_of(field) == Refinement::Count;
  for (std::size_t k = 0; k < group.cases.size(); ++k) {
    const double error = std::abs(record.comparison.error[group.cases[k]].value_or(0.0));
    if (!(error > 0.0) || !std::isfinite(error)) continue;
    errors.points.push_back({count ? 1.0 / group.size[k] : group.size[k], error});
  }
  return errors;
}

bool is_of_groups(ClaimKind kind) {
  return kind == ClaimKind::Order || kind == ClaimKind::Correlation || kind == ClaimKind::Gci ||
         kind == ClaimKind::ExtrapolatedError || kind == ClaimKind::Spread;
}

}  // namespace

ClaimVerdict judge(const Claim& claim, const SweepRecord& record) {
  std::vector<RefinementGroup> groups = chosen_groups(claim, record);
  keep_finest_of_others(claim, record, groups);
  if (claim.kind == ClaimKind::Failed) return judge_failures(claim, record, groups);
  if (claim.kind == ClaimKind::Status) return judge_statuses(claim, record, groups);
  Worst worst(claim);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (claim.kind == ClaimKind::Spread) {
      add_spread(record, groups[g], g, worst);
    } else if (is_of_groups(claim.kind)) {
      add_group(claim, record, groups[g], g, worst);
    } else {
      for (const std::size_t i : groups[g].cases) add_case(claim, record, i, worst);
    }
  }
  ClaimVerdict verdict = worst.verdict([&](std::size_t whose) {
    return is_of_groups(claim.kind) ? groups[whose].label : setting_text(record, whose);
  });
  if (!worst.whose()) return verdict;
  if (is_of_groups(claim.kind)) {
    verdict.at = at(groups[*worst.whose()].label);
    if (claim.kind != ClaimKind::Spread) verdict.errors = errors_of(record, groups[*worst.whose()]);
  } else {
    verdict.at = at(setting_text(record, *worst.whose()));
    if (claim.kind == ClaimKind::Error && verdict.number) {
      verdict.beside = made_of(record, *worst.whose());
    }
  }
  return verdict;
}

ClaimVerdict judge(const Claim& claim, std::span<const stability::StabilityRow> rows) {
  Worst worst(claim);
  if (rows.empty()) return worst.verdict();
  const auto counts = [&](const stability::StabilityRow& row) {
    const auto validity = row.verdict.validity;
    return claim.kind == ClaimKind::Undetected ? validity == stability::Validity::Undetected
                                               : validity != stability::Validity::Valid;
  };
  std::vector<const stability::StabilityRow*> counted;
  for (const stability::StabilityRow& row : rows) {
    if (counts(row)) counted.push_back(&row);
  }
  worst.add(static_cast<double>(counted.size()), 0, "");
  ClaimVerdict verdict = worst.verdict();
  if (!verdict.holds && !counted.empty()) {
    const stability::StabilityRow& first = *counted.front();
    verdict.beside = "the first: " + first.id + ": " + first.verdict.reason;
  }
  name_counted(counted, verdict, [](const stability::StabilityRow* row) {
    const auto word = stability::kValidity[static_cast<std::size_t>(row->verdict.validity)];
    return JudgedNumber{row->id, std::nullopt, fmt::format("{}: {}", word, row->verdict.reason)};
  });
  return verdict;
}

}  // namespace plastica::sweeps
