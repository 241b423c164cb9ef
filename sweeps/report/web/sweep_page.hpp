#pragma once

#include <string>

#include "plastica/report/web/web_page.hpp"
#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// The page of a sweep; not installed.
/// @param file  the result's, for people
report::WebPage sweep_page(const SweepRecord& record, const std::string& file);

}  // namespace plastica::sweeps
