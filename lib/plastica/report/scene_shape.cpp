#include "plastica/report/scene_shape.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_drawing.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_figure.hpp"
#include "plastica/report/scene_frames.hpp"

namespace plastica::report {
namespace {

/// A section is drawn at least this fraction of the beam's extent thick, in its plane and in space.
constexpr double kMinThickness = 1.0 / 60.0;
constexpr double kMinThicknessInSpace = 1.0 / 16.0;

/// How far any joint has moved in a frame [m].
double largest_displacement(const io::SceneRecord& record, std::size_t frame) {
  const ChainHistory& chain = record.response.chain;
  double most = 0.0;
  for (std::size_t i = 0; i < chain.joints; ++i) {
    const double* now = &chain.position[3 * (frame * chain.joints + i)];
    const double* then = &record.outline.node[3 * i];
    most = std::max(most, std::hypot(now[0] - then[0], now[1] - then[1], now[2] - then[2]));
  }
  return most;
}

/// Frames shown faintly beside the one that is drawn: on the way to it, and the one that went
/// farthest.
std::vector<std::size_t> earlier_frames(const io::SceneRecord& record, std::size_t shown) {
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < shown; ++i) {
    if (largest_displacement(record, i) > largest_displacement(record, farthest)) farthest = i;
  }
  std::vector<std::size_t> frames{shown / 4, shown / 2, 3 * shown / 4};
  if (largest_displacement(record, farthest) > 1.05 * largest_displacement(record, shown))
    frames.push_back(farthest);
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  std::erase_if(frames, [&](std::size_t frame) { return frame == 0 || frame == shown; });
  return frames;
}

/// Rotation of the last segment [rad].
double end_rotation(const io::SceneRecord& record, std::size_t frame) {
  const std::size_t behind = 3 * (frame + 1) * record.outline.segments();
  const auto& all = record.response.chain.rotation;
  return std::hypot(all[behind - 3], all[behind - 2], all[behind - 1]);
}

/// How it ended, and how far it went: lines of the title.
std::vector<std::string> facts_of(const io::SceneRecord& record, std::size_t shown,
                                  double thickness) {
  double most = 0.0;
  for (std::size_t i = 0; i <= shown; ++i) most = std::max(most, largest_displacement(record, i));
  const double now = largest_displacement(record, shown);
  std::string facts;
  const auto add = [&](const std::string& fact) { facts += (facts.empty() ? "" : "; ") + fact; };
  const double end = record.response.chain.time.back();
  const double time = time_of_frame(record, shown);
  if (is_motion(record) || time != end) add("at " + time_text(time, end));
  const std::size_t fragments = fragments_at(record, time).size();
  if (fragments > 1 && time != end) add(counted(fragments, "fragment"));
  if (most > 0.0) add(fmt::format("largest displacement {:.4g} mm", 1e3 * now));
  if (now < 0.99 * most) facts += fmt::format(" ({:.4g} mm on the way)", 1e3 * most);
  if (in_space(record)) add(fmt::format("end turned by {:.4g} rad", end_rotation(record, shown)));
  if (thickness > 1.0) add(fmt::format("section drawn {:.0f} times as thick", thickness));
  const std::string outcome = outcome_line(record);
  if (outcome == name_of(Status::Completed)) return {outcome + (facts.empty() ? "" : "; ") + facts};
  return {outcome, facts};
}

std::vector<std::string> titles_of(const io::SceneRecord& record, std::size_t shown,
                                   double thickness) {
  std::vector<std::string> lines{record.setup.scene.name};
  for (std::string& line : facts_of(record, shown, thickness)) lines.push_back(std::move(line));
  return lines;
}

/// Where the picture begins and ends, and its scale: one on both axes.
struct Window {
  double left = 0.0;
  double low = 0.0;
  double scale = 0.0;   ///< [m] of a pixel
  double height = 0.0;  ///< [pixels]
};

/// As high as the beam needs.
Window window_of(const Extent& extent, double size, double width) {
  constexpr double kMinHeight = 150.0;
  constexpr double kMaxHeight = 640.0;
  const double pad = 0.04 * size;
  Window window;
  window.scale = (extent.size(0) + 2.0 * pad) / width;
  window.height = std::clamp((extent.size(1) + 2.0 * pad) / window.scale, kMinHeight, kMaxHeight);
  window.scale = std::max(window.scale, (extent.size(1) + 2.0 * pad) / window.height);
  window.left = extent.middle(0) - 0.5 * width * window.scale;
  window.low = extent.middle(1) - 0.5 * window.height * window.scale;
  return window;
}

}  // namespace

PlotScript shape_page(const io::SceneRecord& record, std::optional<double> time,
                      const Sheet& sheet) {
  PlotScript script(sheet);
  script.begin_panels(1);
  const Eye eye = eye_of(record);
  const std::size_t shown = frame_at(record, time);
  const bool space = in_space(record);
  const BeamPose undeformed(record, kUndeformed);
  const BeamPose pose(record, shown);
  Extent extent;
  extent.add(undeformed.axes(eye));
  extent.add(pose.axes(eye));
  const double size = std::max(extent.size(0), extent.size(1));
  const double thickness =
      drawn_thickness(record, eye, size, space ? kMinThicknessInSpace : kMinThickness);
  const double arrow_length = 0.11 * size;
  for (const Face& face : beam_solid(pose, eye, thickness).faces) extent.add(face.corners);
  if (space) extent.low[1] -= 0.11 * size;  // room for scale and axes
  Lines earlier;
  if (!space) {
    for (const std::size_t frame : earlier_frames(record, shown)) {
      for (auto& axis : BeamPose(record, frame).axes(eye)) earlier.push_back(std::move(axis));
    }
  }
  extent.add(earlier);
  const SupportMarks marks = support_marks(pose, eye, thickness, size);
  extent.add(marks.pillars);
  for (const auto& points : marks.points) extent.add(points);
  for (const auto& arrow : force_arrows(pose, eye, arrow_length)) {
    extent.add(Point2{arrow[0], arrow[1]});
  }

  const double strain = largest_strain(record, shown);
  const bool colored = strain > kNoStrain;
  const Window window = window_of(extent, size, script.panel_width() - (colored ? kBarWidth : 0.0));
  script.set_plot_height(window.height);
  script.command(fmt::format("set xrange [{:.7g}:{:.7g}]\nset yrange [{:.7g}:{:.7g}]", window.left,
                             window.left + script.panel_width() * window.scale, window.low,
                             window.low + window.height * window.scale));
  if (space) {
    add_orientation(script, eye, window.scale, window.height);
  } else {
    script.set_x_label("z [m]");
    script.set_y_label(eye.up[0] == 1.0 ? "x [m]" : "y [m]");
    script.command("set ytics autofreq");
  }
  if (colored) add_color_bar(script, strain, window.height);
  script.begin_panel(titles_of(record, shown, thickness));

  script.add_series(script.add_lists(lists_of(undeformed.axes(eye))),
                    "using 1:2 with lines dashtype 2 linewidth 1.2 linecolor rgb '#8C8C8C'",
                    "undeformed axis");
  if (!earlier.empty()) {
    script.add_series(script.add_lists(lists_of(earlier)),
                      "using 1:2 with lines linewidth 1 linecolor rgb '#C4C4C4'", "on the way");
  }
  if (colored) {
    // What the bar of colours belongs to; under the beam.
    const Point2 start = eye.at(pose.inner(0));
    script.add_unnamed(script.add_points({{start[0], start[1], 0.0}}),
                       "using 1:2:3 with points pointtype 0 linecolor palette");
  }
  BeamPicture picture(record, eye, thickness, colored ? strain : 0.0);
  picture.add_frame(pose, {}, arrow_length, size);
  picture.put(script, true, 0.012);
  script.end_panel();
  return script;
}

PlotScript shape_terminal(const io::SceneRecord& record, std::optional<double> time) {
  const Eye eye = eye_of(record);
  const std::size_t shown = frame_at(record, time);
  const auto before = BeamPose(record, kUndeformed).axes(eye);
  const auto after = BeamPose(record, shown).axes(eye);
  Extent extent;
  extent.add(before);
  extent.add(after);
  // A letter is twice as high as wide; 66 columns and 17 lines are left for the beam.
  const double scale = std::max({extent.size(0) / 66.0, extent.size(1) / 34.0, 1e-12});
  PlotScript script;
  begin_terminal(script);
  const double x = extent.middle(0);
  const double y = extent.middle(1);
  script.command(fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]",
                             x - 34.0 * scale, x + 34.0 * scale, y - 18.0 * scale,
                             y + 18.0 * scale));
  script.command("set title " + in_quotes(titles_of(record, shown, 1.0), 76));
  const auto dense = [&](const Lines& lines) {
    std::vector<std::vector<std::vector<double>>> lists;
    for (const auto& line : lines) {
      lists.push_back(dense_points(rows_of(line), 68.0 * scale, 36.0 * scale));
    }
    return script.add_lists(lists);
  };
  const std::string undeformed = dense(before);
  const std::string deformed = dense(after);
  script.command(
      fmt::format("plot {} using 1:2 with points pointtype '.' title 'undeformed', \\\n"
                  "     {} using 1:2 with points pointtype '#' title 'deformed'",
                  undeformed, deformed));
  return script;
}

}  // namespace plastica::report
