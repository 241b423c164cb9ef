#include "plastica/base/parallel_for.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#ifdef PLASTICA_THREADS_STD
#include <vector>
#endif

namespace plastica {
namespace {

/// Hands out indices and keeps the exception of the smallest one.
class Queue {
 public:
  Queue(std::size_t count, const std::atomic<bool>* stop) : count_(count), stop_(stop) {}

  void work(int worker, const std::function<void(std::size_t, int)>& body) {
    while (!failed_ && !(stop_ != nullptr && *stop_)) {
      const std::size_t index = next_++;
      if (index >= count_) return;
      try {
        body(index, worker);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (index < failed_index_) {
          failed_index_ = index;
          error_ = std::current_exception();
        }
        failed_ = true;
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::size_t count_;
  const std::atomic<bool>* stop_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::size_t failed_index_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr error_;
};

}  // namespace

int resolved_threads(int threads) {
  if (threads > 0) return threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t, int)>& body) {
  if (count == 0) return;
  const int threads = static_cast<int>(
      std::min(count, static_cast<std::size_t>(resolved_threads(options.threads))));
  Queue queue(count, options.stop);
#ifdef PLASTICA_THREADS_STD
  // ThreadSanitizer does not know GCC's OpenMP runtime; it does know these.
  std::vector<std::jthread> workers;
  for (int worker = 1; worker < threads; ++worker) {
    workers.emplace_back([&queue, &body, worker] { queue.work(worker, body); });
  }
  queue.work(0, body);
  workers.clear();
#else
#pragma omp parallel for num_threads(threads) schedule(static, 1)
  for (int worker = 0; worker < threads; ++worker) queue.work(worker, body);
#endif
  queue.rethrow();
}

}  // namespace plastica
