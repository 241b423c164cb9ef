#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "plastica/run/chain_runner.hpp"
#include "plastica/run/lane_program.hpp"
#include "plastica/run/lane_shape.hpp"
#include "plastica/solve/lane_newton.hpp"

namespace plastica {

/// Whether a model is a path that can be followed in a lane, see `why_alone`.
bool continues_in_lanes(const ChainModel& model);
/// Whether two of them can be followed together.
bool same_path_lanes(const ChainModel& a, const ChainModel& b);
/// Paths that one program takes: more than lanes, so that few of those are empty at the end.
inline constexpr std::size_t kPathsTogether = 4 * solve::kPathLanes;
std::unique_ptr<LaneProgram> make_path_lanes(const ChainModel& model);
/// Fewer paths than this are faster one by one, with the same bits: an iteration of all lanes costs
/// what it costs, however many are empty (tests/benchmarks/README.md).
std::size_t fewest_paths(const ChainModel& model);

/// Follows the paths of several beams of one shape, each at its own pace: whoever has found an
/// equilibrium goes on by itself to where it seeks the next, and who has ended makes room for a
/// beam that waits. What is sought otherwise than at a given time (the first equilibrium, arcs,
/// displacement control) each seeks alone.
template <class L>
class PathLanes final : public LaneProgram {
 public:
  /// @param model  has a `lane_law`
  PathLanes(const ChainModel& model, solve::LaneNewtonTable::Make newton)
      : law_(*lane_law(model)), newton_(newton()), fewest_(fewest_paths(model)) {}

  void run(std::span<const LaneCase> cases) override;

 private:
  using Runner = ChainRunner<L, false>;

  struct Lane {
    std::unique_ptr<Runner> runner;
    const ChainModel* model = nullptr;  ///< that the runner has
    bool seeks = false;
    bool found = false;      ///< what it sought, or that it cannot be found
    bool converged = false;  ///< which of both
    bool placed = false;     ///< the segments' places were read, and no more is needed
    int iteration = 0;
    double unstable_modes = -1.0;  ///< see `PathContinuation::take`
  };

  /// Whether lanes are slower than beams one by one, with so many beside those in them.
  bool are_few(std::size_t more) const {
    const auto seek =
        std::count_if(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.seeks; });
    return static_cast<std::size_t>(seek) + waiting_.size() + more < fewest_;
  }
  bool any_seeks() const {
    return std::any_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.seeks; });
  }
  void fill(int lane);
  bool begin(int lane, const LaneCase& one);
  void begin_seeking(int lane);
  void judge(int lane, double imbalance);
  void count_unstable_modes();
  void take_found(int lane);

  template <class Use>
  void with_joints(Runner& runner, const Use& use) const {
    plastica::with_joints<L>(law_, *runner.body().joints, use);
  }

  solve::LaneLaw law_;
  std::unique_ptr<solve::LaneNewton> newton_;
  std::size_t fewest_;  ///< see `are_few`
  std::array<Lane, solve::kPathLanes> lanes_;
  std::span<const LaneCase> waiting_;
  std::vector<std::size_t> shape_;  ///< of what is in the lanes
  std::vector<std::size_t> new_shape_;
  std::vector<double> numbers_, found_;
};

/// Of both levels that lanes have (path_lanes_*.cpp).
std::unique_ptr<LaneProgram> make_planar_path_lanes(const ChainModel& model);
std::unique_ptr<LaneProgram> make_spatial_path_lanes(const ChainModel& model);

}  // namespace plastica
