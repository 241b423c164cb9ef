#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "plastica/base/check.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/field.hpp"

namespace plastica::model_detail {
namespace {

InputError refusal(std::string_view field, std::string_view value, std::string_view rule) {
  return {{}, field, value, rule};
}

/// What a chain by Wendelius' formulas cannot have.
void check_report_rules(const Scene& scene) {
  if (scene.yield_model != YieldModel::PerAxis && scene.yield_model != YieldModel::Elastic) {
    throw refusal("rules.yield_model", "",
                  "must be per_axis (or elastic) with Wendelius' formulas, which clip each moment "
                  "on its own");
  }
  bool ideal = scene.material.hardening.law == HardeningLaw::Ideal;
  for (const Region& region : scene.regions) {
    ideal = ideal && region.material.hardening.law == HardeningLaw::Ideal;
  }
  if (!ideal) {
    throw refusal("material.hardening.law", "",
                  "must be ideal with Wendelius' formulas, which have no hardening");
  }
  if (scene.end_rule == EndRule::HalfJoint) {
    throw refusal("rules.end_rule", "half_joint",
                  "Wendelius' report clamps its ends rigidly: equal, half or three_halves");
  }
  if (scene.hinge_length.value_or(0.0) != 0.0) {
    throw refusal("rules.hinge_length", number_text(*scene.hinge_length),
                  "must be 0 or unset with Wendelius' formulas, whose strain is over a joint's "
                  "own length");
  }
}

void check_yield(const Scene& scene) {
  const bool fully_plastic = scene.yield_cap == YieldCap::FullyPlastic;
  if (fully_plastic && scene.yield_model == YieldModel::Conservative) {
    throw refusal("rules.yield_cap", "fully_plastic",
                  "the conservative surface is one of first yield");
  }
  if (fully_plastic && scene.yield_model == YieldModel::Fibre) {
    throw refusal("rules.yield_cap", "fully_plastic",
                  "a fibre section yields fibre by fibre and has no cap");
  }
  const bool limited = scene.break_limit_x || scene.break_limit_y || scene.break_limit_z;
  if (limited && scene.yield_model == YieldModel::Elastic) {
    throw refusal("rules.yield_model", "elastic",
                  "leaves no permanent strain that a break limit could be held against");
  }
}

void check_end_rule(const Scene& scene) {
  const bool sets_lengths =
      scene.end_rule == EndRule::Half || scene.end_rule == EndRule::ThreeHalves;
  const std::string_view word = scene.end_rule == EndRule::Half ? "half" : "three_halves";
  if (sets_lengths && !scene.beam.segment_fractions.empty()) {
    throw refusal("rules.end_rule", word, "sets the segment lengths itself");
  }
  if (sets_lengths && !scene.beam.joint_lengths.empty()) {
    throw refusal("rules.end_rule", word, "sets the joint lengths itself");
  }
  if (!has_half_joints(scene) && scene.beam.segments < 2) {
    throw refusal("beam.segments", std::to_string(scene.beam.segments),
                  "must be at least 2 where ends are clamped: there is no joint");
  }
}

/// Refuses what only a motion has.
void check_quantity_of_statics(const Probe& probe, const std::string& name) {
  using enum ProbeQuantity;
  const std::string_view rule = "needs solver.analysis = \"dynamics\"";
  switch (probe.quantity) {
    case Velocity:
    case Spin:
    case Momentum:
    case AngularMomentum:
      throw refusal(name + ".kind", probe_kinds()[static_cast<std::size_t>(probe.quantity)], rule);
    default: break;
  }
  if (probe.quantity != Energy || probe.energy < EnergyKind::Kinetic) return;
  throw refusal(name + ".energy", kEnergyKinds[static_cast<std::size_t>(probe.energy)], rule);
}

void check_chain_probe(const Scene& scene, const Probe& probe, const std::string& name,
                       std::span<const double> ends) {
  using enum ProbeQuantity;
  const std::string_view kind = probe_kinds()[static_cast<std::size_t>(probe.quantity)];
  if (probe.quantity == Load || probe.quantity == Dissipation) {
    throw refusal(name + ".kind", kind, "is recorded of a coupon alone");
  }
  check_place(probe.at, scene.beam.segments, name + ".at");
  if (probe.quantity == Reaction || probe.quantity == ReactionMoment) {
    const double fraction = fraction_of(probe.at, ends);
    const bool supported = std::any_of(
        scene.supports.begin(), scene.supports.end(),
        [&](const Support& support) { return fraction_of(support.at, ends) == fraction; });
    if (!supported) throw refusal(name + ".at", place_text(probe.at), "has no support");
  }
}

}  // namespace

bool has_half_joints(const Scene& scene) { return resolved_end_rule(scene) == EndRule::HalfJoint; }

double last_time(const Scene& scene) {
  double last = 0.0;
  for (const Load& load : scene.loads) last = std::max(last, load.history.end());
  for (const Support& support : scene.supports) {
    if (support.moves()) last = std::max(last, support.history.end());
  }
  const bool heavy = scene.gravity != std::array<double, 3>{};
  return heavy ? std::max(last, scene.gravity_history.end()) : last;
}

std::span<const ChainRule> chain_rules() {
  constexpr std::string_view kLimit =
      "is of chains: a coupon breaks at material.break_strain or material.break_shear_strain";
  static constexpr std::array kRules{
      ChainRule{"rules.yield_model", "is of chains: a coupon has one stress component"},
      ChainRule{"rules.break_limit_x", kLimit}, ChainRule{"rules.break_limit_y", kLimit},
      ChainRule{"rules.break_limit_z", kLimit},
      ChainRule{"rules.hinge_length", "is of chains: a coupon has no hinge"}};
  return kRules;
}

void check_coupon_rules(const Setup& setup) {
  struct Left {
    const ChainRule& rule;
    const Field& field;
    FieldValue value;
  };
  static const std::vector<Left> kAllLeft = [] {
    const Setup plain;
    std::vector<Left> all;
    for (const ChainRule& rule : chain_rules()) {
      const Field& field = find_field(rule.path);
      all.push_back({rule, field, field.get(plain)});
    }
    return all;
  }();
  for (const auto& [rule, field, left] : kAllLeft) {
    const FieldValue value = field.get(setup);
    if (value == left) continue;
    const auto* word = std::get_if<std::string>(&value);
    const auto* number = std::get_if<double>(&value);
    throw refusal(rule.path, word != nullptr ? *word : number_text(*number), rule.why);
  }
}

void check_rules(const Scene& scene) {
  if (scene.formulas == Formulas::Report) check_report_rules(scene);
  check_yield(scene);
  check_end_rule(scene);
}

void check_precision(const Scene& scene, const SolverOptions& options) {
  if (options.precision == Precision::Double) return;
  if (scene.is_coupon()) {
    throw refusal("solver.precision", "float", "is of chains: a coupon is computed in double");
  }
  if (options.translation == JointTranslation::Elastic) {
    throw refusal("solver.precision", "float",
                  "is of joints that are rigid in translation (solver.translation)");
  }
  if (scene.material.hardening.law != HardeningLaw::Ideal) {
    throw refusal("solver.precision", "float", "is of ideal plasticity (material.hardening.law)");
  }
}

void check_solver(const Scene& scene, const SolverOptions& options) {
  if (options.control_at) {
    check_place(*options.control_at, scene.beam.segments, "solver.control_at");
  }
  if (options.control == PathControl::Displacement && !options.control_at && scene.loads.empty()) {
    throw refusal("solver.control_at", "",
                  "is missing: no load says which point displacement control should watch");
  }
  if (options.control == PathControl::Displacement) {
    double size = 0.0;
    for (const double part : options.control_motion) size += part * part;
    if (!(size > 0.0 && std::isfinite(size))) {
      throw refusal("solver.control_motion", "",
                    "is needed: how far displacement control takes the point that it watches");
    }
  }
  if (options.control == PathControl::Load && options.control_at) {
    throw refusal("solver.control_at", place_text(*options.control_at),
                  "is of no use with load control");
  }
  if (options.duration == 0.0 && last_time(scene) == 0.0) {
    throw refusal("solver.duration", "0",
                  options.analysis == Analysis::Statics
                      ? "must be above 0 where every history is constant"
                      : "must be above 0 where no history says when the motion ends");
  }
}

void check_probes(const Scene& scene, Analysis analysis, Ends ends) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    const Probe& probe = scene.probes[i];
    const std::string name = item_name("probe", i);
    if (probe.name.empty()) throw refusal(name + ".name", "", "must not be empty");
    if (!names.insert(probe.name).second) {
      throw refusal(name + ".name", probe.name, "is used by another probe of the scene");
    }
    if (!scene.is_coupon()) {
      if (analysis == Analysis::Statics) check_quantity_of_statics(probe, name);
      check_chain_probe(scene, probe, name, ends);
    } else if (probe.quantity > ProbeQuantity::Dissipation) {
      throw refusal(name + ".kind", probe_kinds()[static_cast<std::size_t>(probe.quantity)],
                    "is recorded of a chain alone");
    }
  }
}

}  // namespace plastica::model_detail
