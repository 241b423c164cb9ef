#pragma once

#include <string_view>

/// What every page holds beside its data; not installed.
namespace plastica::report::assets {

std::string_view style();   ///< of assets/page.css
std::string_view script();  ///< of all scripts in assets, one after another
std::string_view
chart_library();  ///< Chart.js as the machine of the build has it; empty: it had not
std::string_view chart_license();

}  // namespace plastica::report::assets
