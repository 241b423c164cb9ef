#pragma once

#include <atomic>

namespace plastica::cli {

/// While it lives, Ctrl-C and SIGTERM only raise a flag, so that work ends in order; a second
/// Ctrl-C ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  const std::atomic<bool>& flag() const;
};

}  // namespace plastica::cli
