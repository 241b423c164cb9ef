#include "calibrate/report/fit_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "calibrate/report/outcome_text.hpp"
#include "calibrate/result/usable.hpp"

namespace plastica::calibrate::report {
namespace {

constexpr std::array<FitFlag, 7> kFitFlags = {{{'u', "no usable fit"},
                                               {'b', "a parameter at a bound"},
                                               {'n', "a parameter not identified"},
                                               {'a', "a parameter from its prior"},
                                               {'p', "poor: the law does not describe the curve"},
                                               {'r', "curve repaired"},
                                               {'w', "warnings"}}};
constexpr std::array<FitFlag, 9> kSceneFitFlags = {{{'u', "no usable fit"},
                                                    {'b', "a parameter at a bound"},
                                                    {'n', "a parameter not identified"},
                                                    {'k', "a parameter weak"},
                                                    {'s', "a break limited by sampling"},
                                                    {'g', "a parameter limited by segments"},
                                                    {'a', "a parameter from its prior"},
                                                    {'c', "a correlation above 0.95"},
                                                    {'w', "warnings"}}};

}  // namespace

std::span<const FitFlag> fit_flags() { return kFitFlags; }
std::span<const FitFlag> scene_fit_flags() { return kSceneFitFlags; }

std::string flags_of(const FitRecord& record) {
  const FitResult& result = record.result;
  const auto any_parameter = [&](auto&& test) {
    return std::any_of(result.parameters.begin(), result.parameters.end(), test);
  };
  std::string flags;
  if (!why_unusable(result).empty()) flags += 'u';
  if (any_parameter([](const FittedParameter& p) { return p.at_lower || p.at_upper; })) {
    flags += 'b';
  }
  if (any_parameter([](const FittedParameter& p) {
        return p.role == ParameterRole::Free && !p.identified;
      })) {
    flags += 'n';
  }
  if (any_parameter([](const FittedParameter& p) { return p.verdict() == Verdict::FromPrior; })) {
    flags += 'a';
  }
  if (result.misfit_word == "poor") flags += 'p';
  if (!record.target.repairs.empty()) flags += 'r';
  if (!record.target.warnings.empty() || !result.warnings.empty()) flags += 'w';
  return flags;
}

std::string flags_of(const SceneFitResult& result) {
  const auto any = [&](Verdict verdict) {
    return std::ranges::any_of(result.free_parameters(),
                               [&](const FittedParameter* p) { return p->verdict() == verdict; });
  };
  std::string flags;
  if (!why_unusable(result).empty()) flags += 'u';
  if (any(Verdict::AtBound)) flags += 'b';
  if (any(Verdict::NotIdentified)) flags += 'n';
  if (any(Verdict::Weak)) flags += 'k';
  if (any(Verdict::LimitedBySampling)) flags += 's';
  if (any(Verdict::LimitedBySegments)) flags += 'g';
  if (any(Verdict::FromPrior)) flags += 'a';
  if (!strong_correlations(result).empty()) flags += 'c';
  if (!result.warnings.empty()) flags += 'w';
  return flags;
}

std::string legend_of(std::span<const FitFlag> flags, std::string_view letters) {
  std::string legend;
  for (const FitFlag& flag : flags) {
    if (letters.find(flag.letter) == std::string_view::npos) continue;
    legend += (legend.empty() ? "" : "; ") + fmt::format("{} {}", flag.letter, flag.meaning);
  }
  return legend;
}

std::string meanings_of(std::span<const FitFlag> flags, std::string_view letters) {
  std::string meanings;
  for (const FitFlag& flag : flags) {
    if (letters.find(flag.letter) == std::string_view::npos) continue;
    meanings += (meanings.empty() ? "" : "; ") + std::string(flag.meaning);
  }
  return meanings;
}

}  // namespace plastica::calibrate::report
