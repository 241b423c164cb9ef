#pragma once

#include <string>
#include <string_view>

namespace plastica::report {

/// A user's text as `printable` has it, for an attribute or the content of an element of XML.
std::string xml_text(std::string_view text);

}  // namespace plastica::report
