#include "calibrate/scene/scene_work.hpp"

#include <mutex>

#include "plastica/base/parallel_for.hpp"

namespace plastica::calibrate {

void SceneWork::tell(const Stage& stage, std::size_t done) const {
  if (!hooks_.progress) return;
  const std::size_t total = stage.total > 0 ? stage.total : stage.pieces;
  hooks_.progress({stage.name, static_cast<int>(done * total / stage.pieces),
                   static_cast<int>(total), problem_.counters().runs + counters_.runs});
}

std::vector<PieceRecord> SceneWork::make(const Stage& stage,
                                         const std::function<PieceRecord(std::size_t)>& piece) {
  std::vector<PieceRecord> made(stage.pieces);
  if (made.empty()) return made;
  tell(stage, 0);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(made.size(), {stage.threads}, [&](std::size_t i, int) {
    const std::string name = std::string(stage.name) + " " + std::to_string(i);
    const std::vector<std::byte>* kept = hooks_.find ? hooks_.find(name) : nullptr;
    made[i] = kept != nullptr ? piece_record_from(*kept) : piece(i);
    const std::lock_guard lock(mutex);
    if (kept == nullptr && hooks_.keep) hooks_.keep(name, bytes_of(made[i]));
    counters_.add(made[i].runs);
    tell(stage, ++done);
  });
  return made;
}

}  // namespace plastica::calibrate
