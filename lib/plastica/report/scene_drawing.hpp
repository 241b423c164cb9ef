#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "plastica/report/beam_solid.hpp"
#include "plastica/report/plot_script.hpp"

/// What the pictures of a beam's shape have in common; not installed.
namespace plastica::report {

inline constexpr double kBarWidth = 110.0;  ///< room for the bar of colours [units of a page]
/// A plastic strain below this is what rounding leaves of an elastic one.
inline constexpr double kNoStrain = 1e-12;

struct Extent {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const Point2& point);
  void add(const std::vector<Point2>& points);
  void add(const Lines& lines);
  double size(std::size_t k) const { return high[k] - low[k]; }
  double middle(std::size_t k) const { return 0.5 * (low[k] + high[k]); }
};

/// Whether a beam is drawn in space, and not in its plane.
bool in_space(const io::SceneRecord& record);

/// From the side in the beam's plane; in space from the side and above.
Eye eye_of(const io::SceneRecord& record);

/// How many times as thick as it is a section is drawn.
/// @param size   of the picture [m]
/// @param least  fraction of it that a section is at least thick
double drawn_thickness(const io::SceneRecord& record, const Eye& eye, double size, double least);

/// Rows of a data block, moved by `shift`.
std::vector<std::vector<double>> rows_of(const std::vector<Point2>& points,
                                         const Point2& shift = {});
std::vector<std::vector<std::vector<double>>> lists_of(const Lines& lines,
                                                       const Point2& shift = {});

/// The largest plastic strain of a frame.
double largest_strain(const io::SceneRecord& record, std::size_t frame);

/// Where the supports are in a frame.
struct SupportMarks {
  std::vector<std::vector<Point2>> points;  ///< by kind, but pillars
  Lines pillars;                            ///< triangles whose tip is what the beam meets
  Lines surfaces;                           ///< from their tips to where the beam is on them
};

/// @param thickness  as for `beam_solid`
/// @param size       of the picture [m]
SupportMarks support_marks(const BeamPose& pose, const Eye& eye, double thickness, double size);

/// Forces as arrows (x, y, dx, dy) that end where they act; as they are at the pose's time.
std::vector<std::array<double, 4>> force_arrows(const BeamPose& pose, const Eye& eye,
                                                double length);

/// The parts of a picture of one or several frames, collected to be drawn in one plot.
class BeamPicture {
 public:
  /// @param strain  plastic strain of the last colour [1]; 0: no colours
  BeamPicture(const io::SceneRecord& record, const Eye& eye, double thickness, double strain)
      : record_(record), eye_(eye), thickness_(thickness), strain_(strain) {}

  /// Adds a frame, moved by `shift` on the picture.
  void add_frame(const BeamPose& pose, const Point2& shift, double arrow_length, double size);
  /// Puts all into a script's panel.
  /// @param lines_between  whether segments are told apart
  /// @param head           size of an arrow's [fraction of the picture's width]
  void put(PlotScript& script, bool lines_between, double head) const;

 private:
  const io::SceneRecord& record_;
  const Eye& eye_;
  double thickness_;
  double strain_;
  std::vector<std::vector<std::vector<double>>> faces_;
  std::vector<std::vector<std::vector<double>>> edges_;
  std::vector<std::vector<std::vector<double>>> segments_;
  std::vector<std::vector<std::vector<double>>> cuts_;
  std::vector<std::vector<std::vector<double>>> pillars_;
  std::vector<std::vector<std::vector<double>>> surfaces_;
  std::vector<std::vector<std::vector<double>>> supports_ =
      std::vector<std::vector<std::vector<double>>>(support_kinds().size());
  std::vector<std::vector<double>> arrows_;
};

/// Switches the bar of colours on. @param strain  of its upper end [1]
/// @param height  of the panel [units of a page]
void add_color_bar(PlotScript& script, double strain, double height);

/// Draws a scale and the world's axes in place of labelled axes, at the lower edge.
/// @param height  of the plot [pixels]
void add_orientation(PlotScript& script, const Eye& eye, double meters_per_pixel, double height);

}  // namespace plastica::report
