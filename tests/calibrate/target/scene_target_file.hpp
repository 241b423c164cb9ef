#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "calibrate/target/scene_target.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::testing {

/// Curves of a bent bar, in a file.
class SceneTargetFile : public ::testing::Test {
 protected:
  calibrate::SceneTarget read(const std::string& text, const std::string& probe = "force") {
    calibrate::SceneTarget probes;
    probes.abscissa_probe = "displacement";
    probes.ordinate_probe = probe;
    probes.ordinate_where = {"fit.toml", 5};
    probes.ordinate_factor = -1.0;
    return calibrate::read_scene_target(source(text), bend_test(4).scene, probes);
  }

  std::string refusal(const std::string& text, const std::string& probe = "force") {
    return message_of([&] { read(text, probe); });
  }

  calibrate::SceneTargetSource source(const std::string& text) {
    calibrate::SceneTargetSource source;
    source.file = folder_.write("bar.csv", text);
    source.abscissa = {"Displacement", {}, {"fit.toml", 4}};
    source.ordinate = {"Force", {}, {"fit.toml", 5}};
    return source;
  }

  /// Of a scene whose support follows the column.
  calibrate::SceneTarget read_driven(const std::string& text) {
    calibrate::SceneTarget driven;
    driven.kind = calibrate::Abscissa::Support;
    driven.driven = 1;
    driven.ordinate_probe = "force";
    return calibrate::read_scene_target(source(text), bend_test(4).scene, driven);
  }

  /// "kind: text", in their order.
  static std::vector<std::string> repairs_of(const std::vector<calibrate::Repair>& repairs) {
    std::vector<std::string> all;
    for (const calibrate::Repair& repair : repairs) {
      EXPECT_TRUE(repair.text.starts_with(std::to_string(repair.count)) || repair.count == 1);
      all.push_back(repair.kind + ": " + repair.text);
    }
    return all;
  }

  std::string file(const std::string& line) const { return folder_.file("bar.csv") + ":" + line; }

  io::ScratchFolder folder_;
};

}  // namespace plastica::testing
