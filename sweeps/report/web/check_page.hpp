#pragma once

#include <cstddef>
#include <span>

#include "plastica/report/web/web_page.hpp"
#include "sweeps/check/report.hpp"

namespace plastica::sweeps {

/// The page of checks: a table of all claims, whose rows open them; not installed.
/// @param files  that were judged (n >= 0)
/// @param asked  how many were to be judged; more than were: the run was interrupted
/// @throws InputError if a table of a fit file can be read no more
report::WebPage check_page(std::span<const CheckedFile> files, std::size_t asked,
                           const io::RunMeta& meta);

}  // namespace plastica::sweeps
