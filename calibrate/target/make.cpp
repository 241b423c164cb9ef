#include "calibrate/target/make.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/correct.hpp"
#include "calibrate/target/elastic_line.hpp"
#include "calibrate/target/measure.hpp"
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

/// The model follows the strain of a cyclic curve to and fro, its noise as well.
void warn_of_followed_noise(Target& target) {
  double noise = 0.0;
  const Samples samples = samples_of(target);
  const std::size_t reversed = reversed_by_noise(samples, noise);
  if (reversed == 0) return;
  target.warnings.push_back(
      fmt::format("the strain runs to and fro by its noise of {:.2g} in {} of {} samples, and the "
                  "model of a cyclic test follows it, as unloading and new flow: stresses come out "
                  "too large; smooth the strain before",
                  noise, reversed, samples.size()));
}

/// Drops where the strain runs back, as what was measured there is no strain of the specimen; a
/// break behind such rows has none either.
void mend_strain(Target& target, const TargetOptions& options) {
  constexpr std::size_t kFew = 5;
  constexpr double kUnderLoad = 0.9;  // of where it turned back; else it is the break that ran back
  const Curve& curve = target.corrected;
  const bool runs_back = curve.size() > 0 && curve.strain.back() < std::ranges::max(curve.strain);
  const Curve before = runs_back ? curve : Curve();
  mend_reversals(samples_of(target), options.reversal_tolerance, "strain");
  auto& observed = target.characteristics.observed_break;
  if (!runs_back || !observed || curve.size() == 0) return;
  const auto last = std::find(before.strain.rbegin(), before.strain.rend(), curve.strain.back());
  const auto lost = static_cast<std::size_t>(last - before.strain.rbegin());
  if (lost < kFew || lost == before.size()) return;
  const double turned = before.stress[before.size() - 1 - lost];
  if (before.stress.back() < kUnderLoad * turned) return;
  observed.reset();
  target.ran_back = true;
  target.warnings.push_back(fmt::format(
      "the strain runs back from {:.4g} % for {} samples before the break, under load: where the "
      "specimen broke is not measured",
      100.0 * curve.strain.back(), lost));
}

/// Where a strain has stood still for long before a break, that may not be measured.
void warn_of_still_strain(Target& target, const RawFacts& facts) {
  const auto& observed = target.characteristics.observed_break;
  const StrainEnd& end = facts.strain_end;
  if (end.unclear == 0 || !observed) return;
  if (std::abs(observed->last_intact_strain - end.still) > end.within) return;  // it broke before
  target.warnings.push_back(fmt::format(
      "the strain stands still at {:.4g} % over {} rows before the break: if the extensometer was "
      "taken off, or at its limit, the strain at break is not the specimen's",
      100.0 * end.still, end.unclear));
}

/// Samples of a strain with coarse steps are not as many as they look.
void warn_of_coarse_strain(Target& target, const ElasticLine& line) {
  constexpr std::size_t kFewSteps = 10, kRowsEach = 3;
  const Curve& curve = target.corrected;
  std::size_t rows = 0, steps = 0;
  for (std::size_t i = 1; i < curve.size() && std::abs(curve.stress[i]) <= line.high; ++i) {
    if (std::abs(curve.stress[i]) < line.low) continue;
    ++rows;
    steps += curve.strain[i] != curve.strain[i - 1] ? 1 : 0;
  }
  if (steps >= kFewSteps || rows < kRowsEach * std::max<std::size_t>(steps, 1)) return;
  target.warnings.push_back(fmt::format(
      "the strain has {} values in the {} samples of the modulus: by its steps Young's modulus may "
      "be off by more than its error says",
      steps, rows));
}

/// The rule of TargetOptions::min_samples.
void check_sampling(Target& target, double noise, const TargetOptions& options) {
  const Characteristics& c = target.characteristics;
  const Curve& curve = target.corrected;
  const double modulus = *c.youngs_modulus;
  const double yield = c.proof_stress ? *c.proof_stress
                                      : *std::max_element(curve.stress.begin(), curve.stress.end());
  const double doubt = std::clamp(
      5.0 * (c.youngs_modulus_stderr.value_or(0.0) / modulus + noise / yield), 1e-6, 0.1);
  const double yield_strain = yield / modulus;
  std::size_t elastic = 0;
  std::size_t plateau = 0;
  for (const double strain : curve.strain) {
    elastic += strain <= yield_strain * (1.0 + doubt) ? 1 : 0;
    plateau += strain >= yield_strain * (1.0 - doubt) ? 1 : 0;
  }
  const bool no_plateau = !c.proof_stress && elastic_to_the_end(curve, modulus, noise, yield);
  if (no_plateau)
    target.warnings.emplace_back("elastic to its end: the yield stress is not identifiable");
  if (elastic >= options.min_samples && (no_plateau || plateau >= options.min_samples)) return;
  give_up(target, TargetStatus::TooCoarse,
          "too coarse: " + std::to_string(elastic) + " samples on the elastic part, " +
              std::to_string(plateau) + " on the plateau, at least " +
              std::to_string(options.min_samples) + " wanted on each");
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
  } else {
    warn_of_followed_noise(target);
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
  if (monotonic) warn_of_still_strain(target, facts);
  if (monotonic) mend_strain(target, options);
  shift_strain(target, *line, options);
  if (line->samples > 0) warn_of_coarse_strain(target, *line);
  if (!convert_to_true(target, options)) return;
  measure_characteristics(target, *line, facts, noise, options);
  if (std::string many = too_many_dropped(target); !many.empty()) {
    target.warnings.insert(target.warnings.begin(), std::move(many));
  }
  if (monotonic) check_sampling(target, noise, options);
  if (target.status != TargetStatus::Ready) return;
  std::string reason = why_implausible(target, options);
  if (!reason.empty()) return refuse_implausible(target, std::move(reason), options);
  warn_of_softness(target, options);
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
