#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sweeps/compare/comparison.hpp"
#include "sweeps/compare/reference_sets.hpp"

/// The cases next to the finest of a set, one axis at a time; not installed.
namespace plastica::sweeps {

/// Whether two axes are one, or move together.
bool moves_with(const Sweep& sweep, std::size_t axis, std::size_t other);

/// The axes of numbers of a set that move on their own: of those that move together the first.
std::vector<std::size_t> free_axes(const Sweep& sweep, const ReferenceSet& set);

/// Cases that are the finest but along one axis, and have a value: from the finest on, no two of
/// one size.
/// @param set  with a finest case
std::vector<std::size_t> line_of_finest(const Sweep& sweep, const ReferenceSets& sets,
                                        const ReferenceSet& set, std::size_t axis,
                                        const std::vector<CaseResult>& results);

/// Whether two runs end in the same way: with one status, and breaking alike (`break_alike`).
bool end_alike(const CaseResult& one, const CaseResult& other);

/// How a run ends that does not end as its reference does: "breaks at joint 5, the reference at
/// joint 0".
std::string other_end(const CaseResult& result, const CaseResult& reference);

/// What changes between the finest case of a set and the next coarser one along an axis, in words:
/// "breaks at joint 14, 15, 30" (the finest last); empty: nothing.
std::string change_of_outcome(const Sweep& sweep, const ReferenceSets& sets,
                              const ReferenceSet& set, const std::vector<CaseResult>& results);

/// About how far the finest case of a set is off its limit, over the scale of errors [1]: the sum
/// of what Roache's grid convergence index says along each axis, from the errors of the two next
/// coarser cases against it (safety factor 1.25, order at most `theory::kHighestOrder`), or with
/// the order 1 where they show none or a higher one, or there is one case (3); and no less
/// than 1.25 times what `theory::limit_of_two_orders` says of the three. None where an axis has no
/// second case.
std::optional<double> error_of_finest(const Sweep& sweep, const ReferenceSets& sets,
                                      const ReferenceSet& set,
                                      const std::vector<CaseResult>& results,
                                      const Comparison& comparison);

}  // namespace plastica::sweeps
