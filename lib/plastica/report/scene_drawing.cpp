#include "plastica/report/scene_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "plastica/model/support_kind.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/strain_color.hpp"

namespace plastica::report {
namespace {

constexpr std::string_view kPillarColor = "#9A9A9A";
constexpr double kTouching = 0.002;  ///< gap that cannot be seen [fraction of the picture]

Point3 scaled(double factor, const Point3& v) { return sum({}, factor, v); }

double size_of(const Point3& v) { return std::sqrt(dot(v, v)); }

/// How far a section reaches along a direction, drawn so many times as thick.
double reach(const BeamPose& pose, std::size_t segment, const Point3& direction, double thickness) {
  const BeamOutline& outline = pose.record().outline;
  const double x = 0.5 * outline.width[segment] * dot(pose.section_axis(segment, 0), direction);
  const double y = 0.5 * outline.height[segment] * dot(pose.section_axis(segment, 1), direction);
  const bool round = outline.round[segment] != 0;
  return thickness * (round ? std::hypot(x, y) : std::fabs(x) + std::fabs(y));
}

/// Whether the joint that a support at an end has with the ground is cut.
bool has_let_go(const BeamPose& pose, const Support& support) {
  const bool start = support.at.fraction == 0.0 && pose.is_cut(0);
  return start || (support.at.fraction == 1.0 && pose.is_cut(pose.segments()));
}

/// Where a support is: what it does not hold goes with the beam.
Point3 place_of(const BeamPose& pose, const BeamPose& undeformed, const Support& support) {
  const Point3 beam = pose.point_at(support.at.fraction);
  const double factor = support.moves() ? support.history.at(pose.time()) : 0.0;
  const Point3 ground = sum(undeformed.point_at(support.at.fraction), factor, support.translation);
  if (has_let_go(pose, support)) return ground;
  const HeldFreedoms held = support.held();
  Point3 place = beam;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool springs = support.stiffness[k] > 0.0;
    if (held[k] || springs) place[k] = ground[k];
  }
  return place;
}

/// A triangle whose tip would touch the drawn beam where the pillar was told to stand; and, where
/// the beam lies on it, the way along its surface, which has no end, to where the beam does.
void add_pillar(const BeamPose& pose, const BeamPose& undeformed, const Support& support,
                const Eye& eye, double thickness, double size, SupportMarks& marks) {
  const Point3& normal = support.normal;
  const Point3 beam = pose.point_at(support.at.fraction);
  const double factor = support.moves() ? support.history.at(pose.time()) : 0.0;
  const Point3 foot = sum(sum(undeformed.point_at(support.at.fraction), -support.gap, normal),
                          factor, support.translation);
  const double half = reach(pose, pose.segment_at(support.at.fraction), normal, thickness);
  const Point2 tip = eye.at(sum(foot, -half, normal));
  const Point2 down = eye.at(scaled(-0.05 * size, normal));
  const Point2 across{-0.45 * down[1], 0.45 * down[0]};
  marks.pillars.push_back({tip,
                           {tip[0] + down[0] + across[0], tip[1] + down[1] + across[1]},
                           {tip[0] + down[0] - across[0], tip[1] + down[1] - across[1]},
                           tip});
  const double gap = dot(normal, sum(beam, -1.0, foot));
  if (gap < kTouching * size) {
    marks.surfaces.push_back({tip, eye.at(sum(beam, -gap - half, normal))});
  }
}

/// A load's force at the time of a pose, turned with its segment if it follows it.
Point3 force_of(const Load& load, const BeamPose& pose, const BeamPose& undeformed,
                double fraction) {
  const Point3 force = scaled(load.history.at(pose.time()), load.force);
  if (!load.follows) return force;
  const std::size_t segment = pose.segment_at(fraction);
  Point3 now{};
  for (std::size_t k = 0; k < 3; ++k) {
    now = sum(now, dot(force, undeformed.section_axis(segment, k)), pose.section_axis(segment, k));
  }
  return now;
}

/// The largest size that a load has at any time.
double largest_force(const Load& load) {
  double factor = 0.0;
  for (const double f : load.history.factor) factor = std::max(factor, std::fabs(f));
  return factor * size_of(load.force);
}

void append(std::vector<std::vector<std::vector<double>>>& to, const Lines& lines,
            const Point2& shift) {
  for (const auto& line : lines) to.push_back(rows_of(line, shift));
}

}  // namespace

void Extent::add(const Point2& point) {
  for (std::size_t k = 0; k < 2; ++k) {
    low[k] = std::min(low[k], point[k]);
    high[k] = std::max(high[k], point[k]);
  }
}

void Extent::add(const std::vector<Point2>& points) {
  for (const Point2& point : points) add(point);
}

void Extent::add(const Lines& lines) {
  for (const auto& line : lines) add(line);
}

bool in_space(const io::SceneRecord& record) { return record.level != Level::Planar; }

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

double drawn_thickness(const io::SceneRecord& record, const Eye& eye, double size, double least) {
  const auto& width = record.outline.width;
  const auto& height = record.outline.height;
  const double wide = *std::max_element(width.begin(), width.end());
  const double high = *std::max_element(height.begin(), height.end());
  const double seen = in_space(record) ? std::max(wide, high) : (eye.up[0] == 1.0 ? wide : high);
  return std::max(1.0, std::round(least * size / seen));
}

std::vector<std::vector<double>> rows_of(const std::vector<Point2>& points, const Point2& shift) {
  std::vector<std::vector<double>> rows;
  rows.reserve(points.size());
  for (const Point2& point : points) rows.push_back({point[0] + shift[0], point[1] + shift[1]});
  return rows;
}

std::vector<std::vector<std::vector<double>>> lists_of(const Lines& lines, const Point2& shift) {
  std::vector<std::vector<std::vector<double>>> lists;
  append(lists, lines, shift);
  return lists;
}

double largest_strain(const io::SceneRecord& record, std::size_t frame) {
  const ChainHistory& chain = record.response.chain;
  const auto first = chain.plastic_strain.begin() + static_cast<long>(frame * chain.joints);
  return *std::max_element(first, first + static_cast<long>(chain.joints));
}

SupportMarks support_marks(const BeamPose& pose, const Eye& eye, double thickness, double size) {
  SupportMarks marks;
  marks.points.resize(support_kinds().size());
  const BeamPose undeformed(pose.record(), kUndeformed);
  for (const Support& support : pose.record().setup.scene.supports) {
    if (traits_of(support).one_sided) {
      add_pillar(pose, undeformed, support, eye, thickness, size, marks);
    } else {
      // A bed by some of its springs.
      const int count = support.to ? 9 : 1;
      for (int i = 0; i < count; ++i) {
        Support here = support;
        const double to = support.to ? support.to->fraction : support.at.fraction;
        here.at.fraction += (to - support.at.fraction) * i / std::max(count - 1, 1);
        marks.points[static_cast<std::size_t>(support.kind)].push_back(
            eye.at(place_of(pose, undeformed, here)));
      }
    }
  }
  return marks;
}

std::vector<std::array<double, 4>> force_arrows(const BeamPose& pose, const Eye& eye,
                                                double length) {
  const BeamPose undeformed(pose.record(), kUndeformed);
  const auto& loads = pose.record().setup.scene.loads;
  double largest = 0.0;
  for (const Load& load : loads) {
    if (!load.to) largest = std::max(largest, largest_force(load));
  }
  std::vector<std::array<double, 4>> arrows;
  for (const Load& load : loads) {
    const int count = load.to ? 9 : 1;
    for (int k = 0; k < count; ++k) {
      const double part = count == 1 ? 0.0 : static_cast<double>(k) / (count - 1);
      const double to = load.to ? load.to->fraction : load.at.fraction;
      const double at = load.at.fraction + part * (to - load.at.fraction);
      const Point3 force = force_of(load, pose, undeformed, at);
      const double size = size_of(force);
      if (!(size > 1e-6 * largest_force(load))) continue;
      const double fraction = load.to ? 0.6 * size / largest_force(load) : size / largest;
      const double scale = length * std::max(fraction, 0.3) / size;
      const Point2 arrow = eye.at(scaled(scale, force));
      const Point2 tip = eye.at(pose.point_at(at));
      arrows.push_back({tip[0] - arrow[0], tip[1] - arrow[1], arrow[0], arrow[1]});
    }
  }
  return arrows;
}

void BeamPicture::add_frame(const BeamPose& pose, const Point2& shift, double arrow_length,
                            double size) {
  const ChainHistory& chain = record_.response.chain;
  const BeamSolid solid = beam_solid(pose, eye_, thickness_);
  for (const Face& face : solid.faces) {
    const double strain = chain.plastic_strain[pose.frame() * chain.joints + face.joint];
    const double color =
        color_at(strain_ > 0.0 ? strain / strain_ : 0.0, in_space(record_) ? face.light : 1.0);
    std::vector<std::vector<double>> rows;
    for (const Point2& corner : face.corners) {
      rows.push_back({corner[0] + shift[0], corner[1] + shift[1], color});
    }
    faces_.push_back(std::move(rows));
  }
  append(edges_, solid.edges, shift);
  append(segments_, solid.segments, shift);
  append(cuts_, solid.cuts, shift);
  const SupportMarks marks = support_marks(pose, eye_, thickness_, size);
  append(pillars_, marks.pillars, shift);
  append(surfaces_, marks.surfaces, shift);
  for (std::size_t kind = 0; kind < supports_.size(); ++kind) {
    for (auto& row : rows_of(marks.points[kind], shift)) supports_[kind].push_back(std::move(row));
  }
  for (const auto& arrow : force_arrows(pose, eye_, arrow_length)) {
    arrows_.push_back({arrow[0] + shift[0], arrow[1] + shift[1], arrow[2], arrow[3]});
  }
}

void BeamPicture::put(PlotScript& script, bool lines_between, double head) const {
  if (!pillars_.empty()) {
    script.add_unnamed(script.add_lists(pillars_),
                       fmt::format("using 1:2 with polygons fillcolor rgb '{}' fillstyle solid "
                                   "border linecolor rgb '{}'",
                                   kPillarColor, kDark));
    script.add_entry(
        fmt::format("with points pointtype 9 pointsize 1.3 linecolor rgb '{}'", kPillarColor),
        "pillar");
  }
  script.add_unnamed(script.add_lists(faces_),
                     "using 1:2:3 with polygons fillcolor rgb variable fillstyle solid noborder");
  const std::string thin = "using 1:2 with lines linewidth 0.7 linecolor rgb '#4A5A68'";
  script.add_unnamed(script.add_lists(edges_), thin);
  if (lines_between && !segments_.empty()) {
    script.add_series(script.add_lists(segments_), thin, "segments");
  }
  if (!cuts_.empty()) {
    script.add_series(script.add_lists(cuts_),
                      "using 1:2 with lines linewidth 2 linecolor rgb '#000000'", "cut");
  }
  for (const SupportTraits& kind : support_traits()) {
    const auto& points = supports_[static_cast<std::size_t>(kind.kind)];
    if (points.empty()) continue;
    script.add_series(script.add_points(points),
                      fmt::format("using 1:2 with points pointtype {} pointsize 1.3 linewidth 1.6 "
                                  "linecolor rgb '{}'",
                                  kind.symbol, kDark),
                      kind.word);
  }
  if (arrows_.empty()) return;
  const std::string style = fmt::format("linewidth 1.8 linecolor rgb '{}'", kVermillion);
  script.add_unnamed(
      script.add_points(arrows_),
      fmt::format("using 1:2:3:4 with vectors size screen {},20 filled {}", head, style));
  script.add_entry("with lines " + style, "force");
}

void add_color_bar(PlotScript& script, double strain, double height) {
  constexpr double kPart = 0.7;  // of the height
  script.command(strain_palette());
  script.command(fmt::format("set cbrange [0:{:.5g}]", 100.0 * strain));
  script.command(fmt::format("set cbtics {:.3g}",
                             round_step(100.0 * strain, static_cast<int>(kPart * height / 24.0))));
  script.command("set cblabel 'plastic strain [%]' textcolor rgb '#333333'");
  script.command(fmt::format(
      "set colorbox user origin graph {:.4f}, graph 0.15 size graph {:.4f}, graph {} noborder",
      1.0 - 92.0 / script.panel_width(), 16.0 / script.panel_width(), kPart));
}

void add_orientation(PlotScript& script, const Eye& eye, double meters_per_pixel, double height) {
  script.command("unset border\nunset tics\nunset xlabel\nunset ylabel\nunset grid");
  double bar = std::pow(10.0, std::floor(std::log10(160.0 * meters_per_pixel)));
  if (bar * 5.0 <= 160.0 * meters_per_pixel)
    bar *= 5.0;
  else if (bar * 2.0 <= 160.0 * meters_per_pixel)
    bar *= 2.0;
  const double pixels = bar / meters_per_pixel;
  const double foot = 14.0 / height;  // of the picture
  script.command(fmt::format(
      "set arrow 901 from graph {0:.4f}, graph {1:.4f} to graph 0.99, graph {1:.4f} heads size "
      "screen 0.005,90 linewidth 1.2 linecolor rgb '#333333'\n"
      "set label 901 '{2:.4g} m' at graph {3:.4f}, graph {1:.4f} offset 0,0.7 center textcolor rgb "
      "'#333333'",
      0.99 - pixels / script.panel_width(), foot, bar, 0.99 - 0.5 * pixels / script.panel_width()));
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Point3 unit{};
    unit[axis] = 1.0;
    const Point2 arrow = eye.at(unit);
    if (std::hypot(arrow[0], arrow[1]) < 1e-6) continue;  // seen from its end
    const double length = 42.0 * meters_per_pixel;
    script.command(fmt::format(
        "set arrow {0} from graph 0.04, graph {6:.4f} rto first {1:.6g}, first {2:.6g} size screen "
        "0.008,20 filled linewidth 1.2 linecolor rgb '#333333'\n"
        "set label {0} '{3}' at graph 0.04, graph {6:.4f} offset first {4:.6g}, first {5:.6g} "
        "center textcolor rgb '#333333'",
        910 + axis, length * arrow[0], length * arrow[1], kNames[axis], 1.4 * length * arrow[0],
        1.4 * length * arrow[1], foot));
  }
}

}  // namespace plastica::report
