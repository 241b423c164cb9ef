#include "plastica/report/scene_frames.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"

namespace plastica::report {

std::size_t frame_at(const io::SceneRecord& record, std::optional<double> time) {
  const std::size_t frames = frames_of(record);
  if (!time) return frames - 1;
  std::size_t nearest = 0;
  for (std::size_t f = 1; f < frames; ++f) {
    const double distance = std::fabs(time_of_frame(record, f) - *time);
    if (distance < std::fabs(time_of_frame(record, nearest) - *time)) nearest = f;
  }
  return nearest;
}

void check_time(const io::SceneRecord& record, std::string_view option,
                const std::optional<double>& time) {
  const std::size_t frames = frames_of(record);
  if (!time || frames == 0) return;
  // A path that arcs lead falls, too.
  double first = time_of_frame(record, 0);
  double last = first;
  for (std::size_t f = 1; f < frames; ++f) {
    first = std::min(first, time_of_frame(record, f));
    last = std::max(last, time_of_frame(record, f));
  }
  const double room = 1e-9 * std::fabs(last);  // what is typed has fewer digits
  if (*time >= first - room && *time <= last + room) return;
  throw InputError({}, option, brief(*time) + " s",
                   fmt::format("must be within the times that are kept, {} to {}",
                               time_text(first, last), time_text(last, last)));
}

std::vector<std::size_t> even_frames(const io::SceneRecord& record, std::size_t count, double from,
                                     double to) {
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k < count; ++k) {
    const double fraction =
        count == 1 ? 1.0 : static_cast<double>(k) / static_cast<double>(count - 1);
    frames.push_back(frame_at(record, from + fraction * (to - from)));
  }
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

std::vector<bool> cut_joints(const io::SceneRecord& record, double time) {
  std::vector<bool> cut(record.outline.ends.size(), false);
  for (const ChainBreak& event : record.response.chain.events) {
    if (event.time > time) continue;
    for (const BrokenJoint& joint : event.joints) {
      if (joint.cut) cut[static_cast<std::size_t>(joint.joint)] = true;
    }
  }
  return cut;
}

std::vector<Fragment> fragments_at(const io::SceneRecord& record, double time) {
  const std::vector<bool> cut = cut_joints(record, time);
  const auto segments = static_cast<int>(record.outline.segments());
  std::vector<Fragment> fragments;
  for (int i = 0; i < segments; ++i) {
    if (i == 0 || cut[static_cast<std::size_t>(i)]) fragments.push_back({i, i});
    fragments.back().last = i;
  }
  return fragments;
}

std::string time_text(double time, double largest) {
  const double size = std::fabs(largest);
  if (size >= 1.0 || size == 0.0) return fmt::format("{:.4g} s", time);
  if (size >= 1e-3) return fmt::format("{:.4g} ms", 1e3 * time);
  return fmt::format("{:.4g} µs", 1e6 * time);
}

}  // namespace plastica::report
