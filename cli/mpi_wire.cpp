#include "cli/mpi_wire.hpp"

#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cli/exit_code.hpp"

namespace plastica::cli {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

// MPI's own waiting takes a whole processor, which others compute with. All waiting here looks now
// and then.
constexpr microseconds kShortWait{20};
constexpr microseconds kLongWait{1000};
/// How often process 0 hears how far another is.
constexpr milliseconds kReportInterval{200};

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
  kAsk,        ///< to 0: the next number, and counts
  kAskClosed,  ///< to 0: whether the counter is closed, and counts
  kAnswer,     ///< from 0: a number, or `kClosed`
  kCounts,     ///< to 0: counts
  kEnd,        ///< to 0: counts, and whether it was stopped
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
      give_up("left a team whose work is shared");  // a defect
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
    has_said_stop_ = false;
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
    reported_.assign(size(), {});
    last_reported_ = last_asked_ = steady_clock::now();
    if (rank_ != 0) return;
    try {
      desk_ = std::thread([this] { serve(); });
    } catch (const std::system_error&) {
      give_up("cannot make a thread");
    }
  }

  std::optional<std::uint64_t> count_up() override {
    if (rank_ == 0) {
      if (closed_) return {};
      return next_++;
    }
    const std::lock_guard lock(mpi_);
    const std::uint64_t number = ask(kAsk);
    if (number == kClosed) return {};
    return number;
  }

  bool is_closed() override {
    if (rank_ == 0 || closed_) return closed_;
    if (steady_clock::now() - last_asked_ < kReportInterval) return false;
    const std::lock_guard lock(mpi_);
    closed_ = ask(kAskClosed) == kClosed;
    return closed_;
  }

  void close_counter() override { closed_ = true; }

  void end_counter(bool stopped) override {
    if (rank_ != 0) {
      const std::lock_guard lock(mpi_);
      send(kEnd, stopped ? 1 : 0);
      return;
    }
    if (desk_.joinable()) desk_.join();
  }

  void report(const Counts& own) override {
    if (rank_ == 0) return;
    const std::lock_guard lock(mpi_);
    counts_ = own;
    if (steady_clock::now() - last_reported_ >= kReportInterval) send(kCounts, 0);
  }

  void on_report(std::function<void(const Counts&)> heard) override { heard_ = std::move(heard); }

 private:
  /// Asks process 0. @return its word
  std::uint64_t ask(Tag question) {
    send(question, 0);
    Message answer{};
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Irecv(answer.data(), static_cast<int>(answer.size()), MPI_UINT64_T, 0, kAnswer, all_,
                    &request),
          "MPI_Irecv");
    wait_for(request);
    last_asked_ = steady_clock::now();
    return answer[3];
  }

  /// To process 0, with the counts.
  void send(Tag tag, std::uint64_t word) {
    const Message message{counts_[0], counts_[1], counts_[2], word};
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Isend(message.data(), static_cast<int>(message.size()), MPI_UINT64_T, 0, tag, all_,
                    &request),
          "MPI_Isend");
    wait_for(request);
    last_reported_ = steady_clock::now();
  }

  void wait_for(MPI_Request request) {
    Patience patience;
    for (int done = 0; done == 0;) {
      check(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
      if (done != 0) return;  // nobody is missed
      look_for_stop();
      patience.wait();
    }
  }

  void look_for_stop() {
    if (!has_said_stop_ && is_raised(watch_.stop) && watch_.raised()) has_said_stop_ = true;
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
    } catch (const std::exception& error) {
      give_up(error.what());
    }
  }

  /// Ends all processes: those that wait for this one would wait for ever. What they have finished
  /// is in their journals.
  void give_up(const char* what) const {
    std::fprintf(stderr, "plastica: %s\n", what);
    MPI_Abort(all_, kMachineFailed);
  }

  /// Takes a message and answers it. @return whether the other has ended
  bool take(const MPI_Status& status) {
    Message message{};
    check(MPI_Recv(message.data(), static_cast<int>(message.size()), MPI_UINT64_T,
                   status.MPI_SOURCE, status.MPI_TAG, all_, MPI_STATUS_IGNORE),
          "MPI_Recv");
    Counts& reported = reported_[static_cast<std::size_t>(status.MPI_SOURCE)];
    const Counts now{message[0], message[1], message[2]};
    const bool news = now != reported;
    reported = now;
    if (status.MPI_TAG == kAsk || status.MPI_TAG == kAskClosed) {
      const bool takes = status.MPI_TAG == kAsk;
      const std::uint64_t number = closed_ ? kClosed : takes ? next_++ : 0;
      const Message answer{0, 0, 0, number};
      check(MPI_Send(answer.data(), static_cast<int>(answer.size()), MPI_UINT64_T,
                     status.MPI_SOURCE, kAnswer, all_),
            "MPI_Send");
    }
    const bool ends = status.MPI_TAG == kEnd;
    if (ends && message[3] != 0) closed_ = true;
    if (news && heard_) {
      Counts sum{};
      for (const Counts& one : reported_) {
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
  std::atomic<bool> has_said_stop_ = false;
  std::mutex mpi_;  ///< of MPI, while work is shared, in other processes than 0
  std::thread desk_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> closed_ = false;
  Counts counts_{};               ///< of this process
  std::vector<Counts> reported_;  ///< of each, in process 0
  steady_clock::time_point last_reported_;
  steady_clock::time_point last_asked_;
  std::function<void(const Counts&)> heard_;
};

}  // namespace

std::unique_ptr<MpiWire> join_mpi() { return std::make_unique<Wire>(); }

}  // namespace plastica::cli
