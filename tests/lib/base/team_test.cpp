#include "plastica/base/team.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/parallel_for.hpp"
#include "tests/support/thread_team.hpp"

namespace plastica {
namespace {

TEST(GuidedParts, HoldEachNumberOnceLargePartsFirst) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 64U, 1000U, 12345U}) {
    for (const std::size_t workers : {1U, 2U, 3U, 64U, 4096U}) {
      const GuidedParts parts(count, workers);
      std::size_t next = 0;
      std::size_t last_size = count + 1;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        ASSERT_EQ(parts[k].begin, next);
        ASSERT_GT(parts[k].end, parts[k].begin);
        const std::size_t size = parts[k].end - parts[k].begin;
        EXPECT_LE(size, last_size);
        last_size = size;
        next = parts[k].end;
      }
      EXPECT_EQ(next, count);
      if (parts.size() > 0) {
        EXPECT_EQ(last_size, 1U);
      }
    }
  }
  EXPECT_EQ(GuidedParts().size(), 0U);
}

// Half of what is left is handed out in as many parts as there are workers: by hand.
TEST(GuidedParts, HalveWhatIsLeft) {
  const GuidedParts parts(16, 2);
  std::vector<std::size_t> sizes;
  for (std::size_t k = 0; k < parts.size(); ++k) sizes.push_back(parts[k].end - parts[k].begin);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{4, 4, 2, 2, 1, 1, 1, 1}));
}

// Few takings, so that a team of thousands asks its leader some ten thousand times in all.
TEST(GuidedParts, AreFew) {
  EXPECT_LT(GuidedParts(1'000'000, 64).size(), 64U * 16U);
  EXPECT_LT(GuidedParts(1'000'000, 4096).size(), 4096U * 10U);
}

TEST(Team, DoesEachNumberOnceInWhicheverMember) {
  for (const std::size_t size : {1U, 2U, 5U}) {
    for (const std::size_t count : {0U, 1U, 3U, 1000U}) {
      std::vector<std::atomic<int>> done(count);
      std::vector<std::atomic<int>> once(count);
      const Ends ends = run_team(size, [&](Team& team) {
        for (auto* round : {&done, &once}) {  // the same team twice
          EXPECT_FALSE(team.share(count, nullptr, [&](const NextIndex& next) {
            while (const auto index = next()) ++(*round)[*index];
          }));
        }
      });
      rethrow(ends);
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i] * 10 + once[i], 11) << i;
    }
  }
}

TEST(Team, HandsOutToThreadsOfEachMember) {
  constexpr std::size_t kCount = 500;
  std::vector<std::atomic<int>> done(kCount);
  rethrow(run_team(3, [&](Team& team) {
    team.share(kCount, nullptr, [&](const NextIndex& next) {
      parallel_for(kCount, {2, nullptr, next}, [&](std::size_t i, int) { ++done[i]; });
    });
  }));
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(done[i], 1) << i;
}

TEST(Team, StopsWhereOneOfThemIsStopped) {
  for (const std::size_t stopped : {0U, 2U}) {
    std::atomic<std::size_t> done = 0;
    std::array<bool, 3> heard{};
    rethrow(run_team(3, [&](Team& team) {
      std::atomic<bool> stop = false;
      const auto work = [&](const NextIndex& next) {
        // The others wait until it is stopped, so that there is something left.
        for (auto index = next(); index; index = next()) {
          ++done;
          if (team.rank() == stopped) stop = true;
          if (stop) break;
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      };
      heard[team.rank()] = team.share(1000, &stop, work);
    }));
    EXPECT_LT(done, 1000U);
    EXPECT_EQ(heard, (std::array{true, true, true}));
  }
}

/// What each member of three threw: nothing, "left", or its error.
std::vector<std::string> ends_of(const std::function<void(Team&)>& work) {
  std::vector<std::string> texts;
  for (const std::exception_ptr& end : run_team(3, work)) {
    texts.emplace_back();
    if (!end) continue;
    try {
      std::rethrow_exception(end);
    } catch (const TeamLeft&) {
      texts.back() = "left";
    } catch (const std::exception& error) {
      texts.back() = error.what();
    }
  }
  return texts;
}

using Texts = std::vector<std::string>;

TEST(Team, EndsAllWhereOneFailsWhileWorkIsShared) {
  const auto failing = [](std::size_t rank) {
    return [rank](Team& team) {
      team.meet();
      std::atomic<std::size_t> begun = 0;
      team.share(1000, nullptr, [&](const NextIndex& next) {
        while (next()) {
          if (team.rank() == rank && ++begun == 2) throw std::runtime_error("a full disk");
        }
      });
      team.meet();
    };
  };
  EXPECT_EQ(ends_of(failing(0)), (Texts{"a full disk", "left", "left"}));
  EXPECT_EQ(ends_of(failing(2)), (Texts{"left", "left", "a full disk"}));
}

TEST(Team, EndsAllWhereOneFailsBetweenMeetings) {
  const auto failing = [](Team& team) {
    team.meet();
    if (team.rank() == 1) throw std::runtime_error("no file");
    team.agree(7, "inputs");
    team.share(10, nullptr, [](const NextIndex&) {});
  };
  EXPECT_EQ(ends_of(failing), (Texts{"left", "no file", "left"}));
}

TEST(Team, RefusesWhatIsNotTheSameInAll) {
  const auto digest_of = [](std::size_t other) {
    return [other](Team& team) { team.agree(team.rank() == other ? 3 : 7, "inputs"); };
  };
  const std::string refused = "processes = 3: do not have the same inputs";
  for (const std::size_t other : {0U, 1U, 2U}) {
    EXPECT_EQ(ends_of(digest_of(other)), (Texts{refused, "left", "left"})) << other;
  }
  EXPECT_EQ(ends_of(digest_of(3)), (Texts{"", "", ""}));
}

// Of several the first says why, so that there is one line.
TEST(Team, LetsTheFirstThatFailedSpeak) {
  const auto common = std::make_shared<ThreadWire::Common>(3);
  std::array<bool, 3> speaks{};
  std::vector<std::jthread> members;
  for (std::size_t rank = 0; rank < 3; ++rank) {
    members.emplace_back([&, rank] {
      Team team(std::make_unique<ThreadWire>(common, rank));
      speaks[rank] = team.leave(rank > 0);
    });
  }
  members.clear();
  EXPECT_EQ(speaks, (std::array{false, true, false}));
}

// What listens may be gone when an exception has left the leader's work.
TEST(Team, TellsNobodyOnceTheLeadersWorkHasFailed) {
  std::atomic<bool> has_left = false;
  std::atomic<int> too_late = 0;
  const Ends ends = run_team(3, [&](Team& team) {
    team.on_report([&](const Team::Counts&) { too_late += has_left ? 1 : 0; });
    try {
      team.share(100, nullptr, [&](const NextIndex& next) {
        std::uint64_t done = 0;
        while (next()) {
          if (team.leads()) throw std::runtime_error("a full disk");
          team.report({++done, 0, 0});
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        team.report({++done, 0, 0});  // of what was under way
      });
    } catch (const std::runtime_error&) {
      if (team.leads()) has_left = true;
      throw;
    }
  });
  EXPECT_EQ(too_late, 0);
  EXPECT_TRUE(ends[0] && ends[1] && ends[2]);
}

// The first part of a process is a quarter of all that there is to do.
TEST(Team, EndsItsPartsWhereAnotherIsStopped) {
  std::atomic<std::size_t> done = 0;
  rethrow(run_team(2, [&](Team& team) {
    const std::atomic<bool> stop = team.rank() == 1;
    team.share(4000, &stop, [&](const NextIndex& next) {
      while (next()) {
        ++done;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
  }));
  EXPECT_LT(done, 500U);
}

TEST(Team, TellsItsLeaderWhatTheOthersHaveCounted) {
  std::mutex mutex;
  Team::Counts last{};
  rethrow(run_team(3, [&](Team& team) {
    team.on_report([&](const Team::Counts& others) {
      const std::lock_guard lock(mutex);
      last = {std::max(last[0], others[0]), std::max(last[1], others[1]), 0};
    });
    team.share(100, nullptr, [&](const NextIndex&) { team.report({team.rank() * 10, 1, 0}); });
  }));
  EXPECT_EQ(last, (Team::Counts{30, 2, 0}));
}

}  // namespace
}  // namespace plastica
