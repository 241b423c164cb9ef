#include "plastica/report/scene_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "plastica/model/beam_axis.hpp"
#include "plastica/report/beam_solid.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_figure.hpp"
#include "plastica/report/strain_color.hpp"

namespace plastica::report {
namespace {

constexpr double kNoStrain = 1e-12;
constexpr double kPlotWidth = 800.0;  ///< of a picture 900 wide [pixels]
constexpr double kBarWidth = 110.0;   ///< room for the bar of colours
/// A section is drawn at least this share of the beam's extent thick, in its plane and in space.
constexpr double kLeastThickness = 1.0 / 60.0;
constexpr double kLeastThicknessInSpace = 1.0 / 16.0;

bool in_space(const io::SceneRecord& record) { return record.level != Level::Planar; }

/// From the side in the beam's plane; in space from the side and above.
Eye eye_of(const io::SceneRecord& record) {
  if (in_space(record)) {
    const double turn = std::numbers::pi / 9.0;
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    return {{-s, 0.0, c}, {c * s, c, s * s}, {c * c, -s, s * c}};
  }
  double across_x = 0.0;
  double across_y = 0.0;
  const auto& position = record.response.chain.position;
  for (std::size_t i = 0; i + 2 < position.size(); i += 3) {
    across_x = std::max(across_x, std::fabs(position[i]));
    across_y = std::max(across_y, std::fabs(position[i + 1]));
  }
  if (across_x > across_y) return {{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}};
  return {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
}

struct Extent {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const Point2& point) {
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  void add(const std::vector<Point2>& points) {
    for (const Point2& point : points) add(point);
  }
  double size(std::size_t k) const { return high[k] - low[k]; }
};

std::vector<std::vector<double>> rows_of(const std::vector<Point2>& points) {
  std::vector<std::vector<double>> rows;
  rows.reserve(points.size());
  for (const Point2& point : points) rows.push_back({point[0], point[1]});
  return rows;
}

std::size_t last_sample(const io::SceneRecord& record) {
  return record.response.chain.time.size() - 1;
}

/// How far any joint has moved at a sample [m].
double largest_way(const io::SceneRecord& record, std::size_t sample) {
  double most = 0.0;
  for (std::size_t i = 0; i <= record.outline.segments(); ++i) {
    const Point3 now = node_at(record, sample, i);
    const Point3 then = node_at(record, kUndeformed, i);
    most = std::max(most, std::hypot(now[0] - then[0], now[1] - then[1], now[2] - then[2]));
  }
  return most;
}

/// Samples shown faintly beside the last: on the way, and the one that went farthest.
std::vector<std::size_t> earlier_samples(const io::SceneRecord& record) {
  const std::size_t last = last_sample(record);
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < last; ++i) {
    if (largest_way(record, i) > largest_way(record, farthest)) farthest = i;
  }
  std::vector<std::size_t> samples{last / 4, last / 2, 3 * last / 4};
  if (largest_way(record, farthest) > 1.05 * largest_way(record, last)) samples.push_back(farthest);
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  std::erase_if(samples, [&](std::size_t sample) { return sample == 0 || sample == last; });
  return samples;
}

/// The point of the deformed axis at a share of the length.
Point3 point_at(const io::SceneRecord& record, std::size_t sample, double share) {
  const std::vector<double>& ends = record.outline.ends;
  std::size_t i = 0;
  while (i + 2 < ends.size() && ends[i + 1] < share) ++i;
  const double t = (share - ends[i]) / (ends[i + 1] - ends[i]);
  const Point3 a = node_at(record, sample, i);
  const Point3 b = node_at(record, sample, i + 1);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// Rotation of the last segment at the last sample [rad].
double end_rotation(const io::SceneRecord& record) {
  const auto& all = record.response.chain.rotation;
  return std::hypot(all[all.size() - 3], all[all.size() - 2], all[all.size() - 1]);
}

/// How it ended, and how far it went: lines of the title.
std::vector<std::string> facts_of(const io::SceneRecord& record, double thickness) {
  const std::size_t last = last_sample(record);
  double most = 0.0;
  for (std::size_t i = 0; i <= last; ++i) most = std::max(most, largest_way(record, i));
  const double now = largest_way(record, last);
  std::string facts;
  const auto add = [&](const std::string& fact) { facts += (facts.empty() ? "" : "; ") + fact; };
  if (most > 0.0) add(fmt::format("largest displacement {:.4g} mm", 1e3 * now));
  if (now < 0.99 * most) facts += fmt::format(" ({:.4g} mm on the way)", 1e3 * most);
  if (in_space(record)) add(fmt::format("end turned by {:.4g} rad", end_rotation(record)));
  if (thickness > 1.0) add(fmt::format("section drawn {:.0f} times as thick", thickness));
  const std::string outcome = outcome_line(record);
  if (outcome == name_of(Status::Completed)) return {outcome + (facts.empty() ? "" : "; ") + facts};
  return {outcome, facts};
}

std::string title_of(const io::SceneRecord& record, double thickness, std::size_t width) {
  std::string title = quoted(cut(record.setup.scene.name, width));
  for (const std::string& line : facts_of(record, thickness)) {
    title += ".\"\\n\"." + quoted(cut(line, width));
  }
  return title;
}

/// Supports by their kind, where the beam is now.
void add_supports(PlotScript& script, const io::SceneRecord& record, const Eye& eye) {
  // Point types of gnuplot in the order of SupportKind: squares hold rotations.
  constexpr std::array<int, 6> kSymbols{5, 9, 6, 4, 12, 8};
  const auto& supports = record.setup.scene.supports;
  for (std::size_t kind = 0; kind < kSymbols.size(); ++kind) {
    std::vector<Point2> points;
    for (const Support& support : supports) {
      if (static_cast<std::size_t>(support.kind) != kind) continue;
      points.push_back(eye.at(point_at(record, last_sample(record), support.at.fraction)));
    }
    if (points.empty()) continue;
    script.add_series(script.add_points(rows_of(points)),
                      fmt::format("using 1:2 with points pointtype {} pointsize 1.3 linewidth 1.6 "
                                  "linecolor rgb '{}'",
                                  kSymbols[kind], kDark),
                      support_kinds()[kind]);
  }
}

/// Forces as arrows that end where they act.
std::vector<std::vector<double>> force_arrows(const io::SceneRecord& record, const Eye& eye,
                                              double length) {
  double largest = 0.0;
  const auto size_of = [](const Load& load) {
    return std::hypot(load.force[0], load.force[1], load.force[2]);
  };
  const auto& loads = record.setup.scene.loads;
  for (const Load& load : loads) {
    if (!load.to) largest = std::max(largest, size_of(load));
  }
  std::vector<std::vector<double>> arrows;
  for (const Load& load : loads) {
    if (size_of(load) == 0.0) continue;
    const Point2 direction = eye.at(load.force);
    const double share = load.to ? 0.6 : size_of(load) / largest;
    const double scale = length * std::max(share, 0.3) / size_of(load);
    const int count = load.to ? 9 : 1;
    for (int k = 0; k < count; ++k) {
      const double part = count == 1 ? 0.0 : static_cast<double>(k) / (count - 1);
      const double to = load.to ? load.to->fraction : load.at.fraction;
      const double at = load.at.fraction + part * (to - load.at.fraction);
      const Point2 tip = eye.at(point_at(record, last_sample(record), at));
      arrows.push_back({tip[0] - scale * direction[0], tip[1] - scale * direction[1],
                        scale * direction[0], scale * direction[1]});
    }
  }
  return arrows;
}

/// Draws a scale and the world's axes in place of labelled axes, which mean nothing in space.
void add_orientation(PlotScript& script, const Eye& eye, double meters_per_pixel) {
  script.command("unset border\nunset tics\nunset xlabel\nunset ylabel\nunset grid");
  double bar = std::pow(10.0, std::floor(std::log10(160.0 * meters_per_pixel)));
  if (bar * 5.0 <= 160.0 * meters_per_pixel)
    bar *= 5.0;
  else if (bar * 2.0 <= 160.0 * meters_per_pixel)
    bar *= 2.0;
  const double pixels = bar / meters_per_pixel;
  script.command(fmt::format(
      "set arrow 901 from graph {:.4f}, graph 0.02 to graph {:.4f}, graph 0.02 heads size screen "
      "0.005,90 linewidth 1.2 linecolor rgb '#333333'\n"
      "set label 901 '{:.4g} m' at graph {:.4f}, graph 0.02 offset 0,0.7 center textcolor rgb "
      "'#333333'",
      0.99 - pixels / kPlotWidth, 0.99, bar, 0.99 - 0.5 * pixels / kPlotWidth));
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Point3 unit{};
    unit[axis] = 1.0;
    const Point2 way = eye.at(unit);
    const double length = 42.0 * meters_per_pixel;
    script.command(fmt::format(
        "set arrow {0} from graph 0.04, graph 0.05 rto first {1:.6g}, first {2:.6g} size screen "
        "0.008,20 filled linewidth 1.2 linecolor rgb '#333333'\n"
        "set label {0} '{3}' at graph 0.04, graph 0.05 offset first {4:.6g}, first {5:.6g} center "
        "textcolor rgb '#333333'",
        910 + axis, length * way[0], length * way[1], kNames[axis], 1.4 * length * way[0],
        1.4 * length * way[1]));
  }
}

/// How many times as thick as it is a section is drawn.
double drawn_thickness(const io::SceneRecord& record, const Eye& eye, double size) {
  const auto& width = record.outline.width;
  const auto& height = record.outline.height;
  const double wide = *std::max_element(width.begin(), width.end());
  const double high = *std::max_element(height.begin(), height.end());
  if (in_space(record)) {
    return std::max(1.0, std::round(kLeastThicknessInSpace * size / std::max(wide, high)));
  }
  return std::max(1.0, std::round(kLeastThickness * size / (eye.up[0] == 1.0 ? wide : high)));
}

}  // namespace

PlotScript shape_page(const io::SceneRecord& record) {
  const Eye eye = eye_of(record);
  const std::size_t last = last_sample(record);
  const bool space = in_space(record);
  Extent axis;
  axis.add(axis_of(record, kUndeformed, eye));
  axis.add(axis_of(record, last, eye));
  const double size = std::max(axis.size(0), axis.size(1));
  const double thickness = drawn_thickness(record, eye, size);
  const BeamSolid solid = beam_solid(record, last, eye, thickness);

  Extent extent = axis;
  for (const Face& face : solid.faces) extent.add(face.corners);
  if (space) extent.low[1] -= 0.11 * size;  // room for scale and axes
  const std::vector<std::size_t> earlier = earlier_samples(record);
  if (!space) {
    for (const std::size_t sample : earlier) extent.add(axis_of(record, sample, eye));
  }
  const auto arrows = force_arrows(record, eye, 0.11 * size);
  for (const auto& arrow : arrows) extent.add(Point2{arrow[0], arrow[1]});

  double strain = 0.0;
  for (std::size_t i = 0; i < record.response.chain.joints; ++i) {
    strain = std::max(
        strain, record.response.chain.plastic_strain[last * record.response.chain.joints + i]);
  }
  const bool colored = strain > kNoStrain;

  // One scale on both axes: the picture is as high as the beam needs.
  const double width = kPlotWidth - (colored ? kBarWidth : 0.0);
  const double pad = 0.04 * size;
  double scale = (extent.size(0) + 2.0 * pad) / width;
  constexpr double kLeastHeight = 150.0;
  constexpr double kMostHeight = 640.0;
  const double wanted = (extent.size(1) + 2.0 * pad) / scale;
  const double height = std::clamp(wanted, kLeastHeight, kMostHeight);
  scale = std::max(scale, (extent.size(1) + 2.0 * pad) / height);

  PlotScript script;
  script.begin_panels(1, {}, static_cast<int>(1 + facts_of(record, thickness).size()));
  script.set_plot_height(height);
  const double x = 0.5 * (extent.low[0] + extent.high[0]);
  const double y = 0.5 * (extent.low[1] + extent.high[1]);
  script.command(fmt::format("set xrange [{:.7g}:{:.7g}]\nset yrange [{:.7g}:{:.7g}]",
                             x - 0.5 * width * scale, x - 0.5 * width * scale + kPlotWidth * scale,
                             y - 0.5 * height * scale, y + 0.5 * height * scale));
  if (space) {
    add_orientation(script, eye, scale);
  } else {
    script.command("set xlabel " + quoted("z [m]"));
    script.command("set ylabel " + quoted(eye.up[0] == 1.0 ? "x [m]" : "y [m]"));
    script.command("set ytics autofreq");
  }
  if (colored) {
    script.command(strain_palette());
    script.command(fmt::format("set cbrange [0:{:.5g}]", 100.0 * strain));
    script.command("set cbtics");
    script.command("set cblabel 'plastic strain [%]' textcolor rgb '#333333'");
    script.command(
        "set colorbox user origin graph 0.9, graph 0.15 size graph 0.02, graph 0.7 noborder");
  }
  script.begin_panel(title_of(record, thickness, 110));

  script.add_series(script.add_points(rows_of(axis_of(record, kUndeformed, eye))),
                    "using 1:2 with lines dashtype 2 linewidth 1.2 linecolor rgb '#8C8C8C'",
                    "undeformed axis");
  if (!space && !earlier.empty()) {
    std::vector<std::vector<std::vector<double>>> lists;
    for (const std::size_t sample : earlier) lists.push_back(rows_of(axis_of(record, sample, eye)));
    script.add_series(script.add_lists(lists),
                      "using 1:2 with lines linewidth 1 linecolor rgb '#C4C4C4'", "on the way");
  }
  std::vector<std::vector<std::vector<double>>> polygons;
  for (const Face& face : solid.faces) {
    const double share =
        colored ? record.response.chain
                          .plastic_strain[last * record.response.chain.joints + face.joint] /
                      strain
                : 0.0;
    const double color = color_at(share, space ? face.light : 1.0);
    std::vector<std::vector<double>> rows;
    for (const Point2& corner : face.corners) rows.push_back({corner[0], corner[1], color});
    polygons.push_back(std::move(rows));
  }
  script.add_unnamed(script.add_lists(polygons),
                     "using 1:2:3 with polygons fillcolor rgb variable fillstyle solid noborder");
  if (colored) {
    // What the bar of colours belongs to; it has no area.
    script.add_unnamed(script.add_points({{x, y, 0.0}}),
                       "using 1:2:3 with points pointtype 0 linecolor palette");
  }
  std::vector<std::vector<std::vector<double>>> edges;
  for (const auto& edge : solid.edges) edges.push_back(rows_of(edge));
  script.add_series(script.add_lists(edges),
                    "using 1:2 with lines linewidth 0.7 linecolor rgb '#4A5A68'", "segments");
  add_supports(script, record, eye);
  if (!arrows.empty()) {
    const std::string style = fmt::format("linewidth 1.8 linecolor rgb '{}'", kVermillion);
    script.add_unnamed(script.add_points(arrows),
                       "using 1:2:3:4 with vectors size screen 0.012,20 filled " + style);
    script.add_entry("with lines " + style, "force");
  }
  script.end_panel();
  return script;
}

PlotScript shape_terminal(const io::SceneRecord& record) {
  const Eye eye = eye_of(record);
  const auto before = axis_of(record, kUndeformed, eye);
  const auto after = axis_of(record, last_sample(record), eye);
  Extent extent;
  extent.add(before);
  extent.add(after);
  // A letter is twice as high as wide; 66 columns and 17 lines are left for the beam.
  const double scale = std::max({extent.size(0) / 66.0, extent.size(1) / 34.0, 1e-12});
  PlotScript script;
  begin_terminal(script);
  const double x = 0.5 * (extent.low[0] + extent.high[0]);
  const double y = 0.5 * (extent.low[1] + extent.high[1]);
  script.command(fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]",
                             x - 34.0 * scale, x + 34.0 * scale, y - 18.0 * scale,
                             y + 18.0 * scale));
  script.command("set title " + title_of(record, 1.0, 76));
  const auto dense = [&](const std::vector<Point2>& points) {
    return script.add_points(dense_points(rows_of(points), 68.0 * scale, 36.0 * scale));
  };
  const std::string undeformed = dense(before);
  const std::string deformed = dense(after);
  script.command(
      fmt::format("plot {} using 1:2 with points pointtype '.' title 'undeformed', \\\n"
                  "     {} using 1:2 with points pointtype '#' title 'at the last sample'",
                  undeformed, deformed));
  return script;
}

}  // namespace plastica::report
