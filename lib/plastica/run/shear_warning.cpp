#include "plastica/run/shear_warning.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_value.hpp"

namespace plastica::run_detail {
namespace {

/// Fraction of a stretch's deflection from which on shear is warned of.
constexpr double kCounts = 0.05;

/// Shear's deflection of the tip of a cantilever, clamped where the beam begins, under a tip force,
/// over that by bending: integral(dz/(kappa G A)) over integral((L - z)^2 dz/(E I)), for one
/// section 3 E I/(kappa G A L^2). Source: Timoshenko's beam.
double shear_over_bending(const Facts& facts, bool about_x) {
  double shear = 0.0;
  double bending = 0.0;
  double left = facts.scene.beam.length;
  for_each_segment(facts, [&](double along, const chain::BeamRegion& region) {
    const SectionProperties& section = region.properties;
    const double second_moment = about_x ? section.second_moment_x : section.second_moment_y;
    const double kappa = about_x ? section.shear_coefficient_y : section.shear_coefficient_x;
    shear += along / (kappa * resolved_shear_modulus(region.material) * section.area);
    const double beyond = std::max(left - along, 0.0);
    bending += (left * left * left - beyond * beyond * beyond) / 3.0 /
               (region.material.youngs_modulus * second_moment);
    left = beyond;
  });
  return shear / bending;
}

/// A part of the beam between neighbours that hold it across its axis.
struct Stretch {
  double length = 1.0;  ///< over the beam's
  /// Shear over bending, times kappa G A l^2/(E I): of a cantilever under a tip force 3; of a span
  /// under a force in its middle 12, held against rotation at one end 192/7, at both 48.
  double factor = 3.0;
};

/// The longest; beyond a support that lies within, the beam goes on, and holds its rotation.
Stretch longest_stretch(const Facts& facts, bool about_x) {
  struct Hold {
    double at;
    bool rotation;
  };
  std::vector<Hold> holds;
  for (const Support& support : facts.scene.supports) {
    const HeldFreedoms held = support.held();
    if (!held[about_x ? 1 : 0]) continue;
    const double at = fraction_of(support.at, facts.layout.ends);
    holds.push_back({at, held[about_x ? 3 : 4] || (at > 0.0 && at < 1.0)});
  }
  std::ranges::sort(holds, {}, &Hold::at);
  Stretch longest{0.0};
  const auto take = [&](double length, double factor) {
    if (length > longest.length) longest = {length, factor};
  };
  for (std::size_t i = 0; i + 1 < holds.size(); ++i) {
    const int rotations = (holds[i].rotation ? 1 : 0) + (holds[i + 1].rotation ? 1 : 0);
    take(holds[i + 1].at - holds[i].at, rotations == 0   ? 12.0
                                        : rotations == 1 ? 192.0 / 7.0
                                                         : 48.0);
  }
  if (holds.empty()) return {};
  take(holds.front().at, 3.0);
  take(1.0 - holds.back().at, 3.0);
  return longest;
}

}  // namespace

std::optional<std::string> shear_warning(const Facts& facts) {
  using model_detail::figure;
  if (facts.options.translation == JointTranslation::Elastic) return std::nullopt;
  const bool about_x =
      bends_about_x(facts.level) &&
      (!bends_about_y(facts.level) || depth_of(facts, true) >= depth_of(facts, false));
  if (!about_x && !bends_about_y(facts.level)) return std::nullopt;
  const Stretch stretch = longest_stretch(facts, about_x);
  const double slenderness = facts.scene.beam.length / depth_of(facts, about_x);
  const double ratio =
      shear_over_bending(facts, about_x) * stretch.factor / 3.0 / (stretch.length * stretch.length);
  const double fraction = ratio / (1.0 + ratio);
  if (slenderness >= 10.0 && !(fraction >= kCounts)) return std::nullopt;
  const bool is_cantilever = stretch.factor == 3.0;
  const std::string text =
      (is_cantilever ? "the beam is " + figure(slenderness)
                     : "between its supports the beam is " + figure(stretch.length * slenderness)) +
      " times as long as deep: shear, which rigid joints leave out, ";
  if (!std::isfinite(fraction)) {
    return text +
           "may count; with section.shear_coefficient, which numbers do not tell, "
           "solver.translation = \"elastic\" has it";
  }
  return text + "is about " + figure(100.0 * fraction) + " % of the deflection under a force " +
         (is_cantilever ? "at its tip" : "in the middle") +
         " (Timoshenko); solver.translation = \"elastic\" has it";
}

}  // namespace plastica::run_detail
