#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
  /// Paths of axes whose error is not in that of a case, "solver.time_step"; empty: it is the error
  /// of all axes that refine (n_cases).
  std::vector<std::string> lacks{};
  /// Paths of axes besides the refined one in which a case is coarser than its reference: along the
  /// refined axis its error falls to theirs, and shows no order. Empty: in none (n_cases).
  std::vector<std::string> coarser_in{};
  /// About how far the reference itself is off, over the scale [1], >= 0; none of a truth, and
  /// where it cannot be said (n_cases).
  std::vector<std::optional<double>> reference_error{};
  /// For the user: what the reference is, and what no error of the sweep has in it.
  std::vector<std::string> notes{};
};

/// What `reason` says of a case that others are compared with, and of one that is its run.
inline constexpr std::string_view kIsReference = "is the finest, the reference of its group";
inline constexpr std::string_view kIsRunOfReference = "is the run of the finest, its reference";
/// How `reason` begins where refinement changes what happens.
inline constexpr std::string_view kNotConverged = "not converged: ";
/// How it begins of a case that ends in another way than its reference, or breaks elsewhere.
inline constexpr std::string_view kEndsOtherwise = "ends otherwise: ";

/// What an error of some axes alone is: "error of beam.segments alone; that of solver.time_step is
/// not in it".
/// @param lacks  not empty
std::string error_alone(std::string_view refined, const std::string& lacks);

/// Compares all cases. Never throws for what one case lacks.
///
/// Against "finest" the reference is the case that is finest in all axes that refine, of those of
/// one problem; against "richardson" what is extrapolated in all of them. Where there is neither,
/// each group has its own along the refined axis, and `lacks` says so.
/// @param ids  of the runs: cases with the same are one; empty: none are (n_cases)
Comparison compare(const Sweep& sweep, const CaseTable& cases,
                   const std::vector<RefinementGroup>& groups,
                   const std::vector<CaseResult>& results, std::span<const std::string> ids = {});

/// Refuses a sweep whose closed form does not exist or does not hold for its first case.
/// @throws InputError
void check_reference(const Sweep& sweep, const CaseTable& cases);

}  // namespace plastica::sweeps
