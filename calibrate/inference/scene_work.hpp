#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/problem/scene_problem.hpp"
#include "calibrate/search/search_record.hpp"

namespace plastica::calibrate {

/// Tasks that follow a search: repetitions, profiles, resamples. Those that an
/// earlier, interrupted fit has kept are taken from it, the others are made and kept.
class SceneWork {
 public:
  /// @param problem  whose runs are told of beside those of the tasks
  /// All must outlive this.
  SceneWork(const SceneProblem& problem, const SceneFitHooks& hooks)
      : problem_(problem), hooks_(hooks) {}

  struct Stage {
    std::string_view name;
    std::size_t tasks = 0;
    int threads = 1;        ///< that make tasks side by side
    std::size_t total = 0;  ///< that the tasks are made of, for those who watch; 0: the tasks
  };
  /// Makes each task by its index. One that throws ends the work; what is finished is kept.
  /// @return in their order
  std::vector<TaskRecord> make(const Stage& stage,
                               const std::function<TaskRecord(std::size_t)>& task);

  const RunCounters& counters() const { return counters_; }  ///< of all tasks

 private:
  void tell(const Stage& stage, std::size_t done) const;

  const SceneProblem& problem_;
  const SceneFitHooks& hooks_;
  RunCounters counters_;
};

}  // namespace plastica::calibrate
