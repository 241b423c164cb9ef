#pragma once

#include <cstddef>

#include "plastica/run/response.hpp"

namespace plastica::cli {

/// Bytes that the numbers of a response take.
std::size_t response_bytes(const Response& response);

}  // namespace plastica::cli
