#include "plastica/io/read_chain.hpp"
#include "plastica/io/read_place.hpp"

namespace plastica::io {
namespace {

/// What a scene asks for of a vector if it does not say: bending about x is the first that a
/// joint can do, y the direction in which that moves it.
Component default_component(ProbeQuantity kind) {
  switch (kind) {
    case ProbeQuantity::Displacement:
    case ProbeQuantity::Velocity:
    case ProbeQuantity::Momentum:
    case ProbeQuantity::Reaction:
    case ProbeQuantity::Force: return Component::Y;
    default: return Component::X;
  }
}

/// Whether a quantity has no place.
bool is_of_whole_beam(ProbeQuantity kind) {
  return is_of_all(kind) || kind == ProbeQuantity::Momentum ||
         kind == ProbeQuantity::AngularMomentum;
}

Probe read_probe(const TomlTable& table, bool coupon) {
  if (const auto old = table.find("quantity")) throw old->error("is called kind");
  const TomlValue kind = table.at("kind");
  Probe probe;
  probe.quantity = static_cast<ProbeQuantity>(kind.word(probe_kinds()));
  const auto name = table.find("name");
  probe.name = name ? name->string() : kind.string();
  const auto at = table.find("at");
  const auto component = table.find("component");
  const auto energy = table.find("energy");
  if (coupon && (at || component)) {
    throw(at ? at : component)->error("is of no use: a coupon is the same everywhere");
  }
  if (at && is_of_whole_beam(probe.quantity)) {
    throw at->error("is of no use: " + kind.string() + " is the whole beam's");
  }
  if (component && is_of_all(probe.quantity)) {
    throw component->error("is of no use: " + kind.string() + " is the whole beam's");
  }
  if (energy && probe.quantity != ProbeQuantity::Energy) {
    throw energy->error("belongs to kind = \"energy\"");
  }
  if (at) probe.at = read_place(*at);
  probe.component = component ? static_cast<Component>(component->word(kComponents))
                              : default_component(probe.quantity);
  if (probe.quantity == ProbeQuantity::Energy) {
    probe.energy = static_cast<EnergyKind>(table.at("energy").word(kEnergyKinds));
  }
  return probe;
}

}  // namespace

std::vector<Probe> read_probes(const TomlTable& root, bool coupon) {
  std::vector<Probe> probes;
  for (const TomlTable& table : root.find_tables("probe")) {
    const Probe probe = read_probe(table, coupon);
    for (const Probe& other : probes) {
      if (other.name != probe.name) continue;
      const auto name = table.find("name");
      throw name.value_or(table.at("kind")).error("is the name of another probe, too");
    }
    probes.push_back(probe);
  }
  return probes;
}

}  // namespace plastica::io
