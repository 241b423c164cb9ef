#include "plastica/run/taken_fibres.hpp"

#include <algorithm>

#include "plastica/base/check.hpp"
#include "plastica/law/fibre_layout.hpp"
#include "plastica/model/choose_level.hpp"

namespace plastica {
namespace {

law::FibrePlane plane_of(const LevelChoice& level) {
  if (level.level == Level::Spatial) return law::FibrePlane::Both;
  if (level.level == Level::Twist) return law::FibrePlane::Torsion;
  return level.bending == BendingAxis::X ? law::FibrePlane::AboutX : law::FibrePlane::AboutY;
}

}  // namespace

int taken_fibres(const Scene& scene, const SolverOptions& options) {
  if (scene.is_coupon() || scene.yield_model != YieldModel::Fibre) return options.fibres;
  law::FibrePlane plane = law::FibrePlane::Both;
  try {
    plane = plane_of(choose_level(scene, options));
  } catch (const InputError&) {
    return options.fibres;
  }
  int taken = law::taken_fibres(scene.section, plane, options.fibres);
  for (const Region& region : scene.regions) {
    taken = std::min(taken, law::taken_fibres(region.section, plane, options.fibres));
  }
  return taken;
}

}  // namespace plastica
