#include "plastica/report/plot_script.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "plastica/io/gnuplot.hpp"
#include "plastica/report/format.hpp"

namespace plastica::report {
namespace {

/// In pixels of a picture 900 wide.
constexpr double kHeight = 560.0;
/// Below the panels: labels and the legend.
constexpr double kBottom = 106.0;
/// Left of a panel: numbers of five letters and the label, which gnuplot leaves out, without a
/// word, where it has no room.
constexpr double kLeft = 98.0;

void put_rows(std::string& block, const std::vector<std::vector<double>>& rows) {
  for (const std::vector<double>& row : rows) {
    for (const double value : row) fmt::format_to(std::back_inserter(block), "{:.7g} ", value);
    block += '\n';
  }
}

}  // namespace

PlotScript::PlotScript() {
  commands_ =
      "set encoding utf8\n"
      "set termoption noenhanced\n"
      "set border 3 linewidth 0.8 linecolor rgb '#333333'\n"
      "set tics nomirror out scale 0.6 textcolor rgb '#333333'\n"
      "set grid ytics linecolor rgb '#E4E4E4' linewidth 0.6 linetype 1\n"
      "set errorbars 0\n";
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

void PlotScript::command(std::string_view line) { commands_.append(line).append("\n"); }

void PlotScript::begin_panels(std::size_t count, std::string_view title, int head, double below) {
  below_ = below;
  count_of_panels_ = count;
  columns_ = count <= 3 ? count : (count == 4 ? 2 : 3);
  const std::size_t rows = (count + columns_ - 1) / columns_;
  relative_height_ = count == 1 ? 1.0 : 0.3 + 0.45 * static_cast<double>(rows);
  head_ = 26.0 + 20.0 * head + (title.empty() ? 0.0 : 26.0);
  command(
      "set key at screen 0.5, screen 0.015 center bottom horizontal reverse Left samplen 2 "
      "width 1 textcolor rgb '#333333'");
  if (count > 1) {
    command("set multiplot" + (title.empty() ? std::string() : " title " + in_quotes(title)));
  }
}

void PlotScript::set_plot_height(double pixels) {
  relative_height_ = (pixels + head_ + kBottom + below_) / kHeight;
}

void PlotScript::begin_panel(std::string_view title) {
  // In pixels of a picture 900 wide: room for labels, titles and the legend.
  const double height = kHeight * relative_height_;
  const double bottom = kBottom + below_;
  const double between = 84.0;
  const double above = 78.0 + below_;
  const auto columns = static_cast<double>(columns_);
  const std::size_t count_of_rows = (count_of_panels_ + columns_ - 1) / columns_;
  const auto rows = static_cast<double>(count_of_rows);
  const std::size_t row = panel_ / columns_;
  const double wide = (900.0 - 22.0 - kLeft - between * (columns - 1.0)) / columns;
  const double high = (height - head_ - bottom - above * (rows - 1.0)) / rows;
  const double x = kLeft + static_cast<double>(panel_ % columns_) * (wide + between);
  const double y = height - head_ - static_cast<double>(row) * (high + above);
  command(
      fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
                  "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}",
                  x / 900.0, (x + wide) / 900.0, y / height, (y - high) / height));
  command("set title " + std::string(title) + " textcolor rgb '#333333'");
  plot_.clear();
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
  legend_ += fmt::format(", \\\n     keyentry {} title {}", style, in_quotes(name));
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
  ++panel_;
  if (panel_ < count_of_panels_ || count_of_panels_ == 1) return;
  // A legend is as wide as its plot: that of all panels belongs to an empty plot of full width.
  command(
      "set lmargin at screen 0.02\nset rmargin at screen 0.98\nunset border\nunset tics\nunset "
      "xzeroaxis\n"
      "unset grid\nunset logscale\nunset title\nunset xlabel\nunset ylabel\nset xrange [0:1]\nset "
      "yrange [0:1]\n"
      "set offsets 0, 0, 0, 0");
  command("plot NaN notitle" + legend_ + "\nunset multiplot");
}

std::size_t legend_rows(const std::vector<std::string>& names, std::size_t panels) {
  std::size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, width_of(name));
  // Columns are 187, 245 and 295 pixels apart for names of 13, 19 and 22 letters.
  const std::size_t wide = panels == 1 ? 780 : 864;
  const std::size_t columns = std::max<std::size_t>(1, wide / (65 + 10 * longest));
  return (names.size() + columns - 1) / columns;
}

std::string in_quotes(std::string_view text) {
  std::string line = printable(text);
  // gnuplot's SVG does not escape the end of a CDATA section, which XML forbids in a text.
  for (std::size_t at = line.find("]]>"); at != line.npos; at = line.find("]]>", at)) {
    line.insert(at + 2, " ");
  }
  return io::gnuplot_string(line);
}

std::string quoted_tic(std::string_view text) {
  std::string doubled;
  for (const char c : text) doubled += c == '%' ? "%%" : std::string(1, c);
  return in_quotes(doubled);
}

}  // namespace plastica::report
