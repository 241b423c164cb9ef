#include "cli/response_bytes.hpp"

namespace plastica::cli {

std::size_t response_bytes(const Response& response) {
  const ChainHistory& chain = response.chain;
  std::size_t values = 0;
  for (const auto& probe : response.probes) values += probe.size();
  for (const auto* list : {&chain.time, &chain.factor, &chain.position, &chain.moment, &chain.force,
                           &chain.angle, &chain.plastic_angle, &chain.rotation,
                           &chain.plastic_strain, &chain.stress, &chain.reaction}) {
    values += list->size();
  }
  return sizeof(double) * values + sizeof(Energies) * chain.energy.size();
}

}  // namespace plastica::cli
