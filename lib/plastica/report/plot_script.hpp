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

/// Width of a page where none is asked for [units].
inline constexpr double kUsualWidth = 900.0;

/// What a picture is drawn on.
struct Sheet {
  bool terminal = false;       ///< characters in place of a page
  double width = kUsualWidth;  ///< of a page, in units: its letters are 14 units high
  bool on_paper = false;       ///< letters are of 8 points, whatever the output
};

/// Right of the panels.
inline constexpr double kRightRoom = 22.0;
/// Of a letter of fonts that are wide.
inline constexpr double kLetterWidth = 8.2;

/// A script with its data blocks; commands are added as text, texts of users by `quoted`. Panels
/// are laid out once all is known that takes room: titles are wrapped, names in the legend are cut
/// to the width. Lengths are in the units of `Sheet`.
class PlotScript {
 public:
  explicit PlotScript(const Sheet& sheet = {});

  /// Adds a block of points. @return its name, "$data3"
  std::string add_points(const std::vector<std::vector<double>>& rows);
  /// Adds several lists of points as one block, a blank line between them: lines that are not
  /// joined. @return its name
  std::string add_lists(const std::vector<std::vector<std::vector<double>>>& lists);
  void command(std::string_view line);

  /// Equal panels with one legend below all of them; the first call of a picture of a page.
  /// @param title  above all panels; may be empty
  /// @param below  room for labels below a panel beyond the usual
  void begin_panels(std::size_t count, std::string_view title = {}, double below = 0.0);
  /// In its place: one panel, and a low one below it that has the same x; its numbers stand below
  /// the low one, so callers give both panels one range.
  void begin_panel_and_strip();
  /// Before the low panel: its numbers are few. @param low, high  of its y
  void begin_strip(double low, double high);
  /// Makes the one panel of a picture so high; before `begin_panel`.
  void set_plot_height(double height) { plot_height_ = height; }
  /// Of the panels from here on. Labels are cut to the room there is, but for their units.
  void set_x_label(std::string_view label) { x_label_ = label; }
  /// Of the panels from here on, at the left edge of the room for it: where gnuplot puts it depends
  /// on the output, and what leaves the picture is dropped without a word.
  void set_y_label(std::string_view label) { y_label_ = label; }
  /// What the next panel shows. @param title  its lines, as users wrote them
  void begin_panel(std::vector<std::string> title);
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

  /// Whether the panel that is drawn, or is next, stands at the left edge, and at the lower end of
  /// its column.
  bool at_left() const { return ended_ % columns_ == 0; }
  bool at_bottom() const { return ended_ + columns_ >= count_of_panels_; }

  /// Lines of a picture of characters.
  int terminal_rows = 23;

  double width() const { return sheet_.width; }
  bool on_paper() const { return sheet_.on_paper; }
  double height() const;
  /// Width of the panel's frame.
  double panel_width() const;
  /// Letters that have room above the panel, in a line.
  std::size_t title_letters() const;
  std::string text() const;

 private:
  struct Panel {
    std::size_t piece = 0;  ///< that says where it is, of `pieces_`
    std::vector<std::string> title;
    std::string x_label;
    std::string y_label;
  };

  std::string next_name();
  /// Or one plot, with or without a strip.
  bool has_many() const { return count_of_panels_ > 1 && !strip_; }
  std::size_t rows() const { return (count_of_panels_ + columns_ - 1) / columns_; }
  std::vector<std::string> wrapped_title(const Panel& panel) const;
  double room_of_titles() const;
  double room_of_legend() const;
  std::string place_of(std::size_t panel) const;
  std::size_t title_lines() const;
  std::string overall_title() const;

  Sheet sheet_;
  std::string blocks_;
  std::vector<std::string> pieces_{""};  ///< commands, and empty ones that the layout fills
  int count_ = 0;
  std::size_t count_of_panels_ = 1;
  std::size_t columns_ = 1;
  bool strip_ = false;
  double below_ = 0.0;
  double plot_height_ = 0.0;  ///< 0: the usual one
  std::string title_;
  std::string x_label_;
  std::string y_label_;
  std::size_t title_piece_ = 0;
  std::vector<Panel> panels_;
  std::size_t ended_ = 0;  ///< of them
  std::string plot_;       ///< series of the panel that is being drawn
  std::vector<std::string> names_;
  std::string legend_;
};

/// A user's text as a gnuplot string: printable, in quotes.
std::string in_quotes(std::string_view text);
/// Lines of a title, as a gnuplot string expression; longer ones are cut. @param letters  in a line
std::string in_quotes(const std::vector<std::string>& lines, std::size_t letters);
/// The same for a label of an axis, in which gnuplot would read % as a format.
std::string quoted_tic(std::string_view text);

}  // namespace plastica::report
