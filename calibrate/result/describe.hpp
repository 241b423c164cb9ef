#pragma once

#include <string_view>

/// Records of fits, each described once.
///
/// A description is a function that calls `d(NAME, UNITS, MEMBER, MEANING)` for each number, word
/// or text of a record, MEMBER a function from the record to it. The result file, the journal, the
/// JSON summary and CSV tables are visitors d: what is added here is in all of them. A visitor has
/// besides
///   optional(NAME, MEMBER, DESCRIPTION)   of what not every record has (std::optional): NAME tells
///                                     whether it is there;
///   only(CONDITION, DESCRIPTION)      of what only those records have for which it holds;
///   since(VERSION, DESCRIPTION)       of what result files have from a version on;
///   derived(NAME, UNITS, FUNCTION, MEANING)   of what follows from the record: it is written, and
///                                     never read.
namespace plastica::calibrate {

/// In place of units: those of the record's own dimension.
inline constexpr std::string_view kOwnUnits = "*";

#define PLASTICA_MEMBER(member) \
  [](auto& row) -> auto& { return row.member; }

/// Of a FittedParameter. Path, dimension and role are not part of it: they say whose row it is.
inline constexpr auto kDescribeParameter = [](auto& d) {
  d("value", kOwnUnits, PLASTICA_MEMBER(value), "fitted, fixed or tied value");
  d("standard_error", kOwnUnits, PLASTICA_MEMBER(standard_error),
    "as of the material: noise, sampling, misfit and segments, whose squares add up");
  d("noise_error", kOwnUnits, PLASTICA_MEMBER(noise_error),
    "what of the standard error is the noise's");
  d.since(4, [](auto& later) {
    later("sampling_error", kOwnUnits, PLASTICA_MEMBER(sampling_error),
          "what of the standard error is of a break between two samples");
    later("misfit_error", kOwnUnits, PLASTICA_MEMBER(misfit_error),
          "what of the standard error is of residuals that are no noise");
    later("degrees_of_freedom", "1", PLASTICA_MEMBER(degrees_of_freedom),
          "of the noise in the standard error; infinite: the targets state theirs");
  });
  d("interval_low", kOwnUnits, PLASTICA_MEMBER(interval_low),
    "confidence interval of the material's, lower end");
  d("interval_high", kOwnUnits, PLASTICA_MEMBER(interval_high),
    "confidence interval of the material's, upper end");
  d.derived(
      "scatter_error", kOwnUnits, [](const auto& row) { return row.scatter_error(); },
      "how far another test of the same specimen would move it: noise and sampling");
  d("start", kOwnUnits, PLASTICA_MEMBER(start), "where the search began");
  d("lower", kOwnUnits, PLASTICA_MEMBER(lower), "lower bound");
  d("upper", kOwnUnits, PLASTICA_MEMBER(upper), "upper bound");
  d("logarithmic", "", PLASTICA_MEMBER(logarithmic), "whether it was searched by its logarithm");
  d("at_lower", "", PLASTICA_MEMBER(at_lower), "whether it ended at its lower bound");
  d("at_upper", "", PLASTICA_MEMBER(at_upper), "whether it ended at its upper bound");
  d("identified", "", PLASTICA_MEMBER(identified), "whether the curves determine it");
  d.optional("judged", PLASTICA_MEMBER(judgement), [](auto& inner) {
    inner("verdict", "", PLASTICA_MEMBER(verdict), "how well the curves determine it");
    inner("verdict_number", "", PLASTICA_MEMBER(number), "the number behind the verdict");
  });
};

/// Of a sentence, such as a warning.
inline constexpr auto kDescribeText = [](auto& d) {
  d(
      "text", "", [](auto& row) -> auto& { return row; });
};

}  // namespace plastica::calibrate
