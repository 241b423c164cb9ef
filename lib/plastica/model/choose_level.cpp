#include "plastica/model/choose_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/scene_actions.hpp"

namespace plastica {
namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

/// A vector that acts on the beam or shapes it.
struct Action : model_detail::SceneAction {
  bool shapes = false;
};

/// What a level below the spatial one holds.
struct Plane {
  std::string_view level;
  std::string_view where;  ///< of the pushes that it holds
  std::array<bool, 3> push{};
  std::array<bool, 3> rotate{};
  std::array<bool, 3> shape{};
};

constexpr Plane kTwist{"twist", "", {}, {false, false, true}, {false, false, true}};
constexpr Plane kAboutX{
    "planar", "y-z plane", {false, true, true}, {true, false, false}, {false, true, true}};
constexpr Plane kAboutY{
    "planar", "x-z plane", {true, false, true}, {false, true, false}, {true, false, true}};

std::vector<Action> all_actions(const Scene& scene) {
  std::vector<Action> actions;
  for (auto& action : model_detail::actions_of(scene)) actions.push_back({std::move(action)});
  const auto add_shape = [&](const std::string& field, const std::array<double, 3>& vector) {
    actions.push_back({{field, VectorSense::None, vector}, true});
  };
  if (scene.beam.shape == BeamShape::Arc) add_shape("beam.arc_towards", scene.beam.arc_towards);
  if (scene.beam.shape == BeamShape::Polyline) {
    for (std::size_t i = 0; i < scene.beam.points.size(); ++i) {
      add_shape(model_detail::item_name("beam.points", i), scene.beam.points[i]);
    }
  }
  return actions;
}

/// The first action that a level does not hold.
struct Misfit {
  std::size_t action = 0;
  std::string reason;
};

std::optional<Misfit> misfit_of(const std::vector<Action>& actions, const Plane& plane) {
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const Action& action = actions[i];
    const bool rotates = action.sense == VectorSense::Rotate;
    const auto& held = rotates ? plane.rotate : action.shapes ? plane.shape : plane.push;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (action.vector[axis] == 0.0 || held[axis]) continue;
      std::string reason = action.field + " has a component " + (rotates ? "about " : "along ") +
                           std::string(kAxes[axis]);
      if (plane.where.empty()) {
        reason += ", and twist is about the beam's axis z alone";
      } else if (rotates && axis == 2) {
        reason += ", which twists the beam";
      } else {
        reason += ", out of the " + std::string(plane.where);
      }
      return Misfit{i, reason};
    }
  }
  return std::nullopt;
}

/// Whether the section bends about y more easily than about x.
bool weaker_about_y(const Section& section) {
  // Rounding of a square or a circle is no difference.
  constexpr double kAlike = 1.0 - 1e-12;
  const SectionProperties p = section_properties(section, 0.0);
  return p.second_moment_y < kAlike * p.second_moment_x;
}

/// The least level that holds the actions, and what the next smaller one does not hold.
LevelChoice lowest_level(const Scene& scene, const std::vector<Action>& actions) {
  if (!misfit_of(actions, kTwist)) {
    return {Level::Twist, {}, "twist: every load and motion is about the beam's axis"};
  }
  const auto about_x = misfit_of(actions, kAboutX);
  const auto about_y = misfit_of(actions, kAboutY);
  if (about_x && about_y) {
    // The plane that most of the scene was meant for is the one that fits longest.
    const Misfit& first = about_x->action >= about_y->action ? *about_x : *about_y;
    return {Level::Spatial, {}, "spatial: " + first.reason};
  }
  const std::string every = "planar: every load, support and joint axis lies in the ";
  if (about_x || about_y) {
    return about_x ? LevelChoice{Level::Planar, BendingAxis::Y, every + "x-z plane"}
                   : LevelChoice{Level::Planar, BendingAxis::X, every + "y-z plane"};
  }
  return weaker_about_y(scene.section)
             ? LevelChoice{Level::Planar, BendingAxis::Y,
                           "planar: all acts along the beam, which is weakest in the x-z plane"}
             : LevelChoice{Level::Planar, BendingAxis::X,
                           "planar: all acts along the beam, which is weakest in the y-z plane"};
}

InputError too_small(std::string_view level, const std::string& reason) {
  return {{}, "solver.level", level, reason};
}

LevelChoice coupon_level(const SolverOptions& options) {
  if (options.level == Level::Auto) {
    return {Level::Coupon, {}, "coupon: a strain history drives all joints alike"};
  }
  if (options.level == Level::Coupon) return {Level::Coupon, {}, "coupon: as the scene asks"};
  throw InputError({}, "solver.level", "", "must be auto or coupon in a scene with a drive");
}

}  // namespace

LevelChoice choose_level(const Scene& scene, const SolverOptions& options) {
  if (scene.is_coupon()) return coupon_level(options);
  const std::vector<Action> actions = all_actions(scene);
  LevelChoice least = lowest_level(scene, actions);
  if (options.level == Level::Auto) return least;
  const auto asked = [&](Level level, std::string_view word) {
    const std::string smaller = least.reason.substr(0, least.reason.find(':'));
    return LevelChoice{level, least.bending,
                       std::string(word) + ": as the scene asks" +
                           (least.level == level ? "" : "; " + smaller + " would hold it")};
  };
  switch (options.level) {
    case Level::Auto:
    case Level::Spatial: break;
    case Level::Coupon:
      throw too_small("coupon", scene.supports.empty() ? "a scene without a drive is no coupon"
                                                       : "a scene with supports is no coupon");
    case Level::Twist:
      if (const auto misfit = misfit_of(actions, kTwist)) throw too_small("twist", misfit->reason);
      return asked(Level::Twist, "twist");
    case Level::Planar: {
      if (least.level == Level::Planar) return asked(Level::Planar, "planar");
      const auto about_x = misfit_of(actions, kAboutX);
      const auto about_y = misfit_of(actions, kAboutY);
      if (!about_x || !about_y) {
        return {Level::Planar, about_x ? BendingAxis::Y : BendingAxis::X,
                "planar: as the scene asks"};
      }
      throw too_small("planar", (about_x->action >= about_y->action ? *about_x : *about_y).reason);
    }
  }
  return asked(Level::Spatial, "spatial");
}

}  // namespace plastica
