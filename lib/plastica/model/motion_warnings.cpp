#include "plastica/model/motion_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/first_frequency.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::model_detail {
namespace {

using std::numbers::pi;

/// Steps in a period that a vibration needs at least to be followed.
constexpr double kEnoughSteps = 20.0;

double omega_of(const FirstFrequency& first) { return 2.0 * pi * first.hertz; }

/// What the warnings need to know of a motion.
struct Facts {
  const Scene& scene;
  const SolverOptions& options;
  const LevelChoice& level;
  const SectionProperties& section;         // of the scene's own
  double duration = 0.0;                    // [s]
  double step = 0.0;                        // of fixed steps [s]
  std::optional<FirstFrequency> first{};    // only with fixed steps
  std::optional<FirstFrequency> fastest{};  // of that and of what is excited
};

std::optional<std::string> coarse_steps(const Facts& facts) {
  if (!facts.fastest) return std::nullopt;
  const double period = 1.0 / facts.fastest->hertz;
  if (period >= kEnoughSteps * facts.step) return std::nullopt;
  return "steps of " + figure(facts.step) + " s are " + figure(period / facts.step) +
         " in a period of the beam's " + frequency_text(*facts.fastest) +
         " (below 20); solver.time_step = \"" + figure(period / kEnoughSteps) + " s\" makes 20";
}

/// That of a sine of the same range and the same largest curvature [s]; infinite for a line.
double shortest_period(const History& history) {
  const auto [low, high] = std::ranges::minmax(history.factor);
  double curvature = 0.0;
  for (const double time : history.time) {
    curvature = std::max(curvature, std::fabs(history.curvature_at(time)));
  }
  return 2.0 * pi * std::sqrt(0.5 * (high - low) / curvature);
}

/// Steps do not end at the segments of smooth histories, so that they must be short beside these.
std::optional<std::string> coarse_histories(const Facts& facts) {
  if (facts.options.step_error > 0.0) return std::nullopt;
  const auto history = shortest_history(facts.scene);
  if (!history || history->period >= kEnoughSteps * facts.step) return std::nullopt;
  return "steps of " + figure(facts.step) + " s are " + figure(history->period / facts.step) +
         " in a period of " + history->name + " (below 20); solver.time_step = \"" +
         figure(history->period / kEnoughSteps) + " s\" makes 20";
}

/// Where a support moves along straight lines its speed jumps from one to the next. The beam takes
/// the impulse, but no force between the jumps shows it.
std::optional<std::string> jumping_supports(const Facts& facts) {
  constexpr int kMeant = 4;  // as a trapezoid has
  for (std::size_t i = 0; i < facts.scene.supports.size(); ++i) {
    const Support& support = facts.scene.supports[i];
    const History& history = support.history;
    if (!support.moves() || !history.slope.empty()) continue;
    int jumps = 0;
    for (std::size_t k = 1; k + 1 < history.time.size(); ++k) {
      const double before = history.slope_at(history.time[k - 1]);
      const double after = history.slope_at(history.time[k]);
      constexpr double kRounding = 1e-9;
      // Where it turns back, as cycles do, a corner is meant.
      const bool jump =
          before * after >= 0.0 && std::fabs(after - before) > kRounding * std::fabs(before);
      if (jump && history.time[k] < facts.duration) ++jumps;
    }
    if (jumps <= kMeant) continue;
    return item_name("support", i) + " moves along straight lines, and its speed jumps " +
           std::to_string(jumps) +
           " times: reactions have nothing of the force that these jumps take; "
           "interpolation = \"cubic\" in its history makes them smooth";
  }
  return std::nullopt;
}

/// What acts on a beam, all in one direction; where no force does, that of a strain of 1e-6 [N].
double acting_force(const Facts& facts, double mass) {
  const Scene& scene = facts.scene;
  const auto size_of = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };
  double sum = mass * size_of(scene.gravity);
  for (const Load& load : scene.loads) {
    sum += size_of(load.force) * (load.to ? scene.beam.length : 1.0);
  }
  constexpr double kHardlyAny = 1e-6;
  return sum > 0.0 ? sum : kHardlyAny * scene.material.youngs_modulus * facts.section.area;
}

/// In a step a place is known to its rounding, so that accelerations, and with them the forces of
/// joints that are rigid along the beam, are noise of M L eps/h^2, times some hundred in chains of
/// tens of segments (measured). In double precision that is something in the shortest steps alone.
std::optional<std::string> noisy_forces(const Facts& facts) {
  if (is_articulated(facts.options.scheme)) return std::nullopt;
  const auto& probes = facts.scene.probes;
  const auto shows = std::find_if(probes.begin(), probes.end(), [](const Probe& probe) {
    return probe.quantity == ProbeQuantity::Reaction || probe.quantity == ProbeQuantity::Force;
  });
  if (shows == probes.end()) return std::nullopt;
  constexpr double kMeasured = 100.0, kMuch = 0.01;
  const bool is_float = facts.options.precision == Precision::Float;
  const double length = facts.scene.beam.length;
  const double mass = facts.scene.material.density * facts.section.area * length;
  const double unit = is_float ? double{std::numeric_limits<float>::epsilon()}
                               : std::numeric_limits<double>::epsilon();
  const double noise = kMeasured * mass * length * unit / (facts.step * facts.step);
  if (!is_float && noise < kMuch * acting_force(facts, mass)) return std::nullopt;
  const std::string size = shows->name + " may have noise of some " + figure(noise) +
                           " N along the beam, rounding of places over the square of the step; ";
  if (is_float) {
    return "solver.precision = \"float\": " + size +
           "\"double\" has hardly any, an articulated scheme none";
  }
  return "steps of " + figure(facts.step) + " s: " + size +
         "longer steps have less, an articulated scheme none";
}

/// Implicit Euler takes a vibration to 1/sqrt(1 + a^2) of its amplitude in a step of the phase
/// a = omega dt, so in a period of 2 pi/a steps to exp(-pi a) for a small a.
std::optional<std::string> first_order(const Facts& facts) {
  const bool articulated = facts.options.scheme == Scheme::ArticulatedEuler;
  if (!articulated && facts.options.scheme != Scheme::LinearlyImplicitEuler) return std::nullopt;
  if (!facts.first) return std::nullopt;
  const double lost = 1.0 - std::exp(-pi * omega_of(*facts.first) * facts.step);
  const std::string kind = articulated ? "articulated_" : "linearly_implicit_";
  return "solver.scheme = \"" + kind + "euler\" is of first order: it takes about " +
         figure(100.0 * lost) + " % of the amplitude in each period of the beam's " +
         frequency_text(*facts.first) + "; \"" + kind + "midpoint\" costs the same";
}

std::optional<std::string> undamped_alpha(const Facts& facts) {
  if (facts.options.scheme != Scheme::GeneralizedAlpha || facts.options.rho_infinity < 1.0) {
    return std::nullopt;
  }
  return "solver.rho_infinity = 1 damps nothing, and generalized_alpha gains energy where a beam "
         "turns far in coarse steps; 0.8 damps what the steps cannot follow, \"energy_momentum\" "
         "keeps energy";
}

/// The highest frequency of a long chain of rods [Hz]: neighbours swing against each other. With
/// the nodes displaced by w (-1)^i, each of the rods of mass m = rho A l has the kinetic energy
/// m w'^2/6 and, of its section, rho I l (2 w'/l)^2/2, and each joint the energy
/// (E I/l)(4 w/l)^2/2; so omega^2 = 48 E I/(rho A l^4)/(1 + 12 I/(A l^2)).
double highest_frequency(const Facts& facts) {
  const Scene& scene = facts.scene;
  const SectionProperties& section = facts.section;
  const bool about_y = facts.level.level == Level::Planar && facts.level.bending == BendingAxis::Y;
  const double area_moment = about_y ? section.second_moment_y : section.second_moment_x;
  const double radius_squared = area_moment / section.area;
  const double l = scene.beam.length / scene.beam.segments;
  const double rotary =
      facts.options.rotary_inertia == RotaryInertia::On ? 12.0 * radius_squared / (l * l) : 0.0;
  const double omega = std::sqrt(48.0 * scene.material.youngs_modulus * radius_squared /
                                 (scene.material.density * (1.0 + rotary))) /
                       (l * l);
  return omega / (2.0 * pi);
}

std::optional<std::string> ringing(const Facts& facts) {
  const Scheme scheme = facts.options.scheme;
  const bool rings = scheme == Scheme::EnergyMomentum || scheme == Scheme::LinearlyImplicitMidpoint;
  const auto& supports = facts.scene.supports;
  const bool hits = std::any_of(supports.begin(), supports.end(), [](const Support& support) {
    return traits_of(support).one_sided;
  });
  if (!rings || !hits || facts.options.damping != Damping::None ||
      facts.level.level == Level::Twist) {
    return std::nullopt;
  }
  const double highest = highest_frequency(facts);
  if (1.0 / highest >= kEnoughSteps * facts.step) return std::nullopt;
  const std::string word =
      scheme == Scheme::EnergyMomentum ? "energy_momentum" : "linearly_implicit_midpoint";
  return "solver.scheme = \"" + word +
         "\" damps nothing: after an impact on a pillar the chain rings on at up to about " +
         figure(highest) + " Hz, which steps of " + figure(facts.step) +
         " s do not follow; \"generalized_alpha\" or solver.damping takes that out";
}

/// Newton's impact makes the touched point's speed -e times that before, by an impulse that the
/// joints pass on without a moment: what bounces with it is of the size of a segment.
std::optional<std::string> local_restitution(const Facts& facts) {
  const auto& supports = facts.scene.supports;
  const auto set = std::find_if(supports.begin(), supports.end(),
                                [](const Support& support) { return support.restitution > 0.0; });
  if (set == supports.end()) return std::nullopt;
  return item_name("support", static_cast<std::size_t>(set - supports.begin()), ".restitution") +
         " = " + figure(set->restitution) +
         " is that of the touched point, which has about the mass of a segment, 1/" +
         std::to_string(facts.scene.beam.segments) +
         " of the beam: the finer the chain, the less it says of how the beam bounces, which "
         "its bending decides";
}

std::optional<std::string> growing_gravity(const Facts& facts) {
  const auto& g = facts.scene.gravity;
  const double size = std::hypot(g[0], g[1], g[2]);
  if (size == 0.0 || !facts.scene.gravity_history.continues) return std::nullopt;
  return "gravity follows a ramp: it grows by " + figure(size) + " m/s^2 in each second, to " +
         figure(size * facts.duration) +
         " m/s^2 at the end; history = \"constant\" has it from the first";
}

std::optional<std::string> articulated_yield(const Facts& facts) {
  if (!is_articulated(facts.options.scheme) || facts.scene.yield_model == YieldModel::Elastic) {
    return std::nullopt;
  }
  return "articulated schemes leave the axial force out of yielding, and do not measure it; "
         "rules.yield_model = \"interaction\" with another scheme takes it into account";
}

std::optional<std::string> late_cut(const Facts& facts) {
  for (std::size_t i = 0; i < facts.scene.cuts.size(); ++i) {
    const double time = facts.scene.cuts[i].time;
    if (time < facts.duration) continue;
    return item_name("cut", i) + " at " + figure(time) + " s never comes: the motion ends at " +
           figure(facts.duration) + " s";
  }
  return std::nullopt;
}

}  // namespace

std::optional<HistoryPeriod> shortest_history(const Scene& scene) {
  std::optional<HistoryPeriod> shortest;
  const auto look_at = [&](const History& history, const std::string& name) {
    if (history.slope.size() < 3) return;
    const double period = shortest_period(history);
    if (!std::isfinite(period) || (shortest && shortest->period <= period)) return;
    shortest = HistoryPeriod{period, name};
  };
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    look_at(scene.loads[i].history, item_name("load", i, ".history"));
  }
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& support = scene.supports[i];
    if (support.moves()) look_at(support.history, item_name("support", i, ".history"));
  }
  look_at(scene.gravity_history, "gravity.history");
  return shortest;
}

std::vector<std::string> motion_warnings(const Scene& scene, const SolverOptions& options,
                                         const LevelChoice& level, const SectionProperties& section,
                                         std::span<const double> ends) {
  Facts facts{scene, options, level, section};
  facts.duration = options.duration > 0.0 ? options.duration : last_time(scene);
  // Steps are of one length from sample to sample.
  const double sampled = facts.duration / options.steps;
  facts.step = sampled / std::max(1.0, std::ceil(sampled / options.time_step - 1e-9));
  if (options.step_error == 0.0) {
    facts.first = first_frequency(scene, level, section, ends);
    facts.fastest = facts.first;
    for (const FirstFrequency& one :
         excited_frequencies(scene, level, {options.translation, facts.duration}, section, ends)) {
      if (!facts.fastest || one.hertz > facts.fastest->hertz) facts.fastest = one;
    }
  }
  std::vector<std::string> warnings;
  for (const auto find :
       {coarse_steps, coarse_histories, jumping_supports, first_order, undamped_alpha, ringing,
        local_restitution, growing_gravity, late_cut, articulated_yield, noisy_forces}) {
    if (auto warning = find(facts)) warnings.push_back(std::move(*warning));
  }
  return warnings;
}

}  // namespace plastica::model_detail
