#include "plastica/run/likely_mistakes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/run/warning_facts.hpp"

namespace plastica {
namespace {

using model_detail::figure;
using run_detail::Facts;

constexpr std::array<double, 3> kNone{};

/// Where the material of a region is given: at the top of the scene, or there.
std::string key_of(const chain::BeamRegion& region) {
  if (region.scene_region == 0) return "material";
  return "region[" + std::to_string(region.scene_region) + "].material";
}

/// Metals yield at strains of 1e-4 (annealed aluminium) to 0.02 (spring steel, titanium), wood and
/// polymers up to 0.1, thermoplastic elastomers up to 0.5.
/// Source: M. F. Ashby, Materials Selection in Mechanical Design (4th ed., 2011), chart of yield
/// strength over modulus.
std::optional<std::string> odd_yield_strain(const Material& material, const std::string& key) {
  constexpr double kLeast = 2e-5;
  constexpr double kMost = 1.0;
  const double strain = material.yield_stress / material.youngs_modulus;
  if (strain >= kLeast && strain <= kMost) return std::nullopt;
  return key + " yields at a strain of " + figure(strain) +
         ": no solid does; are the units of youngs_modulus = " + figure(material.youngs_modulus) +
         " Pa and yield_stress = " + figure(material.yield_stress) + " Pa right?";
}

std::optional<std::string> odd_yield_strain(const Facts& facts) {
  if (facts.scene.yield_model == YieldModel::Elastic) return std::nullopt;
  for (const chain::BeamRegion& region : facts.layout.regions) {
    if (auto odd = odd_yield_strain(region.material, key_of(region))) return odd;
  }
  return std::nullopt;
}

/// Waves of stretch run at sqrt(E/rho): 1 m/s in gels, 8 m/s in soft silicone, 18 km/s in diamond,
/// 27 km/s in carbon nanotubes. A density below that of any solid is one that is not to matter.
std::optional<std::string> odd_wave_speed(const Facts& facts) {
  constexpr double kLeast = 0.5;
  constexpr double kMost = 4e4;
  constexpr double kMassless = 0.1;  // [kg/m^3]
  const bool has_mass = facts.options.analysis == Analysis::Dynamics ||
                        facts.scene.gravity != kNone || facts.options.frequencies > 0;
  if (!has_mass) return std::nullopt;
  for (const chain::BeamRegion& region : facts.layout.regions) {
    const Material& material = region.material;
    const double speed = std::sqrt(material.youngs_modulus / material.density);
    if (material.density < kMassless || (speed >= kLeast && speed <= kMost)) continue;
    return "waves run through " + key_of(region) + " at " + figure(speed) +
           " m/s, which no solid has; are the units of youngs_modulus = " +
           figure(material.youngs_modulus) + " Pa and density = " + figure(material.density) +
           " kg/m^3 right?";
  }
  return std::nullopt;
}

double modulus_of(const Facts& facts, std::size_t segment) {
  const std::size_t region = facts.layout.segment_regions[segment].middle;
  return facts.layout.regions[region].material.youngs_modulus;
}

/// Hooke's law holds for some per cent. A joint between two materials counts as of the stiffer one.
std::optional<std::string> large_elastic_strain(const Facts& facts, const Response& response) {
  constexpr double kMost = 0.05;
  if (facts.scene.yield_model != YieldModel::Elastic || response.chain.stress.empty()) {
    return std::nullopt;
  }
  const std::vector<double>& stress = response.chain.stress;
  const std::size_t segments = facts.layout.size();
  double strain = 0.0;
  double modulus = 0.0;  // where that is
  for (std::size_t k = 0; k < stress.size(); ++k) {
    const std::size_t joint = k % (segments + 1);
    const double own = std::max(modulus_of(facts, joint == 0 ? 0 : joint - 1),
                                modulus_of(facts, std::min(joint, segments - 1)));
    if (!(stress[k] > strain * own)) continue;
    strain = stress[k] / own;
    modulus = own;
  }
  if (!(strain > kMost)) return std::nullopt;
  return "the outermost fibres are strained by " + figure(100.0 * strain) +
         " %, and elastic joints follow Hooke's law, which holds for some per cent: are the units "
         "of loads, section and youngs_modulus = " +
         figure(modulus) + " Pa right?";
}

std::optional<std::string> idle_break_strain(const Facts& facts) {
  if (facts.scene.yield_model != YieldModel::Elastic) return std::nullopt;
  for (const chain::BeamRegion& region : facts.layout.regions) {
    if (!region.material.break_strain && !region.material.break_shear_strain) continue;
    return key_of(region) +
           (region.material.break_strain ? ".break_strain" : ".break_shear_strain") +
           " is a permanent strain, which joints of rules.yield_model = \"elastic\" never have: "
           "nothing breaks";
  }
  return std::nullopt;
}

/// Whether a support takes a load whole, before the beam has any of it.
bool takes(const Support& support, const Load& load) {
  const HeldFreedoms held = support.held();
  const auto all = [&](std::size_t from) { return held[from] && held[from + 1] && held[from + 2]; };
  return (load.force == kNone || all(0)) && (load.moment == kNone || all(3));
}

std::optional<std::string> idle_load(const Facts& facts) {
  const std::vector<double>& ends = facts.layout.ends;
  for (std::size_t i = 0; i < facts.scene.loads.size(); ++i) {
    const Load& load = facts.scene.loads[i];
    if (load.to || (load.force == kNone && load.moment == kNone)) continue;
    for (std::size_t k = 0; k < facts.scene.supports.size(); ++k) {
      const Support& support = facts.scene.supports[k];
      const bool together = !support.to && std::fabs(fraction_of(load.at, ends) -
                                                     fraction_of(support.at, ends)) < 1e-9;
      if (!together || !takes(support, load)) continue;
      return model_detail::item_name("load", i) + " acts where " +
             model_detail::item_name("support", k) +
             " holds the beam, and goes into it whole: the beam has nothing of it";
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> likely_mistakes(const Scene& scene, const Model& model,
                                         const Response& response) {
  std::vector<std::string> all;
  const auto add = [&](std::optional<std::string> mistake) {
    if (mistake) all.push_back(std::move(*mistake));
  };
  if (!model.chain) {
    add(odd_yield_strain(scene.material, "material"));
    return all;
  }
  const Facts facts(model);
  add(odd_yield_strain(facts));
  add(odd_wave_speed(facts));
  add(large_elastic_strain(facts, response));
  add(idle_break_strain(facts));
  add(idle_load(facts));
  return all;
}

}  // namespace plastica
