#include "plastica/report/scene_spectrum.hpp"

#include <cmath>

#include "plastica/report/scene_facts.hpp"

namespace plastica::report {
namespace {

double time_step(const io::SceneRecord& record) {
  const auto& time = record.response.chain.time;
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

}  // namespace

bool has_spectra(const io::SceneRecord& record) {
  const auto& time = record.response.chain.time;
  if (!is_motion(record) || time.size() < theory::kFewestSamples) return false;
  const double step = time_step(record);
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (!(std::fabs(time[i] - time[i - 1] - step) <= 1e-6 * step)) return false;
  }
  return true;
}

std::vector<std::size_t> spectral_probes(const io::SceneRecord& record) {
  std::vector<std::size_t> probes;
  if (!has_spectra(record)) return probes;
  for (std::size_t p = 0; p < record.setup.scene.probes.size(); ++p) {
    const ProbeQuantity quantity = record.setup.scene.probes[p].quantity;
    if (quantity == ProbeQuantity::Displacement || quantity == ProbeQuantity::Velocity) {
      probes.push_back(p);
    }
  }
  return probes;
}

theory::Spectrum spectrum_of(const io::SceneRecord& record, std::size_t probe) {
  return theory::amplitude_spectrum(record.response.probes[probe], time_step(record));
}

}  // namespace plastica::report
