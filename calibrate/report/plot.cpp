#include "calibrate/report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/durable_file.hpp"
#include "plastica/io/gnuplot.hpp"
#include "plastica/io/storage_error.hpp"

namespace plastica::calibrate {
namespace {

using report::PlotScript;

constexpr std::array<PlotKind, 3> kKinds = {{
    {"curve", "one specimen: measured and fitted curve, yield and break (choose it with --case)"},
    {"overview", "all curves by group, with their mean, the fits and the breaks"},
    {"parameters", "the fitted parameters of all specimens by group"},
}};

const FitRecord& find_specimen(std::span<const FitRecord> records, const std::string& name) {
  if (name.empty()) return records.front();
  for (const FitRecord& record : records) {
    if (record.target.name == name) return record;
  }
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(records.size(), 8); ++i) {
    names += (i == 0 ? "" : ", ") + records[i].target.name;
  }
  if (records.size() > 8) names += ", …";
  throw InputError({}, "--case", name, "is not a specimen of this file; it has " + names);
}

PlotScript make(std::span<const FitRecord> records, const PlotRequest& request) {
  if (records.empty()) throw InputError({}, "plot", request.what, "there is no specimen to draw");
  std::string what = request.what;
  if (what.empty()) what = records.size() == 1 || !request.specimen.empty() ? "curve" : "overview";
  const bool terminal = request.output == "-";
  if (what == "curve") {
    const FitRecord& record = find_specimen(records, request.specimen);
    return terminal ? report::curve_terminal(record) : report::curve_plot(record);
  }
  if (what != "overview" && what != "parameters") {
    throw InputError({}, "--what", what, "must be curve, overview or parameters");
  }
  if (!request.specimen.empty()) {
    throw InputError({}, "--case", request.specimen, "goes with the picture 'curve' only");
  }
  if (what == "overview") {
    return terminal ? report::overview_terminal(records) : report::overview_plot(records);
  }
  return terminal ? report::parameters_terminal(records) : report::parameters_plot(records);
}

/// `set terminal` for an output; empty for a script.
std::string terminal_of(const std::string& output, const PlotScript& script) {
  const auto height = [&](double usual) {
    return static_cast<int>(std::lround(usual * script.relative_height()));
  };
  if (output == "-") {
    return fmt::format("set terminal dumb noenhanced mono size 79,{}\n", script.terminal_rows);
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
  throw InputError({}, "--output", output, "must end in .svg, .png, .pdf or .gp, or be -");
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

/// Writes beside the file and moves it into place, so that no half picture is left behind.
void write_file(const std::string& path, std::string_view content) {
  const std::string beside = path + ".part";
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  try {
    if (!out) throw io::StorageError(path, "cannot be written");
    io::move_into_place(beside, path);
  } catch (const io::StorageError&) {
    std::remove(beside.c_str());
    throw;
  }
}

}  // namespace

std::span<const PlotKind> plot_kinds() { return kKinds; }

std::string plot_script(std::span<const FitRecord> records, const PlotRequest& request) {
  return make(records, request).text();
}

void draw_plot(std::span<const FitRecord> records, const PlotRequest& request,
               std::ostream& standard_output) {
  terminal_of(request.output, {});  // an output of no kind is an error before any work is done
  const PlotScript script = make(records, request);
  const std::string terminal = terminal_of(request.output, script);
  if (terminal.empty()) {
    write_file(
        request.output,
        "# Draw it with: gnuplot -p FILE, or: gnuplot -e \"set term svg\" FILE > FILE.svg\n" +
            script.text());
    return;
  }
  const std::string picture = io::run_gnuplot(terminal + script.text());
  if (request.output == "-") {
    standard_output << without_blank_ends(picture);
    if (!standard_output.flush()) throw io::StorageError("standard output", "cannot be written");
  } else {
    write_file(request.output, picture);
  }
}

}  // namespace plastica::calibrate
