#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/target/curve.hpp"

namespace plastica::calibrate::report {

/// Colours that people tell apart whatever they see (Okabe and Ito 2008).
inline constexpr std::string_view kBlue = "#0072B2";
inline constexpr std::string_view kVermillion = "#D55E00";
inline constexpr std::string_view kGreen = "#009E73";
inline constexpr std::string_view kDark = "#333333";
inline constexpr std::string_view kGrey = "#8C8C8C";
inline constexpr std::string_view kLight = "#B8B8B8";

/// A script with its data blocks; commands are added as text, texts of users by `quoted`.
class PlotScript {
 public:
  PlotScript();

  /// Adds a block of points. @return its name, "$data3"
  std::string add_points(const std::vector<std::vector<double>>& rows);
  /// Adds a curve in % and MPa, thinned to what a picture can show.
  std::string add_curve(const Curve& curve);
  /// Adds several curves as one block, a blank line between them.
  std::string add_curves(const std::vector<const Curve*>& curves);
  void command(std::string_view line);

  /// The picture's size relative to the usual 900 x 560.
  double relative_height = 1.0;

  std::string text() const { return blocks_ + commands_; }

 private:
  std::string next_name();

  std::string blocks_;
  std::string commands_;
  int count_ = 0;
};

/// A user's text as a gnuplot string: printable, in quotes.
std::string quoted(std::string_view text);
/// The same for a label of an axis, in which gnuplot would read % as a format.
std::string quoted_tic(std::string_view text);

/// The points of a curve that change a picture: one that falls on the spot of the last kept one,
/// of `spots` along each axis, is left out. Infinite and NaN points are left out, too.
Curve thinned(const Curve& curve, std::size_t spots = 1500);

/// The mean of the curves over their strains, up to where the first of them ends; empty for fewer
/// than two and for curves whose strain turns back by more than noise.
Curve mean_curve(const std::vector<const Curve*>& curves);

}  // namespace plastica::calibrate::report
