#include "python/bindings/background.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace py = pybind11;

namespace plastica::python {
namespace {

constexpr auto kListen = std::chrono::milliseconds(50);

/// Work under way and how it ended.
class Worker {
 public:
  explicit Worker(const std::function<void(const Background&)>& work)
      : thread_([this, &work] {
          try {
            work({&stop_, [this](double now) { progress_.store(now); }});
          } catch (...) {
            thrown_ = std::current_exception();
          }
          const std::lock_guard lock(mutex_);
          ended_ = true;
          changed_.notify_one();
        }) {}
  ~Worker() { thread_.join(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// @return whether the work has ended
  bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kListen, [this] { return ended_; });
  }
  void stop() { stop_.store(true); }
  double progress() const { return progress_.load(); }
  /// Of work that has ended.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<double> progress_{-1.0};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::exception_ptr thrown_;
  std::thread thread_;  // the last: it uses all the others
};

}  // namespace

void in_background(const std::function<void(const Background&)>& work, const py::object& progress) {
  std::optional<py::error_already_set> raised;
  std::exception_ptr thrown;
  {
    py::gil_scoped_release released;
    Worker worker(work);
    double last = -1.0;
    while (!worker.wait()) {
      py::gil_scoped_acquire held;
      if (raised) continue;
      const double now = worker.progress();
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!progress.is_none() && now != last) {
          progress(now);
          last = now;
        }
      } catch (py::error_already_set& error) {
        raised.emplace(error);
        worker.stop();
      } catch (...) {
        worker.stop();
        throw;
      }
    }
    try {
      worker.rethrow();
    } catch (...) {
      thrown = std::current_exception();
    }
  }
  if (raised) throw py::error_already_set(std::move(*raised));
  if (thrown) std::rethrow_exception(thrown);
  if (!progress.is_none()) progress(-1.0);
}

}  // namespace plastica::python
