#include "sweeps/check/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plastica/io/result_file.hpp"
#include "sweeps/compare/convergence.hpp"
#include "sweeps/run/sweep_run.hpp"

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

/// Gathers numbers and keeps the one that is worst against the limits.
class Worst {
 public:
  explicit Worst(const Claim& claim) : claim_(claim) {}

  void add(const std::optional<double>& number, const std::string& otherwise) {
    if (!number || !std::isfinite(*number)) {
      if (reason_.empty()) reason_ = otherwise;
    } else if (!number_ || badness(*number) > badness(*number_)) {
      number_ = number;
    }
  }

  ClaimVerdict verdict() const {
    if (!reason_.empty()) return {false, number_, reason_};
    if (!number_) return {false, std::nullopt, "no case is chosen"};
    return {badness(*number_) <= 0.0, number_, {}};
  }

 private:
  /// How far a number is outside of the limits; inside of them at most 0.
  double badness(double number) const {
    double worst = -std::numeric_limits<double>::infinity();
    if (claim_.at_least) worst = std::max(worst, *claim_.at_least - number);
    if (claim_.at_most) worst = std::max(worst, number - *claim_.at_most);
    return worst;
  }

  const Claim& claim_;
  std::optional<double> number_;
  std::string reason_;
};

/// What a case without a number says of itself.
std::string why(const SweepRecord& record, std::size_t i) {
  const CaseResult& result = record.results[i];
  if (!usable(result.status)) return "a case ended as " + std::string(name_of(result.status));
  if (!result.reason.empty()) return result.reason;
  if (!record.comparison.reason[i].empty()) return record.comparison.reason[i];
  return "a case has no value";
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
std::string no_order(const GroupConvergence& found, const std::string& of) {
  if (found.stops_at.empty()) return "there is no order" + of;
  return "there is no order" + of + ": its errors stop at that of " + found.stops_at;
}

/// Of one group: what claims of order and extrapolation ask for.
void add_group(const Claim& claim, const SweepRecord& record, const RefinementGroup& group,
               Worst& worst) {
  for (const std::size_t i : group.cases) {
    const bool unconverged = record.comparison.reason[i].starts_with(kNotConverged);
    if (unconverged || !usable(record.results[i].status)) worst.add(std::nullopt, why(record, i));
  }
  const GroupConvergence found = convergence_of(group, record.results, record.comparison);
  const std::string of = group.label.empty() ? "" : " of " + group.label;
  if (claim.kind == ClaimKind::Order) {
    worst.add(found.fit.order, no_order(found, of));
  } else if (claim.kind == ClaimKind::Correlation) {
    worst.add(found.fit.correlation, no_order(found, of));
  } else if (claim.kind == ClaimKind::Gci) {
    worst.add(found.grid ? found.grid->fine_index : std::nullopt, "there is no index" + of);
  } else {
    const std::string& lacks = record.comparison.lacks[group.cases.back()];
    if (!lacks.empty()) {
      worst.add(std::nullopt, error_alone(record.axes[*record.refined].field->path, lacks));
      return;
    }
    std::optional<double> error;
    const auto& reference = record.comparison.reference[group.cases.back()];
    if (found.grid && found.grid->extrapolated && reference) {
      const double scale = record.error_scale.value_or(std::abs(*reference));
      error = std::abs(*found.grid->extrapolated - *reference) / scale;
    }
    worst.add(error, "nothing can be extrapolated" + of);
  }
}

/// About how far a case is off that is the reference itself, or its run; none of other cases.
std::optional<double> error_of_reference(const SweepRecord& record, std::size_t i) {
  const std::string& reason = record.comparison.reason[i];
  if (reason != kIsReference && reason != kIsRunOfReference) return std::nullopt;
  return record.comparison.reference_error[i];
}

/// The size of a case's error, where it is that of all axes.
void add_error(const SweepRecord& record, std::size_t i, Worst& worst) {
  const std::string& lacks = record.comparison.lacks[i];
  if (!lacks.empty()) {
    worst.add(std::nullopt, error_alone(record.axes[*record.refined].field->path, lacks));
    return;
  }
  const auto& error = record.comparison.error[i];
  worst.add(error ? std::optional(std::abs(*error)) : error_of_reference(record, i),
            why(record, i));
}

void add_case(const Claim& claim, const SweepRecord& record, std::size_t i, Worst& worst) {
  const CaseResult& result = record.results[i];
  switch (claim.kind) {
    case ClaimKind::Error: add_error(record, i, worst); return;
    case ClaimKind::Value: worst.add(result.value, why(record, i)); return;
    case ClaimKind::EnergyBalance:
      worst.add(usable(result.status) ? std::optional(result.energy_balance_error) : std::nullopt,
                why(record, i));
      return;
    default:
      worst.add(usable(result.status)
                    ? std::optional(static_cast<double>(result.segment_iterations()))
                    : std::nullopt,
                why(record, i));
      return;
  }
}

/// (largest - least)/|mean| of the values of a group.
void add_spread(const SweepRecord& record, const RefinementGroup& group, Worst& worst) {
  std::vector<double> values;
  for (const std::size_t i : group.cases) {
    if (!record.results[i].value) {
      worst.add(std::nullopt, why(record, i));
      return;
    }
    values.push_back(*record.results[i].value);
  }
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  worst.add(mean != 0.0 ? std::optional((*largest - *least) / std::abs(mean)) : std::nullopt,
            "the values have the mean 0");
}

}  // namespace

ClaimVerdict judge(const Claim& claim, const SweepRecord& record) {
  Worst worst(claim);
  std::optional<double> failed;
  std::vector<RefinementGroup> groups = chosen_groups(claim, record);
  keep_finest_of_others(claim, record, groups);
  for (const RefinementGroup& group : groups) {
    switch (claim.kind) {
      case ClaimKind::Order:
      case ClaimKind::Correlation:
      case ClaimKind::ExtrapolatedError:
      case ClaimKind::Gci: add_group(claim, record, group, worst); break;
      case ClaimKind::Spread: add_spread(record, group, worst); break;
      case ClaimKind::Error:
      case ClaimKind::Value:
      case ClaimKind::EnergyBalance:
      case ClaimKind::Work:
        for (const std::size_t i : group.cases) add_case(claim, record, i, worst);
        break;
      case ClaimKind::Undetected:
      case ClaimKind::Invalid: break;  // of scans
      case ClaimKind::Failed:
        for (const std::size_t i : group.cases) {
          failed = failed.value_or(0.0) + (usable(record.results[i].status) ? 0.0 : 1.0);
        }
        break;
    }
  }
  if (claim.kind == ClaimKind::Failed) worst.add(failed, "no case is chosen");
  return worst.verdict();
}

ClaimVerdict judge(const Claim& claim, std::span<const stability::StabilityRow> rows) {
  Worst worst(claim);
  if (rows.empty()) return worst.verdict();
  const auto count = std::count_if(rows.begin(), rows.end(), [&](const auto& row) {
    const auto validity = row.verdict.validity;
    return claim.kind == ClaimKind::Undetected ? validity == stability::Validity::Undetected
                                               : validity != stability::Validity::Valid;
  });
  worst.add(static_cast<double>(count), "");
  return worst.verdict();
}

std::size_t cases_of(const CheckFile& file) {
  std::size_t cases = 0;
  for (const Sweep& sweep : file.sweeps) cases += CaseTable(sweep).size();
  return cases;
}

std::vector<ClaimVerdict> run_check(const CheckFile& file, const CheckOptions& options) {
  std::vector<SweepRecord> records;
  std::size_t before = 0;
  for (const Sweep& timed : file.sweeps) {
    Sweep sweep = timed;
    sweep.timed_runs = 0;  // no claim is about time
    SweepRunOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    SweepRun run(sweep, std::move(how));
    run.on_progress([&](const SweepProgress& progress) {
      if (options.progress) options.progress(before + progress.done);
    });
    std::vector<CaseResult> results = run.run();
    if (!run.complete()) return {};
    before += results.size();
    records.push_back(make_record(sweep, run.cases(), run.ids(), std::move(results)));
  }
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : file.claims) {
    if (!claim.scan) {
      verdicts.push_back(judge(claim, records[claim.sweep]));
      continue;
    }
    stability::StabilityOptions how = *claim.scan;
    how.threads = options.threads;
    how.stop = options.stop;
    how.max_seconds = std::numeric_limits<double>::infinity();  // no verdict hangs on the machine
    const auto rows = stability::run_stability(how);
    if (is_raised(options.stop)) return {};
    verdicts.push_back(judge(claim, rows));
  }
  return verdicts;
}

}  // namespace plastica::sweeps
