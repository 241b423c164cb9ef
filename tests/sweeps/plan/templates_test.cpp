#include "sweeps/plan/templates.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "sweeps/check/run_check.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::sweeps {
namespace {

TEST(SweepTemplates, HoldAsTheyAreWritten) {
  io::ScratchFolder folder;
  for (const auto& file : template_files("check")) {
    std::ofstream(folder.file(file.name)) << file.text;
  }
  const CheckFile file = read_check_file(folder.file("check.toml"));
  EXPECT_EQ(file.claims.size(), 3U);
  for (const ClaimVerdict& verdict : run_check(file, {})) EXPECT_TRUE(verdict.holds);
}

TEST(SweepTemplates, AreOfTheKindsThatAreListed) {
  for (const auto kind : template_kinds()) EXPECT_FALSE(template_files(kind).empty());
  EXPECT_EQ(plastica::testing::message_of([] { template_files("scene"); }),
            "init = scene: must be one of sweep, check");
}

}  // namespace
}  // namespace plastica::sweeps
