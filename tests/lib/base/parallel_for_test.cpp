#include "plastica/base/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace plastica {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 3, 8}) {
    std::vector<int> visits(1000, 0);
    parallel_for(visits.size(), {threads}, [&](std::size_t i, int) { ++visits[i]; });
    for (const int count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, GivesWorkersNumbersBelowTheThreadCount) {
  std::vector<int> worker_of(100, -1);
  parallel_for(worker_of.size(), {3}, [&](std::size_t i, int worker) { worker_of[i] = worker; });
  for (const int worker : worker_of) {
    EXPECT_GE(worker, 0);
    EXPECT_LT(worker, 3);
  }
}

TEST(ParallelFor, CarriesTheExceptionOfTheSmallestIndexWhole) {
  for (const int threads : {1, 4}) {
    try {
      parallel_for(4, {threads}, [](std::size_t i, int) {
        throw std::domain_error("index " + std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::domain_error& error) {
      EXPECT_STREQ(error.what(), "index 0");
    }
  }
}

TEST(ParallelFor, EachOtherWorkerBeginsAtMostOneMoreOnceStopped) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<bool> stop{false};
    std::atomic<int> begun{0};
    parallel_for(1000, {threads, &stop}, [&](std::size_t, int) {
      const int order = ++begun;
      if (order == 10) stop = true;
      // So that none of these ends before the flag is set, however the threads are scheduled.
      while (order > 10 && !stop) std::this_thread::yield();
    });
    EXPECT_GE(begun.load(), 10);
    EXPECT_LE(begun.load(), 10 + threads - 1);
  }
}

TEST(ParallelFor, BeginsNothingWhenStoppedBefore) {
  const std::atomic<bool> stop{true};
  parallel_for(100, {2, &stop}, [](std::size_t, int) { FAIL(); });
}

TEST(ParallelFor, DoesNothingForAnEmptyRange) {
  parallel_for(0, {}, [](std::size_t, int) { FAIL(); });
}

}  // namespace
}  // namespace plastica
