#include "plastica/run/chain_laws.hpp"

#include "plastica/law/gauge_form.hpp"

namespace plastica {

void check_regions(const Scene& scene) {
  const bool one_surface =
      scene.yield_model == YieldModel::Interaction || scene.yield_model == YieldModel::Conservative;
  const auto kind_of = [&](const Section& section) {
    return law::gauge_form(section, scene.yield_model, scene.yield_cap, scene.formulas).kind;
  };
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Region& region = scene.regions[i];
    const std::string name = "region[" + std::to_string(i + 1) + "]";
    if (region.material.hardening.law != scene.material.hardening.law) {
      throw InputError({}, name + ".material", region.material.name,
                       "must have the hardening law of the rest of the beam");
    }
    if (region.material.rate.law != scene.material.rate.law ||
        has_own_rates(region.material) != has_own_rates(scene.material)) {
      throw InputError({}, name + ".material", region.material.name,
                       "must have the rate law of the rest of the beam, and a strain_rate where "
                       "that has one");
    }
    if (one_surface && kind_of(region.section) != kind_of(scene.section)) {
      throw InputError({}, name + ".section", "",
                       "yields by another kind of surface than the rest of the beam: "
                       "take rules.yield_model = per_axis or fibre");
    }
  }
}

}  // namespace plastica
