#pragma once

#include <string>
#include <vector>

#include "plastica/io/result_file.hpp"
#include "plastica/report/json_values.hpp"

/// Reports as one file of HTML, which needs no other file and no network; not installed.
namespace plastica::report {

/// Blocks (web_blocks.hpp) under a name.
struct WebTab {
  std::string name;
  Json blocks = Json::array();
};

struct WebPage {
  std::string title;
  std::vector<std::string> lines{};  ///< below it
  std::vector<WebTab> tabs{};
  /// What the rows of a table open, as `part_text` has it: of ten thousand specimens they would
  /// take a gigabyte otherwise.
  std::vector<std::string> details{};
  std::string numbers_in = "the result file";  ///< where all numbers are; empty: nowhere else
};

/// A part of the page as JSON that HTML takes for no element.
std::string part_text(const WebTab& part);

/// Whether this build was made where the library was that draws the curves, Chart.js.
bool has_chart_library();

/// The page. All texts are shown as they are: none is read as HTML.
/// @throws std::logic_error without the library
std::string html_of(const WebPage& page);

/// How a result came about: time, command, versions, the files that the run was told by.
/// @param file  the result's; empty: there is none
WebTab provenance_tab(const std::string& file, const io::RunMeta& meta,
                      const std::vector<io::InputText>& inputs, const std::string& run = {});

}  // namespace plastica::report
