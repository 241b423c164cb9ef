#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>

#include "calibrate/report/plot.hpp"
#include "calibrate/store/fit_store.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"

namespace plastica::cli {
namespace {

struct PlotArguments {
  std::string file;
  calibrate::PlotRequest request;
  bool list = false;
  bool force = false;
};

int plot(const PlotArguments& arguments) {
  if (arguments.list) {
    for (const auto& kind : calibrate::plot_kinds()) fmt::print("{:<12} {}\n", kind.name, kind.doc);
    return kDone;
  }
  const std::string& output = arguments.request.output;
  if (output != "-") io::check_output_path(output, arguments.force);
  const calibrate::FitStoreContents contents = calibrate::read_fit_store(arguments.file);
  calibrate::draw_plot(contents.records, arguments.request, std::cout);
  if (output != "-") fmt::print("wrote {}\n", output);
  return kDone;
}

}  // namespace

void add_plot(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("plot", "the picture of a result file");
  auto arguments = std::make_shared<PlotArguments>();
  sub->add_option("file", arguments->file, "result of `plastica calibrate`");
  sub->add_option("-o,--output", arguments->request.output,
                  ".svg, .png, .pdf; .gp for script and data; - for the terminal")
      ->capture_default_str();
  sub->add_option("--what", arguments->request.what, "which picture, see --list");
  sub->add_option("--case", arguments->request.specimen, "specimen of a curve");
  sub->add_flag("--list", arguments->list, "the pictures there are");
  sub->add_flag("--force", arguments->force, "overwrite a picture that is there");
  arguments->request.output = "-";
  sub->footer("Example: plastica plot fit.h5 -o fit.svg");
  sub->callback([&action, arguments] {
    if (arguments->file.empty() && !arguments->list) throw CLI::RequiredError("file");
    action = [arguments] { return plot(*arguments); };
  });
}

}  // namespace plastica::cli
