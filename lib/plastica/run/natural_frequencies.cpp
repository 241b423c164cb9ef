#include "plastica/run/natural_frequencies.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/run/chain_modes.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica {
namespace {

[[noreturn]] void refuse_coupon() {
  throw InputError({}, "drive.strain", "", "a coupon has no natural frequencies: a beam has");
}

/// Calls `use` with the modes of a chain at rest, on which nothing acts.
template <class L, bool kElastic, class Use>
void with_modes_of(const ChainModel& model, const chain::View<L>& view, const Use& use) {
  ChainBody<L, kElastic> body(model, view);
  body.reset(material_values(model.scene.material));
  for (History& history : body.build.chain.histories) history = {{0.0}, {0.0}};
  for (std::size_t k = 0; k < body.build.chain.constraints.size(); ++k) {
    // Pillars push on one side alone.
    if (body.build.chain.constraints[k].one_sided) body.work.q.released_constraint[k] = true;
  }
  const chain::Coordinates<L> undeformed = body.work.q;
  ChainModes<L, kElastic> modes(body, undeformed, 0.0, false);
  modes.release_idle_constraints();
  use(modes);
}

template <class Use>
void with_modes_at_rest(const Model& model, const Use& use) {
  using chain::Planar;
  using chain::Spatial;
  using chain::Twist;
  if (!model.chain) refuse_coupon();
  const ChainModel& chain = *model.chain;
  const bool elastic = chain.options.translation == JointTranslation::Elastic;
  switch (chain.level) {
    case Level::Twist: with_modes_of<Twist<double>, false>(chain, {}, use); break;
    case Level::Planar: {
      const chain::View<Planar<double>> view{chain.across};
      if (elastic) {
        with_modes_of<Planar<double>, true>(chain, view, use);
      } else {
        with_modes_of<Planar<double>, false>(chain, view, use);
      }
      break;
    }
    default:
      if (elastic) {
        with_modes_of<Spatial<double>, true>(chain, {}, use);
      } else {
        with_modes_of<Spatial<double>, false>(chain, {}, use);
      }
  }
}

/// A scene of which a motion begins, as statics: what acts at time 0, for good.
Scene held_at_time_zero(Scene scene) {
  const auto hold = [](History& history) { history = {{0.0}, {history.at(0.0)}}; };
  for (Load& load : scene.loads) hold(load.history);
  for (Support& support : scene.supports) {
    hold(support.history);
    support.restitution = 0.0;
  }
  hold(scene.gravity_history);
  scene.initial_motions.clear();
  scene.cuts.clear();
  scene.probes.clear();
  return scene;
}

/// Whether anything acts at time 0 of a motion, or on a path at all. The weight of what flies
/// freely takes part in no stiffness.
bool is_loaded(const Scene& scene, bool in_motion) {
  const auto acts = [&](const History& history) {
    const double factor = history.at(0.0);
    return !in_motion || factor > 0.0 || factor < 0.0;
  };
  const bool weighs = scene.gravity != std::array<double, 3>{} && !scene.supports.empty();
  return (weighs && acts(scene.gravity_history)) ||
         std::any_of(scene.loads.begin(), scene.loads.end(),
                     [&](const Load& load) { return acts(load.history); }) ||
         std::any_of(scene.supports.begin(), scene.supports.end(), [&](const Support& support) {
           return support.moves() && acts(support.history);
         });
}

InputError wrong_count(int count, int most) {
  return {{},
          "count",
          std::to_string(count),
          "must be 1 … " + std::to_string(most) + ", the degrees of freedom of the chain"};
}

}  // namespace

int chain_freedoms(const Model& model) {
  int freedoms = 0;
  with_modes_at_rest(model, [&](auto& modes) { freedoms = modes.freedoms(); });
  return freedoms;
}

std::vector<double> unloaded_frequencies(const Model& model, int count) {
  std::vector<double> frequencies;
  with_modes_at_rest(model, [&](auto& modes) {
    const int most = modes.freedoms();
    if (count < 1 || count > most) throw wrong_count(count, most);
    auto found = modes.vibration(count);
    if (!found) throw std::logic_error("the stiffness of a beam at rest is not symmetric");
    frequencies = std::move(found->frequency);
  });
  return frequencies;
}

std::vector<double> unloaded_frequencies(const Scene& scene, const SolverOptions& options,
                                         int count) {
  if (scene.is_coupon()) refuse_coupon();
  SolverOptions still;
  still.duration = 1.0;  // of which nothing is run
  still.analysis = Analysis::Dynamics;
  still.level = options.level;
  still.translation = options.translation;
  still.fibres = options.fibres;
  still.rotary_inertia = options.rotary_inertia;
  return unloaded_frequencies(prepare(scene, still), count);
}

LoadedFrequencies natural_frequencies(const Scene& scene, const SolverOptions& options, int count) {
  if (scene.is_coupon()) refuse_coupon();
  const bool in_motion = options.analysis == Analysis::Dynamics;
  if (!is_loaded(scene, in_motion)) {
    return {Status::Completed, unloaded_frequencies(scene, options, count)};
  }
  SolverOptions to_the_end = options;
  to_the_end.level = prepare(scene, options).level;
  to_the_end.analysis = Analysis::Statics;
  to_the_end.precision = Precision::Double;
  to_the_end.buckling = 0;
  to_the_end.frequencies = std::max(count, 1);
  to_the_end.frames = 1;
  if (in_motion) {
    to_the_end.duration = 1.0;
    to_the_end.steps = 1;
    to_the_end.damping = Damping::None;
    to_the_end.damping_time = 0.0;
  }
  const Response response = simulate(in_motion ? held_at_time_zero(scene) : scene, to_the_end);
  LoadedFrequencies loaded{response.status, {}};
  if (!response.vibration) return loaded;
  loaded.frequency = response.vibration->frequency;
  const int found = static_cast<int>(loaded.frequency.size());
  if (count < 1 || count > found) throw wrong_count(count, found);
  return loaded;
}

}  // namespace plastica
