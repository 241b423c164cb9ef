#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "sweeps/check/run_check.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {

/// Claims on a sweep of the shipped cantilever, in a folder of their own.
class CheckTest : public ::testing::Test {
 protected:
  CheckTest() {
    const std::string scenes = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/";
    write("sweep.toml",
          "scene = '" + scenes + "cantilever.toml'\n" + segments_axis("[4, 8, 16]") +
              "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n" + kTipError);
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name)) << text;
  }
  CheckFile read(const std::string& claim) {
    write("check.toml", "[[claim]]\nname = 'a'\nsweep = 'sweep.toml'\n" + claim);
    return read_check_file(folder_.file("check.toml"));
  }
  ClaimVerdict verdict(const std::string& claim) { return run_check(read(claim), {}).front(); }
  std::string message(const std::string& claim) {
    const std::string line = plastica::testing::message_of([&] { read(claim); });
    return line.substr(std::min(line.size(), folder_.file("check.toml").size()));
  }

  io::ScratchFolder folder_;
};

}  // namespace plastica::sweeps
