#include "plastica/run/check_regions.hpp"

#include <string>

#include "plastica/base/check.hpp"
#include "plastica/law/gauge_form.hpp"
#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/rate_kind.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica {

void check_regions(const Scene& scene) {
  const auto kind_of = [&](const Section& section) {
    return law::gauge_form(section, scene.yield_model, scene.yield_cap, scene.formulas).kind;
  };
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Region& region = scene.regions[i];
    const std::string name = "region[" + std::to_string(i + 1) + "]";
    const auto same_word = [&](std::string_view law, std::string_view own, std::string_view beams) {
      if (own == beams) return;
      throw InputError({}, name + ".material." + std::string(law), own,
                       "must be that of the rest of the beam, " + std::string(beams));
    };
    same_word("hardening.law", hardening_kind(region.material.hardening.law).word(),
              hardening_kind(scene.material.hardening.law).word());
    same_word("rate.law", rate_kind(region.material.rate.law).word(),
              rate_kind(scene.material.rate.law).word());
    if (has_own_rates(region.material) != has_own_rates(scene.material)) {
      throw InputError({}, name + ".material.rate.strain_rate", "",
                       has_own_rates(scene.material)
                           ? "is said, but the rest of the beam has rates of its joints"
                           : "is missing: the rest of the beam has a rate that all has");
    }
    if (has_one_surface(scene.yield_model) && kind_of(region.section) != kind_of(scene.section)) {
      throw InputError({}, name + ".section.shape", section_kind(region.section).word(),
                       "yields by another kind of surface than the rest of the beam: "
                       "take rules.yield_model = per_axis or fibre");
    }
  }
}

}  // namespace plastica
