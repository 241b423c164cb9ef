#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "calibrate/report/format.hpp"
#include "calibrate/report/plot.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/machine_error.hpp"
#include "plastica/io/gnuplot.hpp"
#include "tests/calibrate/report/records.hpp"

namespace plastica::calibrate {
namespace {

using testing::fitted_record;

/// A folder of this test alone, removed at its end.
class DrawPlot : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string pattern = ::testing::TempDir() + "plastica_draw_XXXXXX";
    std::vector<char> name(pattern.c_str(), pattern.c_str() + pattern.size() + 1);
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name.data();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string drawn(const std::vector<FitRecord>& records, const std::string& name,
                    const std::string& what = {}) {
    const std::string path = folder_ + "/" + name;
    std::ostringstream out;
    draw_plot(records, {.what = what, .output = path}, out);
    EXPECT_EQ(out.str(), "");
    std::ifstream in(path, std::ios::binary);
    std::stringstream content;
    content << in.rdbuf();
    return content.str();
  }

  std::string folder_;
};

std::vector<FitRecord> records() {
  return {fitted_record("a"), fitted_record("b", 290e6), fitted_record("c", 200e6, "150")};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST_F(DrawPlot, WritesEachKindAsSvg) {
  for (const char* what : {"curve", "overview", "parameters"}) {
    const std::string svg = drawn(records(), std::string(what) + ".svg", what);
    EXPECT_TRUE(svg.starts_with("<?xml")) << what;
    EXPECT_NE(svg.find("</svg>"), svg.npos) << what;
    EXPECT_EQ(count(svg, "<g "), count(svg, "</g>") - count(svg, "<g>")) << what;
    EXPECT_GT(count(svg, "<path "), 10U) << what;
  }
}

TEST_F(DrawPlot, WritesPngAndPdf) {
  EXPECT_TRUE(drawn(records(), "a.png").starts_with("\x89PNG"));
  EXPECT_TRUE(drawn(records(), "a.pdf").starts_with("%PDF"));
}

TEST_F(DrawPlot, ShowsTextsOfUsersLetterByLetter) {
  FitRecord record = fitted_record("<b>_{x}^2 & 'q' \"d\" \\n \\ @ `id` \xFF 50%d ]]>");
  const std::string svg = drawn({record}, "a.svg");
  EXPECT_NE(svg.find("&lt;b>_{x}^2 &amp; 'q' \"d\" \\n \\ @ `id` ? 50%d ]] >"), svg.npos);
  record.target.group = {{"lot", "50%d_{x}"}};
  EXPECT_NE(drawn({record}, "b.svg", "parameters").find("50%d_{x}"), std::string::npos);
}

TEST_F(DrawPlot, WritesAScriptThatGnuplotDraws) {
  const std::string script = drawn(records(), "a.gp", "overview");
  EXPECT_TRUE(script.starts_with("# "));
  EXPECT_TRUE(io::run_gnuplot("set terminal svg\n" + script).ends_with("</svg>\n\n"));
}

TEST_F(DrawPlot, DrawsWithCharactersOnStandardOutput) {
  std::ostringstream out;
  draw_plot(records(), {.what = "curve", .specimen = "b", .output = "-"}, out);
  EXPECT_NE(out.str().find("σ_y 290.00"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("...."), std::string::npos) << out.str();
  EXPECT_GE(count(out.str(), "#"), 5U) << out.str();
  EXPECT_EQ(out.str().find('\x1b'), std::string::npos);
}

TEST_F(DrawPlot, FitsATerminalOf80ColumnsAnd24Lines) {
  for (const char* kind : {"curve", "overview"}) {
    std::ostringstream out;
    draw_plot(records(), {.what = kind, .output = "-"}, out);
    std::istringstream in(out.str());
    std::size_t lines = 0;
    for (std::string line; std::getline(in, line); ++lines) {
      EXPECT_LE(report::width_of(line), 80U) << line;
      EXPECT_FALSE(line.ends_with(' ')) << line;
    }
    EXPECT_LE(lines, 24U) << out.str();
    EXPECT_GE(lines, 18U) << out.str();
    EXPECT_NE(out.str().find("engineering strain [%]"), std::string::npos) << out.str();
  }
}

TEST_F(DrawPlot, GivesEachGroupALetterInATerminal) {
  std::ostringstream out;
  draw_plot(std::vector{fitted_record("a", 280e6, "20"), fitted_record("b", 200e6, "150")},
            {.what = "overview", .output = "-"}, out);
  EXPECT_NE(out.str().find("AAAA"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("BBBB"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("temperature 150, measured"), std::string::npos) << out.str();
}

TEST_F(DrawPlot, ShowsParametersInATerminalBelowEachOther) {
  std::ostringstream out;
  draw_plot(records(), {.what = "parameters", .output = "-"}, out);
  EXPECT_LT(out.str().find("yield_stress [MPa]"), out.str().find("break_strain [%]"));
  EXPECT_NE(out.str().find("break_strain [%]"), std::string::npos) << out.str();
}

TEST_F(DrawPlot, LeavesTheOldFileWhereItCannotDraw) {
  const std::string path = folder_ + "/a.svg";
  std::ofstream(path) << "old";
  std::ostringstream out;
  EXPECT_THROW(draw_plot(records(), {.what = "pie", .output = path}, out), InputError);
  EXPECT_EQ(std::filesystem::file_size(path), 3U);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_F(DrawPlot, RefusesAnOutputOfUnknownKind) {
  std::ostringstream out;
  try {
    draw_plot(records(), {.output = folder_ + "/a.jpg"}, out);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.rule(), "must end in .svg, .png, .pdf or .gp, or be -");
  }
}

TEST_F(DrawPlot, SaysThatAFileCannotBeWritten) {
  std::ostringstream out;
  EXPECT_THROW(draw_plot(records(), {.output = folder_ + "/none/a.svg"}, out), MachineError);
}

}  // namespace
}  // namespace plastica::calibrate
