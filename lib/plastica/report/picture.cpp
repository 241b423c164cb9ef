#include "plastica/report/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <ostream>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/base/machine_error.hpp"
#include "plastica/io/gnuplot.hpp"
#include "plastica/io/png_resolution.hpp"
#include "plastica/io/storage_error.hpp"
#include "plastica/io/text_file.hpp"

namespace plastica::report {
namespace {

/// Of a picture of characters: the environment variable COLUMNS less one, 39 … 79.
int terminal_columns() {
  const char* columns = std::getenv("COLUMNS");
  const int number = columns == nullptr ? 80 : std::atoi(columns);
  return number > 0 ? std::clamp(number, 40, 80) - 1 : 79;
}

/// Letters of 14 units are of 8 points.
constexpr double kMillimetres = 25.4 / 72.0 * 8.0 / 14.0;  ///< in a unit, on paper
constexpr int kFont = 15;                                  ///< others are given beside it
constexpr double kDotsOnPaper = 300.0;                     ///< of a PNG [1/inch]

/// `set terminal` for an output; empty for a script.
std::string terminal_of(const std::string& output, const PlotScript& script,
                        std::string_view option = "--output") {
  const double wide = script.width();
  const double high = script.height();
  const bool paper = script.on_paper();
  if (output == "-") {
    return fmt::format("set terminal dumb noenhanced mono size {},{}\n", terminal_columns(),
                       script.terminal_rows);
  }
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending == ".gp") return {};
  if (ending == ".svg") {
    return fmt::format(
        "set terminal svg noenhanced size {:.0f},{:.0f} font 'Helvetica,Arial,sans-serif,14' "
        "background rgb 'white'\n",
        wide, high);
  }
  if (ending == ".png") {
    const double dots = paper ? kDotsOnPaper * kMillimetres / 25.4 : 1.5;  // of a unit
    // The terminal's points are of 96 dots an inch.
    const double scale = paper ? 14.0 * dots * 72.0 / 96.0 / kFont : 1.0;
    return fmt::format(
        "set terminal pngcairo noenhanced size {:.0f},{:.0f} font 'sans,{}' fontscale {:.4g} "
        "linewidth {:.3g} pointscale {:.3g}\n",
        dots * wide, dots * high, kFont, scale, dots, paper ? dots / 1.5 : 1.0);
  }
  if (ending == ".pdf") {
    const double unit = paper ? 0.1 * kMillimetres : 0.02;  // [cm]
    return fmt::format(
        "set terminal pdfcairo noenhanced size {:.6g}cm,{:.6g}cm font 'sans,{}' fontscale {:.4g}\n",
        unit * wide, unit * high, paper ? kFont : 11, paper ? 8.0 / kFont : 0.5);
  }
  throw InputError({}, option, output, "must end in .svg, .png, .pdf or .gp, or be -");
}

/// gnuplot gives the size of an SVG in pixels.
void set_size_on_paper(const PlotScript& script, std::string& picture) {
  const std::string size =
      fmt::format("width=\"{:.0f}\" height=\"{:.0f}\"", script.width(), script.height());
  const std::size_t at = picture.find(size);
  if (at == picture.npos)
    throw MachineError("gnuplot's SVG does not say its size: expected " + size);
  picture.replace(at, size.size(),
                  fmt::format("width=\"{:.2f}mm\" height=\"{:.2f}mm\"",
                              script.width() * kMillimetres, script.height() * kMillimetres));
}

/// A picture of characters without the blanks at the ends of its lines and its empty lines at
/// the top.
std::string without_blank_ends(std::string_view picture) {
  std::string text;
  while (!picture.empty()) {
    const std::size_t end = std::min(picture.find('\n'), picture.size());
    std::string_view line = picture.substr(0, end);
    picture.remove_prefix(std::min(end + 1, picture.size()));
    line = line.substr(0, line.find_last_not_of(" \f\r") + 1);
    if (!text.empty() || !line.empty()) text.append(line).append("\n");
  }
  return text;
}

}  // namespace

Sheet sheet_of(const std::string& output, std::optional<double> width) {
  Sheet sheet;
  sheet.terminal = output == "-";
  if (width) {
    sheet.width = *width / kMillimetres;
    sheet.on_paper = true;
  }
  return sheet;
}

void check_picture_output(const std::string& output, std::string_view option) {
  terminal_of(output, PlotScript(), option);
}

void draw_picture(const PlotScript& script, const std::string& output,
                  std::ostream& standard_output, io::Overwrite overwrite) {
  const std::string terminal = terminal_of(output, script);
  if (terminal.empty()) {
    io::write_text_file(
        output,
        fmt::format(
            "# Draw it with: gnuplot -p FILE, or: gnuplot -e \"set term svg size {:.0f},{:.0f} "
            "font ',14'\" FILE > FILE.svg\n",
            script.width(), script.height()) +
            script.text(),
        overwrite);
    return;
  }
  std::string picture = io::run_gnuplot(terminal + script.text());
  if (script.on_paper() && output.ends_with(".svg")) set_size_on_paper(script, picture);
  if (script.on_paper() && output.ends_with(".png")) {
    io::set_png_resolution(picture, kDotsOnPaper);
  }
  if (output == "-") {
    standard_output << without_blank_ends(picture);
    if (!standard_output.flush()) throw io::StorageError("standard output", "cannot be written");
  } else {
    io::write_text_file(output, picture, overwrite);
  }
}

}  // namespace plastica::report
