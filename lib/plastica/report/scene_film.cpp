#include "plastica/report/scene_film.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_drawing.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_figure.hpp"
#include "plastica/report/scene_frames.hpp"

namespace plastica::report {
namespace {

/// A section is drawn at least this fraction of a frame's extent thick, in its plane and in space.
constexpr double kMinFilmThickness = 1.0 / 45.0;
constexpr double kMinFilmThicknessInSpace = 1.0 / 16.0;
constexpr double kArrow = 0.16;            ///< length of the largest force [fraction of the extent]
constexpr double kMaxStripHeight = 720.0;  ///< of the strip [pixels]
constexpr double kLabelHeight = 24.0;      ///< above each frame [pixels]
constexpr double kPad = 10.0;              ///< around each frame [pixels]
constexpr double kMinSegment = 7.0;        ///< in which segments are told apart [pixels]
constexpr double kFootHeight = 86.0;       ///< room for scale and axes [pixels]

std::vector<std::size_t> frames_of_film(const io::SceneRecord& record, const FilmRequest& request) {
  const double from = request.from.value_or(0.0);
  const double to = request.to.value_or(record.response.chain.time.back());
  if (from > to) {
    throw InputError({}, "--to", fmt::format("{} s", brief(to)),
                     fmt::format("must not be before --from {} s", brief(from)));
  }
  return even_frames(record, static_cast<std::size_t>(request.frames), from, to);
}

/// What all frames show, in one window.
Extent extent_of(const io::SceneRecord& record, const std::vector<std::size_t>& frames,
                 const Eye& eye) {
  Extent extent;
  extent.add(BeamPose(record, kUndeformed).axes(eye));
  for (const std::size_t frame : frames) extent.add(BeamPose(record, frame).axes(eye));
  return extent;
}

/// The strip as a table of frames.
struct Grid {
  std::size_t columns = 1;
  std::size_t rows = 1;
  double scale = 0.0;  ///< [m] of a pixel
  double wide = 0.0;   ///< of a frame [pixels]
  double high = 0.0;   ///< of a frame, its label included [pixels]

  std::size_t column_of(std::size_t index) const { return index % columns; }
  std::size_t row_of(std::size_t index) const { return index / columns; }
};

/// The number of columns that leaves the frames largest.
/// @param width, height  of the whole [pixels]
/// @param label, pad     above, and around each frame [pixels]
Grid grid_of(const Extent& extent, std::size_t count, double width, double height, double label,
             double pad) {
  Grid best;
  for (std::size_t columns = 1; columns <= count; ++columns) {
    Grid grid;
    grid.columns = columns;
    grid.rows = (count + columns - 1) / columns;
    grid.wide = width / static_cast<double>(columns);
    const double room = height / static_cast<double>(grid.rows) - label;
    grid.scale =
        std::max(extent.size(0) / (grid.wide - 2.0 * pad), extent.size(1) / (room - 2.0 * pad));
    if (!(grid.wide > 2.0 * pad) || !(room > 2.0 * pad)) continue;
    grid.high = std::max(extent.size(1) / grid.scale, 20.0) + 2.0 * pad + label;
    if (best.scale == 0.0 || grid.scale < best.scale) best = grid;
  }
  return best;
}

/// "12.5 ms, 3 fragments".
std::string label_of(const io::SceneRecord& record, std::size_t frame, double last) {
  const double time = time_of_frame(record, frame);
  const std::size_t fragments = fragments_at(record, time).size();
  return time_text(time, last) + (fragments > 1 ? ", " + counted(fragments, "fragment") : "");
}

std::vector<std::string> titles_of(const io::SceneRecord& record, double thickness) {
  std::string facts = outcome_line(record);
  if (thickness > 1.0) facts += fmt::format("; section drawn {:.0f} times as thick", thickness);
  return {record.setup.scene.name, std::move(facts)};
}

/// Where the frames of a grid lie: their lower left corners are multiples of the frame's size, the
/// first row on top.
class Strip {
 public:
  Strip(const Grid& grid, const Extent& extent, double pad) : grid_(grid) {
    const double room = grid.wide - 2.0 * pad;
    center_ = 0.5 * (room * grid.scale - extent.size(0));
    origin_ = {extent.low[0] - pad * grid.scale, extent.low[1] - pad * grid.scale};
  }
  double width() const { return static_cast<double>(grid_.columns) * grid_.wide * grid_.scale; }
  double height() const { return static_cast<double>(grid_.rows) * grid_.high * grid_.scale; }
  double left(std::size_t index) const {
    return static_cast<double>(grid_.column_of(index)) * grid_.wide * grid_.scale;
  }
  double low(std::size_t index) const {
    return static_cast<double>(grid_.rows - 1 - grid_.row_of(index)) * grid_.high * grid_.scale;
  }
  /// From world to strip.
  Point2 shift(std::size_t index) const {
    return {left(index) - origin_[0] + center_, low(index) - origin_[1]};
  }

 private:
  const Grid& grid_;
  double center_ = 0.0;
  Point2 origin_{};
};

}  // namespace

PlotScript film_page(const io::SceneRecord& record, const FilmRequest& request,
                     const Sheet& sheet) {
  PlotScript script(sheet);
  script.begin_panels(1);
  const Eye eye = eye_of(record);
  const std::vector<std::size_t> frames = frames_of_film(record, request);
  Extent extent = extent_of(record, frames, eye);
  const double size = std::max(extent.size(0), extent.size(1));
  const double thickness = drawn_thickness(
      record, eye, size, in_space(record) ? kMinFilmThicknessInSpace : kMinFilmThickness);
  double strain = 0.0;
  for (const std::size_t frame : frames) {
    strain = std::max(strain, largest_strain(record, frame));
    const BeamPose pose(record, frame);
    for (const Face& face : beam_solid(pose, eye, thickness).faces) extent.add(face.corners);
    const SupportMarks marks = support_marks(pose, eye, thickness, size);
    extent.add(marks.pillars);
    for (const auto& points : marks.points) extent.add(points);
    for (const auto& arrow : force_arrows(pose, eye, kArrow * size)) {
      extent.add(Point2{arrow[0], arrow[1]});
    }
  }
  const bool colored = strain > kNoStrain;
  const double width = script.panel_width() - (colored ? kBarWidth : 0.0);
  const Grid grid = grid_of(extent, frames.size(), width, kMaxStripHeight, kLabelHeight, kPad);
  const Strip strip(grid, extent, kPad);

  const double height = static_cast<double>(grid.rows) * grid.high + kFootHeight;
  script.set_plot_height(height);
  script.command(fmt::format("set xrange [0:{:.7g}]\nset yrange [{:.7g}:{:.7g}]",
                             script.panel_width() * grid.scale, -kFootHeight * grid.scale,
                             strip.height()));
  add_orientation(script, eye, grid.scale, height);
  if (colored) add_color_bar(script, strain, height);
  const double last = record.response.chain.time[record.response.chain.frame_sample[frames.back()]];
  BeamPicture picture(record, eye, thickness, colored ? strain : 0.0);
  std::vector<std::vector<std::vector<double>>> borders;
  std::vector<std::vector<std::vector<double>>> undeformed;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double x = strip.left(k);
    const double y = strip.low(k);
    const double right = x + grid.wide * grid.scale;
    const double top = y + grid.high * grid.scale;
    borders.push_back({{x, y}, {right, y}, {right, top}, {x, top}, {x, y}});
    script.command(fmt::format("set label {} {} at {:.7g}, {:.7g} left textcolor rgb '#333333'",
                               k + 1, in_quotes(label_of(record, frames[k], last)),
                               x + 0.8 * kPad * grid.scale, top - 0.6 * kLabelHeight * grid.scale));
    const Point2 shift = strip.shift(k);
    for (auto& line : lists_of(BeamPose(record, kUndeformed).axes(eye), shift)) {
      undeformed.push_back(std::move(line));
    }
    picture.add_frame(BeamPose(record, frames[k]), shift, kArrow * size, size);
  }
  script.begin_panel(titles_of(record, thickness));
  script.add_unnamed(script.add_lists(borders),
                     "using 1:2 with lines linewidth 0.6 linecolor rgb '#D8D8D8'");
  script.add_series(script.add_lists(undeformed),
                    "using 1:2 with lines dashtype 2 linewidth 0.8 linecolor rgb '#A8A8A8'",
                    "undeformed axis");
  if (colored) {
    // What the bar of colours belongs to; under the beam.
    const Point2 start = eye.at(BeamPose(record, frames.front()).inner(0));
    const Point2 shift = strip.shift(0);
    script.add_unnamed(script.add_points({{start[0] + shift[0], start[1] + shift[1], 0.0}}),
                       "using 1:2:3 with points pointtype 0 linecolor palette");
  }
  const double segment =
      record.setup.scene.beam.length / static_cast<double>(record.outline.segments()) / grid.scale;
  picture.put(script, segment > kMinSegment, 0.008);
  script.end_panel();
  return script;
}

PlotScript film_terminal(const io::SceneRecord& record, const FilmRequest& request) {
  const Eye eye = eye_of(record);
  const std::vector<std::size_t> frames = frames_of_film(record, request);
  const Extent extent = extent_of(record, frames, eye);
  // A letter is twice as high as wide; both are counted in widths.
  constexpr double kColumns = 74.0;
  constexpr double kRows = 2.0 * 56.0;
  const Grid grid = grid_of(extent, frames.size(), kColumns, kRows, 4.0, 1.0);
  const Strip strip(grid, extent, 1.0);
  PlotScript script;
  begin_terminal(script);
  script.command("unset border\nunset tics");
  script.terminal_rows =
      6 + static_cast<int>(std::ceil(0.5 * grid.high * static_cast<double>(grid.rows)));
  script.command(fmt::format("set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]", kColumns * grid.scale,
                             strip.height()));
  script.command("set title " + in_quotes(titles_of(record, 1.0), 76));
  const double last = record.response.chain.time[record.response.chain.frame_sample[frames.back()]];
  std::vector<std::vector<std::vector<double>>> lists;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    script.command(fmt::format("set label {} {} at {:.7g}, {:.7g} left", k + 1,
                               in_quotes(label_of(record, frames[k], last)),
                               strip.left(k) + grid.scale,
                               strip.low(k) + (grid.high - 2.0) * grid.scale));
    for (const auto& axis : BeamPose(record, frames[k]).axes(eye)) {
      lists.push_back(
          dense_points(rows_of(axis, strip.shift(k)), kColumns * grid.scale, strip.height()));
    }
  }
  script.command(
      fmt::format("plot {} using 1:2 with points pointtype '#' notitle", script.add_lists(lists)));
  return script;
}

}  // namespace plastica::report
