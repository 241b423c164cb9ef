#include "plastica/run/peak_warning.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace plastica {

namespace {

/// Whether no part of a beam hardens: what hardens gives way as it should.
bool is_ideal(const Scene& scene) {
  const auto ideal = [](const Material& material) {
    return material.hardening.law == HardeningLaw::Ideal;
  };
  return ideal(scene.material) && std::ranges::all_of(scene.regions, [&](const Region& region) {
           return ideal(region.material);
         });
}

}  // namespace

std::vector<std::string> peak_warnings(const Scene& scene, const Response& response) {
  const bool is_loaded = !scene.loads.empty() || scene.gravity != std::array<double, 3>{};
  const std::vector<double>& time = response.chain.time;
  const std::vector<double>& factor = response.chain.factor;
  std::vector<std::string> all;
  if (response.status == Status::LimitLoad && !is_loaded) {
    all.emplace_back(
        "nothing but motions of supports loads the beam: beyond that factor of them it jumps to "
        "another equilibrium, or the path was lost; more solver.steps tell");
  }
  if (response.plateau && is_ideal(scene)) {
    all.push_back(
        fmt::format("the beam gives way as it yields: between factors of {:.5g} and {:.5g} it "
                    "moved {:.0f} times "
                    "as far as elastically, and carries more only where it has moved to; "
                    "solver.control = \"arc_length\" follows it from point to point",
                    response.plateau->from, response.plateau->to, response.plateau->times));
  }
  const std::size_t samples = std::min({response.samples, time.size(), factor.size()});
  for (std::size_t i = 1; i < samples; ++i) {
    if (time[i] >= time[i - 1]) continue;
    all.push_back(fmt::format(
        "the path passes a peak at a factor of {:.4g}: beyond it less is needed for equilibrium, "
        "and a beam that keeps its loads would not stay there; solver.control = \"load\" ends at "
        "the peak",
        factor[i - 1]));
    break;
  }
  return all;
}

}  // namespace plastica
