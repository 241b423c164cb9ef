#include "sweeps/run/case_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "plastica/model/check_value.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/run_warnings.hpp"
#include "plastica/run/sample_warning.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::size_t kMostWatched = 16;

/// Alike: but for numbers.
std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return text;
}

/// The frequency that is asked for is that of the level; a beam in space may have a lower one.
std::optional<std::string> slower_out_of_plane(const Model& model, const Setup& setup, int mode) {
  if (model.level != Level::Planar && model.level != Level::Twist) return std::nullopt;
  const auto of = [&](Level level) {
    SolverOptions solver = setup.solver;
    solver.level = level;
    return unloaded_frequencies(setup.scene, solver, mode).back();
  };
  const double own = of(model.level);
  double all = own;
  try {
    all = of(Level::Spatial);
  } catch (const InputError&) {
    return std::nullopt;  // the scene is one of its plane alone
  }
  if (!(all < own * (1.0 - 1e-3))) return std::nullopt;
  using model_detail::figure;
  return fmt::format(
      "the frequency is that {}; in space the unloaded beam has {} Hz in place of "
      "{} Hz: solver.level = \"spatial\" has all",
      model.level == Level::Twist ? "of twisting alone" : "in the plane of the loads", figure(all),
      figure(own));
}

/// A frequency of which the record has fewer than two periods is not looked for.
std::optional<std::string> too_short(const Model& model, const Quantity& quantity) {
  if (quantity.kind != QuantityKind::Probe || quantity.take != Take::Frequency) return std::nullopt;
  if (!model.chain || !is_motion(model)) return std::nullopt;
  const auto lowest = run_detail::lowest_frequency(model);
  const double duration = model.chain->stops.back();
  if (!lowest || *lowest * duration >= 2.0) return std::nullopt;
  using model_detail::figure;
  return fmt::format(
      "the motion lasts {} periods of the unloaded beam's lowest frequency, {} Hz: "
      "what is found is none below {} Hz",
      figure(*lowest * duration), figure(*lowest), figure(2.0 / duration));
}

/// What the run has shown, and what its quantity adds.
/// @throws InputError of a case that cannot be run
std::vector<std::string> warnings_of(const Setup& setup, const Quantity& quantity,
                                     const CaseResult& result) {
  if (quantity.kind == QuantityKind::Fit)
    return result.warnings.value_or(std::vector<std::string>());
  const Model model = prepare(setup.scene, setup.solver);
  std::vector<std::string> warnings = result.warnings ? *result.warnings : scene_warnings(model);
  const bool is_frequency = quantity.kind == QuantityKind::NaturalFrequency ||
                            quantity.kind == QuantityKind::LoadedFrequency;
  if (is_frequency && model.chain) {
    auto slower = slower_out_of_plane(model, setup, quantity.mode);
    if (slower) warnings.insert(warnings.begin(), std::move(*slower));
  }
  if (auto brief = too_short(model, quantity)) {
    warnings.insert(warnings.begin(), std::move(*brief));
  }
  return warnings;
}

/// A warning of one case or more, alike but for numbers.
struct Said {
  std::string text;  ///< of the last case that has it
  std::size_t last = 0;
  std::size_t cases = 0;
  bool is_same = true;  ///< in all cases that have it
};

/// The values of the axes that take more than one: "beam.segments 8, solver.steps 10".
std::string place_of(const Sweep& sweep, const CaseTable& cases, std::size_t index) {
  const auto position = cases.position(index);
  std::string place;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const Axis& axis = sweep.axes[a];
    if (axis.values.size() < 2) continue;
    if (!place.empty()) place += ", ";
    place += axis.field->path;
    place += ' ';
    place += value_text(*axis.field, axis.values[position[a]]);
  }
  return place;
}

/// Which cases a warning is of, and whose numbers it has; empty where it is of all, and the same.
/// @param looked  cases that were looked at, of all
std::string whose(const Said& said, std::size_t looked, std::size_t all, const std::string& place) {
  if (said.cases == all && said.is_same) return "";
  std::string cases = looked == all ? fmt::format("of {} of {} cases", said.cases, all)
                                    : fmt::format("of {} of {} cases that were looked at (of {})",
                                                  said.cases, looked, all);
  if (!said.is_same || said.cases < looked) cases += ", at " + place;
  return cases + ": ";
}

}  // namespace

std::vector<std::size_t> watched_cases(std::size_t cases) {
  std::vector<std::size_t> chosen;
  const std::size_t count = std::min(cases, kMostWatched);
  chosen.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    chosen.push_back(count == 1 ? 0 : k * (cases - 1) / (count - 1));
  }
  return chosen;
}

std::vector<std::string> warnings_of_run(const Setup& setup, const Response& response) {
  if (response.status == Status::Rejected || response.status == Status::NotRun) return {};
  return run_warnings(setup.scene, setup.solver, prepare(setup.scene, setup.solver), response);
}

std::vector<std::string> case_warnings(const Sweep& sweep, const CaseTable& cases,
                                       std::span<const CaseResult> results) {
  std::vector<Said> all;
  std::size_t looked = 0;
  for (const std::size_t i : watched_cases(cases.size())) {
    std::vector<std::string> warnings;
    try {
      warnings = warnings_of(cases.setup(i), sweep.quantity, results[i]);
    } catch (const InputError&) {
      continue;  // its row says why
    }
    ++looked;
    for (std::string& text : warnings) {
      const std::string words = without_numbers(text);
      auto said = std::ranges::find_if(
          all, [&](const Said& one) { return without_numbers(one.text) == words; });
      if (said == all.end()) said = all.insert(all.end(), Said{text, i, 0, true});
      said->is_same = said->is_same && said->text == text;
      said->text = std::move(text);
      said->last = i;
      ++said->cases;
    }
  }
  std::vector<std::string> texts;
  texts.reserve(all.size());
  for (const Said& said : all) {
    texts.push_back(whose(said, looked, cases.size(), place_of(sweep, cases, said.last)) +
                    said.text);
  }
  return texts;
}

}  // namespace plastica::sweeps
