#include <gtest/gtest.h>

#include "tests/cli/command.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

class Picture : public ::testing::Test {
 protected:
  void SetUp() override {
    place_.write("a.csv", broken_curve(350.0, 1));
    place_.write("b.csv", broken_curve(360.0, 2));
    ASSERT_EQ(place_.run({"calibrate", "a.csv", "b.csv", "--quiet", "-o", "fit.h5"}).code, 0);
  }

  /// Draws with further options. @return what the command wrote
  std::string draw(std::vector<std::string> options) const {
    options.insert(options.begin(), {"plot", "fit.h5"});
    const CommandResult result = place_.run(options);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
  }

  Workplace place_;
};

TEST_F(Picture, IsDrawnInTheFormatOfTheEnding) {
  EXPECT_EQ(draw({"-o", "fit.svg"}), "wrote fit.svg\n");
  EXPECT_TRUE(place_.read("fit.svg").starts_with("<?xml"));
  EXPECT_NE(place_.read("fit.svg").find("</svg>"), std::string::npos);
  draw({"-o", "fit.png"});
  EXPECT_TRUE(place_.read("fit.png").starts_with("\x89PNG"));
  draw({"-o", "fit.pdf"});
  EXPECT_TRUE(place_.read("fit.pdf").starts_with("%PDF"));
}

TEST_F(Picture, IsDrawnInLettersOnTheTerminal) {
  const std::string letters = draw({});
  EXPECT_GT(lines_of(letters), 20U);
  EXPECT_EQ(draw({"-o", "-"}), letters);
}

TEST_F(Picture, IsWrittenAsAScriptThatGnuplotDraws) {
  EXPECT_EQ(draw({"-o", "fit.gp"}), "wrote fit.gp\n");
  const CommandResult drawn =
      place_.run_program("/usr/bin/env", {"gnuplot", "-e", "set term svg", "fit.gp"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(drawn.out.find("</svg>"), std::string::npos);
}

TEST_F(Picture, IsTheOneThatIsAskedFor) {
  const std::string overview = draw({"--what", "overview"});
  const std::string curve = draw({"--what", "curve", "--case", "b"});
  EXPECT_EQ(draw({}), overview);  // two specimens
  EXPECT_EQ(draw({"--case", "b"}), curve);
  EXPECT_NE(draw({"--case", "a"}), curve);
  EXPECT_NE(draw({"--what", "parameters"}), overview);
}

TEST(Pictures, AreListedWithoutAFile) {
  const Workplace place;
  const CommandResult listed = place.run({"plot", "--list"});
  EXPECT_EQ(listed.code, 0) << listed.err;
  for (const char* name : {"curve ", "overview ", "parameters "}) {
    EXPECT_NE(("\n" + listed.out).find(std::string("\n") + name), std::string::npos) << listed.out;
  }
  const CommandResult none = place.run({"plot"});
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.err, "plastica: files is required (see plastica plot --help)\n");
}

}  // namespace
}  // namespace plastica::testing
