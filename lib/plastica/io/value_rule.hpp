#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastica/io/hdf5.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/field.hpp"

/// What the numbers of a dataset must be beyond their type and shape; not installed.
///
/// A reader has a table of these, one line for each dataset that needs more than what holds for all
/// that it does not name: real numbers are finite, integers not negative and no larger than the
/// member that they are read into, truth values 0 or 1.
namespace plastica::io {

enum class Order { Any, RisesStrictly };

struct ValueRule {
  std::string_view path{};  ///< of the dataset, from the root; `*` stands for one name on the way
  Range range{};            ///< of each real number
  Order order = Order::Any;
  bool may_lack = false;         ///< NaN: missing
  bool may_be_infinite = false;  ///< of integers: any that the type has, as of a seed
};

inline constexpr Range kFraction{0.0, 1.0};
inline constexpr Range kNotNegative{0.0};
inline constexpr Range kAboveZero{0.0, std::numeric_limits<double>::infinity(), true};
/// Numbers that a computation may not have found, or found to be beyond all bounds.
constexpr ValueRule anything(std::string_view path) { return {path, {}, Order::Any, true, true}; }
constexpr ValueRule may_lack(std::string_view path) { return {path, {}, Order::Any, true}; }

/// Larger counts are none: they are no longer exact as real numbers, and products overflow.
inline constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 53U;

/// Whether a pattern with at most one `*` is that of a path.
constexpr bool matches(std::string_view pattern, std::string_view path) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == path;
  const std::string_view before = pattern.substr(0, star);
  const std::string_view behind = pattern.substr(star + 1);
  if (path.size() <= before.size() + behind.size()) return false;
  const auto name = path.substr(star, path.size() - before.size() - behind.size());
  return path.starts_with(before) && path.ends_with(behind) &&
         name.find('/') == std::string_view::npos;
}

/// The path of a dataset from the root, without a slash in front.
inline std::string path_from_root(const Hdf5Group& group, std::string_view path) {
  const std::string full =
      path.starts_with('/') ? std::string(path) : group.path() + '/' + std::string(path);
  return full.substr(full.find_first_not_of('/'));
}

/// The rule of a path in a table; the default one where it is not named.
inline ValueRule rule_of(std::span<const ValueRule> rules, std::string_view path) {
  const auto found =
      std::ranges::find_if(rules, [&](const ValueRule& rule) { return matches(rule.path, path); });
  return found == rules.end() ? ValueRule{path} : *found;
}

/// @throws InputError that names the dataset
[[noreturn]] inline void refuse_value(const Hdf5Group& group, std::string_view path,
                                      const std::string& value, std::string_view rule) {
  throw InputError({group.file(), 0}, '/' + path_from_root(group, path), value, rule);
}

inline bool keeps(const ValueRule& rule, double value) {
  if (std::isnan(value)) return rule.may_lack;
  if (std::isinf(value)) return rule.may_be_infinite;
  return rule.range.contains(value);
}

inline void check_values(const Hdf5Group& group, std::string_view path,
                         std::span<const double> values, const ValueRule& rule) {
  for (const double value : values) {
    if (!keeps(rule, value)) {
      refuse_value(group, path, model_detail::number_text(value), rule.range.rule());
    }
  }
  if (rule.order == Order::Any) return;
  if (std::ranges::adjacent_find(values, std::not_fn(std::less<>{})) != values.end()) {
    refuse_value(group, path, "", "must rise from each to the next");
  }
}

template <class Member, class Integer>
void check_integers(const Hdf5Group& group, std::string_view path, std::span<const Integer> values,
                    const ValueRule& rule) {
  if (rule.may_be_infinite) return;
  constexpr bool kTruth = sizeof(Integer) == 1;
  constexpr auto kLargest = static_cast<std::uint64_t>(std::numeric_limits<Member>::max());
  constexpr std::uint64_t kMax = kTruth ? 1 : std::min(kMaxCount, kLargest);
  for (const Integer value : values) {
    if (std::cmp_greater_equal(value, 0) && std::cmp_less_equal(value, kMax)) continue;
    refuse_value(group, path, std::to_string(value),
                 kTruth ? "must be 0 or 1" : "must be from 0 to " + std::to_string(kMax));
  }
  const bool strict = rule.order == Order::RisesStrictly;
  if (strict && std::ranges::adjacent_find(values, std::greater_equal<>()) != values.end()) {
    refuse_value(group, path, "", "must rise from each to the next");
  }
}

/// Checks numbers of any type that a file holds.
/// @tparam Member  what they are read into
template <class Member, class Number>
void check_numbers(const Hdf5Group& group, std::string_view path, const std::vector<Number>& values,
                   const ValueRule& rule) {
  if constexpr (std::is_floating_point_v<Number>) {
    check_values(group, path, std::span<const double>(values), rule);
  } else {
    check_integers<Member>(group, path, std::span<const Number>(values), rule);
  }
}

/// Reads a one-dimensional array and checks it.
/// @param rules  of the file's kind
template <class Number>
std::vector<Number> read_numbers(const Hdf5Group& group, std::string_view path,
                                 std::span<const ValueRule> rules) {
  std::vector<Number> values = group.read<Number>(path);
  check_numbers<Number>(group, path, values, rule_of(rules, path_from_root(group, path)));
  return values;
}

/// Reads a single number and checks it.
/// @tparam Member  what it is read into
template <class Member>
Member read_number(const Hdf5Group& group, std::string_view path,
                   std::span<const ValueRule> rules) {
  using Stored =
      std::conditional_t<std::is_floating_point_v<Member>, double,
                         std::conditional_t<std::is_signed_v<Member>, std::int64_t, std::uint64_t>>;
  const std::vector<Stored> values{group.read_scalar<Stored>(path)};
  check_numbers<Member>(group, path, values, rule_of(rules, path_from_root(group, path)));
  return static_cast<Member>(values[0]);
}

/// Reads rows of unequal length, one for each of `count`, and checks their values.
/// @param rules  of the file's kind; that of PATH/values counts
inline Ragged<double> read_lists(const Hdf5Group& group, const std::string& path, std::size_t count,
                                 std::span<const ValueRule> rules) {
  Ragged<double> lists = group.read_ragged<double>(path);
  if (lists.rows() != count) {
    refuse_value(group, path, std::to_string(lists.rows()) + " rows",
                 "must have " + std::to_string(count));
  }
  const std::string values = path + "/values";
  check_values(group, values, lists.values, rule_of(rules, path_from_root(group, values)));
  return lists;
}

}  // namespace plastica::io
