#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace plastica {

struct ParallelOptions {
  int threads = 0;  ///< how many; 0: as many as the machine has
  /// Once true, each worker begins no more than the index that it was about to begin; those under
  /// way are finished. May be null.
  const std::atomic<bool>* stop = nullptr;
};

/// How many threads `threads` stands for: itself, or all of the machine's for 0.
int resolved_threads(int threads);

/// Calls `body(index, worker)` once for each index below `count`, in parallel.
///
/// Indices are handed out in order, one at a time, to whichever worker is free; worker numbers
/// (0 … threads-1) let a body keep one workspace a thread. A body that throws stops the handing
/// out; of all exceptions thrown, the one of the smallest index leaves this function, whole.
/// @throws MachineError if the system does not make so many threads, or their stacks (of
///         OMP_STACKSIZE) are too small
void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t index, int worker)>& body);

}  // namespace plastica
