#include "calibrate/target/make.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/correct.hpp"
#include "calibrate/target/elastic_line.hpp"
#include "calibrate/target/plausibility.hpp"
#include "calibrate/target/repair.hpp"
#include "calibrate/target/samples.hpp"
#include "calibrate/target/several_specimens.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

void check_options(const TargetOptions& options) {
  const auto must = [](bool right, const char* field, double value, const char* rule) {
    if (!right) throw InputError({}, field, std::to_string(value), rule);
  };
  if (options.youngs_modulus) {
    must(*options.youngs_modulus > 0.0, "youngs_modulus", *options.youngs_modulus,
         "must be positive");
  }
  must(options.offset > 0.0, "offset", options.offset, "must be positive");
  must(options.modulus_low >= 0.0 && options.modulus_low < options.modulus_high, "modulus_low",
       options.modulus_low, "must be at least 0 and below modulus_high");
  must(options.modulus_high <= 1.0, "modulus_high", options.modulus_high, "must be at most 1");
  must(options.reversal_tolerance >= 0.0, "reversal_tolerance", options.reversal_tolerance,
       "must not be negative");
}

void give_up(Target& target, TargetStatus status, std::string reason) {
  target.status = status;
  target.reason = std::move(reason);
}

/// Why a monotonic curve that starts at no elastic line is none to fit; empty if it is too coarse.
std::string no_rising_part(const Curve& curve) {
  const auto peak = std::max_element(curve.stress.begin(), curve.stress.end());
  const auto at = static_cast<std::size_t>(peak - curve.stress.begin());
  if (curve.size() < 3) return {};
  if (at == 0) return "no rising part: the first sample has the largest stress";
  if (curve.strain[at] > curve.strain[0]) return {};
  return "no rising part: the strain at the largest stress is not above the first one";
}

/// Why a monotonic curve is not in tension; empty if it is.
std::string not_in_tension(const Curve& curve) {
  const auto [low, high] = std::minmax_element(curve.stress.begin(), curve.stress.end());
  const double strain = curve.strain[static_cast<std::size_t>(low - curve.stress.begin())];
  if (-*low > std::max(0.0, *high) && strain < 0.0) {
    return "compression: the largest stress and its strain are negative; turn both columns by "
           "factor = -1 to fit it as tension";
  }
  return *high > 0.0 ? "" : "the stress is nowhere positive";
}

/// Whether the curve ends on its elastic line, within its noise.
bool elastic_to_the_end(const Curve& curve, double modulus, double noise, double yield) {
  const std::size_t count = std::min<std::size_t>(5, curve.size());
  double below = 0.0;
  for (std::size_t i = curve.size() - count; i < curve.size(); ++i) {
    below += modulus * curve.strain[i] - curve.stress[i];
  }
  return below / static_cast<double>(count) <= 3.0 * noise + 1e-6 * yield;
}

/// The rule of TargetOptions::min_samples.
void check_sampling(Target& target, double noise, const TargetOptions& options) {
  const Characteristics& c = target.characteristics;
  const Curve& curve = target.corrected;
  const double modulus = *c.youngs_modulus;
  const double yield =
      c.rp02 ? *c.rp02 : *std::max_element(curve.stress.begin(), curve.stress.end());
  const double doubt = std::clamp(
      5.0 * (c.youngs_modulus_stderr.value_or(0.0) / modulus + noise / yield), 1e-6, 0.1);
  const double yield_strain = yield / modulus;
  std::size_t elastic = 0;
  std::size_t plateau = 0;
  for (const double strain : curve.strain) {
    elastic += strain <= yield_strain * (1.0 + doubt) ? 1 : 0;
    plateau += strain >= yield_strain * (1.0 - doubt) ? 1 : 0;
  }
  const bool no_plateau = !c.rp02 && elastic_to_the_end(curve, modulus, noise, yield);
  if (no_plateau)
    target.warnings.emplace_back("elastic to its end: the yield stress is not identifiable");
  if (elastic >= options.min_samples && (no_plateau || plateau >= options.min_samples)) return;
  give_up(target, TargetStatus::TooCoarse,
          "too coarse: " + std::to_string(elastic) + " samples on the elastic part, " +
              std::to_string(plateau) + " on the plateau, at least " +
              std::to_string(options.min_samples) + " wanted on each");
}

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
  std::size_t run = 0, longest = 0, end = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    run = stress[i] == largest ? run + 1 : 0;
    if (run > longest) {
      longest = run;
      end = i;
    }
  }
  if (longest < kFewest) return;
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

/// Takes out what cannot be, each with a warning: a number of it would be believed.
void drop_impossible(Target& target, const ElasticLine& line) {
  Characteristics& c = target.characteristics;
  if (c.rp02 && !(*c.rp02 > line.low && *c.rp02 > 0.0)) {
    c.rp02.reset();
    target.warnings.emplace_back("no proof stress: it would lie below the window of the modulus");
  }
  if (c.break_strain_plastic && *c.break_strain_plastic < 0.0) {
    c.break_strain_plastic.reset();
    target.warnings.emplace_back(
        "no permanent strain at the break: it would be negative, as Young's modulus is too small");
  }
  constexpr double kLargestError = 0.05;
  if (c.youngs_modulus_stderr && *c.youngs_modulus_stderr > kLargestError * *c.youngs_modulus) {
    target.warnings.push_back(
        fmt::format("Young's modulus has a standard error of {:.2g} %: too few samples, or too "
                    "much noise, on the elastic part",
                    100.0 * *c.youngs_modulus_stderr / *c.youngs_modulus));
  }
  if (!line.is_straight()) {
    target.warnings.push_back(fmt::format(
        "the curve bends where Young's modulus is measured: its slope falls to 1/{:.2g} "
        "there, so that the modulus is not that of an elastic part; name a window "
        "(characteristics.window), or the modulus",
        line.bend));
  }
}

void measure(Target& target, const ElasticLine& line, const RawFacts& facts, double noise,
             const TargetOptions& options) {
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
  if (target.loading == Loading::Cyclic) return;

  c.offset = options.offset;
  if (!sees_offset(line.modulus, options.offset, noise)) {
    target.warnings.emplace_back("no proof stress: its offset is lost in the noise");
  } else if (!elastic_to_the_end(curve, line.modulus, noise, *c.rm)) {
    c.rp02 = proof_stress(curve.strain, curve.stress, line.modulus, 0.0, options.offset);
  }
  if (const auto point = find_yield_point(curve.stress, noise, options.yield_drop)) {
    // Where flow begins: a drop later on is that of a slip, or of a pause.
    constexpr double kLatest = 0.005;
    const double plastic = curve.strain[point->at] - point->upper / line.modulus;
    constexpr double kBelow = 0.995;  // of the proof stress: flow has not begun
    if (c.rp02 && point->upper < kBelow * *c.rp02) {
      target.warnings.push_back(fmt::format(
          "the stress falls at {:.4g} MPa, below the proof stress: a pause or a slip, and no upper "
          "yield strength",
          point->upper / 1e6));
    } else if (plastic <= kLatest) {
      c.reh = point->upper;
      c.rel = point->lower;
    } else {
      target.warnings.push_back(
          fmt::format("the stress drops at {:.3g} % strain: too late for an upper yield strength",
                      100.0 * curve.strain[point->at]));
    }
  }
  drop_impossible(target, line);
}

}  // namespace

void process_target(Target& target, const TargetOptions& options) {
  check_options(options);
  target.test = options.test;
  target.measure = options.measure;
  if (target.raw.strain.size() != target.raw.stress.size()) {
    throw InputError({}, target.name, "", "strain and stress must be equally long");
  }
  const RawFacts facts = drop_missing(target);
  Curve& curve = target.corrected;
  if (curve.size() == 0) {
    return give_up(target, TargetStatus::Rejected, kNoSamples);
  }
  if (const auto next = find_next_specimen(curve.strain, curve.stress);
      next && options.loading != Loading::Cyclic) {
    return give_up(target, TargetStatus::Rejected,
                   "another specimen begins at sample " + std::to_string(*next + 1) +
                       ", where the strain begins anew: tell them apart by split, or by a file "
                       "each");
  }
  target.loading = options.loading ? *options.loading : find_loading(curve);
  const bool monotonic = target.loading == Loading::Monotonic;
  if (monotonic) {
    drop_outliers(samples_of(target));
    drop_spikes(samples_of(target));
    std::string reason = not_in_tension(curve);
    if (!reason.empty()) return give_up(target, TargetStatus::Rejected, std::move(reason));
    drop_foot_reversals(target, options.reversal_tolerance);
  }
  const double noise = noise_of(curve.strain, curve.stress);
  const auto line = find_elastic_line(curve, target.loading, noise, options);
  if (!line) {
    std::string reason = monotonic ? no_rising_part(curve) : std::string();
    if (!reason.empty()) return give_up(target, TargetStatus::Rejected, std::move(reason));
    const std::size_t samples = curve.size();
    return give_up(
        target, TargetStatus::TooCoarse,
        "too coarse: no elastic part is found (fewer than 3 samples in the window of the "
        "modulus, none that rise, or a window above the knee); the curve has " +
            std::to_string(samples) + " samples");
  }
  bool goes_on = facts.extensometer_removed;
  if (monotonic) {
    drop_unloading_loops(target, options);
    goes_on = drop_unloading(target, line->modulus, options) || goes_on;
  }
  trim_at_break(target, line->modulus, goes_on, options);
  if (monotonic) mend_reversals(samples_of(target), options.reversal_tolerance, "strain");
  shift_strain(target, *line, options);
  if (!convert_to_true(target, options)) return;
  measure(target, *line, facts, noise, options);
  warn_of_saturation(target);
  if (options.youngs_modulus && monotonic) warn_of_given_modulus(target, *line, noise, options);
  if (std::string many = too_many_dropped(target); !many.empty()) {
    target.warnings.insert(target.warnings.begin(), std::move(many));
  }
  if (monotonic) check_sampling(target, noise, options);
  if (target.status != TargetStatus::Ready) return;
  std::string reason = why_implausible(target, options);
  if (!reason.empty()) return refuse_implausible(target, std::move(reason), options);
  warn_of_softness(target);
}

Target make_target(std::string name, Curve raw, const TargetOptions& options) {
  Target target;
  target.name = std::move(name);
  target.raw = std::move(raw);
  process_target(target, options);
  return target;
}

std::optional<double> Target::property(std::string_view property_name) const {
  for (const auto& [key, value] : properties) {
    if (key == property_name) return value;
  }
  return std::nullopt;
}

}  // namespace plastica::calibrate
