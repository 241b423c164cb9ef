#include "sweeps/advise/adviser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "sweeps/advise/next_setting.hpp"

namespace plastica::sweeps {
namespace {

/// An axis that adds less than this part of the allowed error is not measured again; nor is one
/// whose order was seen, at a size that differs by no more than this factor from where it was
/// measured.
constexpr double kMinorError = 0.1;
constexpr double kNear = 2.2;
/// The run that verifies is finer by `kRefined`, in what adds less than `kMinorError` of all by
/// this.
constexpr double kSlightlyRefined = 0.7;
/// Errors that were foretold are measured if the run that verifies shows so much more.
constexpr double kTrusted = 1.25;
/// Words are decided where the numbers are off by no more than this, or so many times what is
/// allowed: where the differences between models can be told from those of a coarse beam.
constexpr double kCloseError = 0.2;
constexpr double kCloseToAllowed = 8.0;
/// Where nothing moves, on the sizes of the run that tells whether anything does.
constexpr double kFarFiner = 0.0625;
/// The scene as its file has it is run beside what seems to be found, where it takes no more than
/// so many times its work: whoever wrote the file knew how fine a beam must be to show what is
/// probed.
constexpr double kOwnIsWorth = 20.0;
/// So often words may be decided: where those that a coarse beam asks for do not do.
constexpr int kDecisions = 3;

/// "tip, middle"
std::string names_of(const std::vector<WatchedProbe>& probes) {
  std::string names;
  for (const WatchedProbe& probe : probes) names += (names.empty() ? "" : ", ") + probe.name;
  return names;
}

}  // namespace

Adviser::Adviser(AdviceRuns& runs) : runs_(runs), models_(runs.axes().size()), words_(runs) {}

Trial Adviser::coarsest() const {
  Trial trial = runs_.own();
  for (std::size_t k = 0; k < runs_.axes().size(); ++k) {
    trial.setting[k] = runs_.axes()[k].coarsest;
  }
  return runs_.with_ends_at_probes(runs_.taken(std::move(trial)));
}

Trial Adviser::finer(const Trial& trial, std::size_t axis) const {
  std::vector<double> factors(runs_.axes().size(), 1.0);
  factors[axis] = kRefined;
  return runs_.scaled(trial, factors);
}

std::vector<double> Adviser::factors_in_all(const Candidate& candidate, double factor) const {
  std::vector<double> factors;
  for (std::size_t k = 0; k < candidate.errors.size(); ++k) {
    // Segments are divided, whatever their number alone seems to do.
    const bool minor = k > 0 && candidate.errors[k].error < kMinorError * candidate.numbers;
    factors.push_back(factor * (minor ? kSlightlyRefined / kRefined : 1.0));
  }
  return factors;
}

double Adviser::supposed_order(std::size_t axis, const Trial& trial) const {
  const std::string_view path = runs_.axes()[axis].field->path;
  if (path == "beam.segments") {
    return order_of_method(runs_.setup_of(trial), find_field("rules.end_rule"));
  }
  if (path != "solver.time_step") return 1.0;
  return order_of_method(runs_.setup_of(trial), find_field("solver.scheme"));
}

bool Adviser::is_foretold(std::size_t axis, const Candidate& candidate) const {
  if (!models_.knows(axis)) return false;
  if (candidate.errors[axis].error < kMinorError * within_) return true;
  const double ratio =
      models_.ratio_to_last(axis, runs_.axes()[axis].size(candidate.trial.setting[axis]));
  return !measure_all_ && candidate.errors[axis].seen && ratio < kNear && ratio > 1.0 / kNear;
}

bool Adviser::estimate(Candidate& candidate) {
  const Trial& trial = candidate.trial;
  const auto& axes = runs_.axes();
  candidate.errors.assign(axes.size(), {});
  candidate.numbers = 0.0;
  std::vector<std::size_t> measured;
  std::vector<Trial> trials{trial};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (!runs_.acts(k, trial.words)) continue;
    if (models_.knows(k)) candidate.errors[k] = models_.foretold(k, axes[k].size(trial.setting[k]));
    if (is_foretold(k, candidate)) continue;
    measured.push_back(k);
    trials.push_back(finer(trial, k));
  }
  if (!runs_.run_all(trials)) {
    for (const std::size_t k : measured) {
      if (!models_.knows(k)) candidate.errors[k].error = std::numeric_limits<double>::infinity();
    }
    name_worst(candidate);
    return false;
  }
  moves_ = moves_ && measured.empty();
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const std::size_t k = measured[i];
    const Deviation off = runs_.off(trial, trials[i + 1]);
    candidate.errors[k] = models_.measured(k, axes[k].size(trial.setting[k]),
                                           axes[k].size(trials[i + 1].setting[k]), off);
    if (!off.reason.empty()) candidate.reason = off.reason;
    moves_ = moves_ || !off.reason.empty() || off.quantities > 0;
  }
  for (const AxisError& e : candidate.errors) candidate.numbers += e.error;
  name_worst(candidate);
  return true;
}

void Adviser::name_worst(Candidate& candidate) const {
  double largest = 0.0;
  std::string named;
  bool all_named = true;
  const auto look = [&](double error, const std::string& quantity) {
    all_named = all_named && (std::isfinite(error) || !quantity.empty());
    if (quantity.empty() || !(error > largest)) return;
    largest = error;
    named = quantity;
  };
  for (const AxisError& e : candidate.errors) look(e.error, e.quantity);
  const bool known = all_named || candidate.worst.empty();
  if (known && !named.empty()) candidate.worst = named;
}

void Adviser::forget_methods(const Words& before, const Words& after) {
  for (std::size_t w = 0; w < before.size(); ++w) {
    const WordAxis& axis = runs_.word_axes()[w];
    if (axis.kind == WordKind::Model || before[w] == after[w]) continue;
    for (std::size_t k = 0; k < runs_.axes().size(); ++k) {
      const bool of_time = runs_.axes()[k].field->path == "solver.time_step";
      if (of_time == (axis.field().path == "solver.scheme")) models_.forget(k);
    }
  }
}

bool Adviser::settle_words(Candidate& candidate, bool& changed) {
  changed = false;
  const double close = std::max(kCloseError, kCloseToAllowed * within_);
  if (words_.decided() || candidate.numbers > close) return true;
  if (++decisions_ > kDecisions) {
    end_ = AdviceEnd::Diverging;
    return false;
  }
  if (!words_.decide(candidate.trial, candidate.errors, within_)) return false;
  if (words_.words() == candidate.trial.words) return true;
  models_.doubt();
  forget_methods(candidate.trial.words, words_.words());
  candidate.trial =
      runs_.with_ends_at_probes(runs_.taken({words_.words(), candidate.trial.setting}));
  changed = true;
  return true;
}

bool Adviser::run_finest(const Candidate& candidate, const std::vector<double>& factors,
                         bool richest) {
  const Trial finer = runs_.scaled(candidate.trial, factors);
  const Trial finest = richest ? words_.enriched(finer) : finer;
  if (!runs_.run_all({finest})) return false;
  finest_ = finest;
  return true;
}

bool Adviser::look_whether_settled(const Candidate& candidate, const std::vector<double>& factors,
                                   SettledWords& settled) {
  settled = {};
  const Trial finer = runs_.scaled(candidate.trial, factors);
  const Trial richest = words_.enriched(finer);
  if (richest == finer || measure_all_ || outcomes_vary(candidate.trial)) return true;
  const double saved = runs_.foreseen_cost({richest}) - runs_.foreseen_cost({finer});
  return measure_settled(runs_, words_, candidate, within_, saved, settled);
}

bool Adviser::measure_hidden(Candidate& candidate) {
  const auto& axes = runs_.axes();
  for (std::size_t k = 0; k < axes.size(); ++k) {
    AxisError& e = candidate.errors[k];
    const bool expected = axes[k].field->path == "beam.segments" &&
                          has_first_order_errors(runs_.setup_of(candidate.trial));
    if (!expected && !(e.hidden > std::max(e.error, kMinorError * within_))) continue;
    const Trial once = finer(candidate.trial, k);
    const Trial twice = finer(once, k);
    if (!runs_.run_all({candidate.trial, once, twice})) return false;
    if (twice == once) continue;  // at the finest value of the axis
    const auto size = [&](const Trial& trial) { return axes[k].size(trial.setting[k]); };
    e = models_.measured_twice(k, size(candidate.trial), size(once), size(twice),
                               runs_.off(candidate.trial, once), runs_.off(once, twice));
    candidate.numbers = 0.0;
    for (const AxisError& one : candidate.errors) candidate.numbers += one.error;
  }
  return true;
}

bool Adviser::verify(Candidate& candidate) {
  if (!measure_hidden(candidate)) return false;
  if (candidate.numbers + words_.error() > within_) return true;
  if (!words_.confirm(candidate.trial, within_, measure_all_)) return false;
  candidate.lines = words_.lines();
  if (candidate.numbers + words_.error() > within_) {
    // Either finer numbers make room for the words, or the words are not what they seemed.
    if (words_.error() > kWordsShare * within_) words_.doubt();
    return true;
  }
  std::vector<double> factors = factors_in_all(candidate, kRefined);
  // Where no order was seen, a run twice as fine is no proof: what yields may show its errors late,
  // and a load or a probe may stand at the same part of a segment in both.
  const std::vector<double> usual = factors;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    if (rests_on_unseen(candidate, k)) factors[k] *= kRefined;
  }
  SettledWords settled;
  if (!look_whether_settled(candidate, factors, settled)) return false;
  if (!run_finest(candidate, factors, !settled.are_so)) return false;
  Deviation off = runs_.off(candidate.trial, *finest_);
  if (off.reason.empty() && outcomes_vary(*finest_)) {
    // Near a break, a limit or another path it may be on the same wrong side, too.
    for (std::size_t k = 0; k < factors.size(); ++k) factors[k] = usual[k] * kRefined;
    if (!run_finest(candidate, factors, true)) return false;
    const Deviation further = runs_.off(candidate.trial, *finest_);
    // Without the richest words the first one lacks what the words leave out.
    if (settled.are_so || further.largest > off.largest) off = further;
    settled = {};
  }
  candidate.worst = off.quantity;
  candidate.reason = off.reason;
  candidate.verified = off.largest;
  // What the finer run itself is off: by the axis that falls the slowest of those that matter.
  double left = 1.0;
  double changes = 0.0;
  double expected = 0.0;  // of the run that verifies
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const AxisError& e = candidate.errors[k];
    changes += e.change;
    expected += e.change * usual[k] / factors[k];
    if (e.error > 0.05 * candidate.numbers) {
      left = std::max(left, left_of(1.0, e.ratio * kRefined / factors[k], e.order));
    }
  }
  const double words = settled.are_so ? 0.0 : words_.error();  // that are in the difference
  if (off.largest > kTrusted * expected + words && !measure_all_) {
    measure_all_ = true;  // what was foretold is not so
    return true;
  }
  candidate.finest = finest_;
  candidate.words_settled = settled.are_so;
  candidate.of_words = settled.are_so ? settled.error : 0.0;
  candidate.of_finest = (left - 1.0) * std::max(changes, off.largest - words);
  candidate.promised = promise(candidate, words_.error());
  candidate.within = candidate.promised <= within_;
  return !candidate.within || look_for_rest(candidate);
}

bool Adviser::look_for_rest(Candidate& candidate) {
  const Trial own = runs_.own();
  const bool cheap = runs_.foreseen_cost({own}) <= kOwnIsWorth * runs_.cost(candidate.trial);
  // It may take more than was foreseen: what was found does not hang on it.
  const bool ran = !cheap || !runs_.affords(own) || runs_.run_all({own});
  if (!ran && runs_.end() == AdviceEnd::Interrupted) return false;
  const std::string probe = runs_.at_rest_where_finer_moves(candidate.trial, *candidate.finest);
  if (probe.empty()) return true;
  candidate.rests = true;
  candidate.within = false;
  candidate.worst = probe;
  candidate.reason = probe + " is at rest in it, and moves in a finer run";
  return true;
}

bool Adviser::rests_on_unseen(const Candidate& candidate, std::size_t axis) const {
  const AxisError& e = candidate.errors[axis];
  return !e.seen && e.error > kMinorError * candidate.numbers;
}

bool Adviser::outcomes_vary(const Trial& trial) const {
  const Outcome& one = runs_.outcome(trial);
  return std::ranges::any_of(runs_.outcomes(), [&](const auto& ran) {
    return usable(ran.second.status) && !end_alike(ran.second, one);
  });
}

bool Adviser::judge(Candidate& candidate) {
  bool measured_all = false;
  measure_all_ = false;
  do {
    measured_all = measure_all_;
    bool changed = true;
    while (changed) {
      if (!estimate(candidate) || !settle_words(candidate, changed)) return false;
    }
    if (words_.decided() && !moves_) {
      if (alone_) return true;
      if (!go_on_if_finer_moves(candidate)) return false;
      continue;
    }
    if (!words_.decided() || candidate.numbers + words_.error() > within_) return true;
    if (!verify(candidate)) return false;
  } while (!words_.decided() || measure_all_ != measured_all);
  return true;
}

bool Adviser::go_on_if_finer_moves(Candidate& candidate) {
  const Trial finer =
      runs_.scaled(candidate.trial, std::vector<double>(runs_.axes().size(), kFarFiner));
  if (!runs_.run_all({finer})) return false;
  const Deviation off = runs_.off(candidate.trial, finer);
  if (off.quantities == 0 && off.reason.empty()) {
    throw InputError({}, "probe", "",
                     "stays within rounding, whatever is probed (" +
                         names_of(runs_.probes().watched) +
                         "): advice needs a probe of something that moves");
  }
  for (std::size_t k = 0; k < runs_.axes().size(); ++k) models_.forget(k);
  candidate = {.trial = words_.with_own_methods(finer)};
  words_.doubt();
  moves_ = true;
  return true;
}

}  // namespace plastica::sweeps
