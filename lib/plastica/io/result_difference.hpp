#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace plastica::io {

/// How two results are compared.
struct DifferenceRule {
  /// Numbers a, b are equal if |a - b| <= within max(|a|, |b|): 0 beside another number is as far
  /// off as can be, 1. NaN is equal to NaN, infinity to infinity of its sign, 0 to -0. 0: no
  /// difference at all. 0 ... 1.
  double within = 0.0;
  /// Numbers are equal, too, if both are at most so much of the largest finite one of their dataset
  /// in either file: what rounding leaves of a zero [1].
  double floor = 0.0;
  /// Groups, datasets and attributes ("/fits/cost", "/inputs", "@version") that are left out,
  /// besides /meta, /VTKHDF and the attribute `run`: each must be in one of the files.
  std::vector<std::string> left_out{};
  /// The same where they are there: digests of versions and inputs, which say who a row is.
  std::vector<std::string> identities{};
  std::size_t kept = std::numeric_limits<std::size_t>::max();  ///< most differences that are listed
};

/// One thing that differs.
struct ResultDifference {
  std::string place;  ///< "/fits/cost", of an attribute "/fits/cost @units"
  std::string row;    ///< "CA-RD-01", "[3, 5]"; empty: the whole
  std::string first;  ///< what the first file has there
  std::string second;
  std::optional<double> relative{};  ///< of two finite numbers: |a - b|/max(|a|, |b|) [1]
};

/// What a comparison has found.
struct ResultComparison {
  std::vector<ResultDifference> differences;  ///< the first ones, in the order of the files
  std::size_t differing = 0;                  ///< how many there are
  std::size_t numbers = 0;                    ///< that were compared
  std::size_t texts = 0;                      ///< likewise
  double largest = 0.0;                       ///< largest relative difference of numbers [1]
  std::vector<std::string> notes{};  ///< what differs in /meta of what may change digits: versions
};

/// Compares two result files of one kind, dataset by dataset: extents, numbers, texts, attributes.
/// @throws InputError if one cannot be read, they are of different kinds, or what is to be left out
///         is in neither
ResultComparison compare_results(const std::string& first, const std::string& second,
                                 const DifferenceRule& rule);

}  // namespace plastica::io
