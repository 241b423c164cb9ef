#include "plastica/base/parallel_for.hpp"

#include <pthread.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <latch>
#include <limits>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "plastica/base/machine_error.hpp"

namespace plastica {
namespace {

/// A thread needs less than 24 KiB for what the library does; the rest is for callers.
constexpr std::size_t kStackBytes = 128 * 1024;

/// Whether the calling thread's stack is large enough. An overflow would end the program.
bool has_room() {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return true;
  std::size_t bytes = kStackBytes;
  pthread_attr_getstacksize(&attributes, &bytes);
  pthread_attr_destroy(&attributes);
  return bytes >= kStackBytes;
}

[[noreturn]] void refuse_threads(int threads, int error) {
  throw MachineError("cannot make " + std::to_string(threads) + " threads: " +
                     std::strerror(error) + "; give fewer (--threads), or smaller stacks");
}

#ifndef PLASTICA_THREADS_STD
/// The stack that OpenMP gives to its threads: OMP_STACKSIZE, a number of B, K (where it says no
/// unit), M or G; 0 for the system's. Source: OpenMP 5.0, 6.7.
std::size_t openmp_stack_bytes() {
  const char* text = std::getenv("OMP_STACKSIZE");
  if (text == nullptr) text = std::getenv("GOMP_STACKSIZE");
  if (text == nullptr) return 0;
  char* end = nullptr;
  const unsigned long long number = std::strtoull(text, &end, 10);
  while (*end == ' ') ++end;
  switch (*end) {
    case 'b':
    case 'B': return number;
    case 'm':
    case 'M': return number << 20U;
    case 'g':
    case 'G': return number << 30U;
    default: return number << 10U;
  }
}

void* wait_for(void* latch) {
  static_cast<std::latch*>(latch)->wait();
  return nullptr;
}

/// Makes as many threads as OpenMP may have to add to those that it keeps for the calling thread,
/// and lets them go: OpenMP ends the program where it cannot make one.
void try_threads(int threads) {
  thread_local int kept = 1;  // OpenMP keeps those of the last team, for each calling thread
  if (threads > kept) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    // A size that the system refuses is not taken by OpenMP either.
    if (const std::size_t bytes = openmp_stack_bytes(); bytes > 0) {
      pthread_attr_setstacksize(&attributes, bytes);
    }
    std::latch all_made(1);
    std::vector<pthread_t> tried(static_cast<std::size_t>(threads - kept));
    std::size_t made = 0;
    int error = 0;
    while (made < tried.size() && error == 0) {
      error = pthread_create(&tried[made], &attributes, wait_for, &all_made);
      if (error == 0) ++made;
    }
    all_made.count_down();
    for (std::size_t i = 0; i < made; ++i) pthread_join(tried[i], nullptr);
    pthread_attr_destroy(&attributes);
    if (error != 0) refuse_threads(threads, error);
  }
  if (threads > 1) kept = threads;
}
#endif

/// Hands out indices and keeps the exception of the smallest one.
class Queue {
 public:
  Queue(std::size_t count, const ParallelOptions& options)
      : count_(count), stop_(options.stop), given_(options.next) {}

  void work(int worker, const std::function<void(std::size_t, int)>& body) {
    // The caller's own stack has carried it so far.
    if (worker > 0 && !has_room()) {
      const std::lock_guard lock(mutex_);
      failed_index_ = 0;
      error_ = std::make_exception_ptr(
          MachineError("the stacks of threads are too small: set OMP_STACKSIZE, or ulimit -s, to " +
                       std::to_string(kStackBytes / 1024) + "k or more"));
      failed_ = true;
    }
    while (!failed_ && !(stop_ != nullptr && *stop_)) {
      std::size_t index = 0;
      try {
        const std::optional<std::size_t> next = next_index();
        if (!next) return;
        index = *next;
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
  std::optional<std::size_t> next_index() {
    if (given_) return given_();
    const std::size_t index = next_++;
    return index < count_ ? std::optional(index) : std::nullopt;
  }

  std::size_t count_;
  const std::atomic<bool>* stop_;
  const NextIndex& given_;
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
  Queue queue(count, options);
#ifdef PLASTICA_THREADS_STD
  // ThreadSanitizer does not know GCC's OpenMP runtime; it does know these.
  std::vector<std::jthread> workers;
  try {
    for (int worker = 1; worker < threads; ++worker) {
      workers.emplace_back([&queue, &body, worker] { queue.work(worker, body); });
    }
  } catch (const std::system_error& error) {
    refuse_threads(threads, error.code().value());
  }
  queue.work(0, body);
  workers.clear();
#else
  try_threads(threads);
#pragma omp parallel for num_threads(threads) schedule(static, 1)
  for (int worker = 0; worker < threads; ++worker) queue.work(worker, body);
#endif
  queue.rethrow();
}

}  // namespace plastica
