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
#include "plastica/base/machine_error.hpp"
#include "plastica/io/gnuplot.hpp"

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
  if (what == "curve") return report::curve_plot(find_specimen(records, request.specimen));
  if (what != "overview" && what != "parameters") {
    throw InputError({}, "--what", what, "must be curve, overview or parameters");
  }
  if (!request.specimen.empty()) {
    throw InputError({}, "--case", request.specimen, "goes with the picture 'curve' only");
  }
  return what == "overview" ? report::overview_plot(records) : report::parameters_plot(records);
}

/// `set terminal` for an output; empty for a script.
std::string terminal_of(const std::string& output, double relative_height) {
  const auto height = [&](double usual) {
    return static_cast<int>(std::lround(usual * relative_height));
  };
  if (output == "-") return fmt::format("set terminal dumb noenhanced size 98,{}\n", height(32));
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

/// Writes beside the file and moves it into place, so that no half picture is left behind.
void write_file(const std::string& path, std::string_view content) {
  const std::string beside = path + ".part";
  {
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) {
      std::remove(beside.c_str());
      throw MachineError("cannot write " + path);
    }
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error) {
    std::remove(beside.c_str());
    throw MachineError("cannot write " + path + ": " + error.message());
  }
}

}  // namespace

std::span<const PlotKind> plot_kinds() { return kKinds; }

std::string plot_script(std::span<const FitRecord> records, const PlotRequest& request) {
  return make(records, request).text();
}

void draw_plot(std::span<const FitRecord> records, const PlotRequest& request,
               std::ostream& standard_output) {
  terminal_of(request.output, 1.0);  // an output of no kind is an error before any work is done
  const PlotScript script = make(records, request);
  const std::string terminal = terminal_of(request.output, script.relative_height());
  if (terminal.empty()) {
    write_file(
        request.output,
        "# Draw it with: gnuplot -p FILE, or: gnuplot -e \"set term svg\" FILE > FILE.svg\n" +
            script.text());
    return;
  }
  std::string text = script.text();
  if (request.output == "-") {
    // Of characters, a grid would be as heavy as the curves.
    const std::string_view grid = "set grid ytics";
    text.replace(text.find(grid), grid.size(), "unset grid #");
  }
  const std::string picture = io::run_gnuplot(terminal + text);
  if (request.output == "-") {
    standard_output << picture;
    if (!standard_output.flush()) throw MachineError("cannot write to standard output");
  } else {
    write_file(request.output, picture);
  }
}

}  // namespace plastica::calibrate
