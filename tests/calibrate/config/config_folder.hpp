#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/message.hpp"

namespace plastica::calibrate {

/// A test with a folder of its own for fit files and curves; errors are shown without its path.
class ConfigFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        std::filesystem::path(::testing::TempDir()) /
        (std::string(test->test_suite_name()) + "_" + test->name() + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void write(const std::string& name, const std::string& text = "Strain,Stress\n0,0\n1,1\n") const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }

  /// A text without the path of the folder.
  std::string local(std::string text) const {
    const std::string prefix = folder_.string();
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      const bool whole = text.compare(at + prefix.size(), 1, "/") != 0;
      text.replace(at, prefix.size() + (whole ? 0 : 1), whole ? "FOLDER" : "");
    }
    return text;
  }

  template <typename Action>
  std::string error_of(const Action& action) const {
    return local(testing::message_of(action));
  }

  std::filesystem::path folder_;
};

}  // namespace plastica::calibrate
