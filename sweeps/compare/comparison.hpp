#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sweeps/plan/sweep.hpp"
#include "sweeps/run/case_result.hpp"

namespace plastica::sweeps {

/// Cases that differ by nothing but the refinement of their discretization.
struct RefinementGroup {
  std::string label;               ///< what else tells them apart: "rules.end_rule = equal"
  std::vector<std::size_t> cases;  ///< from the coarsest to the finest (n)
  std::vector<double> size;        ///< of each, falling or the same (n)

  /// Places in the group of which no earlier one has the same size, but for rounding.
  std::vector<std::size_t> distinct() const;
};

/// The groups of a sweep; none where no axis refines.
std::vector<RefinementGroup> refinement_groups(const Sweep& sweep, const CaseTable& cases);

/// What cases are compared with, and how far they are off it.
struct Comparison {
  std::vector<std::optional<double>> reference;  ///< [SI]; none of a curve (n_cases)
  /// (value - reference)/scale, of a curve the rms difference over the rms of the reference; none
  /// for a case without value, and for the finest case against itself (n_cases).
  std::vector<std::optional<double>> error;
  /// Of a curve its reference at the case's own times [SI]; empty where there is none (n_cases).
  std::vector<std::vector<double>> reference_curve;
  std::vector<std::string> reason;  ///< why a case with a value has no error (n_cases)
};

/// Compares all cases. Never throws for what one case lacks.
Comparison compare(const Sweep& sweep, const CaseTable& cases,
                   const std::vector<RefinementGroup>& groups,
                   const std::vector<CaseResult>& results);

/// Refuses a sweep whose closed form does not exist or does not hold for its first case.
/// @throws InputError
void check_reference(const Sweep& sweep, const CaseTable& cases);

}  // namespace plastica::sweeps
