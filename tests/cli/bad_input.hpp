#pragma once

#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/command.hpp"

namespace plastica::testing {

/// Files in a folder, a command line, and the one line that the command answers with.
struct BadInput {
  std::string name;
  std::map<std::string, std::string> files;
  std::vector<std::string> arguments;
  /// The line behind "plastica: ", whole; one that ends with "…" may go on in any words.
  std::string line;
};

inline std::ostream& operator<<(std::ostream& out, const BadInput& input) {
  return out << input.name;
}

/// A text with one piece changed, which must be in it.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error(from + " is not in the text");
  return text.replace(at, from.size(), to);
}

/// What `simulate` answers to a scene file.
/// @param files  beside it
/// @param line   behind the file's name
inline BadInput bad_scene(std::string name, std::string text, const std::string& line,
                          std::map<std::string, std::string> files = {}) {
  files["scene.toml"] = std::move(text);
  return {std::move(name),
          std::move(files),
          {"simulate", "scene.toml", "-o", "out.csv"},
          "scene.toml:" + line};
}

/// The name of a case, for INSTANTIATE_TEST_SUITE_P.
inline std::string name_of_case(const ::testing::TestParamInfo<BadInput>& info) {
  return info.param.name;
}

/// Expects exit code 2, the line on stderr, silence on stdout, and every file as it was.
inline void expect_refusal(const BadInput& input) {
  const Workplace place;
  for (const auto& [name, content] : input.files) place.write(name, content);
  const auto before = place.contents();
  const CommandResult result = place.run(input.arguments);
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(lines_of(result.err), 1U) << result.err;
  const std::string dots = "…";
  if (input.line.ends_with(dots)) {
    const std::string beginning =
        "plastica: " + input.line.substr(0, input.line.size() - dots.size());
    EXPECT_EQ(result.err.substr(0, beginning.size()), beginning) << result.err;
    EXPECT_GT(result.err.size(), beginning.size() + 1);
  } else {
    EXPECT_EQ(result.err, "plastica: " + input.line + "\n");
  }
  EXPECT_EQ(place.contents(), before);
}

}  // namespace plastica::testing
