#include "cli/mpi_wire.hpp"

#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace plastica::cli {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

// MPI's own waiting takes a whole processor, which others compute with. All waiting here looks now
// and then.
constexpr microseconds kShortWait{20};
constexpr microseconds kLongWait{1000};
/// How often process 0 is told how far another is.
constexpr milliseconds kTellInterval{200};

/// Waits twice as long each time, up to `kLongWait`.
class Patience {
 public:
  void wait() {
    std::this_thread::sleep_for(wait_);
    wait_ = std::min(2 * wait_, kLongWait);
  }
  void reset() { wait_ = kShortWait; }

 private:
  microseconds wait_ = kShortWait;
};

void check(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  throw std::runtime_error(std::string("MPI: ") + call + " failed");
}

// Messages between process 0 and another.
enum Tag : int {
  kAsk,     ///< to 0: the next number, and counts
  kAnswer,  ///< from 0: a number, or `kClosed`
  kCounts,  ///< to 0: counts
  kEnd,     ///< to 0: counts, and whether it was stopped
};

constexpr std::uint64_t kClosed = ~std::uint64_t{0};
/// Counts, and a word.
using Message = std::array<std::uint64_t, 4>;

int processors_of_process() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

int processors_of_machine() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

class Wire final : public MpiWire {
 public:
  Wire() {
    int given = MPI_THREAD_SINGLE;
    check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given), "MPI_Init_thread");
    if (given < MPI_THREAD_SERIALIZED) {
      throw std::runtime_error("MPI: is built without support for threads");
    }
    check(MPI_Comm_dup(MPI_COMM_WORLD, &all_), "MPI_Comm_dup");
    MPI_Comm_set_errhandler(all_, MPI_ERRORS_RETURN);
    MPI_Comm_rank(all_, &rank_);
    MPI_Comm_size(all_, &size_);
    MPI_Comm machine = MPI_COMM_NULL;
    check(MPI_Comm_split_type(all_, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine),
          "MPI_Comm_split_type");
    int neighbours = 1;
    MPI_Comm_size(machine, &neighbours);
    MPI_Comm_free(&machine);
    // A launcher may have bound the process to some of the processors.
    threads_ =
        std::clamp(processors_of_process(), 1, std::max(1, processors_of_machine() / neighbours));
  }

  ~Wire() override {
    if (desk_.joinable()) {
      // Only a defect leads here: the others would wait for ever.
      MPI_Abort(all_, 3);
    }
    MPI_Comm_free(&all_);
    MPI_Finalize();
  }

  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  std::size_t rank() const override { return static_cast<std::size_t>(rank_); }
  std::size_t size() const override { return static_cast<std::size_t>(size_); }
  int threads() const override { return threads_; }

  void watch(StopWatch watch) override {
    watch_ = std::move(watch);
    has_told_stop_ = false;
  }

  Words largest(const Words& own) override {
    Words heard{};
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Iallreduce(own.data(), heard.data(), static_cast<int>(own.size()), MPI_UINT64_T,
                         MPI_MAX, all_, &request),
          "MPI_Iallreduce");
    wait_for(request);
    return heard;
  }

  void open_counter() override {
    next_ = 0;
    closed_ = false;
    counts_ = {};
    told_.assign(size(), {});
    last_told_ = steady_clock::now();
    if (rank_ == 0) desk_ = std::thread([this] { serve(); });
  }

  std::optional<std::uint64_t> count_up() override {
    if (rank_ == 0) {
      if (closed_) return {};
      return next_++;
    }
    const std::lock_guard lock(mpi_);
    send(kAsk, 0);
    Message answer{};
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Irecv(answer.data(), static_cast<int>(answer.size()), MPI_UINT64_T, 0, kAnswer, all_,
                    &request),
          "MPI_Irecv");
    wait_for(request);
    if (answer[3] == kClosed) return {};
    return answer[3];
  }

  void close_counter() override { closed_ = true; }

  void end_counter(bool stopped) override {
    if (rank_ != 0) {
      const std::lock_guard lock(mpi_);
      send(kEnd, stopped ? 1 : 0);
      return;
    }
    if (desk_.joinable()) desk_.join();
    if (desk_failed_) std::rethrow_exception(std::exchange(desk_failed_, nullptr));
  }

  void tell(const Counts& own) override {
    if (rank_ == 0) return;
    const std::lock_guard lock(mpi_);
    counts_ = own;
    if (steady_clock::now() - last_told_ >= kTellInterval) send(kCounts, 0);
  }

  void on_told(std::function<void(const Counts&)> heard) override { heard_ = std::move(heard); }

 private:
  /// To process 0, with the counts.
  void send(Tag tag, std::uint64_t word) {
    const Message message{counts_[0], counts_[1], counts_[2], word};
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Isend(message.data(), static_cast<int>(message.size()), MPI_UINT64_T, 0, tag, all_,
                    &request),
          "MPI_Isend");
    wait_for(request);
    last_told_ = steady_clock::now();
  }

  void wait_for(MPI_Request request) {
    Patience patience;
    for (int done = 0; done == 0;) {
      check(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
      look_for_stop();
      if (done == 0) patience.wait();
    }
  }

  void look_for_stop() {
    if (is_raised(watch_.stop) && !has_told_stop_.exchange(true)) watch_.raised();
  }

  /// What process 0 does beside its own work until all others have ended.
  void serve() {
    try {
      Patience patience;
      std::size_t ended = 0;
      while (ended + 1 < size()) {
        look_for_stop();
        int there = 0;
        MPI_Status status;
        check(MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, all_, &there, &status), "MPI_Iprobe");
        if (there == 0) {
          patience.wait();
          continue;
        }
        patience.reset();
        if (take(status)) ++ended;
      }
    } catch (...) {
      desk_failed_ = std::current_exception();
      closed_ = true;
    }
  }

  /// Takes a message and answers it. @return whether the other has ended
  bool take(const MPI_Status& status) {
    Message message{};
    check(MPI_Recv(message.data(), static_cast<int>(message.size()), MPI_UINT64_T,
                   status.MPI_SOURCE, status.MPI_TAG, all_, MPI_STATUS_IGNORE),
          "MPI_Recv");
    Counts& told = told_[static_cast<std::size_t>(status.MPI_SOURCE)];
    const Counts now{message[0], message[1], message[2]};
    const bool news = now != told;
    told = now;
    if (status.MPI_TAG == kAsk) {
      const std::uint64_t number = closed_ ? kClosed : next_++;
      const Message answer{0, 0, 0, number};
      check(MPI_Send(answer.data(), static_cast<int>(answer.size()), MPI_UINT64_T,
                     status.MPI_SOURCE, kAnswer, all_),
            "MPI_Send");
    }
    const bool ends = status.MPI_TAG == kEnd;
    if (ends && message[3] != 0) closed_ = true;
    if (news && heard_) {
      Counts sum{};
      for (const Counts& one : told_) {
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += one[k];
      }
      heard_(sum);
    }
    return ends;
  }

  MPI_Comm all_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  int threads_ = 1;
  StopWatch watch_;
  std::atomic<bool> has_told_stop_ = false;
  std::mutex mpi_;  ///< of MPI, while work is shared, in other processes than 0
  std::thread desk_;
  std::exception_ptr desk_failed_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> closed_ = false;
  Counts counts_{};            ///< of this process
  std::vector<Counts> told_;   ///< of each, in process 0
  steady_clock::time_point last_told_;
  std::function<void(const Counts&)> heard_;
};

}  // namespace

std::unique_ptr<MpiWire> join_mpi() { return std::make_unique<Wire>(); }

}  // namespace plastica::cli
