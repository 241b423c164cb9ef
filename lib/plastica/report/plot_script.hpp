#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Pictures as gnuplot scripts that hold their data.
namespace plastica::report {

/// Colours that people tell apart whatever they see (Okabe and Ito 2008).
inline constexpr std::string_view kBlue = "#0072B2";
inline constexpr std::string_view kVermillion = "#D55E00";
inline constexpr std::string_view kDark = "#333333";
inline constexpr std::string_view kGrey = "#8C8C8C";

/// A script with its data blocks; commands are added as text, texts of users by `quoted`.
class PlotScript {
 public:
  PlotScript();

  /// Adds a block of points. @return its name, "$data3"
  std::string add_points(const std::vector<std::vector<double>>& rows);
  /// Adds several lists of points as one block, a blank line between them: lines that are not
  /// joined. @return its name
  std::string add_lists(const std::vector<std::vector<std::vector<double>>>& lists);
  void command(std::string_view line);

  /// Lays out equal panels with one legend below all of them; the first call of a picture.
  /// @param title  above all panels; may be empty
  /// @param head   lines that the title of a panel takes
  /// @param below  room for labels below a panel beyond the usual [pixels of 900 in a row]
  void begin_panels(std::size_t count, std::string_view title = {}, int head = 1,
                    double below = 0.0);
  /// Makes the one panel of a picture so high; before `begin_panel`. [pixels of 900 in a row]
  void set_plot_height(double pixels);
  /// What the next panel shows.
  /// @param title  of the panel, as a gnuplot string expression
  void begin_panel(std::string_view title);
  /// Adds a series to the panel.
  /// @param block  its data: a name that `add_…` gave
  /// @param style  "using 1:2 with lines …"
  /// @param name   in the legend; each name is there once
  void add_series(std::string_view block, std::string_view style, std::string_view name);
  /// Adds a series that is not in the legend.
  void add_unnamed(std::string_view block, std::string_view style);
  /// Adds a line to the legend. @param style  "with lines …"
  void add_entry(std::string_view style, std::string_view name);
  /// Draws the panel.
  void end_panel();

  /// Whether the next panel stands at the left edge, and at the lower end of its column.
  bool at_left() const { return panel_ % columns_ == 0; }
  bool at_bottom() const { return panel_ + columns_ >= count_of_panels_; }

  /// Lines of a picture of characters.
  int terminal_rows = 23;

  /// The picture's height relative to the usual 900 x 560.
  double relative_height() const { return relative_height_; }
  std::string text() const { return blocks_ + commands_; }

 private:
  std::string next_name();

  std::string blocks_;
  std::string commands_;
  int count_ = 0;
  double relative_height_ = 1.0;
  std::size_t count_of_panels_ = 1;
  std::size_t columns_ = 1;
  double below_ = 0.0;
  double head_ = 0.0;      ///< room above the panels, in pixels of a picture 900 wide
  std::size_t panel_ = 0;  ///< the one being drawn, or next
  std::string plot_;       ///< its series
  std::vector<std::string> names_;
  std::string legend_;
};

/// Rows that gnuplot makes of a legend below a picture 900 wide.
/// @param panels  of the picture: the legend of one is as wide as its plot
std::size_t legend_rows(const std::vector<std::string>& names, std::size_t panels);

/// A user's text as a gnuplot string: printable, in quotes.
std::string in_quotes(std::string_view text);
/// The same for a label of an axis, in which gnuplot would read % as a format.
std::string quoted_tic(std::string_view text);

}  // namespace plastica::report
