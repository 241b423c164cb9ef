#pragma once

#include <string_view>

namespace plastica::calibrate {

/// The text of data/scenes/bend_test.toml and of data/targets/bend_test.csv, for `plastica init`.
std::string_view bend_test_scene();
std::string_view bend_test_curve();

}  // namespace plastica::calibrate
