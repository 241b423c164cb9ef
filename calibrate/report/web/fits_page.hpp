#pragma once

#include <string>

#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "plastica/report/web/web_page.hpp"

/// Pages of fits: a table whose rows open the specimens; not installed.
namespace plastica::calibrate {

/// @param file  the result's, for people
plastica::report::WebPage fits_page(const FitStoreContents& contents, const std::string& file);
plastica::report::WebPage fits_page(const SceneFitContents& contents, const std::string& file);

}  // namespace plastica::calibrate
