#include "plastica/report/web/web_page.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <utility>

#include "plastica/report/format.hpp"
#include "plastica/report/web/assets.hpp"
#include "plastica/report/web/web_blocks.hpp"
#include "plastica/report/xml_text.hpp"

namespace plastica::report {
namespace {

Json tabs_of(const std::vector<WebTab>& tabs) {
  Json all = Json::array();
  for (const WebTab& tab : tabs) all.push_back({{"name", tab.name}, {"blocks", tab.blocks}});
  return all;
}

/// JSON in which HTML finds no end of the element that holds it, and no comment.
std::string inert(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

// Nothing is fetched, whatever the page is told.
constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:">
<meta name="generator" content="Plastica">
)";

}  // namespace

bool has_chart_library() { return !assets::chart_library().empty(); }

std::string html_of(const WebPage& page) {
  if (!has_chart_library()) throw std::logic_error("html_of: this build has no Chart.js");
  const Json data = {{"title", page.title},
                     {"lines", page.lines},
                     {"tabs", tabs_of(page.tabs)},
                     {"details", tabs_of(page.details)},
                     {"license", assets::chart_license()}};
  std::string html(kHead);
  html += fmt::format("<title>{}</title>\n<style>\n", xml_text(printable(page.title)));
  html += assets::style();
  html += "</style>\n</head>\n<body>\n<noscript>This report needs JavaScript.</noscript>\n";
  html += "<script type=\"application/json\" id=\"data\">";
  html += inert(data);
  html += "</script>\n<script>\n";
  html += assets::chart_library();
  html += "</script>\n<script>\n\"use strict\";\n";
  html += assets::script();
  html += "</script>\n</body>\n</html>\n";
  return html;
}

WebTab provenance_tab(const std::string& file, const io::RunMeta& meta,
                      const std::vector<io::InputText>& inputs, const std::string& run) {
  std::string versions;
  for (const auto& [name, version] : meta.versions) {
    versions += (versions.empty() ? "" : ", ") + name + " " + version;
  }
  WebTab tab{"Provenance", Json::array()};
  tab.blocks.push_back(web_facts(
      "Run", {{"result file", file},
              {"run", run},
              {"command", meta.command_line},
              {"begun", meta.start_time},
              {"took", significant(meta.seconds, 3) + " s"},
              {"threads", std::to_string(meta.threads)},
              {"instruction set", meta.instruction_set},
              {"resumed", meta.resumptions > 0 ? counted(static_cast<std::size_t>(meta.resumptions), "time") : ""},
              {"versions", versions}}));
  for (const io::InputText& input : inputs) tab.blocks.push_back(web_text(input.name, input.text));
  return tab;
}

}  // namespace plastica::report
