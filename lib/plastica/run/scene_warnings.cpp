#include "plastica/run/scene_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/local_buckling.hpp"
#include "plastica/model/motion_warnings.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/model/yield_warnings.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/fibre_warning.hpp"
#include "plastica/run/joint_warnings.hpp"
#include "plastica/run/sample_warning.hpp"
#include "plastica/run/section_warnings.hpp"
#include "plastica/run/shear_warning.hpp"
#include "plastica/run/warning_facts.hpp"

namespace plastica {
namespace {

using model_detail::figure;
using namespace run_detail;

/// Whether a history lets go of what it had reached.
bool lets_go(const History& history) {
  for (std::size_t i = 1; i < history.factor.size(); ++i) {
    const double before = history.factor[i - 1];
    if (before * history.factor[i] < before * before) return true;
  }
  return false;
}

bool scene_lets_go(const Scene& scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(),
                     [](const Load& load) { return lets_go(load.history); }) ||
         std::any_of(
             scene.supports.begin(), scene.supports.end(),
             [](const Support& support) { return support.moves() && lets_go(support.history); }) ||
         (scene.gravity != std::array<double, 3>{} && lets_go(scene.gravity_history));
}

std::optional<std::string> cap(const Facts& facts) {
  const Scene& scene = facts.scene;
  if (scene.yield_model == YieldModel::Elastic || !is_ideal(scene) || !scene_lets_go(scene)) {
    return std::nullopt;
  }
  const double factor = shape_factor(facts);
  // Fibres know bending and torsion, so that this holds at every level.
  const std::string fibres = "; rules.yield_model = \"fibre\" follows the section";
  if (scene.yield_cap == YieldCap::FullyPlastic) {
    return "the beam is loaded and let go: an ideal joint with the fully plastic cap is elastic up "
           "to " +
           figure(factor) + " times first yield, and below that keeps nothing" + fibres;
  }
  return "the beam is loaded and let go: an ideal joint with the cap at first yield turns freely "
         "from there on, where the section carries up to " +
         figure(factor) + " times as much" + fibres;
}

std::string ratio(double value) {
  return value < 100.0 ? figure(value) : std::to_string(std::lround(value));
}

/// What a tube's wall does before the section yields, or before its hinges have turned.
std::optional<std::string> thin_wall(const Facts& facts) {
  const Scene& scene = facts.scene;
  if (scene.yield_model == YieldModel::Elastic || facts.level.level == Level::Twist) {
    return std::nullopt;
  }
  const bool plastic =
      scene.yield_cap == YieldCap::FullyPlastic || scene.yield_model == YieldModel::Fibre;
  std::optional<std::string> warning;
  int worst = plastic ? 1 : 2;
  const auto look_at = [&](const Section& section, const Material& material,
                           const std::string& where) {
    const auto wall = model_detail::worst_wall(section, material, bends_about_x(facts.level),
                                               bends_about_y(facts.level));
    if (!wall || wall->section_class <= worst) return;
    worst = wall->section_class;
    constexpr std::array<std::string_view, 3> kEnds{
        "reaches its plastic moment, but buckles as a hinge turns",
        "buckles before its plastic moment, and as a hinge turns at first yield",
        "buckles before first yield"};
    warning = "the wall of the section" + where + " is thin, " + std::string(wall->ratio) + " = " +
              ratio(wall->slenderness) + " (beyond " + ratio(wall->limit) + ", class " +
              std::to_string(worst) + " of EN 1993-1-1, table 5.2): it " +
              std::string(kEnds[static_cast<std::size_t>(worst - 2)]) +
              ", and the model does not know of local buckling";
  };
  look_at(scene.section, scene.material, "");
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    look_at(scene.regions[i].section, scene.regions[i].material,
            " of " + model_detail::item_name("region", i));
    if (!scene.regions[i].to_section) continue;
    look_at(*scene.regions[i].to_section, scene.regions[i].material,
            " at the end of " + model_detail::item_name("region", i));
  }
  return warning;
}

std::optional<std::string> per_axis(const Facts& facts) {
  return model_detail::per_axis_warning(facts.scene, facts.level);
}

std::optional<std::string> warping(const Facts& facts) {
  return model_detail::warping_warning(facts.scene, facts.level);
}

std::optional<std::string> softening(const Facts& facts) {
  return model_detail::softening_warning(facts.scene);
}

/// Supports, loads and masses inside of segments whose lengths the scene sets.
std::optional<std::string> inner_places(const Facts& facts) {
  for (const NodePlace& place : node_places(facts.scene)) {
    const std::string_view list = place.list;
    const bool acts = list == "support" || list == "load" || list == "mass";
    if (!acts || segment_end_at({place.fraction, {}}, facts.layout.ends)) continue;
    return model_detail::item_name(place.list, place.index, place.key) + " = " +
           figure(place.fraction) +
           " lies inside of a segment, which is rigid; without segment_lengths and joint_lengths a "
           "segment ends there";
  }
  return std::nullopt;
}

std::optional<std::string> cut_corners(const Facts& facts) {
  const Beam& beam = facts.scene.beam;
  if (beam.shape != BeamShape::Polyline) return std::nullopt;
  double deepest = 0.0;
  for (std::size_t i = 2; i < beam.points.size(); ++i) {
    const double along = polyline_length(std::span(beam.points).first(i)) / beam.length;
    if (segment_end_at({along, {}}, facts.layout.ends)) continue;
    const auto after = std::upper_bound(facts.layout.ends.begin(), facts.layout.ends.end(), along);
    const auto from = axis_point(beam, *(after - 1));
    const auto to = axis_point(beam, *after);
    const auto corner = beam.points[i - 1];
    // Distance of the corner from the straight segment that spans it.
    const double chord = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const double fraction =
        ((corner[0] - from[0]) * (to[0] - from[0]) + (corner[1] - from[1]) * (to[1] - from[1]) +
         (corner[2] - from[2]) * (to[2] - from[2])) /
        (chord * chord);
    deepest = std::max(deepest, std::hypot(corner[0] - from[0] - fraction * (to[0] - from[0]),
                                           corner[1] - from[1] - fraction * (to[1] - from[1]),
                                           corner[2] - from[2] - fraction * (to[2] - from[2])));
  }
  if (deepest == 0.0) return std::nullopt;
  return "a corner of beam.points lies inside of a segment, which is straight and misses it by " +
         figure(deepest) +
         " m; without segment_lengths and joint_lengths segments end at the corners";
}

/// Turning points of histories that no sample keeps; at rest the path goes over them all the same.
std::optional<std::string> missed_corners(const Facts& facts) {
  if (facts.options.analysis == Analysis::Dynamics) return std::nullopt;
  const ChainModel& chain = *facts.model.chain;
  std::size_t missed = 0;
  double first = 0.0;
  for (std::size_t i = 0; i < chain.stops.size(); ++i) {
    const double time = chain.stops[i];
    const bool cut =
        std::ranges::any_of(facts.scene.cuts, [&](const Cut& each) { return each.time == time; });
    if (chain.recorded[i] || cut) continue;
    if (missed++ == 0) first = time;
  }
  if (missed == 0) return std::nullopt;
  return "histories turn between two samples, " +
         (missed == 1 ? "at " : std::to_string(missed) + " times, first at ") + figure(first) +
         " s: the path goes over these points, but curves, least and most of probes leave them "
         "out; solver.steps says how many samples there are";
}

/// Histories that grow in proportion to time while another, longer one decides when the path ends.
std::optional<std::string> grown_ramps(const Facts& facts) {
  if (facts.options.analysis == Analysis::Dynamics || facts.options.duration > 0.0) return {};
  const double end = facts.model.chain->stops.back();
  if (!(end > 1.0 + 1e-9)) return {};
  const auto say = [&](const std::string& what) {
    return what + " follows a ramp, and the path ends at " + figure(end) +
           " s, with the longest history: there it is " + figure(end) +
           " times what the scene says; history = \"constant\" or rows of a history keep it";
  };
  if (facts.scene.gravity != std::array<double, 3>{} && facts.scene.gravity_history.continues) {
    return say("gravity");
  }
  for (std::size_t i = 0; i < facts.scene.loads.size(); ++i) {
    if (facts.scene.loads[i].history.continues) return say(model_detail::item_name("load", i));
  }
  return {};
}

std::optional<std::string> covered_region(const Facts& facts) {
  const auto& regions = facts.scene.regions;
  const std::vector<double>& ends = facts.layout.ends;
  for (std::size_t later = 1; later < regions.size(); ++later) {
    for (std::size_t i = 0; i < later; ++i) {
      const double from =
          std::max(fraction_of(regions[i].from, ends), fraction_of(regions[later].from, ends));
      const double to =
          std::min(fraction_of(regions[i].to, ends), fraction_of(regions[later].to, ends));
      if (!(to > from + 1e-9)) continue;
      return model_detail::item_name("region", later) + " lies over " +
             model_detail::item_name("region", i) + " from " + figure(from) + " to " + figure(to) +
             " of the length: there it holds alone, with the beam's own section or material where "
             "it says none";
    }
  }
  return {};
}

/// Loads whose work depends on the path: the tangent at an equilibrium is not symmetric.
std::optional<std::string> no_potential(const Facts& facts) {
  if (facts.options.analysis == Analysis::Dynamics) return {};
  if (facts.level.level != Level::Planar && facts.level.level != Level::Spatial) return {};
  const auto load = model_detail::load_without_potential(facts.scene, facts.level);
  if (load) {
    return model_detail::item_name("load", *load) +
           (facts.scene.loads[*load].follows ? ".follows" : ".moment, of a fixed axis in space,") +
           " has no potential: where equilibria become unstable is only reported if an odd number "
           "of modes does so at once; pairs of modes, and flutter, are not detected";
  }
  if (facts.options.buckling > 0 && facts.level.level == Level::Planar) {
    const LevelChoice in_space{.level = Level::Spatial, .reason = {}};
    const auto unconservative = model_detail::load_without_potential(facts.scene, in_space);
    if (unconservative) {
      return model_detail::item_name("load", *unconservative) +
             ".moment has no potential in space: solver.buckling covers the beam's plane alone";
    }
  }
  return {};
}

}  // namespace

std::optional<std::string> first_yield_warning(const Model& model) {
  if (!model.chain) return std::nullopt;
  const Facts facts(model);
  if (facts.scene.yield_model == YieldModel::Elastic || !is_ideal(facts.scene) ||
      facts.scene.yield_cap != YieldCap::FirstYield || scene_lets_go(facts.scene)) {
    return std::nullopt;
  }
  return "joints have yielded, and their caps are those of first yield: the section carries up "
         "to " +
         figure(shape_factor(facts)) +
         " times as much, and so does a limit load; rules.yield_cap = \"fully_plastic\" has that, "
         "\"fibre\" for rules.yield_model follows it from first yield on";
}

std::vector<std::string> scene_warnings(const Model& model) {
  if (!model.chain) return {};
  const Facts facts(model);
  std::vector<std::string> warnings;
  for (const auto find : {shear_warning,
                          thick_wall_warning,
                          hinge_warning,
                          cap,
                          thin_wall,
                          per_axis,
                          warping,
                          softening,
                          inner_places,
                          cut_corners,
                          inner_clamp_warning,
                          rigid_stretch_warning,
                          missed_corners,
                          grown_ramps,
                          steep_hardening_warning,
                          whole_section_rate_warning,
                          break_measure_warning,
                          covered_region,
                          no_potential,
                          fibre_warning}) {
    if (auto warning = find(facts)) warnings.push_back(std::move(*warning));
  }
  if (facts.options.analysis == Analysis::Dynamics) {
    if (auto warning = sample_warning(facts)) warnings.push_back(std::move(*warning));
    for (std::string& warning : model_detail::motion_warnings(
             facts.scene, facts.options, facts.level, facts.section, facts.layout.ends)) {
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

}  // namespace plastica
