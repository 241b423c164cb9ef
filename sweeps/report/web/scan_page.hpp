#pragma once

#include <span>

#include "plastica/io/scene_file.hpp"
#include "plastica/report/web/web_page.hpp"
#include "sweeps/stability/scene_scan.hpp"

namespace plastica::sweeps::stability {

/// The page of the scan of a scene; not installed.
/// @param pair  of `scan_pair`; empty: no two fields were varied together
/// @param file  the scene
report::WebPage scan_page(const SceneScan& scan, std::span<const StabilityRow> pair,
                          const SceneScanOptions& options, const io::SceneFile& file,
                          const io::RunMeta& meta);

}  // namespace plastica::sweeps::stability
