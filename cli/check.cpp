#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/input_kind.hpp"
#include "cli/interrupt.hpp"
#include "cli/page_output.hpp"
#include "cli/progress_bar.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/format.hpp"
#include "sweeps/check/report.hpp"
#include "sweeps/check/run_check.hpp"
#include "sweeps/report/web/check_page.hpp"

namespace plastica::cli {
namespace {

struct CheckArguments {
  std::string command_line;
  std::vector<std::string> files;
  std::string junit;
  std::string report;
  std::string annotate;
  int threads = 0;
  bool dry_run = false;
  bool force = false;
  bool quiet = false;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// "1 sweep, 2 scenes".
std::string subjects_of(const sweeps::CheckFile& file) {
  std::set<std::string> scenes;
  for (const sweeps::Sweep& scene : file.scenes) scenes.insert(scene.scene.path);
  const auto scans = static_cast<std::size_t>(
      std::count_if(file.claims.begin(), file.claims.end(),
                    [](const sweeps::Claim& claim) { return claim.scan.has_value(); }));
  std::vector<std::string> all;
  const auto add = [&](std::size_t count, const char* noun) {
    if (count > 0) all.push_back(report::counted(count, noun));
  };
  add(file.sweeps.size(), "sweep");
  add(scenes.size(), "scene");
  add(file.fits.size(), "fit file");
  add(scans, "scan");
  return fmt::format("{}", fmt::join(all, ", "));
}

int print_dry_run(const std::vector<sweeps::CheckFile>& files) {
  for (const sweeps::CheckFile& file : files) {
    say("{}: {} about {} with {}\n", file.path, report::counted(file.claims.size(), "claim"),
        subjects_of(file), report::counted(sweeps::cases_of(file), "case"));
  }
  say("nothing was run\n");
  return kDone;
}

/// All files that a check reads.
std::vector<std::string> files_of(const sweeps::CheckFile& file) {
  std::vector<std::string> all{file.path};
  const auto add = [&](const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const auto* sweeps : {&file.sweeps, &file.scenes}) {
    for (const sweeps::Sweep& sweep : *sweeps) {
      add({sweep.path, sweep.scene.path, sweep.against.name});
    }
  }
  for (const sweeps::FitSubject& fits : file.fits) {
    add({fits.path});
    if (fits.curves) add(files_read(*fits.curves));
    if (fits.scenes) add(fits.scenes->read_files);
  }
  return all;
}

/// Runs one file. @return whether it was run to its end
bool run_file(sweeps::CheckFile file, const CheckArguments& arguments,
              const std::atomic<bool>& stop, std::vector<sweeps::CheckedFile>& checked) {
  const auto begin = std::chrono::steady_clock::now();
  ProgressBar bar("checking", sweeps::cases_of(file), arguments.quiet);
  sweeps::CheckOptions options;
  options.threads = arguments.threads;
  options.stop = &stop;
  options.progress = [&bar](std::size_t done) { bar.update(done, 0); };
  sweeps::CheckedFile result{std::move(file), {}, 0.0};
  result.verdicts = sweeps::run_check(result.file, options);
  bar.clear();
  if (result.verdicts.empty()) return false;
  result.seconds = seconds_since(begin);
  using enum sweeps::CheckLines;
  fmt::print("{}", sweeps::check_report(result, arguments.quiet ? FailuresOnly : All));
  if (!arguments.annotate.empty()) say(sweeps::github_annotations(result));
  std::fflush(stdout);
  checked.push_back(std::move(result));
  return true;
}

/// Checks where the results are to go, before anything is run.
void check_outputs_of(const std::vector<sweeps::CheckFile>& files,
                      const CheckArguments& arguments) {
  std::vector<std::string> read;
  for (const sweeps::CheckFile& file : files) {
    for (std::string& path : files_of(file)) read.push_back(std::move(path));
  }
  if (!arguments.junit.empty()) {
    for (const std::string& path : read) refuse_input("--junit", arguments.junit, path);
    io::check_output_path(arguments.junit, arguments.force);
  }
  check_report_option(arguments.report, arguments.force, read, std::array{arguments.junit});
}

int check(const CheckArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  io::RunMeta meta = io::begin_meta(arguments.command_line, arguments.threads);
  // All files are read before the first is run: a bad one loses nothing.
  std::vector<sweeps::CheckFile> files;
  for (const std::string& path : arguments.files) {
    expect_input(path, {InputKind::Check});
    files.push_back(sweeps::read_check_file(path, check_without_digest));
  }
  for (const sweeps::CheckFile& file : files) tell_notes(file.notes);
  check_outputs_of(files, arguments);
  if (arguments.dry_run) return print_dry_run(files);
  const InterruptGuard interrupt;
  std::vector<sweeps::CheckedFile> checked;
  bool complete = true;
  for (sweeps::CheckFile& file : files) {
    complete = complete && run_file(std::move(file), arguments, interrupt.flag(), checked);
  }
  if (!arguments.junit.empty()) {
    io::write_text_file(arguments.junit, sweeps::junit_xml(checked),
                        io::overwrite_if(arguments.force));
  }
  if (!arguments.report.empty() && !checked.empty()) {
    meta.seconds = seconds_since(begin);
    write_page(arguments.report, sweeps::check_page(checked, files.size(), meta),
               io::overwrite_if(arguments.force));
    if (!arguments.quiet) tell("wrote {}\n", arguments.report);
  }
  if (!complete) {
    tell("plastica: interrupted\n");
    return kInterrupted;
  }
  if (!arguments.quiet) fmt::print("{}", sweeps::check_summary(checked));
  const bool all = std::all_of(checked.begin(), checked.end(), [](const auto& file) {
    return std::all_of(file.verdicts.begin(), file.verdicts.end(),
                       [](const auto& verdict) { return verdict.holds; });
  });
  return all ? kDone : kNotAcceptable;
}

}  // namespace

void add_check(CLI::App& app, const Invocation& invocation, Action& action) {
  CLI::App* sub = app.add_subcommand("check", "Check named claims on sweeps, scenes and fits");
  auto arguments = std::make_shared<CheckArguments>();
  arguments->command_line = invocation.command_line;
  sub->add_option("files", arguments->files, "Check files")
      ->required()
      ->option_text("CHECK.toml...");
  sub->add_option("--junit", arguments->junit, "Also write the verdicts as JUnit's XML")
      ->option_text("FILE");
  add_report_option(*sub, arguments->report);
  sub->add_option("--annotate", arguments->annotate,
                  "Also print each claim that does not hold as this CI takes it: github")
      ->check(CLI::IsMember({"github"}))
      ->option_text("CI");
  add_threads_option(*sub, arguments->threads);
  add_dry_run_option(*sub, arguments->dry_run);
  add_force_option(*sub, arguments->force, "the XML and the page");
  add_quiet_option(*sub, arguments->quiet, "nothing but claims that do not hold");
  sub->footer(
      "Example:\n"
      "  plastica check checks/*.toml --junit checks.xml\n"
      "Exit code 0 if every claim holds, 1 if one does not, 2 for a bad file.");
  sub->callback([&action, arguments] { action = [arguments] { return check(*arguments); }; });
}

}  // namespace plastica::cli
