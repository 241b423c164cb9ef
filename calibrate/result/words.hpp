#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_result.hpp"
#include "calibrate/target/scene_target.hpp"
#include "plastica/model/field.hpp"

/// The words of enumerations, the same in result files, summaries, tables and reports.
namespace plastica::calibrate {

/// Enumerations whose words are those of `name_of`, which are all the same beyond the last.
template <typename Enum>
concept Named = std::is_same_v<Enum, Verdict> || std::is_same_v<Enum, LeastSquaresOutcome> ||
    std::is_same_v<Enum, Dimension> || std::is_same_v<Enum, SegmentsTrend> ||
    std::is_same_v<Enum, ProfileEnd> || std::is_same_v<Enum, Law>;

template <Named Enum>
std::vector<std::string_view> all_names() {
  const std::string_view none = name_of(static_cast<Enum>(-1));
  std::vector<std::string_view> names;
  for (int i = 0; name_of(static_cast<Enum>(i)) != none; ++i) {
    names.push_back(name_of(static_cast<Enum>(i)));
  }
  return names;
}

/// The words of an enumeration in files, in the order of its enumerators.
template <typename Enum>
std::span<const std::string_view> words_of() {
  using namespace std::string_view_literals;
  if constexpr (std::is_same_v<Enum, FitStatus>) {
    static constexpr std::array kWords{"fitted"sv, "failed"sv, "rejected"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, TargetStatus>) {
    static constexpr std::array kWords{"ready"sv, "too-coarse"sv, "rejected"sv, "implausible"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, Measure>) {
    static constexpr std::array kWords{"engineering"sv, "true"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, Loading>) {
    static constexpr std::array kWords{"monotonic"sv, "cyclic"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, ParameterRole>) {
    static constexpr std::array kWords{"free"sv, "fixed"sv, "tied"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, ParameterScale>) {
    static constexpr std::array kWords{"auto"sv, "linear"sv, "logarithmic"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, Objective>) {
    static constexpr std::array kWords{"path"sv, "least-squares"sv};
    return kWords;
  } else if constexpr (std::is_same_v<Enum, Abscissa>) {
    static constexpr std::array kWords{"probe"sv, "time"sv, "support"sv, "load"sv, "strain"sv};
    return kWords;
  } else if constexpr (Named<Enum>) {
    static const std::vector<std::string_view> words = all_names<Enum>();
    return words;
  } else if constexpr (std::is_same_v<Enum, Level>) {
    return find_field_or_null("solver.level")->choices;
  } else {
    static_assert(std::is_same_v<Enum, Test>);
    static const std::span<const std::string_view> words =
        find_field_or_null("drive.deformation")->choices;
    return words;
  }
}

/// "fitted", "planar", "engineering", …
template <typename Enum>
std::string_view word_of(Enum value) requires std::is_enum_v<Enum> {
  return words_of<Enum>()[static_cast<std::size_t>(value)];
}

}  // namespace plastica::calibrate
