#pragma once

#include <atomic>

namespace plastica {

/// A flag that any thread, or a signal handler, raises once so that work ends early; null: never.
using StopFlag = const std::atomic<bool>*;

/// Whether work is to end; costs a load from memory that nobody writes.
inline bool is_raised(StopFlag flag) {
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

}  // namespace plastica
