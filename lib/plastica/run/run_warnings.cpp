#include "plastica/run/run_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "plastica/model/yield_warnings.hpp"
#include "plastica/run/axial_warning.hpp"
#include "plastica/run/likely_mistakes.hpp"
#include "plastica/run/peak_warning.hpp"
#include "plastica/run/plane_warning.hpp"
#include "plastica/run/rounding_warning.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/turn_warning.hpp"

namespace plastica {
namespace {

/// Whether joints have done plastic work, beyond rounding.
bool has_yielded(const Response& response) {
  const auto& energy = response.chain.energy;
  if (response.samples == 0 || energy.size() < response.samples) return false;
  const Energies& last = energy[response.samples - 1];
  return last.plastic > 1e-9 * std::max(std::fabs(last.external), last.elastic);
}

/// Whether a limit load that is met as the first joint yields, before any plastic work, is one of
/// moments: whether the last sample's, with the factor, come at it to a part of the yield stress.
bool yields_by_bending(const Scene& scene, const Response& response) {
  constexpr double kPart = 0.5;
  const ChainHistory& chain = response.chain;
  if (response.status != Status::LimitLoad || !response.limit || chain.stress.empty()) return false;
  const double factor = chain.factor[response.samples - 1];
  if (!(std::fabs(factor) > 0.0)) return true;  // there is none before the limit
  double stress = 0.0;
  for (std::size_t frame = 0; frame < chain.frame_sample.size(); ++frame) {
    if (chain.frame_sample[frame] + 1 != response.samples) continue;
    for (std::size_t joint = 0; joint < chain.joints; ++joint) {
      stress = std::max(stress, std::fabs(chain.stress[frame * chain.joints + joint]));
    }
  }
  return stress * response.limit->below / factor > kPart * scene.material.yield_stress;
}

/// Whether a beam that bends in a plane comes to leave it, or would.
bool leaves_plane(const Response& response) {
  const auto any = [](const auto& modes) {
    return modes && std::ranges::find(modes->out_of_plane, 1) != modes->out_of_plane.end();
  };
  return any(response.critical) || any(response.buckling);
}

}  // namespace

std::vector<std::string> run_warnings(const Scene& scene, const SolverOptions& solver,
                                      const Model& model, const Response& response) {
  std::vector<std::string> all = likely_mistakes(scene, model, response);
  const auto add = [&](std::optional<std::string> warning) {
    if (warning) all.push_back(std::move(*warning));
  };
  const auto add_all = [&](const std::vector<std::string>& some) {
    std::ranges::copy(some, std::back_inserter(all));
  };
  add_all(scene_warnings(model));
  if (has_yielded(response) || yields_by_bending(scene, response)) add(first_yield_warning(model));
  if (leaves_plane(response)) add(model_detail::tipping_warning(scene));
  add(plane_warning(scene, solver, model.level, response));
  add_all(axial_warnings(scene, solver, response));
  add_all(rounding_warnings(scene, response));
  add_all(peak_warnings(scene, response));
  add_all(turn_warnings(scene, model.level, response));
  return all;
}

}  // namespace plastica
