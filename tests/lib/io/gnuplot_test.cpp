#include "plastica/io/gnuplot.hpp"

#include <gtest/gtest.h>

#include <string>

#include "plastica/base/machine_error.hpp"

namespace plastica::io {
namespace {

TEST(Gnuplot, ThatIsMissingIsAFailureOfTheMachine) {
  try {
    run_gnuplot("plot x", "no-such-gnuplot");
    FAIL() << "no error";
  } catch (const MachineError& error) {
    EXPECT_NE(std::string(error.what()).find("no program 'no-such-gnuplot'"), std::string::npos);
  }
}

TEST(Gnuplot, PassesItsFirstMessageOn) {
  try {
    run_gnuplot("set terminal svg\nplot nonsense(x)\n");
    FAIL() << "no error";
  } catch (const MachineError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("gnuplot drew nothing: ")) << error.what();
    EXPECT_GT(std::string(error.what()).size(), 30U) << error.what();
  }
}

TEST(Gnuplot, TakesALongScript) {
  std::string script = "set terminal svg\n$d << END\n";
  for (int i = 0; i < 50000; ++i) script += std::to_string(i) + " 1\n";
  EXPECT_NE(run_gnuplot(script + "END\nplot $d every 1000\n").find("</svg>"), std::string::npos);
}

TEST(Gnuplot, StringsKeepAllButControlCharacters) {
  EXPECT_EQ(gnuplot_string("it's\n\\x `y` \"z\""), "'it''s \\x `y` \"z\"'");
}

}  // namespace
}  // namespace plastica::io
