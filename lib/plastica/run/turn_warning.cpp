#include "plastica/run/turn_warning.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

namespace plastica {
namespace {

/// Of half a turn: the size of a vector that comes back does not jump.
constexpr double kNearlyHalf = 0.95;

bool passes_half_a_turn(const Probe& probe, const std::vector<double>& values,
                        std::size_t samples) {
  for (std::size_t i = 0; i < samples; ++i) {
    const bool jumps = i > 0 && std::fabs(values[i] - values[i - 1]) > std::numbers::pi;
    const bool is_long =
        probe.component == Component::Size && values[i] > kNearlyHalf * std::numbers::pi;
    if (jumps || is_long) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> turn_warnings(const Scene& scene, Level level, const Response& response) {
  std::vector<std::string> all;
  if (level != Level::Spatial) return all;
  for (std::size_t k = 0; k < scene.probes.size() && k < response.probes.size(); ++k) {
    const Probe& probe = scene.probes[k];
    if (probe.quantity != ProbeQuantity::Rotation) continue;
    if (!passes_half_a_turn(probe, response.probes[k], response.samples)) continue;
    all.push_back(
        fmt::format("{} passes half a turn: in space a rotation is a vector of half a turn at "
                    "most, which comes "
                    "back from the other side; in a plane turns are counted",
                    probe.name));
  }
  return all;
}

}  // namespace plastica
