#pragma once

#include "plastica/model/field.hpp"

/// What each field is to the error of a result, said once for all that ask.
namespace plastica::sweeps {

/// What a finer discretization does to a field's value.
enum class Refinement {
  None,   ///< the field is no measure of fineness
  Count,  ///< it grows: the size is 1/value
  Size,   ///< it falls: the size is the value
};

Refinement refinement_of(const Field& field);

enum class AxisRole {
  Problem,  ///< part of the problem: each value has a result of its own to converge to
  Number,   ///< refines by its number: `refinement_of`
  Word,     ///< refines by its word: `is_finest_word`
  Method,   ///< a choice of the solver's without a known order of fineness
};

AxisRole role_of(const Field& field);

/// Whether a word is one of the finest of a field of role Word. No order is known of two that are,
/// nor of two that are not.
bool is_finest_word(const Field& field, const FieldValue& value);

/// Whether all words of a field come to the same result as the numbers are refined, so that errors
/// of a coarser word fall to zero, too: ways to step time, ways to join ends.
bool words_converge(const Field& field);

}  // namespace plastica::sweeps
