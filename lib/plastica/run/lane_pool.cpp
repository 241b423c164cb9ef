#include "plastica/run/lane_pool.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <utility>

namespace plastica {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void LanePool::add(WaitingCase&& one, const Take& take) {
  const ChainModel& model = *one.model->chain;
  auto shape = std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& s) {
    return !s.waiting.empty() && same_lanes(*s.waiting.front().model->chain, model);
  });
  if (shape == shapes_.end()) {
    Shape fresh{make_lane_program(model), {}};
    shapes_.push_back(std::move(fresh));
    shape = shapes_.end() - 1;
  }
  shape->waiting.push_back(std::move(one));
  if (shape->waiting.size() < shape->program->width()) return;
  Shape full = std::move(*shape);
  shapes_.erase(shape);
  run(full, take);
}

void LanePool::merge(LanePool&& other, const Take& take) {
  for (Shape& shape : other.shapes_) {
    for (WaitingCase& one : shape.waiting) add(std::move(one), take);
  }
  other.shapes_.clear();
}

void LanePool::finish(const Take& take) {
  for (Shape& shape : shapes_) run(shape, take);
  shapes_.clear();
}

void LanePool::run(Shape& shape, const Take& take) {
  std::vector<LaneCase> cases;
  cases.reserve(shape.waiting.size());
  for (WaitingCase& one : shape.waiting) {
    cases.push_back({one.model->chain.get(), &one.model->material, &one.hooks, &one.row.response});
  }
  const double begin = thread_seconds();
  try {
    shape.program->run(cases);
  } catch (const std::exception& error) {
    // Out of memory, or a defect: the other cases of the batch go on.
    for (WaitingCase& one : shape.waiting) {
      one.row.response = {};
      one.row.reason = error.what();
    }
  }
  const double seconds = (thread_seconds() - begin) / static_cast<double>(cases.size());
  for (WaitingCase& one : shape.waiting) {
    one.row.response.seconds = seconds;
    take(one.index, std::move(one.row));
  }
}

}  // namespace plastica
