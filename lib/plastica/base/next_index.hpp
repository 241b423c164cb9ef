#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace plastica {

/// Hands out indices, each once; nothing: none is left. May be called by several threads.
using NextIndex = std::function<std::optional<std::size_t>()>;

}  // namespace plastica
