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

/// How the ends of a stretch are held against rotation.
enum class Ends { Cantilever, Free, OneHeld, BothHeld };

/// A part of the beam between neighbours that hold it across its axis.
struct Stretch {
  double length = 1.0;  ///< over the beam's
  Ends ends = Ends::Cantilever;
};

/// Shear's part of the deflection under a force at a cantilever's tip or in the middle of a span.
/// @param phi  E I/(kappa G A l^2) of the stretch
/// Source: unit loads on Timoshenko's beam. Of a span that is held at one end the roller's force is
/// (5/48 + phi/2)/(1/3 + phi) of the force, and the deflection without shear 7/768.
double shear_part(Ends ends, double phi) {
  const auto part = [](double ratio) { return ratio / (1.0 + ratio); };
  switch (ends) {
    case Ends::Cantilever: return part(3.0 * phi);
    case Ends::Free: return part(12.0 * phi);
    case Ends::BothHeld: return part(48.0 * phi);
    case Ends::OneHeld: break;
  }
  const double roller = (5.0 / 48.0 + 0.5 * phi) / (1.0 / 3.0 + phi);
  const double deflection = 1.0 / 24.0 + 0.5 * phi - roller * (5.0 / 48.0 + 0.5 * phi);
  return 1.0 - 7.0 / 768.0 / deflection;
}

/// The longest; beyond a support that lies within, the beam goes on, and holds its rotation.
Stretch longest_stretch(const Facts& facts, bool about_x) {
  struct Hold {
    double at;
    bool rotation;
  };
  std::vector<Hold> holds;
  for (const Support& support : facts.scene.supports) {
    // At rest one that moves is the load: the head of a machine.
    if (facts.options.analysis == Analysis::Statics && support.moves()) continue;
    const HeldFreedoms held = support.held();
    constexpr double kMostly = 0.7;  // of a normal
    const std::size_t across = about_x ? 1 : 0;
    const bool by_normal = support.has_normal() && std::fabs(support.normal[across]) > kMostly;
    if (!held[across] && !by_normal) continue;
    const double at = fraction_of(support.at, facts.layout.ends);
    holds.push_back({at, held[about_x ? 3 : 4] || (at > 0.0 && at < 1.0)});
  }
  std::ranges::sort(holds, {}, &Hold::at);
  Stretch longest{0.0};
  const auto take = [&](double length, Ends ends) {
    if (length > longest.length) longest = {length, ends};
  };
  for (std::size_t i = 0; i + 1 < holds.size(); ++i) {
    const int rotations = (holds[i].rotation ? 1 : 0) + (holds[i + 1].rotation ? 1 : 0);
    take(holds[i + 1].at - holds[i].at, rotations == 0   ? Ends::Free
                                        : rotations == 1 ? Ends::OneHeld
                                                         : Ends::BothHeld);
  }
  if (holds.empty()) return {};
  take(holds.front().at, Ends::Cantilever);
  take(1.0 - holds.back().at, Ends::Cantilever);
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
  const double phi = shear_over_bending(facts, about_x) / 3.0 / (stretch.length * stretch.length);
  const double fraction = shear_part(stretch.ends, phi);
  if (slenderness >= 10.0 && !(fraction >= kCounts)) return std::nullopt;
  const bool is_cantilever = stretch.ends == Ends::Cantilever;
  const std::string text = (is_cantilever ? "the beam is " : "between its supports the beam is ") +
                           figure(stretch.length * slenderness) +
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

std::optional<std::string> thick_wall_warning(const Facts& facts) {
  constexpr double kHollow = 0.6;
  if (facts.options.translation != JointTranslation::Elastic) return std::nullopt;
  const auto is_thick = [](const chain::BeamRegion& region) {
    const Section& section = region.section;
    return section.shape == SectionShape::RectangularTube && !section.shear_coefficient &&
           (section.inner_width < kHollow * section.width ||
            section.inner_height < kHollow * section.height);
  };
  if (std::ranges::none_of(facts.layout.regions, is_thick)) return std::nullopt;
  return "the shear coefficient of a rectangular tube is Cowper's of thin walls, and these are "
         "thick: it shears too much, some 1.7 times with next to no hole; "
         "section.shear_coefficient "
         "says a better one";
}

}  // namespace plastica::run_detail
