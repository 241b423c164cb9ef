#pragma once

#include <string>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/web/web_page.hpp"

namespace plastica::report {

/// The page of a simulated scene; not installed.
/// @param file  the result's, for people
WebPage scene_page(const io::SceneRecord& record, const std::string& file);

}  // namespace plastica::report
