#include "plastica/report/web/web_beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/report/beam_pose.hpp"
#include "plastica/report/scene_drawing.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_history.hpp"
#include "plastica/report/scene_words.hpp"
#include "plastica/report/web/packed_points.hpp"
#include "plastica/report/web/web_blocks.hpp"

namespace plastica::report {
namespace {

/// Frames that a film has at most, and segments in all of them together: some two megabytes.
constexpr std::size_t kMostFrames = 200;
constexpr std::size_t kMostPoses = 60'000;
/// Histories beside the beam; all of them have a tab of their own.
constexpr std::size_t kMostProbes = 3;

using Rows = std::vector<std::vector<double>>;

std::vector<std::size_t> shown_frames(const io::SceneRecord& record) {
  const std::size_t each = std::max<std::size_t>(1, record.outline.segments());
  const std::size_t most = std::clamp<std::size_t>(kMostPoses / each, 2, kMostFrames);
  if (frames_of(record) <= most) {
    std::vector<std::size_t> all(frames_of(record));
    for (std::size_t f = 0; f < all.size(); ++f) all[f] = f;
    return all;
  }
  return even_frames(record, most, time_of_frame(record, 0),
                     time_of_frame(record, frames_of(record) - 1));
}

/// Ends of each segment, then axes x and y of its section.
Rows poses_of(const io::SceneRecord& record, std::span<const std::size_t> frames) {
  Rows rows;
  for (const std::size_t frame : frames) {
    const BeamPose pose(record, frame);
    for (std::size_t s = 0; s < pose.segments(); ++s) {
      std::vector<double> row;
      for (const Point3& point :
           {pose.inner(s), pose.outer(s), pose.section_axis(s, 0), pose.section_axis(s, 1)}) {
        row.insert(row.end(), point.begin(), point.end());
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// A number of each joint, in each of the frames.
/// @param values  (n_frames x n_joints x stride)
Rows values_of(const io::SceneRecord& record, std::span<const std::size_t> frames,
               const std::vector<double>& values, std::size_t stride, std::size_t offset) {
  const std::size_t joints = record.response.chain.joints;
  Rows rows;
  rows.reserve(frames.size() * joints);
  for (const std::size_t frame : frames) {
    for (std::size_t j = 0; j < joints; ++j) {
      rows.push_back({values[(frame * joints + j) * stride + offset]});
    }
  }
  return rows;
}

double largest_of(const Rows& rows) {
  double largest = 0.0;
  for (const auto& row : rows) largest = std::max(largest, std::fabs(row[0]));
  return largest;
}

/// What of the joints is shown by colours, by its size; what is zero everywhere is not.
Json colors_of(const io::SceneRecord& record, std::span<const std::size_t> frames) {
  const ChainHistory& chain = record.response.chain;
  Json all = Json::array();
  const auto add = [&](std::string_view name, Dimension dimension,
                       const std::vector<double>& values, double least) {
    const Rows rows = values_of(record, frames, values, 1, 0);
    const double largest = largest_of(rows);
    if (!(largest > least) || !std::isfinite(largest)) return;
    const DisplayUnit unit = shown_unit(dimension, largest);
    all.push_back({{"name", name},
                   {"unit", unit.name},
                   {"scale", unit.scale},
                   {"largest", largest},
                   {"values", packed_points(rows, {}, 0)}});
  };
  // What rounding leaves of elastic joints is no strain.
  add("permanent strain", Dimension::Strain, chain.plastic_strain, 1e-12);
  add("bending stress", Dimension::Stress, chain.stress, 0.0);
  return all;
}

Json moments_of(const io::SceneRecord& record, std::span<const std::size_t> frames) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kMoments{
      {{"bending about x", "M_x"}, {"bending about y", "M_y"}, {"torque", "T"}}};
  std::array<Rows, 3> rows;
  double most = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows[axis] = values_of(record, frames, record.response.chain.moment, 3, axis);
    most = std::max(most, largest_of(rows[axis]));
  }
  Json all = Json::array();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double largest = largest_of(rows[axis]);
    if (!(largest > 1e-6 * most)) continue;
    const DisplayUnit unit = shown_unit(Dimension::Moment, largest);
    const auto any = [&](auto has) { return std::ranges::any_of(rows[axis], has); };
    all.push_back({{"name", kMoments[axis].first},
                   {"symbol", kMoments[axis].second},
                   {"unit", unit.name},
                   {"scale", unit.scale},
                   {"largest", largest},
                   {"positive", any([&](const auto& row) { return row[0] > 1e-3 * largest; })},
                   {"negative", any([&](const auto& row) { return row[0] < -1e-3 * largest; })},
                   {"values", packed_points(rows[axis], {}, 0)}});
  }
  return all;
}

/// The first probes' histories, and the energies of a motion.
Json linked_of(const io::SceneRecord& record) {
  Figure figure;
  const auto add = [&](Figure one) {
    for (FigurePanel& panel : one.panels) figure.panels.push_back(std::move(panel));
  };
  const auto& probes = record.setup.scene.probes;
  for (std::size_t p = 0; p < std::min(probes.size(), kMostProbes); ++p) {
    add(history_figure(std::span(&record, 1), probes[p].name));
  }
  if (is_motion(record)) add(energy_figure(record, true));
  Json all = Json::array();
  if (!figure.panels.empty()) all.push_back(web_figure(figure));
  return all;
}

}  // namespace

Json web_beam(const io::SceneRecord& record) {
  const std::vector<std::size_t> frames = shown_frames(record);
  const ChainHistory& chain = record.response.chain;
  const double last = chain.time.back();
  std::vector<double> times;
  Json texts = Json::array();
  for (const std::size_t frame : frames) {
    times.push_back(time_of_frame(record, frame));
    const double factor = chain.factor[chain.frame_sample[frame]];
    texts.push_back(is_motion(record) ? time_text(times.back(), last)
                                      : fmt::format("load factor {:.4g}", factor));
  }
  std::vector<double> places;
  for (const double end : record.outline.ends) {
    places.push_back(end * record.setup.scene.beam.length);
  }
  Json nodes = Json::array();
  for (std::size_t i = 0; i + 2 < record.outline.node.size(); i += 3) {
    nodes.push_back(
        {record.outline.node[i], record.outline.node[i + 1], record.outline.node[i + 2]});
  }
  const Eye eye = eye_of(record);
  const std::string note = frames.size() < frames_of(record)
                               ? fmt::format("{} of {} frames.", frames.size(), frames_of(record))
                               : "";
  return {{"kind", "beam"},
          {"segments", record.outline.segments()},
          {"joints", chain.joints},
          {"times", times},
          {"times_text", std::move(texts)},
          {"eye", {{"right", eye.right}, {"up", eye.up}, {"away", eye.away}}},
          {"width", record.outline.width},
          {"height", record.outline.height},
          {"places", places},
          {"nodes", std::move(nodes)},
          {"note", note},
          {"pose", packed_points(poses_of(record, frames), {}, 0)},
          {"colors", colors_of(record, frames)},
          {"moments", moments_of(record, frames)},
          {"linked", linked_of(record)}};
}

}  // namespace plastica::report
