#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "calibrate/report/text.hpp"
#include "calibrate/store/fit_store.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/find_record.hpp"
#include "cli/run_files.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_text.hpp"

namespace plastica::cli {
namespace {

struct ShowArguments {
  std::string file;
  std::string specimen;
  bool all = false;
};

int show_scene(const ShowArguments& arguments) {
  constexpr std::string_view kRule = "is for results of fits; this is a simulated scene";
  refuse_option(!arguments.specimen.empty(), "--case", kRule);
  refuse_option(arguments.all, "--all", kRule);
  const io::SceneRecord record = io::read_scene_store(arguments.file);
  fmt::print("{}", report::scene_report(record, isatty(STDOUT_FILENO) != 0));
  return kDone;
}

int show(const ShowArguments& arguments) {
  if (holds_scene(arguments.file)) return show_scene(arguments);
  const calibrate::FitStoreContents contents = calibrate::read_fit_store(arguments.file);
  calibrate::ReportOptions options;
  options.color = isatty(STDOUT_FILENO) != 0;
  options.confidence = contents.options.confidence;
  options.law = contents.options.setup.scene.material.hardening.law;
  if (!arguments.specimen.empty()) {
    const auto& record = find_record(contents.records, arguments.specimen, arguments.file);
    fmt::print("{}", calibrate::fit_report(record, options));
    return kDone;
  }
  if (arguments.all) {
    options.specimens_shown = 0;
    options.groups_shown = 0;
    for (const auto& record : contents.records) {
      fmt::print("{}\n", calibrate::fit_report(record, options));
    }
  } else if (contents.records.size() == 1) {
    fmt::print("{}\n", calibrate::fit_report(contents.records.front(), options));
  }
  fmt::print("{}", calibrate::batch_report(contents.records, options));
  return kDone;
}

}  // namespace

void add_show(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("show", "the report of a result file");
  auto arguments = std::make_shared<ShowArguments>();
  sub->add_option("file", arguments->file, "result of `plastica calibrate` or `simulate`")
      ->required();
  sub->add_option("--case", arguments->specimen, "the whole report of one specimen");
  sub->add_flag("--all", arguments->all, "the whole report of every specimen");
  sub->footer("Example: plastica show fit.h5 --case CA-RD-01");
  sub->callback([&action, arguments] { action = [arguments] { return show(*arguments); }; });
}

}  // namespace plastica::cli
