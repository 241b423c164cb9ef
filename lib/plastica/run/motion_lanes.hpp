#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "plastica/run/chain_body.hpp"
#include "plastica/run/lane_program.hpp"
#include "plastica/run/lane_shape.hpp"
#include "plastica/solve/lane_motion.hpp"
#include "plastica/solve/motion_options.hpp"

namespace plastica {

/// Whether a model is a motion of a general scheme that can be stepped in a lane, see `why_alone`.
bool moves_in_lanes(const ChainModel& model);
/// Whether two of them can be stepped together.
bool same_motion_lanes(const ChainModel& a, const ChainModel& b);
std::unique_ptr<LaneProgram> make_motion_lanes(const ChainModel& model);

/// Steps the motions of several beams of one shape side by side, all by the same steps. A beam that
/// needs other ones (a step that fails, a joint that breaks) leaves its lane, and runs alone from
/// its begin once the others have ended.
template <class L>
class MotionLanes final : public LaneProgram {
 public:
  /// @param model  has a `lane_law`
  MotionLanes(const ChainModel& model, solve::LaneMotionTable::Make steps)
      : law_(*lane_law(model)), steps_(steps()) {}

  void run(std::span<const LaneCase> cases) override;
  std::size_t left() const override { return count_ - riders(); }

 private:
  using Body = ChainBody<L, false>;
  using Motions = std::vector<solve::SegmentMotion<L>>;
  using OfEach = std::array<double, solve::kPathLanes>;

  struct Lane {
    std::unique_ptr<Body> body;
    const ChainModel* model = nullptr;  ///< that the body has
    LaneCase one;
    bool rides = false;
    Motions motion;  ///< at the last sample (N)
    double kinetic = 0.0;
    solve::EnergyFlows flows;
    double momentum_error = 0.0;
  };

  std::span<Lane> lanes() { return std::span(lanes_).first(count_); }
  std::size_t riders() const;
  void begin(std::span<const LaneCase> cases);
  bool lay_out(Lane& lane);
  void take_numbers(int number, Lane& lane);
  void start();
  void go_to(double stop, class StepSize& size);
  void take_step(double h);
  bool goes_on(int number, Lane& lane, bool restarted);
  void read_joints(int number, Lane& lane);
  void read_motion(int number, Lane& lane);
  void read_all(int number, Lane& lane);
  void record();
  void finish();

  solve::LaneLaw law_;
  std::unique_ptr<solve::LaneMotion> steps_;
  std::array<Lane, solve::kPathLanes> lanes_;
  std::size_t count_ = 0;  ///< of them that have a case
  solve::MotionOptions options_;
  double time_ = 0.0;
  std::vector<std::size_t> shape_, new_shape_;
  std::vector<double> numbers_, found_, axial_;
};

/// Of both levels that lanes have (motion_lanes_*.cpp).
std::unique_ptr<LaneProgram> make_planar_motion_lanes(const ChainModel& model);
std::unique_ptr<LaneProgram> make_spatial_motion_lanes(const ChainModel& model);

}  // namespace plastica
