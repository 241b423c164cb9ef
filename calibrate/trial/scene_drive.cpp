#include "calibrate/trial/scene_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "calibrate/trial/scene_model.hpp"

namespace plastica::calibrate {
namespace {

using Vector = std::array<double, 3>;

double size_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

bool is_constant(const History& history) {
  const auto& f = history.factor;
  return std::adjacent_find(f.begin(), f.end(), std::not_equal_to<>()) == f.end();
}

/// One history of a scene and what it scales.
struct Driven {
  std::string name;  ///< of the second support "support[2]", as files name it
  Vector straight{};
  Vector rotation{};
  Dimension straight_is = Dimension::None;
  Dimension rotation_is = Dimension::None;
  History* history = nullptr;

  double size() const { return size_of(straight) + size_of(rotation); }
  bool rotates() const { return size_of(rotation) > 0.0; }
};

std::vector<Driven> histories_of(Scene& scene) {
  std::vector<Driven> all;
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    Support& s = scene.supports[i];
    all.push_back({fmt::format("support[{}]", i + 1), s.translation, s.rotation, Dimension::Length,
                   Dimension::Angle, &s.history});
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    Load& load = scene.loads[i];
    all.push_back({fmt::format("load[{}]", i + 1), load.force, load.moment, Dimension::Force,
                   Dimension::Moment, &load.history});
  }
  return all;
}

std::size_t index_of(const Scene& scene, const SceneTarget& target, const SourceLocation& where) {
  const bool support = target.kind == Abscissa::Support;
  const std::size_t count = support ? scene.supports.size() : scene.loads.size();
  if (target.driven >= count) {
    throw InputError(
        where, "abscissa.drive",
        fmt::format("{}[{}]", support ? "support" : "load", target.driven + 1),
        count == 0 ? "the scene has none" : fmt::format("the scene has {} of them", count));
  }
  return target.driven + (support ? 0 : scene.supports.size());
}

Driven driven_of(Scene& scene, const SceneTarget& target, const SourceLocation& where) {
  Driven driven = histories_of(scene)[index_of(scene, target, where)];
  if ((size_of(driven.straight) > 0.0) == driven.rotates()) {
    throw InputError(where, "abscissa.drive", driven.name,
                     target.kind == Abscissa::Support
                         ? "must be moved by a translation or by a rotation, to follow a number"
                         : "must be a force or a moment, to follow a number");
  }
  return driven;
}

void check_others(Scene& scene, const History* follows) {
  constexpr std::string_view kRule =
      "must be constant: the scene is driven by what was measured, and the rest is there from "
      "the first";
  for (const Driven& other : histories_of(scene)) {
    if (other.history == follows || other.size() == 0.0) continue;
    if (!is_constant(*other.history)) throw InputError({}, other.name + ".history", "", kRule);
  }
  if (size_of(scene.gravity) > 0.0 && !is_constant(scene.gravity_history)) {
    throw InputError({}, "gravity.history", "", kRule);
  }
}

}  // namespace

Dimension abscissa_dimension(const Scene& scene, const SceneTarget& target,
                             const SourceLocation& where) {
  switch (target.kind) {
    case Abscissa::Probe:
      // The scene is a chain: its probes do not depend on a coupon's deformation.
      return dimension_of(
          scene.probes[probe_index(scene, target.abscissa_probe, "abscissa.probe", where)].quantity,
          Deformation::Tension);
    case Abscissa::Time: return Dimension::Time;
    case Abscissa::Strain: return Dimension::Strain;
    case Abscissa::Support:
    case Abscissa::Load: break;
  }
  Scene copy = scene;
  const Driven driven = driven_of(copy, target, where);
  return driven.rotates() ? driven.rotation_is : driven.straight_is;
}

Dimension ordinate_dimension(const Scene& scene, const SceneTarget& target) {
  const std::size_t index =
      probe_index(scene, target.ordinate_probe, "ordinate.probe", target.ordinate_where);
  return dimension_of(scene.probes[index].quantity, scene.drive.deformation);
}

Setup driven_setup(const Setup& setup, const SceneTarget& target) {
  Setup followed = setup;
  Scene& scene = followed.scene;
  std::vector<double> values = target.abscissa;
  if (target.broke) values.push_back(target.broke->broken_from(values.back()));
  if (target.kind == Abscissa::Strain) {
    for (double& strain : values) strain /= target.abscissa_factor;
    scene.drive.strain = std::move(values);
    return followed;
  }
  if (setup.solver.analysis == Analysis::Dynamics) {
    throw InputError(target.abscissa_where, "abscissa.drive", "",
                     "is followed at rest: the curve of a motion is compared over its time");
  }
  const Driven driven = driven_of(scene, target, target.abscissa_where);
  check_others(scene, driven.history);
  History history{{0.0}, {0.0}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    history.time.push_back(static_cast<double>(i + 1));
    history.factor.push_back(values[i] / (target.abscissa_factor * driven.size()));
  }
  *driven.history = history;
  followed.solver.duration = history.end();
  followed.solver.steps = static_cast<int>(values.size());
  return followed;
}

std::optional<Setup> extended_setup(const Setup& setup, int times) {
  const Scene& scene = setup.scene;
  const SolverOptions& solver = setup.solver;
  const bool by_load = solver.control == PathControl::Auto || solver.control == PathControl::Load;
  if (solver.analysis == Analysis::Dynamics || scene.is_coupon() || !by_load) return std::nullopt;
  const bool heavy = scene.gravity != std::array<double, 3>{};
  if (heavy && scene.gravity_history.continues) return std::nullopt;
  bool any = false;
  double end = heavy ? scene.gravity_history.end() : 0.0;
  const auto take = [&](const History& history) {
    any = any || history.continues;
    end = std::max(end, history.end());
  };
  for (const Support& support : scene.supports) {
    if (support.moves()) take(support.history);
  }
  for (const Load& load : scene.loads) take(load.history);
  if (!any) return std::nullopt;
  Setup longer = setup;
  longer.solver.duration = times * (solver.duration > 0.0 ? solver.duration : end);
  longer.solver.steps = times * solver.steps;
  return longer;
}

}  // namespace plastica::calibrate
