#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace plastica::testing {

/// Path of a file or folder in `../shared`, the data and tables that a user's clone does not have.
inline std::string shared_path(const std::string& name) {
  return std::filesystem::path(PLASTICA_SOURCE_DIR).parent_path() / "shared" / name;
}

/// Whether the environment makes a test that lacks its data a failure (PLASTICA_REQUIRE_SHARED=1).
inline bool shared_is_required() {
  const char* value = std::getenv("PLASTICA_REQUIRE_SHARED");
  return value != nullptr && std::string(value) == "1";
}

}  // namespace plastica::testing

/// First line of a test that reads `../shared/NAME`: skips it where that is absent, or fails it
/// where the environment requires the data.
#define PLASTICA_NEEDS_SHARED(name)                                       \
  if (!std::filesystem::exists(plastica::testing::shared_path(name))) {   \
    if (plastica::testing::shared_is_required()) {                        \
      FAIL() << plastica::testing::shared_path(name) << " is absent";     \
    }                                                                     \
    GTEST_SKIP() << plastica::testing::shared_path(name) << " is absent"; \
  }                                                                       \
  static_assert(true)
