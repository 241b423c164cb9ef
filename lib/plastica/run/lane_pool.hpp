#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "plastica/run/batch.hpp"
#include "plastica/run/lane_program.hpp"

namespace plastica {

/// A case that is laid out and waits for others of its shape.
struct WaitingCase {
  std::size_t index = 0;  ///< in the batch
  std::unique_ptr<Model> model;
  BatchRow row;
  Workspace hooks;
};

/// Cases of one shape (`same_lanes`), no more than are stepped together.
using LaneCases = std::vector<WaitingCase>;

/// Cases that wait for each other, or run together, take no more memory than this, unless it is one
/// [bytes].
inline constexpr std::size_t kMaxLaneBytes = std::size_t{1} << 28;

/// Collects cases of lane programs until there are enough of a shape; one a thread.
class LanePool {
 public:
  /// Takes a case in.
  /// @param one  of `has_lanes`
  /// @return cases that are to be run now: a shape of which there are enough, or, where very many
  ///         cases wait, the shape that waits longest, or, where they take much memory, that of the
  ///         case
  std::optional<LaneCases> add(WaitingCase&& one);

  /// Gives back all that wait.
  std::vector<LaneCases> release();

 private:
  static constexpr std::size_t kMaxShapes = 64;

  std::vector<LaneCases> shapes_;  ///< none of them empty
  std::size_t bytes_ = 0;          ///< that all who wait take
};

/// Runs cases of one shape together; should that throw, each by itself, so that one case's failure
/// is no other's.
/// @param take  called with each row
void run_lane_cases(LaneCases&& cases,
                    const std::function<void(std::size_t index, BatchRow&& row)>& take);

}  // namespace plastica
