#include "calibrate/inference/scene_work.hpp"

#include <mutex>

#include "plastica/base/parallel_for.hpp"

namespace plastica::calibrate {

void SceneWork::tell(const Stage& stage, std::size_t done) const {
  if (!hooks_.progress) return;
  const std::size_t total = stage.total > 0 ? stage.total : stage.tasks;
  hooks_.progress({stage.name, static_cast<int>(done * total / stage.tasks),
                   static_cast<int>(total), problem_.counters().runs + counters_.runs});
}

std::vector<TaskRecord> SceneWork::make(const Stage& stage,
                                        const std::function<TaskRecord(std::size_t)>& task) {
  std::vector<TaskRecord> made(stage.tasks);
  if (made.empty()) return made;
  const auto name_of = [&](std::size_t i) {
    return std::string(stage.name) + " " + std::to_string(i);
  };
  // What is kept is looked up before anything is added to it.
  std::size_t done = 0;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::vector<std::byte>* kept = hooks_.find ? hooks_.find(name_of(i)) : nullptr;
    if (kept == nullptr) {
      missing.push_back(i);
      continue;
    }
    made[i] = task_record_from(*kept);
    counters_.add(made[i].runs);
    ++done;
  }
  tell(stage, done);
  std::mutex mutex;
  parallel_for(missing.size(), {stage.threads}, [&](std::size_t k, int) {
    const std::size_t i = missing[k];
    made[i] = task(i);
    const std::lock_guard lock(mutex);
    if (hooks_.keep) hooks_.keep(name_of(i), bytes_of(made[i]));
    counters_.add(made[i].runs);
    tell(stage, ++done);
  });
  return made;
}

}  // namespace plastica::calibrate
