#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

#include "plastica/base/next_index.hpp"

namespace plastica {

struct ParallelOptions {
  int threads = 0;  ///< how many; 0: as many as the machine has
  /// Once true, each worker begins no more than the index that it was about to begin; those under
  /// way are finished. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Gives the indices, each below `count` at most once. Empty: all of them, in order.
  NextIndex next{};
};

/// How many threads `threads` stands for: itself, or all of the machine's for 0.
int resolved_threads(int threads);

/// Calls `body(index, worker)` once for each index below `count`, or for those that
/// `options.next` gives, in parallel.
///
/// Indices are handed out in order, one at a time, to whichever worker is free; worker numbers
/// (0 … threads-1) let a body keep one workspace a thread. A body that throws stops the handing
/// out; of all exceptions thrown, the one of the smallest index leaves this function, whole.
/// @throws MachineError if the system does not make so many threads, or their stacks (of
///         OMP_STACKSIZE) are too small
void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t index, int worker)>& body);

}  // namespace plastica
