#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "plastica/run/chain_run.hpp"

namespace plastica {

/// Runs motions or paths at rest, several at a time; one a thread. A case has the same bits in
/// whatever company.
class LaneProgram {
 public:
  virtual ~LaneProgram() = default;
  /// @param cases  1 … lane_width(), all of one shape (`same_lanes`) with the program's model
  virtual void run(std::span<const LaneCase> cases) = 0;
  /// Of the last cases, how many have left their lanes and run alone.
  virtual std::size_t left() const { return 0; }
};

/// Gives each case its fraction of the time of all [s]: as its iterations and samples are of
/// theirs.
void share_seconds(double seconds, std::span<const LaneCase> cases);

/// Whether a model is a motion of an articulated scheme, which nothing but a lane program steps, a
/// lone one too.
bool steps_in_lanes(const ChainModel& model);

/// Why no lane program can run a model; empty: one can. Motions ride by articulated schemes; so do
/// motions of the other schemes with fixed steps, and paths under load control, of joints that are
/// rigid in translation, in the plane or in space, elastic or yielding about each axis by itself at
/// no rate of their own, on two-sided supports, with double precision.
std::string_view why_alone(const ChainModel& model);

/// Whether a lane program can run a model.
bool has_lanes(const ChainModel& model);

/// Whether two models of `has_lanes` can be run together: as many segments and, of motions, the
/// same steps and histories; but for articulated motions, supports, loads and masses of the same
/// kind at the same segments, and the same law. All other numbers may differ.
bool same_lanes(const ChainModel& a, const ChainModel& b);

/// Most cases that are run together.
std::size_t lane_width(const ChainModel& model);
/// How many of so many cases a thread runs together: no more than leave work for all threads; but
/// articulated motions are stepped in registers, full or not.
std::size_t lane_width(const ChainModel& model, std::size_t cases, int threads);

/// @throws InputError if the processor does not have the instruction set that is asked for
std::unique_ptr<LaneProgram> make_lane_program(const ChainModel& model);

/// A program of one motion at a time.
/// @param model  outlives it
std::unique_ptr<ChainProgram> make_lone_lane(const ChainModel& model);

}  // namespace plastica
