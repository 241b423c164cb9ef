#include "sweeps/run/case_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "plastica/model/check_value.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/sample_warning.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::size_t kMostCases = 16;

std::vector<std::size_t> looked_at(std::size_t cases) {
  std::vector<std::size_t> chosen;
  const std::size_t count = std::min(cases, kMostCases);
  for (std::size_t k = 0; k < count; ++k) {
    chosen.push_back(count == 1 ? 0 : k * (cases - 1) / (count - 1));
  }
  return chosen;
}

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

/// @throws InputError of a case that cannot be run
std::vector<std::string> warnings_of(const Setup& setup, const Quantity& quantity) {
  const Model model = prepare(setup.scene, setup.solver);
  std::vector<std::string> warnings = scene_warnings(model);
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

}  // namespace

std::vector<std::string> case_warnings(const Sweep& sweep, const CaseTable& cases) {
  struct Said {
    std::string text;  ///< of the last case that has it
    std::size_t cases = 0;
  };
  std::vector<Said> all;
  std::size_t looked = 0;
  if (sweep.quantity.kind == QuantityKind::Fit) return {};  // a fit says its own
  for (const std::size_t i : looked_at(cases.size())) {
    std::vector<std::string> warnings;
    try {
      warnings = warnings_of(cases.setup(i), sweep.quantity);
    } catch (const InputError&) {
      continue;  // its row says why
    }
    ++looked;
    for (std::string& text : warnings) {
      const std::string words = without_numbers(text);
      auto said = std::ranges::find_if(
          all, [&](const Said& one) { return without_numbers(one.text) == words; });
      if (said == all.end()) said = all.insert(all.end(), Said{});
      said->text = std::move(text);
      ++said->cases;
    }
  }
  std::vector<std::string> texts;
  texts.reserve(all.size());
  for (Said& said : all) {
    texts.push_back(said.cases == looked ? std::move(said.text) : "of some cases: " + said.text);
  }
  return texts;
}

}  // namespace plastica::sweeps
