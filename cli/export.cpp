#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "calibrate/report/csv_export.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/store/fit_store.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/storage_error.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_json.hpp"
#include "sweeps/report/csv.hpp"
#include "sweeps/report/json.hpp"
#include "sweeps/report/markup.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

struct ExportArguments {
  std::string file;
  std::string to = "csv";
  std::string what;  ///< empty: the first of the file's kind
  std::string time;
  std::string output = "-";
  bool force = false;
};

/// What of a file's kind that was asked for, or its first.
std::string what_of(const ExportArguments& arguments, const std::vector<std::string>& kinds) {
  if (arguments.what.empty()) return kinds.front();
  if (std::find(kinds.begin(), kinds.end(), arguments.what) == kinds.end()) {
    throw InputError({}, "--what", arguments.what,
                     fmt::format("must be {} of this file", fmt::join(kinds, " or ")));
  }
  return arguments.what;
}

std::string text_of_scene(const ExportArguments& arguments) {
  const std::string what =
      what_of(arguments, {"probes", "joints", "energies", "events", "pieces", "spectrum"});
  const std::optional<double> time = seconds_of("--time", arguments.time);
  refuse_option(time && what != "joints", "--time", "goes with --what joints only");
  const io::SceneRecord record = io::read_scene_store(arguments.file);
  if (arguments.to == "json") return report::scene_json(record);
  std::ostringstream out;
  if (what == "probes") report::write_probes_csv(out, record);
  if (what == "joints") report::write_joints_csv(out, record, time);
  if (what == "energies") report::write_energies_csv(out, record);
  if (what == "events") report::write_events_csv(out, record);
  if (what == "pieces") report::write_pieces_csv(out, record);
  if (what == "spectrum") report::write_spectrum_csv(out, record);
  return out.str();
}

std::string text_of_fits(const ExportArguments& arguments) {
  const std::string what = what_of(arguments, {"specimens", "curves"});
  const calibrate::FitStoreContents contents = calibrate::read_fit_store(arguments.file);
  if (arguments.to == "json") return calibrate::json_summary(contents.records) + '\n';
  std::ostringstream out;
  if (what == "curves") {
    calibrate::write_curves_csv(out, contents.records);
  } else {
    calibrate::write_specimens_csv(out, contents.records);
  }
  return out.str();
}

std::string text_of_sweep(const ExportArguments& arguments) {
  const std::string what = what_of(arguments, {"cases", "curves"});
  refuse_option(!arguments.what.empty() && arguments.to != "csv", "--what", "goes with --to csv");
  const sweeps::SweepRecord record = sweeps::read_sweep_store(arguments.file);
  if (arguments.to == "json") return sweeps::sweep_json(record);
  if (arguments.to == "markdown") return sweeps::markdown_table(record);
  if (arguments.to == "latex") return sweeps::latex_table(record);
  std::ostringstream out;
  if (what == "curves") {
    sweeps::write_sweep_curves_csv(out, record);
  } else {
    sweeps::write_cases_csv(out, record);
  }
  return out.str();
}

std::string text_of(const ExportArguments& arguments) {
  using enum ResultKind;
  const ResultKind kind = kind_of_result(arguments.file);
  const std::array options{
      ResultOption{"--time", !arguments.time.empty(), {Scene}},
      ResultOption{
          "--to " + arguments.to, arguments.to == "markdown" || arguments.to == "latex", {Sweep}}};
  refuse_options_of_others(kind, options);
  switch (kind) {
    case Fits: return text_of_fits(arguments);
    case Scene: return text_of_scene(arguments);
    case Sweep: break;
  }
  return text_of_sweep(arguments);
}

int run_export(const ExportArguments& arguments) {
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.file);
    io::check_output_path(arguments.output, arguments.force);
  }
  const std::string text = text_of(arguments);
  if (arguments.output == "-") {
    std::cout << text;
    return kDone;
  }
  std::ofstream out(arguments.output, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw io::StorageError(arguments.output, "cannot be written");
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("export", "the numbers of a result file");
  auto arguments = std::make_shared<ExportArguments>();
  sub->add_option("file", arguments->file, "result of `plastica calibrate`, `simulate` or `sweep`")
      ->required();
  sub->add_option("--to", arguments->to,
                  "csv or json; of a sweep also its table as markdown or latex")
      ->check(CLI::IsMember({"csv", "json", "markdown", "latex"}))
      ->capture_default_str();
  sub->add_option(
         "--what", arguments->what,
         "csv of fits: specimens, or curves, a row per sample; of a scene: probes or energies, a "
         "row per sample, joints, a row per joint at --time T, events, a row per joint that broke, "
         "pieces, or spectrum, a row per frequency; of a sweep: cases, or curves")
      ->check(CLI::IsMember({"specimens", "curves", "probes", "joints", "energies", "events",
                             "pieces", "spectrum", "cases"}));
  sub->add_option("--time", arguments->time, "of joints: \"12 ms\"; else the last frame's");
  sub->add_option("-o,--output", arguments->output, "file, or - for the terminal")
      ->capture_default_str();
  sub->add_flag("--force", arguments->force, "overwrite the output");
  sub->footer("Example: plastica export fit.h5 --to csv -o fit.csv");
  sub->callback([&action, arguments] { action = [arguments] { return run_export(*arguments); }; });
}

}  // namespace plastica::cli
