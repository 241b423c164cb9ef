#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "calibrate/report/web/fits_page.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/page_output.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/web/scene_page.hpp"
#include "plastica/report/web/web_page.hpp"
#include "sweeps/report/web/sweep_page.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

struct ReportArguments {
  std::string file;
  std::string output;
  bool force = false;
};

plastica::report::WebPage page_of(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  switch (kind_of_result(file)) {
    case ResultKind::Fits: return calibrate::fits_page(calibrate::read_fit_store(file), name);
    case ResultKind::SceneFits:
      return calibrate::fits_page(calibrate::read_scene_fit_store(file), name);
    case ResultKind::Scene: return plastica::report::scene_page(io::read_scene_store(file), name);
    case ResultKind::Sweep: break;
  }
  return sweeps::sweep_page(sweeps::read_sweep_store(file), name);
}

int write_report(const ReportArguments& arguments) {
  const std::string output =
      arguments.output.empty()
          ? std::filesystem::path(arguments.file).replace_extension(".html").string()
          : arguments.output;
  require_chart_library("report", "");
  refuse_input("--output", output, arguments.file);
  require_ending("--output", output, ".html", "it is a page");
  io::check_output_path(output, arguments.force);
  io::write_text_file(output, plastica::report::html_of(page_of(arguments.file)),
                      io::overwrite_if(arguments.force));
  say("wrote {}\n", output);
  return kDone;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  CLI::App* sub =
      app.add_subcommand("report", "Write a result file as one page of HTML that needs no network");
  auto arguments = std::make_shared<ReportArguments>();
  sub->add_option("file", arguments->file, "Result of calibrate, simulate or sweep")
      ->required()
      ->option_text("FILE.h5");
  sub->add_option("-o,--output", arguments->output, "Write this file; default: FILE.html")
      ->option_text("FILE.html");
  add_force_option(*sub, arguments->force, "a page that is there");
  sub->footer(
      "Examples:\n"
      "  plastica report fit.h5\n"
      "  plastica report sweep.h5 -o sweep.html");
  sub->callback(
      [&action, arguments] { action = [arguments] { return write_report(*arguments); }; });
}

}  // namespace plastica::cli
