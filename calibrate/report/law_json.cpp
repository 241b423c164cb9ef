#include "calibrate/report/law_json.hpp"

#include <string>
#include <utility>

#include "calibrate/report/law_choice.hpp"

namespace plastica::calibrate::report {
namespace {

/// Laws beside each other, the best first.
Json comparison_of(const LawComparison& comparison) {
  Json laws = Json::array();
  for (const ComparedLaw& law : comparison.laws) {
    Json counts = Json::object();
    for (const Verdict verdict : law.fit.verdicts) {
      Json& count = counts[std::string(calibrate::name_of(verdict))];
      count = count.is_null() ? 1 : count.get<int>() + 1;
    }
    laws.push_back({{"law", calibrate::name_of(law.fit.law)},
                    {"fitted", law.fit.fitted},
                    {"parameters", law.fit.parameters.size()},
                    {"misfit_fraction", number(law.fit.misfit_fraction)},
                    {"aic", number(law.aic)},
                    {"aicc", number(law.aicc)},
                    {"bic", number(law.bic)},
                    {"held_out", number(law.held_out)},
                    {"unseen", number(law.unseen)},
                    {"verdicts", std::move(counts)},
                    {"evaluations", law.fit.evaluations},
                    {"runs", law.fit.runs > 0 ? Json(law.fit.runs) : Json(nullptr)},
                    {"lacks_fit", law.fit.lacks_fit}});
  }
  return {{"samples", number(comparison.samples)},
          {"comparable_by_information", comparison.is_informed},
          {"ranked_by", calibrate::name_of(comparison.ranked_by)},
          {"laws", std::move(laws)},
          {"advised", comparison.advised
                          ? Json(calibrate::name_of(comparison.laws[*comparison.advised].fit.law))
                          : Json()},
          {"advice", text_or_null(comparison.advice)}};
}

template <typename Record>
Json all_of(std::span<const Record> records) {
  Json targets = Json::array();
  for (const auto& target : by_target(records)) {
    Json one = comparison_of(compare_laws(target));
    one["name"] = name_of(*target.front());
    targets.push_back(std::move(one));
  }
  return {{"targets", std::move(targets)}, {"all", comparison_of(compare_laws(records))}};
}

}  // namespace

Json laws_json(std::span<const FitRecord> records) { return all_of(records); }
Json laws_json(std::span<const SceneFitRecord> records) { return all_of(records); }

}  // namespace plastica::calibrate::report
