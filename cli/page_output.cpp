#include "cli/page_output.hpp"

#include <CLI/CLI.hpp>

#include "cli/run_files.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/text_file.hpp"

namespace plastica::cli {

void require_chart_library(const std::string& option, const std::string& value) {
  if (report::has_chart_library()) return;
  throw InputError({}, option, value,
                   "was left out of this build, which found no Chart.js (Debian: "
                   "libjs-chart.js); build again where it is");
}

void add_report_option(CLI::App& sub, std::string& path) {
  sub.add_option("--report", path, "Also write one page of HTML that needs no network")
      ->option_text("FILE.html");
}

void check_report_option(const std::string& path, bool force, std::span<const std::string> read,
                         std::span<const std::string> others) {
  if (path.empty()) return;
  require_chart_library("--report", path);
  for (const std::string& input : read) refuse_input("--report", path, input);
  require_ending("--report", path, ".html", "it is a page");
  io::check_output_path(path, force);
  for (const std::string& other : others) {
    if (!other.empty()) refuse_own_files("--report", path, other);
  }
}

void write_page(const std::string& path, const report::WebPage& page, io::Overwrite overwrite) {
  io::write_text_file(path, report::html_of(page), overwrite);
}

}  // namespace plastica::cli
