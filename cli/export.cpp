#include <fmt/format.h>

#include <algorithm>
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
#include "cli/run_files.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/storage_error.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_json.hpp"

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
  refuse_option(!arguments.time.empty(), "--time",
                "is for simulated scenes; this is a result of fits");
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

int run_export(const ExportArguments& arguments) {
  if (arguments.output != "-") {
    refuse_input("--output", arguments.output, arguments.file);
    io::check_output_path(arguments.output, arguments.force);
  }
  const std::string text =
      holds_scene(arguments.file) ? text_of_scene(arguments) : text_of_fits(arguments);
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
  sub->add_option("file", arguments->file, "result of `plastica calibrate` or `simulate`")
      ->required();
  sub->add_option("--to", arguments->to, "csv or json")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  sub->add_option(
         "--what", arguments->what,
         "csv of fits: specimens, or curves, a row per sample; of a scene: probes or energies, a "
         "row per sample, joints, a row per joint at --time T, events, a row per joint that broke, "
         "pieces, or spectrum, a row per frequency")
      ->check(CLI::IsMember(
          {"specimens", "curves", "probes", "joints", "energies", "events", "pieces", "spectrum"}));
  sub->add_option("--time", arguments->time, "of joints: \"12 ms\"; else the last frame's");
  sub->add_option("-o,--output", arguments->output, "file, or - for the terminal")
      ->capture_default_str();
  sub->add_flag("--force", arguments->force, "overwrite the output");
  sub->footer("Example: plastica export fit.h5 --to csv -o fit.csv");
  sub->callback([&action, arguments] { action = [arguments] { return run_export(*arguments); }; });
}

}  // namespace plastica::cli
