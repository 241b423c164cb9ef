#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "plastica/model/field.hpp"

/// Scenes of a bar of known material that studies fit back, 400 mm long and 20 mm square.
namespace plastica::testing {

enum class Test { Bend, Twist, Cantilever };

/// A test of the bar, at rest or in motion, and the path that is measured.
struct Trip {
  std::string name;
  Setup setup;
  /// Without ordinates; its abscissa ends where the path does.
  calibrate::SceneTarget target;
  std::string break_path;  ///< the limit that it breaks by

  double last() const { return target.abscissa.back(); }
};

namespace trips {

inline constexpr double kLength = 0.4, kDepth = 0.02, kYield = 380e6;
inline constexpr int kSamples = 60;

inline Support held(double place, SupportKind kind) { return {.at = {place, {}}, .kind = kind}; }

inline Support pushed(double place) {
  Support head = held(place, SupportKind::Roller);
  head.hold = HeldFreedoms{false, true, false, false, false, false};
  head.translation = {0.0, -1.0, 0.0};
  return head;
}

inline Support turned_end() {
  Support head = held(1.0, SupportKind::Guide);
  head.hold = HeldFreedoms{false, false, false, false, false, true};
  head.rotation = {0.0, 0.0, 1.0};
  return head;
}

inline Probe probe(ProbeQuantity quantity, double place, Component component) {
  return {.name = "measured", .quantity = quantity, .at = {place, {}}, .component = component};
}

inline Setup bar(int segments) {
  Setup setup;
  Scene& scene = setup.scene;
  scene.material.youngs_modulus = 205e9;
  scene.material.yield_stress = kYield;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 10e9;
  scene.section = {.shape = SectionShape::Rectangle, .width = kDepth, .height = kDepth};
  scene.beam.length = kLength;
  scene.beam.segments = segments;
  scene.yield_model = YieldModel::PerAxis;
  scene.probes.clear();
  return setup;
}

/// Moved by the machine's head.
inline void at_rest(Test test, Trip& trip) {
  Scene& scene = trip.setup.scene;
  double last = 0.0;
  if (test == Test::Bend) {
    scene.supports = {held(0.0, SupportKind::Pin), held(1.0, SupportKind::Roller), pushed(0.5)};
    scene.probes = {probe(ProbeQuantity::Reaction, 0.5, Component::Y)};
    last = 0.02;
  } else if (test == Test::Cantilever) {
    scene.supports = {held(0.0, SupportKind::Clamp), pushed(1.0)};
    scene.probes = {probe(ProbeQuantity::Reaction, 1.0, Component::Y)};
    scene.yield_model = YieldModel::Fibre;
    last = 0.06;
  } else {
    scene.supports = {held(0.0, SupportKind::Clamp), turned_end()};
    scene.probes = {probe(ProbeQuantity::ReactionMoment, 1.0, Component::Z)};
    last = 0.5;
  }
  trip.target.kind = calibrate::Abscissa::Support;
  trip.target.driven = scene.supports.size() - 1;
  trip.target.ordinate_factor = test == Test::Twist ? 1.0 : -1.0;
  for (int i = 1; i <= kSamples; ++i) trip.target.abscissa.push_back(last * i / kSamples);
}

/// Loaded faster and faster beyond yield within a few of its periods.
inline void in_motion(Test test, Trip& trip) {
  Setup& setup = trip.setup;
  Scene& scene = setup.scene;
  const double yield_moment = kYield * kDepth * kDepth * kDepth / 6.0;
  Load load;
  double duration = 0.0;
  if (test == Test::Bend) {
    scene.supports = {held(0.0, SupportKind::Pin), held(1.0, SupportKind::Roller)};
    load.at = {0.5, {}};
    load.force = {0.0, -1.6 * 4.0 * yield_moment / kLength, 0.0};
    scene.probes = {probe(ProbeQuantity::Displacement, 0.5, Component::Y)};
    duration = 0.02;
  } else if (test == Test::Cantilever) {
    scene.supports = {held(0.0, SupportKind::Clamp)};
    load.force = {0.0, -1.6 * yield_moment / kLength, 0.0};
    scene.probes = {probe(ProbeQuantity::Displacement, 1.0, Component::Y)};
    duration = 0.05;
  } else {
    scene.supports = {held(0.0, SupportKind::Clamp)};
    // First yield of a square: 0.208 h^3 tau.
    load.moment = {0.0, 0.0, 1.6 * 0.208 * std::pow(kDepth, 3) * kYield / std::sqrt(3.0)};
    scene.probes = {probe(ProbeQuantity::Rotation, 1.0, Component::Z)};
    duration = 0.005;
  }
  load.history = {{0.0, duration}, {0.0, 1.0}};
  scene.loads = {load};
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.duration = duration;
  setup.solver.steps = 4 * kSamples;
  setup.solver.time_step = duration / setup.solver.steps;
  trip.target.kind = calibrate::Abscissa::Time;
  trip.target.ordinate_factor = test == Test::Twist ? 1.0 : -1.0;
  for (int i = 1; i <= kSamples; ++i) trip.target.abscissa.push_back(duration * i / kSamples);
}

}  // namespace trips

inline Trip make_trip(Test test, Analysis analysis, int segments) {
  constexpr const char* kNames[] = {"bend", "twist", "cantilever"};
  const bool moves = analysis == Analysis::Dynamics;
  Trip trip;
  trip.name = kNames[static_cast<int>(test)];
  trip.name += moves ? " in motion" : " at rest";
  trip.setup = trips::bar(segments);
  trip.target.name = trip.name;
  trip.target.ordinate_probe = "measured";
  trip.break_path = test == Test::Twist ? "material.break_shear_strain" : "material.break_strain";
  if (moves) {
    trips::in_motion(test, trip);
  } else {
    trips::at_rest(test, trip);
  }
  return trip;
}

}  // namespace plastica::testing
