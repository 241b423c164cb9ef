#include "plastica/run/lane_program.hpp"

#include <algorithm>
#include <utility>

#include "plastica/run/lane_group.hpp"
#include "plastica/run/lane_planar.hpp"
#include "plastica/run/lane_spatial.hpp"
#include "plastica/run/motion_lanes.hpp"
#include "plastica/run/path_lanes.hpp"

namespace plastica {
namespace {

bool same_steps(const SolverOptions& a, const SolverOptions& b) {
  return a.scheme == b.scheme && a.time_step == b.time_step && a.precision == b.precision &&
         a.isa == b.isa && a.largest_rotation == b.largest_rotation &&
         a.smallest_step == b.smallest_step;
}

template <class Form>
std::unique_ptr<LaneProgram> make_group(const ChainModel& model) {
  if (model.options.precision == Precision::Float) {
    return std::make_unique<LaneGroup<Form, float>>(model);
  }
  return std::make_unique<LaneGroup<Form, double>>(model);
}

class LoneLane final : public ChainProgram {
 public:
  explicit LoneLane(const ChainModel& model) : model_(model), program_(make_lane_program(model)) {}

  void run(const MaterialValues<double>& material, const Workspace& hooks,
           Response& response) override {
    const LaneCase one{&model_, &material, &hooks, &response};
    program_->run({&one, 1});
  }

 private:
  const ChainModel& model_;
  std::unique_ptr<LaneProgram> program_;
};

}  // namespace

void share_seconds(double seconds, std::span<const LaneCase> cases) {
  const auto work = [](const LaneCase& one) {
    return 1.0 + one.response->counters.iterations + static_cast<double>(one.response->samples);
  };
  double all = 0.0;
  for (const LaneCase& one : cases) all += work(one);
  for (const LaneCase& one : cases) one.response->seconds = seconds * work(one) / all;
}

std::size_t lane_width(const ChainModel& model, std::size_t cases, int threads) {
  const std::size_t most = lane_width(model);
  if (steps_in_lanes(model)) return most;
  const auto workers = static_cast<std::size_t>(threads);
  return std::clamp((cases + workers - 1) / workers, std::size_t{1}, most);
}

bool steps_in_lanes(const ChainModel& model) {
  return model.options.analysis == Analysis::Dynamics && is_articulated(model.options.scheme);
}

bool has_lanes(const ChainModel& model) { return why_alone(model).empty(); }

bool same_lanes(const ChainModel& a, const ChainModel& b) {
  if (continues_in_lanes(a) || continues_in_lanes(b)) return same_path_lanes(a, b);
  if (moves_in_lanes(a) || moves_in_lanes(b)) return same_motion_lanes(a, b);
  return a.level == b.level && a.across == b.across && a.layout.size() == b.layout.size() &&
         same_steps(a.options, b.options) && same_times(a, b) &&
         (a.scene.yield_model == YieldModel::Elastic) ==
             (b.scene.yield_model == YieldModel::Elastic);
}

std::size_t lane_width(const ChainModel& model) {
  if (continues_in_lanes(model)) return kPathsTogether;
  if (moves_in_lanes(model)) return solve::kPathLanes;
  return model.options.precision == Precision::Float ? lanes::kManyLanes<float>
                                                     : lanes::kManyLanes<double>;
}

std::unique_ptr<LaneProgram> make_lane_program(const ChainModel& model) {
  if (continues_in_lanes(model)) return make_path_lanes(model);
  if (moves_in_lanes(model)) return make_motion_lanes(model);
  if (model.level == Level::Spatial) return make_group<SpatialLanes>(model);
  return make_group<PlanarLanes>(model);
}

std::unique_ptr<ChainProgram> make_lone_lane(const ChainModel& model) {
  return std::make_unique<LoneLane>(model);
}

}  // namespace plastica
