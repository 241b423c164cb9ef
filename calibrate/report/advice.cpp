#include "calibrate/report/advice.hpp"

#include <algorithm>
#include <string_view>

#include "calibrate/report/format.hpp"
#include "calibrate/report/parameter_words.hpp"

namespace plastica::calibrate::report {
namespace {

void advise_on(const FittedParameter& parameter, std::vector<std::string>& advice) {
  const std::string_view bound = word_of_bound(parameter);
  if (parameter.role != ParameterRole::Free) return;
  if (!parameter.identified) {
    advice.push_back(parameter.name() +
                     ": no value is better than another for this curve; fix it, or fit a curve "
                     "that goes far enough to show it.");
  } else if (!bound.empty()) {
    advice.push_back(parameter.name() + ": the best value is at the " + std::string(bound) +
                     " bound or beyond; widen the bounds if the material allows it, else fix it.");
  }
}

/// Whether a curve goes on beyond its largest stress.
bool falls_after_peak(const Target& target) {
  constexpr double kRest = 0.02;
  const Characteristics& all = target.characteristics;
  return all.strain_at_rm && all.largest_strain > (1.0 + kRest) * *all.strain_at_rm;
}

}  // namespace

std::string misfit_meaning(const FitResult& result) {
  constexpr double kNothing = 0.01;
  const std::string name(phrase_of(result.law));
  if (result.misfit_word == "close") {
    return name + " follows this curve" +
           (result.misfit_fraction < kNothing ? "" : " within its noise");
  }
  if (result.misfit_word == "fair") return name + " follows this curve roughly";
  if (result.misfit_word == "poor") return name + " does not describe this curve";
  return {};
}

std::vector<std::string> advice_for(const FitRecord& record) {
  const FitResult& result = record.result;
  std::vector<std::string> advice;
  if (record.target.status == TargetStatus::TooCoarse) {
    advice.emplace_back(
        "Sample the test more often on its elastic part; characteristics.min_samples says how many "
        "samples are wanted, and with E fixed two of them may do.");
  }
  if (result.status != FitStatus::Fitted) return advice;
  for (const FittedParameter& parameter : result.parameters) advise_on(parameter, advice);
  if (!result.stages.empty() && result.stages.back().outcome.find("maxeval") != std::string::npos) {
    advice.emplace_back("The optimizer stopped at its limit of evaluations: allow it more.");
  }
  const bool widened = std::ranges::any_of(
      result.parameters, [](const FittedParameter& p) { return p.misfit_error > 0.0; });
  if (result.misfit_word == "fair" || (result.misfit_word == "close" && widened)) {
    advice.emplace_back(widened ? "The residuals are no noise, or more than is stated: errors and "
                                  "intervals are widened for it, and rough."
                                : "What is left may be no noise: errors and intervals hold only as "
                                  "far as the model does.");
  }
  if (result.misfit_word == "poor") {
    advice.emplace_back(
        falls_after_peak(record.target)
            ? "If it is the fall after the largest stress that the model misses, fit up to there; "
              "the picture shows what is missing."
            : "The picture shows what the model misses.");
  }
  return advice;
}

}  // namespace plastica::calibrate::report
