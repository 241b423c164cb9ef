#include "plastica/report/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <ostream>

#include <fmt/format.h>

#include "plastica/base/check.hpp"
#include "plastica/io/gnuplot.hpp"
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

/// `set terminal` for an output; empty for a script.
std::string terminal_of(const std::string& output, const PlotScript& script,
                        std::string_view option = "--output") {
  const auto height = [&](double usual) {
    return static_cast<int>(std::lround(usual * script.relative_height()));
  };
  if (output == "-") {
    return fmt::format("set terminal dumb noenhanced mono size {},{}\n", terminal_columns(),
                       script.terminal_rows);
  }
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending == ".gp") return {};
  if (ending == ".svg") {
    return fmt::format(
        "set terminal svg noenhanced size 900,{} font 'Helvetica,Arial,sans-serif,14' "
        "background rgb 'white'\n",
        height(560));
  }
  if (ending == ".png") {
    return fmt::format(
        "set terminal pngcairo noenhanced size 1350,{} font 'sans,15' "
        "linewidth 1.5\n",
        height(840));
  }
  if (ending == ".pdf") {
    return fmt::format("set terminal pdfcairo noenhanced size 18cm,{}cm font 'sans,11'\n",
                       0.01 * height(1120));
  }
  throw InputError({}, option, output, "must end in .svg, .png, .pdf or .gp, or be -");
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

void check_picture_output(const std::string& output, std::string_view option) {
  terminal_of(output, {}, option);
}

void draw_picture(const PlotScript& script, const std::string& output,
                  std::ostream& standard_output, io::Overwrite overwrite) {
  const std::string terminal = terminal_of(output, script);
  if (terminal.empty()) {
    io::write_text_file(
        output,
        "# Draw it with: gnuplot -p FILE, or: gnuplot -e \"set term svg\" FILE > FILE.svg\n" +
            script.text(),
        overwrite);
    return;
  }
  const std::string picture = io::run_gnuplot(terminal + script.text());
  if (output == "-") {
    standard_output << without_blank_ends(picture);
    if (!standard_output.flush()) throw io::StorageError("standard output", "cannot be written");
  } else {
    io::write_text_file(output, picture, overwrite);
  }
}

}  // namespace plastica::report
