#include "calibrate/target/plausibility.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "plastica/base/median.hpp"

namespace plastica::calibrate {
namespace {

/// What of a curve is judged.
struct Judged {
  double modulus = 0.0;   ///< [Pa]
  double strength = 0.0;  ///< proof stress, or the largest stress [Pa]
  double strain = 0.0;    ///< the largest [1]
  bool yields = false;
  double yield_strain() const { return strength / modulus; }
};

std::optional<Judged> judged(const Target& target) {
  const Characteristics& c = target.characteristics;
  if (target.test != Test::Tension || !c.youngs_modulus || !c.rm) return std::nullopt;
  // Of what stretches far the true stress is many times the engineering one.
  const double rm = target.measure == Measure::True ? *c.rm / std::exp(c.largest_strain) : *c.rm;
  return Judged{*c.youngs_modulus, c.proof_stress.value_or(rm), c.largest_strain,
                c.proof_stress.has_value()};
}

/// A mistake: by what it multiplies stresses and strains.
struct Mistake {
  double stress, strain;
  std::string_view says;
};

constexpr std::array<Mistake, 14> kMistakes{{
    {1e3, 1.0, "stress looks a thousand times too large: is its unit one step smaller?"},
    {1e-3, 1.0, "stress looks a thousand times too small: is its unit one step larger?"},
    {1e6, 1.0, "stress looks a million times too large: is it in Pa?"},
    {1e-6, 1.0, "stress looks a million times too small: is it in MPa?"},
    {1e-2, 1.0, "stress looks a hundred times too small: is the area in mm^2, not cm^2?"},
    {1e2, 1.0, "stress looks a hundred times too large: is the area in cm^2, not mm^2?"},
    {4.0, 1.0, "stress looks four times too large: is a radius taken for the diameter?"},
    {0.25, 1.0, "stress looks four times too small: is a diameter taken for the radius?"},
    {1.0, 10.0, "strain looks ten times too large: is its unit, or the gauge length's, smaller?"},
    {1.0, 0.1, "strain looks ten times too small: is its unit, or the gauge length's, larger?"},
    {1.0, 1e2, "strain looks a hundred times too large: is it in %?"},
    {1.0, 1e-2, "strain looks a hundred times too small: is it a fraction, not in %?"},
    {1.0, 1e-3, "strain looks a thousand times too small: is the gauge length in mm, not m?"},
    {1.0, 1e3, "strain looks a thousand times too large: is the gauge length in m, not mm?"},
}};

/// Whether numbers are a usual metal's, or near the expected modulus.
bool is_usual(const Judged& curve, const TargetOptions& options) {
  const double e = curve.modulus;
  if (options.expected_modulus) {
    return e < 1.5 * *options.expected_modulus && 1.5 * e > *options.expected_modulus;
  }
  const double y = curve.yield_strain();
  return e > 40e9 && e < 420e9 && y > 2e-4 && y < 0.015 && curve.strain < 1.5;
}

/// What mistake would explain the numbers; of travel where nothing else does and they are too soft.
std::string likely_cause(const Judged& curve, const TargetOptions& options) {
  std::string causes;
  for (const Mistake& mistake : kMistakes) {
    const Judged mended{curve.modulus / mistake.stress * mistake.strain,
                        curve.strength / mistake.stress, curve.strain / mistake.strain,
                        curve.yields};
    if (is_usual(mended, options))
      causes += (causes.empty() ? "" : " or: ") + std::string(mistake.says);
  }
  // A machine's give makes a strong material look soft.
  if (!causes.empty() && !(curve.strength > options.plausible.strong_stress)) return causes;
  for (double give = 1.5; give < 60.0; give *= 1.2) {
    if (is_usual({curve.modulus * give, curve.strength, curve.strain, curve.yields}, options)) {
      return causes + (causes.empty() ? "" : " or: ") +
             "the strain may be crosshead travel, in which the machine gives way, or its gauge "
             "length too short";
    }
  }
  return !causes.empty() ? causes : "are the units of strain and stress right?";
}

std::string stress_text(double stress) {
  const double size = std::fabs(stress);
  if (size >= 1e9) return fmt::format("{:.4g} GPa", stress / 1e9);
  if (size >= 1e5) return fmt::format("{:.4g} MPa", stress / 1e6);
  return fmt::format("{:.4g} kPa", stress / 1e3);
}
std::string percent(double strain) {
  const double value = 100.0 * strain;
  return std::fabs(value) >= 100.0 ? fmt::format("{:.0f} %", value)
                                   : fmt::format("{:.3g} %", value);
}

/// What of a curve lies beyond a bound, and that bound's key.
std::string beyond_bounds(const Judged& curve, bool is_measured, const TargetOptions& options) {
  const PlausibleBounds& bounds = options.plausible;
  const double e = curve.modulus;
  const double y = curve.yield_strain();
  if (is_measured && (e < bounds.min_modulus || e > bounds.max_modulus)) {
    return fmt::format("Young's modulus of {} is not within {} to {} (plausible.youngs_modulus)",
                       stress_text(e), stress_text(bounds.min_modulus),
                       stress_text(bounds.max_modulus));
  }
  if (is_measured && options.expected_modulus) {
    const double ratio = e / *options.expected_modulus;
    if (ratio > bounds.modulus_factor || ratio * bounds.modulus_factor < 1.0) {
      return fmt::format(
          "Young's modulus of {} is off the expected {} by more than a factor of {:g} "
          "(plausible.modulus_factor)",
          stress_text(e), stress_text(*options.expected_modulus), bounds.modulus_factor);
    }
  }
  const bool is_strong = curve.strength > bounds.strong_stress;
  const bool is_soft = e < bounds.soft_modulus && !is_strong && curve.yields;
  const double least = is_soft ? bounds.min_soft_yield_strain : bounds.min_yield_strain;
  const std::string shown = fmt::format("a yield strain of {} ({} over Young's modulus of {})",
                                        percent(y), stress_text(curve.strength), stress_text(e));
  if (y < least) {
    return fmt::format("{} is less than {} (plausible.{})", shown, percent(least),
                       is_soft ? "soft_yield_strain" : "yield_strain");
  }
  // Fibres break at 5 %, and do not yield.
  const double most = curve.yields ? bounds.max_yield_strain : bounds.max_elastic_strain;
  if (is_strong && y > most) {
    return fmt::format("{} is more than {} (plausible.{})", shown, percent(most),
                       curve.yields ? "yield_strain" : "elastic_strain");
  }
  constexpr double kDuctile = 0.02;
  if (is_measured && curve.strain > kDuctile && e > bounds.max_ductile_modulus) {
    return fmt::format(
        "Young's modulus of {} is more than {} for what stretches by {} "
        "(plausible.ductile_modulus)",
        stress_text(e), stress_text(bounds.max_ductile_modulus), percent(curve.strain));
  }
  if (is_strong && curve.strain > bounds.max_strong_strain) {
    return fmt::format(
        "a strain of {} is more than {} for a stress of {} (plausible.strong_strain)",
        percent(curve.strain), percent(bounds.max_strong_strain), stress_text(curve.strength));
  }
  if (curve.strain > bounds.max_strain) {
    return fmt::format("a strain of {} is more than {} (plausible.strain)", percent(curve.strain),
                       percent(bounds.max_strain));
  }
  return {};
}

/// How many times a value is off, "" within the factor.
std::string times_off(double value, double of_group, double factor) {
  if (value >= factor * of_group) return fmt::format("{:.3g} times", value / of_group);
  if (factor * value <= of_group) return fmt::format("1/{:.3g} of", of_group / value);
  return {};
}

}  // namespace

std::string why_implausible(const Target& target, const TargetOptions& options) {
  const auto curve = judged(target);
  if (!curve) return {};
  const bool is_measured = target.characteristics.modulus_method != "given";
  const std::string beyond = beyond_bounds(*curve, is_measured, options);
  return beyond.empty() ? beyond : beyond + "; " + likely_cause(*curve, options);
}

void warn_of_softness(Target& target, const TargetOptions& options) {
  constexpr double kSoft = 0.5e9;
  const auto curve = judged(target);
  if (!curve) return;
  // Of metals magnesium is the softest that carries so much, with 45 GPa.
  constexpr double kSoftMetal = 30e9;
  const bool is_measured = target.characteristics.modulus_method != "given";
  const bool is_strong = curve->strength > options.plausible.strong_stress && curve->yields;
  if (is_measured && is_strong && !options.expected_modulus && curve->modulus < kSoftMetal) {
    target.warnings.push_back(fmt::format(
        "Young's modulus is less than {}, below that of every structural metal: is the strain "
        "crosshead travel, in which the machine gives way, or its gauge length too short?",
        stress_text(kSoftMetal)));
  }
  if (curve->modulus >= kSoft) return;
  target.warnings.push_back(fmt::format(
      "Young's modulus of {}, as of a rubber: are the units of strain and stress right?",
      stress_text(curve->modulus)));
}

std::string plausible_text(const TargetOptions& options) {
  const PlausibleBounds& b = options.plausible;
  std::string text = fmt::format(
      "Young's modulus {} to {}, beyond a strain of 2 % to {}; yield strain {} to {} (the latter "
      "above {}), and at least {} below a modulus of {}; strain up to {}, above {} up to {}; "
      "within "
      "a factor of {:g} of its group's median",
      stress_text(b.min_modulus), stress_text(b.max_modulus), stress_text(b.max_ductile_modulus),
      percent(b.min_yield_strain), percent(b.max_yield_strain), stress_text(b.strong_stress),
      percent(b.min_soft_yield_strain), stress_text(b.soft_modulus), percent(b.max_strain),
      stress_text(b.strong_stress), percent(b.max_strong_strain), b.group_factor);
  if (options.expected_modulus) {
    text += fmt::format("; Young's modulus within a factor of {:g} of {}", b.modulus_factor,
                        stress_text(*options.expected_modulus));
  }
  return text;
}

void refuse_implausible(Target& target, std::string reason, const TargetOptions& options) {
  if (options.accept) {
    target.warnings.push_back("implausible, but accepted: " + std::move(reason));
    return;
  }
  target.status = TargetStatus::Implausible;
  target.reason =
      "implausible: " + std::move(reason) + " (--accept, or plausible.accept = true, fits it)";
}

void check_groups(std::span<Target> targets, const TargetOptions& options) {
  using Groups = std::map<std::vector<std::pair<std::string, std::string>>, std::vector<Target*>>;
  Groups groups;
  for (Target& target : targets) {
    if (target.status == TargetStatus::Ready && judged(target))
      groups[target.group].push_back(&target);
  }
  for (const auto& [group, members] : groups) {
    if (members.size() < 3) continue;
    std::vector<double> moduli, strengths;
    for (const Target* target : members) {
      moduli.push_back(*target->characteristics.youngs_modulus);
      strengths.push_back(*target->characteristics.rm);
    }
    const double modulus = median_of(moduli);
    const double strength = median_of(strengths);
    for (Target* target : members) {
      const Characteristics& c = target->characteristics;
      const double factor = options.plausible.group_factor;
      const std::string of_modulus = times_off(*c.youngs_modulus, modulus, factor);
      const std::string of_strength = times_off(*c.rm, strength, factor);
      constexpr double kFar = 1.5;
      const std::string far = times_off(*c.youngs_modulus, modulus, kFar);
      if (of_modulus.empty() && of_strength.empty() && !far.empty()) {
        target->warnings.push_back(fmt::format(
            "Young's modulus is {} the median of its {} specimens: is its gauge length, area or "
            "material another one?",
            far, members.size()));
      }
      if (of_modulus.empty() && of_strength.empty()) continue;
      const bool is_modulus = !of_modulus.empty();
      refuse_implausible(*target,
                         fmt::format("{} is {} the median of its {} specimens "
                                     "(plausible.group_factor); is its unit another one?",
                                     is_modulus ? "Young's modulus" : "the largest stress",
                                     is_modulus ? of_modulus : of_strength, members.size()),
                         options);
    }
  }
}

}  // namespace plastica::calibrate
