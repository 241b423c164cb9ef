#include "plastica/run/lane_pool.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "plastica/base/thread_seconds.hpp"
#include "plastica/run/response_size.hpp"

namespace plastica {
namespace {

void run_together(LaneCases& cases) {
  std::vector<LaneCase> lanes;
  lanes.reserve(cases.size());
  for (WaitingCase& one : cases) {
    lanes.push_back({one.model->chain.get(), &one.model->material, &one.hooks, &one.row.response});
  }
  const double begin = thread_seconds();
  make_lane_program(*cases.front().model->chain)->run(lanes);
  share_seconds(thread_seconds() - begin, lanes);
}

std::size_t bytes_of(const WaitingCase& one) { return response_size(*one.model).needed_bytes(); }

void run_by_itself(WaitingCase& one) {
  try {
    one.row.response = make_response(*one.model);
    Workspace workspace = make_workspace(*one.model);
    workspace.on_break = one.hooks.on_break;
    workspace.stop = one.hooks.stop;
    run(*one.model, {}, workspace, one.row.response);
  } catch (const std::exception& error) {
    // Out of memory, or a defect: the other cases go on.
    one.row.response = {};
    one.row.reason = error.what();
  }
}

}  // namespace

std::optional<LaneCases> LanePool::add(WaitingCase&& one) {
  const ChainModel& model = *one.model->chain;
  auto shape = std::find_if(shapes_.begin(), shapes_.end(), [&](const LaneCases& cases) {
    return same_lanes(*cases.front().model->chain, model);
  });
  if (shape == shapes_.end()) {
    shapes_.emplace_back();
    shape = shapes_.end() - 1;
  }
  bytes_ += bytes_of(one);
  shape->push_back(std::move(one));
  if (shape->size() < lane_width(*shape->front().model->chain)) {
    if (shapes_.size() <= kMaxShapes && bytes_ <= kMaxLaneBytes) return {};
    if (shapes_.size() > kMaxShapes) shape = shapes_.begin();
  }
  LaneCases ready = std::move(*shape);
  for (const WaitingCase& each : ready) bytes_ -= bytes_of(each);
  shapes_.erase(shape);
  return ready;
}

std::vector<LaneCases> LanePool::release() {
  bytes_ = 0;
  return std::exchange(shapes_, {});
}

void run_lane_cases(LaneCases&& cases,
                    const std::function<void(std::size_t index, BatchRow&& row)>& take) {
  try {
    run_together(cases);
  } catch (const std::exception&) {
    for (WaitingCase& one : cases) run_by_itself(one);
  }
  for (WaitingCase& one : cases) take(one.index, std::move(one.row));
}

}  // namespace plastica
