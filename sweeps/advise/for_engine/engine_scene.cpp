#include "sweeps/advise/for_engine/engine_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "plastica/base/check.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::sweeps {
namespace {

/// Plastic work below this part of the stored energy is rounding.
constexpr double kPlasticRounding = 1e-9;

[[noreturn]] void refuse_for_engine(const std::string& field, std::string_view rule) {
  throw InputError({}, field, "", rule);
}

/// A clamp that turns in a plane is the rest of its half joint's spring.
bool turns_in_plane(const Setup& setup, const Support& support) {
  const Level level = choose_level(setup.scene, setup.solver).level;
  const HeldFreedoms held = support.held();
  for (std::size_t k = 0; k < 3; ++k) {
    if (support.rotation[k] != 0.0 && !held[3 + k]) return false;
  }
  return support.translation == std::array<double, 3>{} && level != Level::Spatial &&
         resolved_end_rule(setup.scene) == EndRule::HalfJoint &&
         setup.solver.damping == Damping::None;
}

void check_engine_support(const AdvisedEngine& engine, const Setup& setup, const Support& support,
                          const std::string& name) {
  const SupportTraits& kind = traits_of(support);
  if (support.at.fraction > 1e-9) {
    refuse_for_engine(name,
                      fmt::format("is off the beam's start: advice for {} is for beams that are "
                                  "held at their start alone",
                                  engine.word));
  }
  if (kind.springs || kind.normal) {
    refuse_for_engine(name, fmt::format("is of kind {}, which no export has", kind.word));
  }
  if (support.moves() && !turns_in_plane(setup, support)) {
    refuse_for_engine(name,
                      "moves: with --for only a clamp may that turns in the plane of the motion, "
                      "by end_rule = \"half_joint\" and without damping");
  }
}

bool is_of_engine(ProbeQuantity quantity) {
  switch (quantity) {
    case ProbeQuantity::Displacement:
    case ProbeQuantity::Rotation:
    case ProbeQuantity::Velocity:
    case ProbeQuantity::Spin: return true;
    default: return false;
  }
}

}  // namespace

void check_for_engine(const AdvisedEngine& engine, const Setup& setup) {
  const Scene& scene = setup.scene;
  if (setup.solver.analysis != Analysis::Dynamics) {
    refuse_for_engine("solver.analysis",
                      "must be \"dynamics\" with --for: it advises the step of "
                      "a motion");
  }
  if (scene.supports.empty()) {
    refuse_for_engine("support",
                      fmt::format("is missing: advice for {} is for beams that are held at their "
                                  "start",
                                  engine.word));
  }
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    check_engine_support(engine, setup, scene.supports[i], fmt::format("support[{}]", i + 1));
  }
  if (!scene.initial_motions.empty()) {
    refuse_for_engine("initial_motion", "does not go with --for: an export has no velocities");
  }
  if (!scene.cuts.empty()) {
    refuse_for_engine(
        "cut", fmt::format("does not go with --for: {} has no joint that breaks", engine.word));
  }
}

void check_elastic(const AdvisedEngine& engine, const Setup& setup, const Response& response) {
  if (!response.chain.events.empty()) {
    refuse_for_engine("material.break_strain",
                      fmt::format("is exceeded after {:.4g} s, and {} has no joint that breaks",
                                  response.chain.events.front().time, engine.word));
  }
  double plastic = 0.0;
  double stored = 0.0;
  for (const Energies& energy : response.chain.energy) {
    plastic = std::max(plastic, energy.plastic);
    stored = std::max(stored, energy.elastic);
  }
  if (plastic <= kPlasticRounding * stored || setup.scene.yield_model == YieldModel::Elastic)
    return;
  refuse_for_engine("rules.yield_model",
                    fmt::format("lets the beam yield here (plastic work {:.3g} J), and {} has "
                                "no joint that yields",
                                plastic, engine.word));
}

WatchedProbes engine_probes(const Setup& setup, const std::vector<std::string>& names) {
  WatchedProbes found = watched_probes(setup, names);
  std::vector<WatchedProbe> kept;
  for (const WatchedProbe& one : found.watched) {
    if (is_of_engine(setup.scene.probes[one.probe].quantity)) {
      kept.push_back(one);
    } else if (names.empty()) {
      found.left_out.push_back(one.name);
    } else {
      throw InputError({}, "--of", one.name,
                       "is no displacement, rotation, velocity or spin, which alone are compared "
                       "with --for");
    }
  }
  if (kept.empty()) {
    refuse_for_engine("probe",
                      "is missing: advice with --for needs a displacement, rotation, "
                      "velocity or spin to look at");
  }
  found.watched = std::move(kept);
  return found;
}

}  // namespace plastica::sweeps
