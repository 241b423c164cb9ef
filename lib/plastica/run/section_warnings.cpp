#include "plastica/run/section_warnings.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/chain/joint_model.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/run/scene_joints.hpp"

namespace plastica::run_detail {
namespace {

using model_detail::figure;

/// Whether one law with the fully plastic cap stands for the section.
bool is_whole(const Scene& scene) {
  return scene.yield_cap == YieldCap::FullyPlastic && scene.yield_model != YieldModel::Elastic &&
         scene.yield_model != YieldModel::Fibre;
}

}  // namespace

std::optional<std::string> steep_hardening_warning(const Facts& facts) {
  const Scene& scene = facts.scene;
  const double factor = shape_factor(facts);
  if (!is_whole(scene) || is_ideal(scene) || factor < 1.05) return {};
  return "joints with rules.yield_cap = \"fully_plastic\" harden " + figure(factor) +
         " times as steeply as the section does once all of it flows: they bend too little; "
         "\"fibre\" for rules.yield_model follows the section";
}

std::optional<std::string> whole_section_rate_warning(const Facts& facts) {
  const Scene& scene = facts.scene;
  const RateDependence& rate = scene.material.rate;
  if (!is_whole(scene) || !has_own_rates(scene.material)) return {};
  // In torsion a circle has int_0^1 3 y^2 (...) dy.
  const double powers = facts.level.level == Level::Twist ? 3.0 : 2.0;
  const bool by_power = rate.law == RateLaw::CowperSymonds;
  const std::string much = by_power ? "what the rate adds to a moment comes out " +
                                          figure(100.0 / (powers * *rate.exponent)) + " % too large"
                                    : "a moment comes out by " +
                                          figure(100.0 * *rate.coefficient / powers) +
                                          " % of its value at the reference rate too large";
  const std::string of = powers == 2.0 ? " in a rectangle (in a round bar a quarter more)" : "";
  return "joints with rules.yield_cap = \"fully_plastic\" take the strain rate of the outermost "
         "fibre for all of the section: " +
         much + of + "; \"fibre\" for rules.yield_model has each fibre's own";
}

std::optional<std::string> break_measure_warning(const Facts& facts) {
  const Scene& scene = facts.scene;
  const bool keeps_less = scene.yield_model == YieldModel::Fibre || is_whole(scene);
  if (!keeps_less || scene.formulas == Formulas::Report || facts.level.level == Level::Twist) {
    return {};
  }
  constexpr double kNotable = 0.05;
  double limit = chain::JointModel::kNever;
  for (const chain::JointModel& joint :
       scene_joints(*facts.model.chain, material_values(scene.material))) {
    for (const std::size_t k : {0U, 1U, 3U}) limit = std::min(limit, joint.limit[k]);
  }
  const double less =
      (shape_factor(facts) - 1.0) * scene.material.yield_stress / scene.material.youngs_modulus;
  if (!(less > kNotable * limit)) return {};
  return "a break limit of " + figure(100.0 * limit) +
         " % is held against the bend that stays without the moment; the permanent strain of the "
         "extreme fibre is up to " +
         figure(100.0 * less) +
         " % more there, so that the beam breaks too late, and a limit that is fitted comes out "
         "too small by as much";
}

}  // namespace plastica::run_detail
