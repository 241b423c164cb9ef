#include <algorithm>

#include "plastica/base/check.hpp"
#include "plastica/model/check_parts.hpp"

namespace plastica::model_detail {

std::optional<std::size_t> load_without_potential(const Scene& scene, const LevelChoice& level) {
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const auto& moment = scene.loads[i].moment;
    const bool has_moment =
        level.level == Level::Spatial &&
        std::any_of(moment.begin(), moment.end(), [](double m) { return m != 0.0; });
    if (scene.loads[i].follows || has_moment) return i;
  }
  return std::nullopt;
}

void check_modes(const Scene& scene, const SolverOptions& options, const LevelChoice& level) {
  const auto check = [&](std::string_view field, int count) {
    if (count == 0) return;
    const auto refuse = [&](std::string_view rule) {
      throw InputError({}, field, std::to_string(count), rule);
    };
    if (scene.is_coupon()) refuse("is of a beam: a coupon has no modes");
    if (options.analysis == Analysis::Dynamics) {
      refuse("needs solver.analysis = \"statics\": modes are about an equilibrium");
    }
    if (options.precision == Precision::Float) refuse("needs solver.precision = \"double\"");
    const auto load = load_without_potential(scene, level);
    if (!load) return;
    refuse("is for loads that have a potential: " + item_name("load", *load) +
           (scene.loads[*load].follows ? " follows its segment"
                                       : " has a moment of a fixed axis in space"));
  };
  check("solver.buckling", options.buckling);
  check("solver.frequencies", options.frequencies);
  if (options.buckling > 0 && level.level == Level::Twist) {
    throw InputError({}, "solver.buckling", std::to_string(options.buckling),
                     "needs a level that bends: a beam that is only twisted does not buckle");
  }
}

}  // namespace plastica::model_detail
