#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "calibrate/problem/scene_problem.hpp"
#include "calibrate/search/least_squares.hpp"

namespace plastica::calibrate {

/// One finished search.
struct SearchRecord {
  LeastSquares found;
  PointRun start;    ///< what came of its first point
  RunCounters runs;  ///< of all its points
};

/// The finished screening of points.
struct ScreenRecord {
  std::vector<double> costs;  ///< not finite without a curve (n_points)
  RunCounters runs;
};

/// A finished task of what follows the search, as numbers whose meaning its maker knows.
struct TaskRecord {
  std::vector<std::vector<double>> rows;
  std::string text;
  RunCounters runs;
};

/// Bumped whenever the bytes of these change.
inline constexpr std::uint32_t kSearchRecordVersion = 2;

std::vector<std::byte> bytes_of(const SearchRecord& record);
std::vector<std::byte> bytes_of(const ScreenRecord& record);
std::vector<std::byte> bytes_of(const TaskRecord& record);
/// @throws io::StorageError if the bytes are no such record
SearchRecord search_record_from(std::span<const std::byte> bytes);
ScreenRecord screen_record_from(std::span<const std::byte> bytes);
TaskRecord task_record_from(std::span<const std::byte> bytes);

}  // namespace plastica::calibrate
