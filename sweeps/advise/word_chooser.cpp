#include "sweeps/advise/word_chooser.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "plastica/base/status.hpp"

namespace plastica::sweeps {
namespace {

/// A method is changed if another is expected to cost less than this part.
constexpr double kWorthChanging = 0.7;
/// What a word adds below this part of the allowed error is not measured again.
constexpr double kSlight = 1e-3;

constexpr std::string_view kRicher = "richer";

bool is_same(double error) { return error <= kSameWord; }

}  // namespace

WordChooser::WordChooser(AdviceRuns& runs)
    : runs_(runs),
      words_(own_words(runs.word_axes())),
      options_(runs.word_axes().size()),
      lines_(runs.word_axes().size()) {}

bool WordChooser::has_choice(std::size_t w) const {
  const WordAxis& axis = runs_.word_axes()[w];
  return axis.kind == WordKind::Model && axis.richest > 0;
}

Trial WordChooser::with(Trial trial, std::size_t w, std::size_t choice) const {
  trial.words[w] = choice;
  return runs_.taken(std::move(trial));
}

Trial WordChooser::comparable(Trial trial) const {
  const auto& axes = runs_.word_axes();
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (axes[w].field().path != "solver.scheme") continue;
    for (std::size_t c = 0; c < axes[w].choices.size(); ++c) {
      if (axes[w].choices[c].text() == "linearly_implicit_midpoint") return with(trial, w, c);
    }
  }
  return trial;
}

bool WordChooser::run_richest(const Trial& trial) {
  auto& axes = runs_.word_axes();
  const auto richest_of = [&](Trial from) {
    for (std::size_t w = 0; w < axes.size(); ++w) {
      if (has_choice(w)) from.words[w] = w == same_level_ ? 0 : axes[w].richest;
    }
    return runs_.taken(std::move(from));
  };
  richest_ = richest_of(trial);
  if (!is_accepted(runs_.setup_of(richest_))) richest_ = comparable(richest_);
  if (!runs_.run_all({richest_})) return false;
  if (usable(runs_.outcome(richest_).status)) return true;
  // Some richer word cannot be run: which, beside the words that the trial has?
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (!has_choice(w) || axes[w].richest == trial.words[w]) continue;
    Trial one = with(trial, w, axes[w].richest);
    if (!is_accepted(runs_.setup_of(one))) one = comparable(one);
    if (!runs_.run_all({one})) return false;
    const Outcome& of = runs_.outcome(one);
    if (usable(of.status)) continue;
    axes[w].note = axes[w].choices[axes[w].richest].text() + " cannot be run: " + of.reason;
    axes[w].richest = trial.words[w];
  }
  const Trial before = richest_;
  richest_ = richest_of(trial);
  if (richest_ == before) {  // each can be run, but not all together
    for (std::size_t w = 0; w < axes.size(); ++w) {
      if (!has_choice(w) || axes[w].richest == trial.words[w]) continue;
      axes[w].note = "with the richest of all words the scene cannot be run";
      axes[w].richest = trial.words[w];
    }
    richest_ = richest_of(trial);
  }
  return runs_.run_all({richest_});
}

bool WordChooser::compare_levels(const Trial& trial) {
  const auto& axes = runs_.word_axes();
  same_level_ = axes.size();
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (axes[w].field().path != "solver.level" || !has_choice(w)) continue;
    const Trial least = with(trial, w, 0);
    const Trial space = with(trial, w, axes[w].richest);
    if (!is_accepted(runs_.setup_of(space))) continue;
    if (!runs_.run_all({least, space})) return false;
    const Deviation off = runs_.off(least, space, kRicher);
    if (!is_same(off.largest)) continue;
    same_level_ = w;
    options_[w] = {{0, 1.0, off.largest, {}},
                   {axes[w].richest, runs_.cost(space) / runs_.cost(least), 0.0, {}}};
  }
  return true;
}

void WordChooser::note_option(std::size_t w, std::size_t choice) {
  const Trial one = with(richest_, w, choice);
  const Deviation off = runs_.off(one, richest_, kRicher);
  options_[w].push_back({choice, runs_.cost(one) / runs_.cost(richest_), off.largest, off.reason});
}

bool WordChooser::run_models(const Trial& trial) {
  if (!compare_levels(trial) || !run_richest(trial)) return false;
  const auto& axes = runs_.word_axes();
  std::vector<Trial> first;
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (has_choice(w) && w != same_level_) first.push_back(with(richest_, w, 0));
  }
  if (!runs_.run_all(first)) return false;
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (w == same_level_) continue;
    options_[w].clear();
    if (!has_choice(w)) continue;
    note_option(w, 0);
    // With words that the trial had they may not have been comparable.
    if (axes[w].field().path == "solver.level" && is_same(options_[w].front().error)) {
      same_level_ = w;
    }
    // Where the simplest differs by nothing, what is between the two does not matter either.
    if (!is_same(options_[w].front().error)) {
      std::vector<Trial> more;
      for (std::size_t c = 1; c < axes[w].richest; ++c) more.push_back(with(richest_, w, c));
      if (!runs_.run_all(more)) return false;
      for (std::size_t c = 1; c < axes[w].richest; ++c) note_option(w, c);
    }
    options_[w].push_back({axes[w].richest});
  }
  return true;
}

void WordChooser::choose_models(const Trial& trial, const std::vector<AxisError>& errors) {
  double inverse_orders = 0.0;
  for (const AxisError& e : errors) {
    if (e.error > kSlight * within_) inverse_orders += 1.0 / e.order;
  }
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> at(options_.size(), 0);
  const auto next = [&] {
    for (std::size_t w = 0; w < at.size(); ++w) {
      if (options_[w].empty()) continue;
      if (++at[w] < options_[w].size()) return true;
      at[w] = 0;
    }
    return false;
  };
  do {
    double error = 0.0;
    double cost = 1.0;
    Words words = trial.words;
    for (std::size_t w = 0; w < at.size(); ++w) {
      if (options_[w].empty()) continue;
      const Option& option = options_[w][at[w]];
      words[w] = option.choice;
      error += option.error;
      cost *= option.cost;
    }
    if (error > kWordsShare * within_) continue;
    cost *= std::pow(within_ / (within_ - error), inverse_orders);
    Trial one = runs_.taken({words, trial.setting});
    if (!is_accepted(runs_.setup_of(one))) {
      const double before = kernel_cost(runs_.setup_of(runs_.taken(trial)));
      one = comparable(one);
      if (!is_accepted(runs_.setup_of(one))) continue;
      cost *= kernel_cost(runs_.setup_of(comparable(trial))) / before;
    }
    // Of equal ones the simplest, which comes first.
    if (cost >= least * (1.0 - 1e-12)) continue;
    least = cost;
    words_ = one.words;
  } while (next());
}

bool WordChooser::choose_method(const Trial& trial, std::size_t w,
                                const std::vector<AxisError>& errors) {
  const WordAxis& axis = runs_.word_axes()[w];
  lines_[w] = {};
  const bool of_time = axis.field().path == "solver.scheme";
  std::size_t k = 0;  // the axis of numbers along which the method errs: segments come first
  if (of_time) {
    const auto& numbers = runs_.axes();
    while (k < numbers.size() && numbers[k].field->path != "solver.time_step") ++k;
    // What an adaptive step may be off is said of the step, whatever the scheme.
    const bool adaptive = std::ranges::any_of(numbers, [](const FinenessAxis& axis_of) {
      return axis_of.field->path == "solver.step_error";
    });
    if (adaptive || k == numbers.size()) return true;
  }
  const double significant = static_cast<double>(std::ranges::count_if(
      errors, [&](const AxisError& e) { return e.error > kSlight * within_; }));
  const double share = (within_ - error()) / std::max(significant, 1.0);
  const AxisError& own = errors[k];
  if (!of_time && own.error <= share) return true;  // it has few segments anyhow
  std::vector<double> factors(runs_.axes().size(), 1.0);
  factors[k] = 0.5;
  const Trial finer = runs_.scaled(trial, factors);
  std::vector<Trial> trials{finer, trial};
  for (std::size_t c = 0; c < axis.choices.size(); ++c) {
    const bool fits = is_accepted(runs_.setup_of(with(trial, w, c))) &&
                      is_accepted(runs_.setup_of(with({words_, trial.setting}, w, c)));
    if (c != trial.words[w] && fits) trials.push_back(with(trial, w, c));
  }
  if (!runs_.run_all(trials)) return false;
  const double coarser =
      runs_.axes()[k].size(trial.setting[k]) / runs_.axes()[k].size(runs_.axes()[k].coarsest);
  const auto cost_of = [&](const Trial& one, double error) {
    const double order = order_of_method(runs_.setup_of(one), axis.field());
    return runs_.cost(one) * std::max(std::pow(error / share, 1.0 / order), coarser);
  };
  const double left_of_finer = own.error - own.change;
  const double own_cost = cost_of(trial, own.error);
  double least = kWorthChanging * own_cost;
  std::vector<OtherWord> others;
  for (std::size_t t = 2; t < trials.size(); ++t) {
    const std::size_t c = trials[t].words[w];
    const Deviation off = runs_.off(trials[t], finer);
    const double error = off.largest + left_of_finer;
    const double cost = cost_of(trials[t], error);
    others.push_back({c, cost, error, off.reason});
    if (!(cost < least)) continue;
    least = cost;
    words_[w] = c;
  }
  if (words_[w] != trial.words[w]) others.push_back({trial.words[w], own_cost, own.error, {}});
  const double chosen = words_[w] == trial.words[w] ? own_cost : least;
  std::erase_if(others, [&](const OtherWord& other) { return other.choice == words_[w]; });
  for (OtherWord& other : others) other.cost /= chosen;
  std::ranges::sort(others, {}, &OtherWord::choice);
  lines_[w].others = std::move(others);
  return true;
}

void WordChooser::fill_lines() {
  for (std::size_t w = 0; w < options_.size(); ++w) {
    if (options_[w].empty()) continue;
    lines_[w] = {};
    const auto chosen = std::ranges::find(options_[w], words_[w], &Option::choice);
    lines_[w].error = chosen->error;
    for (const Option& option : options_[w]) {
      if (option.choice == words_[w]) continue;
      lines_[w].others.push_back(
          {option.choice, option.cost / chosen->cost, option.error, option.reason});
    }
  }
}

bool WordChooser::let_move(Trial& trial) {
  if (!runs_.run_all({trial})) return false;
  if (runs_.outcome(trial).status != Status::HeldTwice) return true;
  const auto& axes = runs_.word_axes();
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (axes[w].field().path != "solver.translation") continue;
    Trial shifting = with(trial, w, axes[w].richest);
    if (!is_accepted(runs_.setup_of(shifting))) shifting = comparable(shifting);
    if (is_accepted(runs_.setup_of(shifting))) trial = shifting;
  }
  return true;
}

Trial WordChooser::with_own_methods(Trial trial) {
  own_methods_ = true;
  const auto& axes = runs_.word_axes();
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (axes[w].kind != WordKind::Method) continue;
    trial.words[w] = words_[w] = axes[w].own;
    lines_[w] = {};
  }
  return runs_.taken(std::move(trial));
}

bool WordChooser::decide(const Trial& trial, const std::vector<AxisError>& errors, double within) {
  within_ = within;
  words_ = trial.words;
  if (!run_models(trial)) return false;
  choose_models(trial, errors);
  fill_lines();
  const auto& axes = runs_.word_axes();
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (axes[w].kind != WordKind::Method || own_methods_) continue;
    if (!choose_method(trial, w, errors)) return false;
  }
  decided_ = true;
  return true;
}

bool WordChooser::compare(Trial trial, std::size_t w, std::size_t choice, OtherWord& found) {
  Trial richer = with(trial, w, runs_.word_axes()[w].richest);
  if (!is_accepted(runs_.setup_of(richer))) {
    trial = comparable(trial);
    richer = comparable(richer);
  }
  const Trial poorer = with(trial, w, choice);
  if (!runs_.run_all({trial, poorer, richer})) return false;
  const Deviation off = runs_.off(poorer, richer, kRicher);
  found = {choice, runs_.cost(poorer) / runs_.cost(trial), off.largest, off.reason};
  return true;
}

bool WordChooser::confirm(const Trial& trial, double within, bool all) {
  const auto& axes = runs_.word_axes();
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (!has_choice(w)) continue;
    const std::size_t chosen = trial.words[w];
    OtherWord measured;
    const bool matters =
        all ? w != same_level_ : lines_[w].error > std::max(kSlight * within, kSameWord);
    if (chosen != axes[w].richest && matters) {
      if (!compare(trial, w, chosen, measured)) return false;
      lines_[w].error = measured.error;
    }
    // The next simpler one is told of.
    auto& others = lines_[w].others;
    const auto beyond =
        std::ranges::find_if(others, [&](const OtherWord& other) { return other.choice > chosen; });
    if (beyond == others.begin() || !std::isfinite(std::prev(beyond)->error)) continue;
    if (!compare(trial, w, std::prev(beyond)->choice, measured)) return false;
    *std::prev(beyond) = measured;
  }
  return true;
}

Trial WordChooser::enriched(const Trial& trial) const {
  const auto& axes = runs_.word_axes();
  Trial made = trial;
  for (std::size_t w = 0; w < axes.size(); ++w) {
    if (has_choice(w) && w != same_level_) made = with(made, w, axes[w].richest);
  }
  return is_accepted(runs_.setup_of(made)) ? made : comparable(made);
}

double WordChooser::error() const {
  double sum = 0.0;
  for (const WordLine& line : lines_) sum += line.error;
  return sum;
}

}  // namespace plastica::sweeps
