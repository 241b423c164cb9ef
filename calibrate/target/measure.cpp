#include "calibrate/target/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "calibrate/target/characteristics.hpp"

namespace plastica::calibrate {
namespace {

void measure_break(Characteristics& c, double modulus) {
  if (!c.observed_break) return;
  c.break_strain = c.observed_break->strain();
  c.break_strain_plastic = *c.break_strain - c.observed_break->last_intact_stress / modulus;
}

/// A stress that stands at its largest value to the last digit, in a record that has noise below
/// it.
void warn_of_saturation(Target& target) {
  constexpr std::size_t kFewest = 5;
  const std::vector<double>& stress = target.corrected.stress;
  const double largest = *std::ranges::max_element(stress);
  std::size_t run = 1, longest = 0, other = 1, end = 0;  // runs of the largest, and of any other
  for (std::size_t i = 1; i < stress.size(); ++i) {
    run = stress[i] == stress[i - 1] ? run + 1 : 1;
    if (stress[i] != largest) {
      other = std::max(other, run);
    } else if (run > longest) {
      longest = run;
      end = i;
    }
  }
  // In whole megapascals a rounded maximum is flat as well, and so is what leads to it.
  if (longest < kFewest || longest <= 5 * other) return;
  const std::span<const double> before(stress.data(), end + 1 - longest);
  const std::span<const double> strain(target.corrected.strain.data(), before.size());
  if (!(noise_of(strain, before) > 1e-6 * largest)) return;
  target.warnings.push_back(fmt::format(
      "the stress stands at its largest value, {:.5g} MPa, for {} samples: if the load cell was at "
      "its limit, Rm and what is fitted are that limit",
      largest / 1e6, longest));
}

/// The slope that the curve has, where the user gives another one.
void warn_of_given_modulus(Target& target, const ElasticLine& given, double noise,
                           const TargetOptions& options) {
  constexpr double kAlike = 0.25;
  TargetOptions without = options;
  without.youngs_modulus.reset();
  const auto own = find_elastic_line(target.corrected, target.loading, noise, without);
  if (!own || std::abs(own->modulus / given.modulus - 1.0) <= kAlike) return;
  target.warnings.push_back(fmt::format(
      "the curve rises with {:.4g} GPa, and not with the given {:.4g} GPa: one of them is "
      "wrong, and with it the proof stress",
      own->modulus / 1e9, given.modulus / 1e9));
}

/// A window whose lower half is less steep than this beside its upper half has a foot in it.
constexpr double kRising = 0.95;

/// Takes out what cannot be, and warns of that and of what is doubtful: a number would be believed.
void drop_impossible(Target& target, const ElasticLine& line) {
  Characteristics& c = target.characteristics;
  if (c.proof_stress && !(*c.proof_stress > line.low && *c.proof_stress > 0.0)) {
    c.proof_stress.reset();
    target.warnings.emplace_back("no proof stress: it would lie below the window of the modulus");
  }
  // One that may be none is no sign of a wrong modulus: without it means would be too large.
  if (c.break_strain_plastic && *c.break_strain_plastic < -2.0 * c.permanent_strain_error()) {
    c.break_strain_plastic.reset();
    target.warnings.emplace_back(
        "no permanent strain at the break: it would be negative, as Young's modulus is too small");
  }
  if (c.youngs_modulus && !c.sound_modulus()) {
    target.warnings.push_back(fmt::format(
        "Young's modulus is not known: its standard error is {:.2g} %, above 5 %, of "
        "too few samples, or too much noise, on the elastic part{}",
        100.0 * *c.youngs_modulus_stderr / *c.youngs_modulus,
        c.proof_stress
            ? fmt::format("; the proof stress leans on {:.4g} GPa", *c.youngs_modulus / 1e9)
            : std::string()));
  }
  if (!line.is_straight()) {
    target.warnings.push_back(fmt::format(
        "the curve bends where Young's modulus is measured: its slope falls to 1/{:.2g} "
        "there, so that the modulus is not that of an elastic part; name a window "
        "(characteristics.window), or the modulus",
        line.bend));
  } else if (line.bend < kRising) {
    target.warnings.push_back(fmt::format(
        "the curve grows steeper where Young's modulus is measured, by {:.3g} % there, as where a "
        "foot reaches into it: the modulus is too small by at least as much; name a window "
        "(characteristics.window), or the modulus",
        100.0 * (1.0 / std::max(line.bend, 0.1) - 1.0)));
  }
}

/// Where the upper yield strength is the largest stress, Rm is that of work hardening.
void take_later_peak(const YieldPoint& point, const RawFacts& facts, const Curve& curve,
                     Characteristics& c) {
  if (!point.later_peak || !facts.largest_has_strain) return;
  c.rm = curve.stress[*point.later_peak];
  c.strain_at_rm = curve.strain[*point.later_peak];
}

}  // namespace

bool elastic_to_the_end(const Curve& curve, double modulus, double noise, double yield) {
  const std::size_t count = std::min<std::size_t>(5, curve.size());
  double below = 0.0;
  for (std::size_t i = curve.size() - count; i < curve.size(); ++i) {
    below += modulus * curve.strain[i] - curve.stress[i];
  }
  return below / static_cast<double>(count) <= 3.0 * noise + 1e-6 * yield;
}

void measure_characteristics(Target& target, const ElasticLine& line, const RawFacts& facts,
                             double noise, const TargetOptions& options) {
  Characteristics& c = target.characteristics;
  const Curve& curve = target.corrected;
  c.youngs_modulus = line.modulus;
  c.modulus_method = options.youngs_modulus                           ? "given"
                     : options.modulus_method == ModulusMethod::Chord ? "chord"
                                                                      : "regression";
  if (c.modulus_method == "regression") c.youngs_modulus_stderr = line.modulus_stderr;
  c.modulus_window_low = line.low;
  c.modulus_window_high = line.high;
  c.largest_strain = *std::max_element(curve.strain.begin(), curve.strain.end());
  const auto peak = std::max_element(curve.stress.begin(), curve.stress.end());
  c.rm = *peak;
  if (facts.largest_has_strain || target.measure != options.measure) {
    c.strain_at_rm = curve.strain[static_cast<std::size_t>(peak - curve.stress.begin())];
  } else {
    c.rm = facts.largest_stress;
  }
  measure_break(c, line.modulus);
  warn_of_saturation(target);
  if (target.loading == Loading::Cyclic) return;

  c.offset = options.offset;
  if (!sees_offset(line.modulus, options.offset, noise)) {
    target.warnings.emplace_back("no proof stress: its offset is lost in the noise");
  } else if (!elastic_to_the_end(curve, line.modulus, noise, *c.rm)) {
    c.proof_stress = proof_stress(curve.strain, curve.stress, line.modulus, 0.0, options.offset);
  }
  if (auto point = find_yield_point(curve.stress, noise, options.yield_drop)) {
    leave_out_transient(curve.strain, curve.stress, noise, options.yield_drop, *point);
    // Where flow begins: a drop later on is that of a slip, or of a pause.
    constexpr double kLatest = 0.005;
    const double plastic = curve.strain[point->at] - point->upper / line.modulus;
    // In a pause the strain stands still while the stress relaxes; at a yield point it runs.
    const double ran = curve.strain[point->lower_at] - curve.strain[point->at];
    const bool pauses = ran < (point->upper - point->lower) / line.modulus;
    constexpr double kBelow = 0.995;  // of the proof stress: flow has not begun
    if (c.proof_stress && point->upper < kBelow * *c.proof_stress) {
      target.warnings.push_back(fmt::format(
          "the stress falls at {:.4g} MPa, below the proof stress: a pause or a slip, and no upper "
          "yield strength",
          point->upper / 1e6));
    } else if (plastic <= kLatest && pauses) {
      target.warnings.push_back(
          fmt::format("the stress falls at {:.3g} % strain while the strain stands still: a pause, "
                      "and no upper yield strength",
                      100.0 * curve.strain[point->at]));
    } else if (plastic <= kLatest) {
      c.reh = point->upper;
      c.rel = point->lower;
      take_later_peak(*point, facts, curve, c);
    } else if (!point->later_peak) {
      target.warnings.push_back(
          fmt::format("the stress drops at {:.3g} % strain: too late for an upper yield strength",
                      100.0 * curve.strain[point->at]));
    }
  }
  drop_impossible(target, line);
  if (options.youngs_modulus) warn_of_given_modulus(target, line, noise, options);
}

}  // namespace plastica::calibrate
