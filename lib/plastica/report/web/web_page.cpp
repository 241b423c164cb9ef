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

void append_list(std::string& html, const std::vector<std::string>& texts) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) html += ',';
    html += texts[i];
  }
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

std::string part_text(const WebTab& part) {
  return inert({{"name", part.name}, {"blocks", part.blocks}});
}

bool has_chart_library() { return !assets::chart_library().empty(); }

std::string html_of(const WebPage& page) {
  if (!has_chart_library()) throw std::logic_error("html_of: this build has no Chart.js");
  std::string html(kHead);
  html += fmt::format("<title>{}</title>\n<style>\n", xml_text(printable(page.title)));
  html += assets::style();
  html += "</style>\n</head>\n<body>\n<noscript>This report needs JavaScript.</noscript>\n";
  html += "<script type=\"application/json\" id=\"data\">";
  std::vector<std::string> tabs;
  for (const WebTab& tab : page.tabs) tabs.push_back(part_text(tab));
  html += fmt::format("{{\"title\":{},\"lines\":{},\"numbers_in\":{},\"license\":{},\"tabs\":[",
                      inert(page.title), inert(page.lines), inert(page.numbers_in),
                      inert(assets::chart_license()));
  append_list(html, tabs);
  html += "],\"details\":[";
  append_list(html, page.details);
  html += "]}";
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
    versions += fmt::format("{}{} {}", versions.empty() ? "" : ", ", name, version);
  }
  WebTab tab{"Provenance", Json::array()};
  tab.blocks.push_back(web_facts(
      "Run",
      {{"result file", file},
       {"run", run},
       {"command", meta.command_line},
       {"begun", meta.start_time},
       {"took", significant(meta.seconds, 3) + " s"},
       {"threads", std::to_string(meta.threads)},
       {"instruction set", meta.instruction_set},
       {"resumed",
        meta.resumptions > 0 ? counted(static_cast<std::size_t>(meta.resumptions), "time") : ""},
       {"versions", versions}}));
  for (const io::InputText& input : inputs) tab.blocks.push_back(web_text(input.name, input.text));
  return tab;
}

}  // namespace plastica::report
