#include "plastica/model/scene.hpp"

#include <cmath>
#include <set>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/model/check_value.hpp"

namespace plastica {

using model_detail::require_positive;

void check_scene(const Scene& scene, const SolverOptions& /*options*/) {
  check_material(scene.material);
  check_section(scene.section);
  require_positive(scene.beam.length, {}, "beam.length");
  if (scene.beam.segments < 1) {
    throw InputError({}, "beam.segments", std::to_string(scene.beam.segments),
                     "must be at least 1");
  }
  if (scene.formulas == Formulas::Report &&
      (scene.section.shape == SectionShape::RoundTube ||
       scene.section.shape == SectionShape::RectangularTube)) {
    throw InputError({}, "rules.formulas", "report", "the report has no formulas for tubes");
  }
  if (scene.formulas == Formulas::Report && scene.yield_cap == YieldCap::FullyPlastic) {
    throw InputError({}, "rules.yield_cap", "fully_plastic",
                     "the report's caps are at first yield");
  }
  if (scene.drive.strain.empty()) {
    throw InputError({}, "drive.strain", "[]", "needs at least one sample");
  }
  for (const double strain : scene.drive.strain) {
    if (!std::isfinite(strain)) {
      throw InputError({}, "drive.strain", std::to_string(strain), "must be finite");
    }
  }
  std::set<std::string> names;
  for (const Probe& probe : scene.probes) {
    if (probe.name.empty()) throw InputError({}, "probe.name", "", "must not be empty");
    if (!names.insert(probe.name).second) {
      throw InputError({}, "probe.name", probe.name, "is used by another probe of the scene");
    }
    if (scene.is_coupon() && probe.quantity > ProbeQuantity::Dissipation) {
      throw InputError({}, "probe", probe.name, "records what a coupon does not have");
    }
  }
}

}  // namespace plastica
