#pragma once

#include <cstddef>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "plastica/theory/spectrum.hpp"

/// Frequencies of a motion's probes; not installed.
namespace plastica::report {

/// Whether a record's probes have spectra: it is a motion, its samples are at even times, and there
/// are enough of them.
bool has_spectra(const io::SceneRecord& record);

/// Those of a record's probes whose frequencies the report lists: displacements and velocities.
std::vector<std::size_t> spectral_probes(const io::SceneRecord& record);

/// @param record  that has spectra
theory::Spectrum spectrum_of(const io::SceneRecord& record, std::size_t probe);

}  // namespace plastica::report
