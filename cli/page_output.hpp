#pragma once

#include <span>
#include <string>

#include "plastica/io/output_file.hpp"
#include "plastica/report/web/web_page.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library CLI11
class App;
}

namespace plastica::cli {

/// Refuses to write a page where this build has no library that draws the curves.
/// @param option  what asks for one: "--report", or the command
/// @throws InputError
void require_chart_library(const std::string& option, const std::string& value);

/// Adds `--report`, which writes a page of what a command found.
void add_report_option(CLI::App& sub, std::string& path);

/// Checks where the page of `--report` is to go, before anything is computed; empty: none is asked
/// for. Not even `force` lets a run write over what it reads, or over its other output.
/// @param read    files that the run reads
/// @param others  its other outputs; empty ones are none
/// @throws InputError
void check_report_option(const std::string& path, bool force, std::span<const std::string> read,
                         std::span<const std::string> others);

void write_page(const std::string& path, const report::WebPage& page, io::Overwrite overwrite);

}  // namespace plastica::cli
