#include "sweeps/advise/advice_json.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "plastica/base/quantity.hpp"

namespace plastica::sweeps {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson finite_or_null(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

OrderedJson words_or_null(std::string_view text) {
  return text.empty() ? OrderedJson(nullptr) : OrderedJson(text);
}

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
OrderedJson values_of(const Advice& advice, const Setting& setting, const Words& words) {
  OrderedJson all = OrderedJson::object();
  for (std::size_t k = 0; k < setting.size(); ++k) {
    all[std::string(advice.axes[k].field->path)] = finite_or_null(setting[k]);
  }
  for (std::size_t w = 0; w < words.size(); ++w) {
    for (const auto& [field, word] : advice.word_axes[w].choices[words[w]].values) {
      all[std::string(field->path)] = word;
    }
  }
  return all;
}

OrderedJson fractions_or_null(const std::vector<double>& fractions) {
  return fractions.empty() ? OrderedJson(nullptr) : OrderedJson(fractions);
}

OrderedJson tried_of(const Advice& advice, const TriedSetting& one) {
  return {{"values", values_of(advice, one.setting, one.words)},
          {"segment_fractions", fractions_or_null(one.fractions)},
          {"error", finite_or_null(one.error)},
          {"reason", words_or_null(one.reason)},
          {"segment_iterations", one.work > 0 ? OrderedJson(one.work) : OrderedJson(nullptr)},
          {"cost", one.work > 0 ? OrderedJson(one.cost) : OrderedJson(nullptr)},
          {"seconds", one.work > 0 ? OrderedJson(one.seconds) : OrderedJson(nullptr)}};
}

OrderedJson numbers_of(const Advice& advice) {
  OrderedJson all = OrderedJson::array();
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    const Field& field = *advice.axes[k].field;
    const bool known = k < advice.budget.size();
    all.push_back({{"field", field.path},
                   {"unit", si_unit(field.dimension)},
                   {"value", advice.setting[k]},
                   {"error", known ? finite_or_null(advice.budget[k].error) : OrderedJson(nullptr)},
                   {"order", known ? OrderedJson(advice.budget[k].order) : OrderedJson(nullptr)},
                   {"order_seen", known && advice.budget[k].order_seen}});
  }
  return all;
}

OrderedJson others_of(const WordAxis& axis, const WordLine& line) {
  OrderedJson all = OrderedJson::array();
  for (const OtherWord& other : line.others) {
    all.push_back({{"word", axis.choices[other.choice].text()},
                   {"cost_ratio", finite_or_null(other.cost)},
                   {"error", finite_or_null(other.error)},
                   {"reason", words_or_null(other.reason)}});
  }
  return all;
}

OrderedJson words_of(const Advice& advice) {
  OrderedJson all = OrderedJson::array();
  for (std::size_t w = 0; w < advice.word_axes.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    const bool model = axis.kind == WordKind::Model;
    const bool known = !advice.word_budget.empty();
    all.push_back(
        {{"field", axis.field().path},
         {"word", axis.choices[advice.words[w]].text()},
         {"in_file", axis.choices[axis.own].text()},
         {"kind", model ? "model" : "method"},
         {"richest", model ? OrderedJson(axis.choices[axis.richest].text()) : OrderedJson(nullptr)},
         {"error",
          known && model ? finite_or_null(advice.word_budget[w].error) : OrderedJson(nullptr)},
         {"others", known ? others_of(axis, advice.word_budget[w]) : OrderedJson::array()},
         {"note", words_or_null(axis.note)}});
  }
  return all;
}

}  // namespace

std::string advice_json(const Advice& advice, const AdviceOptions& options,
                        const std::string& name) {
  const bool found = advice.end == AdviceEnd::Found;
  OrderedJson tried = OrderedJson::array();
  for (const TriedSetting& one : advice.tried) tried.push_back(tried_of(advice, one));
  const OrderedJson all = {
      {"scene", name},
      {"end", word_of(advice.end)},
      {"cut_short",
       advice.cut_short ? OrderedJson(word_of(*advice.cut_short)) : OrderedJson(nullptr)},
      {"within", options.budget > 0.0 ? OrderedJson(nullptr) : OrderedJson(options.within)},
      {"budget", options.budget > 0.0 ? OrderedJson(options.budget) : OrderedJson(nullptr)},
      {"promised", found ? finite_or_null(advice.promised) : OrderedJson(nullptr)},
      {"verified", found ? finite_or_null(advice.verified) : OrderedJson(nullptr)},
      {"verified_with", words_or_null(verified_with(advice))},
      {"words_left_out", found ? finite_or_null(advice.of_words) : OrderedJson(nullptr)},
      {"worst", words_or_null(advice.worst)},
      {"reason", words_or_null(advice.reason)},
      {"numbers", numbers_of(advice)},
      {"segment_fractions", fractions_or_null(advice.fractions)},
      {"even", advice.even ? tried_of(advice, *advice.even) : OrderedJson(nullptr)},
      {"words", words_of(advice)},
      {"segment_iterations", advice.work},
      {"cost", finite_or_null(advice.cost)},
      {"seconds", finite_or_null(advice.seconds)},
      {"expected_seconds", finite_or_null(advice.expected_seconds)},
      {"next_cheaper",
       advice.next_cheaper ? tried_of(advice, *advice.next_cheaper) : OrderedJson(nullptr)},
      {"in_file", tried_of(advice, advice.own)},
      {"left_out", advice.left_out},
      {"runs", advice.runs},
      {"total_segment_iterations", advice.total_work},
      {"total_seconds", finite_or_null(advice.total_seconds)},
      {"tried", std::move(tried)}};
  return all.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

}  // namespace plastica::sweeps
