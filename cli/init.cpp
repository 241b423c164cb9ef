#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "calibrate/config/templates.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/tell.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/text_file.hpp"
#include "sweeps/plan/templates.hpp"

namespace plastica::cli {
namespace {

struct InitArguments {
  std::string kind;
  std::string folder = ".";
  bool force = false;
};

bool is_of_sweeps(const std::string& kind) {
  const auto kinds = sweeps::template_kinds();
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// The command that runs what was begun.
std::string_view command_of(const std::string& kind) {
  if (is_of_sweeps(kind)) return kind;
  return kind == "fit" || kind == "scene-fit" ? "calibrate" : "simulate";
}

int init(const InitArguments& arguments) {
  const std::filesystem::path folder(arguments.folder);
  const auto files = is_of_sweeps(arguments.kind) ? sweeps::template_files(arguments.kind)
                                                  : calibrate::template_files(arguments.kind);
  if (!std::filesystem::is_directory(folder)) {
    throw InputError({}, "--directory", arguments.folder, "must be a folder that exists");
  }
  // All names are looked at before the first is written.
  for (const auto& file : files) {
    const auto path = folder / file.name;
    // A check brings the sweep that it is about, which may be there as it was begun.
    io::check_output_path(path.string(), true);
    const bool exists = std::filesystem::exists(path);
    if (exists && !arguments.force && io::read_text_file(path.string()) != file.text) {
      throw InputError({}, "init", path.string(), "exists already; --force overwrites it");
    }
  }
  for (const auto& file : files) {
    const auto path = folder / file.name;
    io::write_text_file(path.string(), file.text);
    say("wrote {}\n", path.string());
  }
  say("next: plastica {} {}\n", command_of(arguments.kind), (folder / files.front().name).string());
  return kDone;
}

}  // namespace

void add_init(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("init", "Write a commented file that runs as it is");
  auto arguments = std::make_shared<InitArguments>();
  std::vector<std::string> kinds;
  for (const auto& kind : calibrate::template_kinds()) kinds.emplace_back(kind);
  for (const auto& kind : sweeps::template_kinds()) kinds.emplace_back(kind);
  sub->add_option("kind", arguments->kind,
                  "What to begin: fit, scene-fit (a fit through a beam), scene, coupon, sweep or "
                  "check")
      ->required()
      ->check(CLI::IsMember(kinds))
      ->option_text("KIND");
  sub->add_option("-d,--directory", arguments->folder, "Write there; default: here")
      ->option_text("FOLDER");
  add_force_option(*sub, arguments->force, "files that exist");
  sub->footer("Example:\n  plastica init fit && plastica calibrate fit.toml");
  sub->callback([&action, arguments] { action = [arguments] { return init(*arguments); }; });
}

}  // namespace plastica::cli
