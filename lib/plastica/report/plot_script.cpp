#include "plastica/report/plot_script.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "plastica/io/gnuplot.hpp"
#include "plastica/report/format.hpp"

namespace plastica::report {
namespace {

/// Height of a picture of one panel, 900 wide.
constexpr double kHeight = 560.0;
/// Below the panels: labels and a legend of one row.
constexpr double kBottom = 106.0;
/// Left of a panel: numbers of five letters and the label, which gnuplot leaves out, without a
/// word, where it has no room.
constexpr double kLeft = 104.0;
/// gnuplot's number of the label of y.
constexpr int kLabelTag = 899;
/// Between panels side by side, and one above the other.
constexpr double kBetween = 84.0;
constexpr double kAbove = 92.0;
/// Of a row of panels among others.
constexpr double kRow = 264.0;
/// A panel side by side with others is at least so wide.
constexpr double kNarrowest = 180.0;
/// Height of a strip below a panel, and the room between.
constexpr double kStrip = 116.0;
constexpr double kAboveStrip = 26.0;
constexpr double kLine = 20.0;         ///< of a title
constexpr std::size_t kMostLines = 2;  ///< of the title of one panel among others
constexpr double kLegendLine = 19.0;
/// gnuplot's own have a blank in place of a sign, and stand aside of their ticks.
constexpr std::string_view kPlainNumbers = "set format x '%h'";

void put_rows(std::string& block, const std::vector<std::vector<double>>& rows) {
  for (const std::vector<double>& row : rows) {
    for (const double value : row) fmt::format_to(std::back_inserter(block), "{:.10g} ", value);
    block += '\n';
  }
}

/// Facts that stand apart by blanks, or end with a semicolon.
std::vector<std::string> facts_in(const std::string& text) {
  std::vector<std::string> facts;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t blanks = text.find("  ", from);
    const std::size_t semicolon = text.find("; ", from);
    const std::size_t end =
        std::min({blanks, semicolon == text.npos ? semicolon : semicolon + 1, text.size()});
    facts.push_back(text.substr(from, end - from));
    from = text.find_first_not_of(' ', end);
    if (from == text.npos) break;
  }
  return facts;
}

/// Broken between facts where there are several, between words of one that is longer than a line.
/// @param letters  in a line
std::vector<std::string> lines_of(const std::string& text, std::size_t letters) {
  if (width_of(text) <= letters) return {text};
  std::vector<std::string> lines;
  for (const std::string& fact : facts_in(text)) {
    const bool semicolon = !lines.empty() && lines.back().ends_with(';');
    const std::string_view between = semicolon ? " " : "    ";
    if (!lines.empty() && width_of(lines.back()) + between.size() + width_of(fact) <= letters) {
      lines.back().append(between).append(fact);
      continue;
    }
    std::istringstream parts(wrapped("", fact, letters));
    for (std::string part; std::getline(parts, part);) lines.push_back(part);
  }
  return lines;
}

/// A name is cut, but not its unit: "reaction of the h… [N]".
std::string cut_label(const std::string& label, std::size_t letters) {
  const std::size_t unit = label.ends_with(']') ? label.rfind(" [") : label.npos;
  if (unit == label.npos) return cut(label, letters);
  const std::size_t taken = width_of(label.substr(unit));
  return cut(label.substr(0, unit), letters > taken + 1 ? letters - taken : 1) + label.substr(unit);
}

std::size_t letters_in(double width) { return static_cast<std::size_t>(width / kLetterWidth); }

}  // namespace

PlotScript::PlotScript(const Sheet& sheet) : sheet_(sheet) {
  command(
      "set encoding utf8\n"
      "set termoption noenhanced\n"
      "set border 3 linewidth 0.8 linecolor rgb '#333333'\n"
      "set tics nomirror out scale 0.6 textcolor rgb '#333333'\n"
      "set grid ytics linecolor rgb '#E4E4E4' linewidth 0.6 linetype 1\n"
      "set errorbars 0");
}

std::string PlotScript::next_name() { return fmt::format("$data{}", ++count_); }

std::string PlotScript::add_points(const std::vector<std::vector<double>>& rows) {
  return add_lists({rows});
}

std::string PlotScript::add_lists(const std::vector<std::vector<std::vector<double>>>& lists) {
  std::string name = next_name();
  blocks_ += name + " << END_OF_DATA\n";
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (i > 0) blocks_ += '\n';
    put_rows(blocks_, lists[i]);
  }
  blocks_ += "END_OF_DATA\n";
  return name;
}

void PlotScript::command(std::string_view line) { pieces_.back().append(line).append("\n"); }

void PlotScript::begin_panels(std::size_t count, std::string_view title, double below) {
  below_ = below;
  count_of_panels_ = count;
  const std::size_t usual = count <= 3 ? count : (count == 4 ? 2 : 3);
  const double room = (sheet_.width - kLeft - kRightRoom + kBetween) / (kNarrowest + kBetween);
  columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(room), 1, usual);
  title_ = title;
  command(
      "set key at screen 0.5, screen 0.015 center bottom horizontal reverse Left samplen 2 "
      "width 1 textcolor rgb '#333333'\n"
      // Both stand far off.
      "set xlabel offset 0,0.3\nset title offset 0,-0.5");
  command(kPlainNumbers);
  if (count == 1) return;
  title_piece_ = pieces_.size();
  pieces_.insert(pieces_.end(), 2, "");
}

void PlotScript::begin_panel_and_strip() {
  strip_ = true;
  begin_panels(2);
  columns_ = 1;
  command("set format x ''");
}

void PlotScript::begin_strip(double low, double high) {
  constexpr int kMostNumbers = 3;
  command(kPlainNumbers);
  command(high > low ? fmt::format("set ytics {:.7g}", round_step(high - low, kMostNumbers))
                     : std::string("set ytics autofreq"));
}

void PlotScript::begin_panel(std::vector<std::string> title) {
  panels_.push_back({pieces_.size(), std::move(title), x_label_, y_label_});
  pieces_.insert(pieces_.end(), 2, "");
  plot_.clear();
}

double PlotScript::panel_width() const {
  const auto columns = static_cast<double>(columns_);
  return (sheet_.width - kRightRoom - kLeft - kBetween * (columns - 1.0)) / columns;
}

std::size_t PlotScript::title_letters() const {
  // Titles stand above the middle of their panels.
  const double wide =
      columns_ == 1 ? sheet_.width - (kLeft - kRightRoom) : panel_width() + kBetween;
  return letters_in(wide);
}

std::vector<std::string> PlotScript::wrapped_title(const Panel& panel) const {
  std::vector<std::string> lines;
  for (const std::string& line : panel.title) {
    if (line.empty()) continue;
    std::vector<std::string> parts = lines_of(line, title_letters());
    if (has_many() && parts.size() > kMostLines) {
      parts.resize(kMostLines);
      parts.back() = cut(parts.back() + " …", title_letters());
    }
    for (std::string& part : parts) lines.push_back(std::move(part));
  }
  return lines;
}

/// Of the panel that has most.
std::size_t PlotScript::title_lines() const {
  std::size_t lines = 1;
  for (const Panel& panel : panels_) lines = std::max(lines, wrapped_title(panel).size());
  return lines;
}

double PlotScript::room_of_titles() const {
  const std::size_t lines = title_lines();
  const std::size_t above =
      title_.empty() || !has_many() ? 0 : lines_of(title_, letters_in(sheet_.width)).size();
  return 26.0 + kLine * static_cast<double>(lines) +
         (above > 0 ? 6.0 + kLine * static_cast<double>(above) : 0.0);
}

/// Beyond one row. gnuplot's columns are 187, 245 and 295 units apart for names of 13, 19 and 22
/// letters; the legend of one panel is as wide as its plot.
double PlotScript::room_of_legend() const {
  std::size_t longest = 0;
  for (const std::string& name : names_) longest = std::max(longest, width_of(name));
  const double wide = count_of_panels_ == 1 ? panel_width() : 0.96 * sheet_.width;
  const auto across = static_cast<std::size_t>(wide) / (65 + 10 * longest);
  const std::size_t columns = std::max<std::size_t>(1, across);
  const std::size_t rows = (names_.size() + columns - 1) / columns;
  return kLegendLine * static_cast<double>(std::max<std::size_t>(rows, 1) - 1);
}

double PlotScript::height() const {
  const double frame = room_of_titles() + kBottom + below_ + room_of_legend();
  const bool usual = sheet_.width >= kUsualWidth;
  const double strip = strip_ ? kStrip + kAboveStrip : 0.0;
  if (has_many()) {
    const double row = kRow + kLine * static_cast<double>(title_lines() - 1);
    const double panels = row * static_cast<double>(rows());
    return usual ? 0.3 * kHeight + panels : frame - kAbove + panels;
  }
  if (plot_height_ > 0.0) return frame + plot_height_;
  // A tall legend must not take the plot's room.
  if (usual) return strip + (room_of_legend() > 60.0 ? frame + 390.0 : kHeight);
  return strip + frame + (sheet_.width < 600.0 ? 0.72 : 0.5) * panel_width();
}

std::string PlotScript::place_of(std::size_t panel) const {
  const double all = height();
  const double above = kAbove + below_ + kLine * static_cast<double>(title_lines() - 1);
  const auto count = static_cast<double>(rows());
  const double bottom = kBottom + below_ + room_of_legend();
  const double head = room_of_titles();
  const double wide = panel_width();
  double high = (all - head - bottom - above * (count - 1.0)) / count;
  const double x = kLeft + static_cast<double>(panel % columns_) * (wide + kBetween);
  const std::size_t row = panel / columns_;
  double y = all - head - static_cast<double>(row) * (high + above);
  if (strip_) {
    high = panel == 0 ? all - head - bottom - kStrip - kAboveStrip : kStrip;
    y = panel == 0 ? all - head : bottom + kStrip;
  }
  const double room_left = panel % columns_ == 0 ? kLeft : kBetween;
  const double middle = y - 0.5 * high;
  const double upright = has_many() || strip_ ? high + (strip_ ? kAboveStrip : above)
                                              : 2.0 * std::min(middle, all - middle);
  return fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set title {} textcolor rgb '#333333'\nset xlabel {}\n"
      "set ylabel ''\nset label {} {} at screen {:.4f}, graph 0.5 center rotate by 90\n",
      x / sheet_.width, (x + wide) / sheet_.width, y / all, (y - high) / all,
      in_quotes(wrapped_title(panels_[panel]), title_letters()),
      in_quotes(cut_label(panels_[panel].x_label, title_letters())), kLabelTag,
      in_quotes(cut_label(panels_[panel].y_label, letters_in(upright - 10.0))),
      (x - room_left + kLetterWidth) / sheet_.width);
}

std::string PlotScript::overall_title() const {
  if (title_.empty()) return "set multiplot\n";
  const std::size_t letters = letters_in(sheet_.width);
  return "set multiplot title " + in_quotes(lines_of(title_, letters), letters) + "\n";
}

std::string PlotScript::text() const {
  std::vector<std::string> pieces = pieces_;
  if (title_piece_ > 0) pieces[title_piece_] = overall_title();
  for (std::size_t k = 0; k < panels_.size(); ++k) pieces[panels_[k].piece] = place_of(k);
  std::string text = blocks_;
  for (const std::string& piece : pieces) text += piece;
  return text;
}

void PlotScript::add_series(std::string_view block, std::string_view style, std::string_view name) {
  const auto known = std::find(names_.begin(), names_.end(), name);
  const bool fresh = known == names_.end();
  // A line type for each name: pictures of characters tell lines apart by it.
  std::string styled(style);
  const std::size_t kind = styled.find(' ', styled.find("with ") + 5);
  styled.insert(kind, fmt::format(" linetype {}", known - names_.begin() + 1));
  const std::string_view separator = plot_.empty() ? "plot " : ", \\\n     ";
  plot_ += fmt::format("{}{} {} notitle", separator, block, styled);
  if (fresh) add_entry(styled.substr(styled.find("with ")), name);
}

void PlotScript::add_entry(std::string_view style, std::string_view name) {
  if (std::ranges::find(names_, name) != names_.end()) return;
  names_.emplace_back(name);
  const std::string shown = cut(name, letters_in(sheet_.width - 60.0));
  legend_ += fmt::format(", \\\n     keyentry {} title {}", style, in_quotes(shown));
}

void PlotScript::add_unnamed(std::string_view block, std::string_view style) {
  plot_ += fmt::format("{}{} {} notitle", plot_.empty() ? "plot " : ", \\\n     ", block, style);
}

void PlotScript::end_panel() {
  if (count_of_panels_ == 1) {
    command((plot_.empty() ? "plot NaN notitle" : plot_) + legend_);
  } else {
    command(plot_.empty() ? "plot NaN notitle" : plot_);
  }
  ++ended_;
  if (ended_ < count_of_panels_ || count_of_panels_ == 1) return;
  // A legend is as wide as its plot: that of all panels belongs to an empty plot of full width.
  command(
      "set lmargin at screen 0.02\nset rmargin at screen 0.98\nunset border\nunset tics\nunset "
      "xzeroaxis\n"
      "unset grid\nunset logscale\nunset title\nunset xlabel\nunset label\nset xrange [0:1]\nset "
      "yrange [0:1]\n"
      "set offsets 0, 0, 0, 0");
  command("plot NaN notitle" + legend_ + "\nunset multiplot");
}

std::string in_quotes(std::string_view text) {
  std::string line = printable(text);
  // gnuplot's SVG does not escape the end of a CDATA section, which XML forbids in a text.
  for (std::size_t at = line.find("]]>"); at != line.npos; at = line.find("]]>", at)) {
    line.insert(at + 2, " ");
  }
  return io::gnuplot_string(line);
}

std::string in_quotes(const std::vector<std::string>& lines, std::size_t letters) {
  std::string text;
  for (const std::string& line : lines) {
    text += (text.empty() ? "" : ".\"\\n\".") + in_quotes(cut(line, letters));
  }
  return text.empty() ? in_quotes("") : text;
}

std::string quoted_tic(std::string_view text) {
  std::string doubled;
  for (const char c : text) doubled += c == '%' ? "%%" : std::string(1, c);
  return in_quotes(doubled);
}

}  // namespace plastica::report
