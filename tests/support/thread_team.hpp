#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "plastica/base/team.hpp"

namespace plastica {

/// A team whose processes are threads of this one: what `Team` does, without MPI. None of them
/// counts further ahead of another than by one, so that each gets its part however fast it is.
class ThreadWire : public TeamWire {
 public:
  /// What its members share.
  struct Common {
    explicit Common(std::size_t members) : size(members) {}

    std::size_t size;
    std::mutex mutex;
    std::condition_variable all_are_here;
    std::size_t here = 0;
    std::size_t meetings = 0;
    Words words{};  ///< of the meeting that gathers
    Words heard{};  ///< of the last one
    std::uint64_t next = 0;
    bool closed = false;
    static constexpr std::size_t kEnded = ~std::size_t{0};
    std::vector<std::size_t> taken;  ///< by each member, or `kEnded`
    std::condition_variable somebody_took;
    std::vector<Counts> reported;
    std::function<void(const Counts&)> listener;
  };

  ThreadWire(std::shared_ptr<Common> common, std::size_t rank)
      : common_(std::move(common)), rank_(rank) {}

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return common_->size; }

  Words largest(const Words& own) override {
    std::unique_lock lock(common_->mutex);
    for (std::size_t k = 0; k < own.size(); ++k) {
      common_->words[k] = std::max(common_->words[k], own[k]);
    }
    const std::size_t meeting = common_->meetings;
    if (++common_->here == common_->size) {
      common_->heard = common_->words;
      common_->words = {};
      common_->here = 0;
      ++common_->meetings;
      common_->all_are_here.notify_all();
    }
    common_->all_are_here.wait(lock, [&] { return common_->meetings != meeting; });
    return common_->heard;
  }

  void open_counter() override {
    {
      const std::lock_guard lock(common_->mutex);
      common_->next = 0;
      common_->closed = false;
      common_->taken.assign(common_->size, 0);
      common_->reported.assign(common_->size, {});
    }
    largest({});  // nobody counts before all have opened it
  }
  std::optional<std::uint64_t> count_up() override {
    std::unique_lock lock(common_->mutex);
    common_->somebody_took.wait(lock, [&] {
      return common_->closed || common_->taken[rank_] <= *std::ranges::min_element(common_->taken);
    });
    if (common_->closed) return {};
    ++common_->taken[rank_];
    common_->somebody_took.notify_all();
    return common_->next++;
  }
  bool is_closed() override {
    const std::lock_guard lock(common_->mutex);
    return common_->closed;
  }
  void close_counter() override {
    const std::lock_guard lock(common_->mutex);
    common_->closed = true;
    common_->somebody_took.notify_all();
  }
  void end_counter(bool stopped) override {
    if (stopped) close_counter();
    {
      const std::lock_guard lock(common_->mutex);
      common_->taken[rank_] = Common::kEnded;
      common_->somebody_took.notify_all();
    }
    largest({});
  }
  void report(const Counts& own) override {
    if (rank_ == 0) return;
    const std::lock_guard lock(common_->mutex);
    common_->reported[rank_] = own;
    Counts others{};
    for (const Counts& one : common_->reported) {
      for (std::size_t k = 0; k < others.size(); ++k) others[k] += one[k];
    }
    if (common_->listener) common_->listener(others);
  }
  void on_report(std::function<void(const Counts&)> heard) override {
    const std::lock_guard lock(common_->mutex);
    if (rank_ == 0) common_->listener = std::move(heard);
  }

 private:
  std::shared_ptr<Common> common_;
  std::size_t rank_;
};

/// What became of each member: what it threw, if it threw.
using Ends = std::vector<std::exception_ptr>;

/// Runs `work` in each member of a team of so many, and lets each leave it.
template <class Work>
Ends run_team(std::size_t size, const Work& work) {
  const auto common = std::make_shared<ThreadWire::Common>(size);
  Ends ends(size);
  std::vector<std::jthread> members;
  for (std::size_t rank = 0; rank < size; ++rank) {
    members.emplace_back([&, rank] {
      Team team(std::make_unique<ThreadWire>(common, rank));
      bool failed = false;
      try {
        work(team);
      } catch (const TeamLeft&) {
        ends[rank] = std::current_exception();
      } catch (...) {
        ends[rank] = std::current_exception();
        failed = true;
      }
      team.leave(failed);
    });
  }
  members.clear();
  return ends;
}

/// Throws what a member of the team threw, the first that did not throw because of another.
inline void rethrow(const Ends& ends) {
  for (const std::exception_ptr& end : ends) {
    if (!end) continue;
    try {
      std::rethrow_exception(end);
    } catch (const TeamLeft&) {
      continue;
    }
  }
}

}  // namespace plastica
