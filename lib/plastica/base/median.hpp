#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plastica {

/// The value that `rank` of some values would stand before if they were in order; it changes their
/// order.
///
/// What std::nth_element finds, a third of its time: a processor cannot foresee how numbers in no
/// order compare, so that no branch here hangs on it.
/// @param values  none of them NaN
/// @param rank  below their number
double value_of_rank(std::span<double> values, std::size_t rank);

/// The middle one of some values; of an even number of them the mean of the two in the middle.
/// @param values  one or more, none of them NaN
double median_of(std::vector<double> values);

}  // namespace plastica
