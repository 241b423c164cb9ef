#include "plastica/report/web/web_page.hpp"

#include <gtest/gtest.h>

#include <string>

#include "plastica/report/web/assets.hpp"
#include "plastica/report/web/web_blocks.hpp"

namespace plastica::report {
namespace {

std::string page_of(const std::string& text) {
  WebPage page{text, {text}};
  WebTab tab{text, Json::array()};
  tab.blocks.push_back(web_text(text, text));
  tab.blocks.push_back(web_facts(text, {{text, text}}));
  WebTable table(text);
  table.add_words(text, text);
  table.add_row({text});
  tab.blocks.push_back(table.block());
  page.tabs.push_back(tab);
  page.details.push_back(part_text(tab));
  return html_of(page);
}

std::size_t count(const std::string& text, const std::string& of) {
  std::size_t n = 0;
  for (auto at = text.find(of); at != text.npos; at = text.find(of, at + 1)) ++n;
  return n;
}

TEST(WebPage, HasNoElementOfAText) {
  ASSERT_TRUE(has_chart_library()) << "tests need libjs-chart.js";
  const std::string plain = page_of("plain");
  const std::string hostile = page_of("</script><script>alert(1)</script><!-- \"'&\n");
  for (const char* mark : {"<script", "</script", "<!--", "<title", "alert(1)</"}) {
    EXPECT_EQ(count(hostile, mark), count(plain, mark)) << mark;
  }
  EXPECT_EQ(count(hostile, "alert(1)"), 1U + count(hostile, "alert(1)\\u003c"));  // the title's
}

// What is not UTF-8 must not end the page.
TEST(WebPage, TakesBytesThatAreNoText) {
  EXPECT_NE(page_of(std::string("a\xff\xfe\0b", 5)).find("</html>"), std::string::npos);
}

TEST(WebPage, AsksForNothing) {
  const std::string page = page_of("plain");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  const std::string ours = page.substr(0, page.find("<script type")) +
                           std::string(assets::script()) + std::string(assets::style());
  for (const char* mark :
       {" src=", " href=", "@import", "url(", "http:", "https:", "fetch(", "innerHTML"}) {
    EXPECT_EQ(ours.find(mark), std::string::npos) << mark;
  }
}

}  // namespace
}  // namespace plastica::report
