#pragma once

#include <span>
#include <string>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_figure.hpp"

/// The pictures of a simulated scene over time and frequency; not installed.
namespace plastica::report {

/// A probe over time, with the times at which joints broke or were cut where there is one record.
/// @throws InputError for a probe that there is not
Figure history_figure(std::span<const io::SceneRecord> records, const std::string& probe);

/// The energy balance over time: of a motion, areas on top of each other up to what came in, where
/// `stacked`; else a line per entry. Entries that are zero are left out.
Figure energy_figure(const io::SceneRecord& record, bool stacked);

/// Amplitudes of a probe over frequency, on a logarithmic scale, with its strongest peaks. As a
/// picture of characters (`letters`) the logarithms are drawn.
/// @throws InputError for a probe that there is not, or records without spectra
Figure spectrum_figure(std::span<const io::SceneRecord> records, const std::string& probe,
                       bool letters);

}  // namespace plastica::report
