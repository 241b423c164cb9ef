#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/fit_reports.hpp"
#include "cli/result_kind.hpp"
#include "cli/terminal.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_text.hpp"
#include "sweeps/report/select.hpp"
#include "sweeps/report/text.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

struct ShowArguments {
  std::string file;
  std::string which;  ///< of the specimens or cases
  bool all = false;
};

int show_scene(const ShowArguments& arguments) {
  const io::SceneRecord record = io::read_scene_store(arguments.file);
  fmt::print("{}", report::scene_report(record, has_color(STDOUT_FILENO)));
  return kDone;
}

int show_sweep(const ShowArguments& arguments) {
  const sweeps::SweepRecord record = sweeps::read_sweep_store(arguments.file);
  if (arguments.which.empty()) {
    fmt::print("{}",
               arguments.all ? sweeps::sweep_report(record, 0) : sweeps::sweep_report(record));
    return kDone;
  }
  bool first = true;
  for (const std::size_t i : sweeps::select_cases(record, arguments.which)) {
    fmt::print("{}{}", first ? "" : "\n", sweeps::case_report(record, i));
    first = false;
  }
  return kDone;
}

/// Of fits of curves, or through scenes.
template <typename Contents>
int show_fits(const ShowArguments& arguments) {
  Contents contents = read_fits<Contents>(arguments.file, calibrate::FitSamples::Counted);
  if (arguments.which.empty()) {
    print_fits(contents, arguments.all);
  } else {
    print_fit(contents, arguments.which, arguments.file);
  }
  return kDone;
}

int show(const ShowArguments& arguments) {
  using enum ResultKind;
  const ResultKind kind = kind_of_result(arguments.file);
  const std::array options{
      ResultOption{"--case", !arguments.which.empty(), {Fits, SceneFits, Sweep}},
      ResultOption{"--all", arguments.all, {Fits, SceneFits, Sweep}}};
  refuse_options_of_others(kind, options);
  switch (kind) {
    case Fits: return show_fits<calibrate::FitStoreContents>(arguments);
    case Scene: return show_scene(arguments);
    case SceneFits: return show_fits<calibrate::SceneFitContents>(arguments);
    case Sweep: break;
  }
  return show_sweep(arguments);
}

}  // namespace

void add_show(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("show", "Print the report of a result file");
  auto arguments = std::make_shared<ShowArguments>();
  sub->add_option("file", arguments->file, "Result of calibrate, simulate or sweep")
      ->required()
      ->option_text("FILE.h5");
  sub->add_option(
         "--case", arguments->which,
         "Print the whole report of one specimen, or of cases of a sweep: an id, or \"AXIS "
         "= VALUE, AXIS = VALUE\"")
      ->option_text("CASE");
  sub->add_flag("--all", arguments->all,
                "Print the whole report of every specimen, or every case of a sweep");
  sub->footer(
      "Examples:\n"
      "  plastica show fit.h5 --case CA-RD-01\n"
      "  plastica show sweep.h5 --case \"beam.segments = 20\"");
  sub->callback([&action, arguments] { action = [arguments] { return show(*arguments); }; });
}

}  // namespace plastica::cli
