#include "calibrate/target/correct.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/find_break.hpp"

namespace plastica::calibrate {
namespace {

using Mode = CorrectionChoice::Mode;

void shift(Curve& curve, double amount) {
  for (double& strain : curve.strain) strain -= amount;
}

/// Whether the specimen carries next to nothing before the elastic line meets zero stress, as in
/// slack grips, however long: a curve that bends has taken up load until there.
bool is_slack(const Curve& curve, const ElasticLine& line) {
  constexpr double kNear = 0.9, kNothing = 0.05;
  const double nothing =
      std::max(kNothing * line.yield_stress, 4.0 * noise_of(curve.strain, curve.stress));
  std::size_t before = 0;
  while (before < curve.size() && curve.strain[before] < kNear * line.zero_strain) {
    if (std::abs(curve.stress[before++]) > nothing) return false;
  }
  // A foot of the material, as of rubber in true stress, rises steadily.
  constexpr double kFlat = 0.05;
  if (before > 0 && curve.stress[before - 1] > kFlat * line.modulus * curve.strain[before - 1]) {
    return false;
  }
  return before > 0;
}

/// Of the elastic range: what carries load over more of it is hardly a foot.
constexpr double kLongFoot = 0.5;

/// Whether a line that the curve begins beyond is that of what bends, as of rubber, and not of an
/// elastic part behind a strain sensor that stuck at first: published curves of metals that begin
/// so have bends of up to 1.09.
bool is_bent(const ElasticLine& line) { return line.bend > 1.1 || line.bend < 0.9; }

/// Whether the first samples lie far beyond a line that meets zero stress at `zero`: below it, at
/// larger strains. A foot lies before it.
bool begins_beyond(const Curve& curve, double modulus, double zero) {
  constexpr std::size_t kFirst = 3;  // the very first is often a row of zeros
  constexpr double kFar = 0.25;      // of what the line misses the origin by
  for (std::size_t i = 0; i < std::min(kFirst, curve.size()); ++i) {
    const double beyond = curve.strain[i] - curve.stress[i] / modulus - zero;
    if (beyond < kFar * std::abs(zero)) return false;
  }
  return true;
}

/// What the load cell shows when nothing is left to carry load is its zero.
void warn_of_load_zero(Target& target, std::size_t broken) {
  constexpr std::size_t kFewest = 3;
  constexpr double kSmall = 0.01, kLarge = 0.2;  // of Rm; beyond, something still carries
  const Curve& curve = target.corrected;
  if (curve.size() < broken + kFewest) return;
  std::vector<double> rest(curve.stress.end() - kFewest, curve.stress.end());
  const auto [low, high] = std::ranges::minmax_element(rest);
  const double rm = *std::ranges::max_element(curve.stress);
  const double noise = noise_of(curve.strain, curve.stress);
  const double stands = 0.5 * (*low + *high);
  const bool is_still = *high - *low < std::max(0.1 * std::abs(stands), 8.0 * noise);
  const double size = std::abs(stands);
  if (!is_still || size < std::max(kSmall * rm, 5.0 * noise) || size > kLarge * rm) return;
  target.warnings.push_back(
      fmt::format("after the break the stress is {:+.3g} MPa: if that is the load cell's zero, all "
                  "stresses are off by it",
                  stands / 1e6));
}

/// The slack before a curve whose modulus is given: where its own elastic line, if that has about
/// the given slope, meets zero stress.
std::optional<double> slack_before(const Target& target, double modulus, double threshold,
                                   const TargetOptions& options) {
  constexpr double kAlike = 0.15;
  const Curve& curve = target.corrected;
  if (target.loading != Loading::Monotonic) return std::nullopt;
  TargetOptions without = options;
  without.youngs_modulus.reset();
  const auto own =
      find_elastic_line(curve, target.loading, noise_of(curve.strain, curve.stress), without);
  const bool is_alike = own && std::abs(own->modulus / modulus - 1.0) < kAlike;
  if (!is_alike || !(own->zero_strain > threshold) || !is_slack(curve, *own)) return std::nullopt;
  return own->zero_strain;
}

/// Drops the samples before the origin: no law of a specimen that carries load passes there, and a
/// fit that had to would bend its modulus towards them.
std::size_t drop_before_origin(Curve& curve) {
  std::size_t before = 0;
  while (before < curve.size() && curve.strain[before] < 0.0) ++before;
  const auto end = static_cast<std::ptrdiff_t>(before);
  curve.strain.erase(curve.strain.begin(), curve.strain.begin() + end);
  curve.stress.erase(curve.stress.begin(), curve.stress.begin() + end);
  return before;
}

Correction off(const char* kind, const char* unit) { return {kind, false, 0.0, unit, "off"}; }

}  // namespace

void trim_at_break(Target& target, double modulus, bool goes_on, const TargetOptions& options) {
  Curve& curve = target.corrected;
  if (options.trim.mode == Mode::Off) {
    target.corrections.push_back(off("trim-at-break", "samples"));
    return;
  }
  std::optional<BreakFound> found;
  if (options.trim.mode == Mode::Set) {
    std::size_t last = 0;
    while (last + 1 < curve.size() && curve.strain[last + 1] <= options.trim.amount) ++last;
    if (last + 1 < curve.size()) found = broken_after(curve, last, target.loading, "set");
  } else {
    found = find_break(curve, target.loading, modulus, goes_on, options);
  }
  if (!found) {
    const char* why = goes_on ? "the strain ends before the break"
                              : "no load drop, no fall to zero, and the data end under load";
    target.corrections.push_back({"trim-at-break", false, 0.0, "samples", why});
    return;
  }
  const std::size_t cut = curve.size() - found->intact;
  warn_of_load_zero(target, found->intact);
  curve.strain.resize(found->intact);
  curve.stress.resize(found->intact);
  std::string text = "rule: " + found->observation.rule;
  target.corrections.push_back(
      {"trim-at-break", cut > 0, static_cast<double>(cut), "samples", std::move(text)});
  target.characteristics.observed_break = std::move(found->observation);
}

double shift_strain(Target& target, const ElasticLine& line, const TargetOptions& options) {
  Curve& curve = target.corrected;
  Correction toe{"toe", false, 0.0, "1", ""};
  Correction preload{"preload-offset", false, 0.0, "1", ""};
  double total = 0.0;
  for (auto [choice, correction] :
       {std::pair{&options.toe, &toe}, std::pair{&options.preload, &preload}}) {
    if (choice->mode == Mode::Off) correction->text = "off";
    if (choice->mode == Mode::Set) {
      *correction = {correction->kind, true, choice->amount, "1", "set by the user"};
      total += choice->amount;
    }
  }

  // With a given modulus the line goes through the first sample, and only a coarse offset counts.
  const bool given = options.youngs_modulus.has_value();
  const double fraction = given ? options.given_modulus_threshold : options.shift_threshold;
  const double threshold =
      std::max(fraction * line.yield_stress / line.modulus, 6.0 * line.zero_strain_stderr);
  const auto slack = given ? slack_before(target, line.modulus, threshold, options) : std::nullopt;
  const double zero = slack   ? *slack
                      : given ? curve.strain[0] - curve.stress[0] / line.modulus
                              : line.zero_strain;
  const char* why_not = nullptr;
  bool is_within = false;
  if (total != 0.0) {
    why_not = "another strain shift is set";
  } else if (target.loading == Loading::Cyclic) {
    why_not = "a cyclic curve keeps its measured zero";
  } else if (!(std::abs(zero) > threshold)) {
    is_within = true;
    why_not = "the elastic line meets the origin within the threshold";
  }
  // Zeroed at another load, the whole curve lies beside its place, from the first sample on.
  const double first_beside = curve.strain[0] - curve.stress[0] / line.modulus - zero;
  const bool is_preload = std::abs(first_beside) < 0.5 * std::abs(zero);
  if (!why_not && !is_preload && std::abs(zero) > line.yield_stress / line.modulus && !slack &&
      (given || !is_slack(curve, line))) {
    why_not = "the elastic line misses the origin by more than the yield strain: no foot";
    target.warnings.push_back(
        fmt::format("the elastic line meets zero stress at {:.3g} % strain, beyond the yield "
                    "strain: is the strain's zero right, and is this an elastic part? Else E and "
                    "the yield stress are wrong",
                    100.0 * zero));
  }
  if (!why_not && !is_preload && zero < 0.0 && !line.is_straight()) {
    why_not = "the curve bends where the line was found: no foot is so";
  }
  if (!why_not && !is_preload && is_bent(line) && begins_beyond(curve, line.modulus, zero)) {
    why_not = "the curve begins beyond the line, on a steeper one: no foot is so";
    target.warnings.push_back(fmt::format(
        "the curve begins steeper than where Young's modulus is measured, whose line meets zero "
        "stress at {:.3g} % strain: the modulus is not that of its beginning; name a window "
        "(characteristics.window), or the modulus",
        100.0 * zero));
  }
  Correction& candidate = is_preload ? preload : toe;
  const Mode mode = is_preload ? options.preload.mode : options.toe.mode;
  if (!why_not && mode == Mode::Automatic) {
    total += zero;
    if (!given && !slack) target.shift_error = line.zero_strain_stderr;
    candidate.applied = true;
    candidate.amount = zero;
    candidate.text = is_preload ? "the curve starts on an elastic line beside the origin"
                                : "the elastic line beyond the foot misses the origin";
  }
  // Within the threshold it may be the line or the zero that is off, and that by so much.
  if (is_within &&
      (options.toe.mode == Mode::Automatic || options.preload.mode == Mode::Automatic)) {
    target.shift_error = given ? std::abs(zero) : std::max(std::abs(zero), line.zero_strain_stderr);
  }
  for (Correction* correction : {&toe, &preload}) {
    if (!correction->text.empty()) continue;
    correction->text = why_not      ? why_not
                       : is_preload ? "the first sample is on the elastic line: no foot"
                                    : "the first sample is not on the elastic line: a foot";
  }
  const double elastic = line.yield_stress / line.modulus;
  if (toe.applied && options.toe.mode == Mode::Automatic && toe.amount > elastic) {
    target.warnings.push_back(fmt::format(
        "the toe of {:.3g} % is longer than the elastic range of {:.3g} %, as no foot is: it is "
        "taken for slack of the grips; if they had none, are strain and stress the right columns "
        "and units?",
        100.0 * toe.amount, 100.0 * elastic));
  } else if (toe.applied && options.toe.mode == Mode::Automatic && !slack &&
             toe.amount > kLongFoot * elastic && (given || !is_slack(curve, line))) {
    target.warnings.push_back(fmt::format(
        "the foot of {:.3g} % is long beside the elastic range of {:.3g} %, and carries load: if "
        "that is the material and not the grips, strains and modulus are wrong "
        "(corrections.toe = \"off\")",
        100.0 * toe.amount, 100.0 * elastic));
  }
  shift(curve, total);
  if (toe.applied && target.loading == Loading::Monotonic) {
    const std::size_t dropped = drop_before_origin(curve);
    if (dropped > 0) toe.text += fmt::format("; {} samples before it dropped", dropped);
  }
  target.corrections.push_back(std::move(toe));
  target.corrections.push_back(std::move(preload));
  if (total == 0.0) return 0.0;
  if (auto& broken = target.characteristics.observed_break) {
    broken->last_intact_strain -= total;
    broken->first_broken_strain -= total;
  }
  return total;
}

bool convert_to_true(Target& target, const TargetOptions& options) {
  if (!options.convert_to_true || target.measure == Measure::True) return true;
  if (target.test != Test::Tension) {
    target.status = TargetStatus::Rejected;
    target.reason = "only a tension curve can be converted to true stress and strain";
    return false;
  }
  Curve& curve = target.corrected;
  auto& broken = target.characteristics.observed_break;
  if (!options.force_true) {
    const auto peak = std::max_element(curve.stress.begin(), curve.stress.end());
    const auto keep = static_cast<std::size_t>(peak - curve.stress.begin()) + 1;
    if (keep < curve.size()) {
      target.warnings.push_back(std::to_string(curve.size() - keep) +
                                " samples beyond Rm refused: true strain is unknown in a neck");
      curve.strain.resize(keep);
      curve.stress.resize(keep);
      broken.reset();
      target.ends_at_neck = true;
    }
  }
  // Both by the strain as it was, which shortens a specimen in compression.
  const double sign = options.is_compressed ? -1.0 : 1.0;
  const auto true_strain = [&](double strain) { return sign * std::log1p(sign * strain); };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!(sign * curve.strain[i] > -1.0)) {
      target.status = TargetStatus::Rejected;
      target.reason = "an engineering strain of -1 or less has no true strain";
      return false;
    }
    curve.stress[i] *= 1.0 + sign * curve.strain[i];
    curve.strain[i] = true_strain(curve.strain[i]);
  }
  if (broken) {
    broken->last_intact_stress *= 1.0 + sign * broken->last_intact_strain;
    broken->last_intact_strain = true_strain(broken->last_intact_strain);
    broken->first_broken_strain = true_strain(broken->first_broken_strain);
  }
  target.measure = Measure::True;
  std::string text = options.force_true ? "forced beyond Rm" : "up to Rm";
  if (options.is_compressed) text += "; of a specimen in compression";
  target.corrections.push_back(
      {"true-measure", true, static_cast<double>(curve.size()), "samples", std::move(text)});
  return true;
}

}  // namespace plastica::calibrate
