#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/scene_store.hpp"

/// Frames of a chain's history: the samples whose shape was kept; not installed.
namespace plastica::report {

inline std::size_t frames_of(const io::SceneRecord& record) {
  return record.response.chain.frame_sample.size();
}
inline double time_of_frame(const io::SceneRecord& record, std::size_t frame) {
  return record.response.chain.time[record.response.chain.frame_sample[frame]];
}
/// Whether the frames have velocities: those of motions, but of results of older versions.
inline bool has_velocities(const io::SceneRecord& record) {
  return !record.response.chain.velocity.empty();
}
/// Whether every sample has its shape.
inline bool keeps_all_frames(const io::SceneRecord& record) {
  return frames_of(record) == record.response.chain.time.size();
}

/// The frame next to a time, of two the earlier one; without a time the last one.
/// @param record  with at least one frame
std::size_t frame_at(const io::SceneRecord& record, std::optional<double> time = {});

/// Refuses a time that is not within those of the frames.
/// @param option  by which the user gave it: "--time"
/// @throws InputError
void check_time(const io::SceneRecord& record, std::string_view option,
                const std::optional<double>& time);

/// Frames at even times from one to another, each once: as many as there are if those are fewer.
/// @param count  >= 1
std::vector<std::size_t> even_frames(const io::SceneRecord& record, std::size_t count, double from,
                                     double to);

/// Which joints are cut at a time (N + 1).
std::vector<bool> cut_joints(const io::SceneRecord& record, double time);

/// The fragments that the beam is in at a time, by rising segment.
std::vector<Fragment> fragments_at(const io::SceneRecord& record, double time);

/// "12.5 ms": a time beside others of the size `largest`.
std::string time_text(double time, double largest);

}  // namespace plastica::report
