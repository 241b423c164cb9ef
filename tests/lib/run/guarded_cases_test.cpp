#include "plastica/run/guarded_cases.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <vector>

namespace plastica {
namespace {

/// Runs cases of which some cannot be run; what has begun before is lost.
struct Runs {
  std::vector<std::size_t> failing;
  int calls = 0;

  void operator()(std::size_t first, std::span<Response> responses) {
    ++calls;
    for (std::size_t k = 0; k < responses.size(); ++k) {
      responses[k].status = Status::NonFinite;  // half done
      for (const std::size_t bad : failing) {
        if (first + k == bad && bad % 2 == 0) throw std::bad_alloc();
        if (first + k == bad) throw 7;
      }
      responses[k].samples = 100 + first + k;
      responses[k].status = Status::Completed;
    }
  }
};

TEST(GuardedCases, RunTogetherWhereNoneFails) {
  std::vector<Response> responses(4);
  Runs runs{{}};
  run_guarded(10, std::span(responses), runs);
  EXPECT_EQ(runs.calls, 1);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(responses[k].samples, 110 + k);
}

TEST(GuardedCases, ThatFailAreEmptyAndTheOthersGoOn) {
  std::vector<Response> responses(5);
  Runs runs{{12, 13}};
  run_guarded(10, std::span(responses), runs);
  for (std::size_t k = 0; k < 5; ++k) {
    const bool fails = k == 2 || k == 3;
    EXPECT_EQ(responses[k].status, fails ? Status::NotRun : Status::Completed) << k;
    EXPECT_EQ(responses[k].samples, fails ? 0 : 110 + k) << k;
  }
}

TEST(GuardedCases, ThatRunAloneAreNotTriedAgain) {
  std::vector<Response> responses(1);
  Runs runs{{12}};
  run_guarded(12, std::span(responses), runs);
  EXPECT_EQ(runs.calls, 1);
  EXPECT_EQ(responses[0].status, Status::NotRun);
}

}  // namespace
}  // namespace plastica
