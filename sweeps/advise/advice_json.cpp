#include "sweeps/advise/advice_json.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "plastica/base/quantity.hpp"
#include "plastica/report/json_values.hpp"

namespace plastica::sweeps {
namespace {

using report::Json;
using report::number;
using report::text_or_null;

std::string_view word_of(AdviceEnd end) {
  switch (end) {
    case AdviceEnd::Found: return "found";
    case AdviceEnd::TooManyRuns: return "too_many_runs";
    case AdviceEnd::TooMuchWork: return "too_much_work";
    case AdviceEnd::Diverging: return "diverging";
    case AdviceEnd::TooDear: return "too_dear";
    case AdviceEnd::AtFinest: return "at_finest";
    case AdviceEnd::Interrupted: break;
  }
  return "interrupted";
}

/// The words of the run that verifies; empty: there is none.
std::string_view verified_with(const Advice& advice) {
  if (advice.end != AdviceEnd::Found) return {};
  return advice.words_settled ? "advised_words" : "richest_words";
}

/// Fields and their values: those of the axes, then those of the words.
Json values_of(const Advice& advice, const Setting& setting, const Words& words) {
  Json all = Json::object();
  for (std::size_t k = 0; k < setting.size(); ++k) {
    all[std::string(advice.axes[k].field->path)] = number(setting[k]);
  }
  for (std::size_t w = 0; w < words.size(); ++w) {
    for (const auto& [field, word] : advice.word_axes[w].choices[words[w]].values) {
      all[std::string(field->path)] = word;
    }
  }
  return all;
}

Json fractions_or_null(const std::vector<double>& fractions) {
  return fractions.empty() ? Json(nullptr) : Json(fractions);
}

Json tried_of(const Advice& advice, const TriedSetting& one) {
  return {{"values", values_of(advice, one.setting, one.words)},
          {"segment_fractions", fractions_or_null(one.fractions)},
          {"error", number(one.error)},
          {"reason", text_or_null(one.reason)},
          {"segment_iterations", one.work > 0 ? Json(one.work) : Json(nullptr)},
          {"cost", one.work > 0 ? Json(one.cost) : Json(nullptr)},
          {"seconds", one.work > 0 ? Json(one.seconds) : Json(nullptr)}};
}

Json numbers_of(const Advice& advice) {
  Json all = Json::array();
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    const Field& field = *advice.axes[k].field;
    const bool known = k < advice.budget.size();
    all.push_back({{"field", field.path},
                   {"unit", si_unit(field.dimension)},
                   {"value", advice.setting[k]},
                   {"error", known ? number(advice.budget[k].error) : Json(nullptr)},
                   {"order", known ? Json(advice.budget[k].order) : Json(nullptr)},
                   {"order_seen", known && advice.budget[k].order_seen}});
  }
  return all;
}

Json others_of(const WordAxis& axis, const WordLine& line) {
  Json all = Json::array();
  for (const OtherWord& other : line.others) {
    all.push_back({{"word", axis.choices[other.choice].text()},
                   {"cost_ratio", number(other.cost)},
                   {"error", number(other.error)},
                   {"reason", text_or_null(other.reason)}});
  }
  return all;
}

Json words_of(const Advice& advice) {
  Json all = Json::array();
  for (std::size_t w = 0; w < advice.word_axes.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    const bool model = axis.kind == WordKind::Model;
    const bool known = !advice.word_budget.empty();
    all.push_back({{"field", axis.field().path},
                   {"word", axis.choices[advice.words[w]].text()},
                   {"in_file", axis.choices[axis.own].text()},
                   {"kind", model ? "model" : "method"},
                   {"richest", model ? Json(axis.choices[axis.richest].text()) : Json(nullptr)},
                   {"error", known && model ? number(advice.word_budget[w].error) : Json(nullptr)},
                   {"others", known ? others_of(axis, advice.word_budget[w]) : Json::array()},
                   {"note", text_or_null(axis.note)}});
  }
  return all;
}

}  // namespace

std::string advice_json(const Advice& advice, const AdviceOptions& options,
                        const std::string& name) {
  const bool found = advice.end == AdviceEnd::Found;
  Json tried = Json::array();
  for (const TriedSetting& one : advice.tried) tried.push_back(tried_of(advice, one));
  const Json all = {
      {"scene", name},
      {"end", word_of(advice.end)},
      {"cut_short", advice.cut_short ? Json(word_of(*advice.cut_short)) : Json(nullptr)},
      {"within", options.budget > 0.0 ? Json(nullptr) : Json(options.within)},
      {"budget", options.budget > 0.0 ? Json(options.budget) : Json(nullptr)},
      {"promised", found ? number(advice.promised) : Json(nullptr)},
      {"verified", found ? number(advice.verified) : Json(nullptr)},
      {"verified_with", text_or_null(verified_with(advice))},
      {"words_left_out", found ? number(advice.of_words) : Json(nullptr)},
      {"worst", text_or_null(advice.worst)},
      {"reason", text_or_null(advice.reason)},
      {"numbers", numbers_of(advice)},
      {"segment_fractions", fractions_or_null(advice.fractions)},
      {"even", advice.even ? tried_of(advice, *advice.even) : Json(nullptr)},
      {"words", words_of(advice)},
      {"segment_iterations", advice.work},
      {"cost", number(advice.cost)},
      {"seconds", number(advice.seconds)},
      {"expected_seconds", number(advice.expected_seconds)},
      {"next_cheaper",
       advice.next_cheaper ? tried_of(advice, *advice.next_cheaper) : Json(nullptr)},
      {"in_file", tried_of(advice, advice.own)},
      {"left_out", advice.left_out},
      {"warnings", advice.warnings},
      {"runs", advice.runs},
      {"total_segment_iterations", advice.total_work},
      {"total_seconds", number(advice.total_seconds)},
      {"tried", std::move(tried)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::sweeps
