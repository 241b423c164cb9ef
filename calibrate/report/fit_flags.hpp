#pragma once

#include <span>
#include <string>
#include <string_view>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

/// What a reader of a table over fits is to look at, a letter each; not installed.
namespace plastica::calibrate::report {

struct FitFlag {
  char letter;
  std::string_view meaning;
};

/// In the order in which they are shown.
std::span<const FitFlag> fit_flags();
std::span<const FitFlag> scene_fit_flags();

/// The letters of a fit.
std::string flags_of(const FitRecord& record);
std::string flags_of(const SceneFitResult& result);

/// "u no usable fit; w warnings": those of the letters.
std::string legend_of(std::span<const FitFlag> flags, std::string_view letters);
/// "no usable fit; warnings"
std::string meanings_of(std::span<const FitFlag> flags, std::string_view letters);

}  // namespace plastica::calibrate::report
