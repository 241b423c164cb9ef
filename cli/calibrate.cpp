#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "calibrate/config/bare_files.hpp"
#include "calibrate/config/fit_file.hpp"
#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/journaled_batch.hpp"
#include "cli/calibrate_arguments.hpp"
#include "cli/calibrate_scenes.hpp"
#include "cli/column_options.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/text_file.hpp"

namespace plastica::cli {
namespace {

bool is_fit_file(const std::string& path) {
  return std::filesystem::path(path).extension() == ".toml";
}

calibrate::FitFile read_inputs(const CalibrateArguments& arguments) {
  const auto toml = std::find_if(arguments.inputs.begin(), arguments.inputs.end(), is_fit_file);
  if (toml == arguments.inputs.end()) {
    calibrate::BareFiles bare = arguments.bare;
    bare.files = arguments.inputs;
    // The order of the command line must not change a bit of the result.
    std::sort(bare.files.begin(), bare.files.end());
    const auto twice = std::adjacent_find(bare.files.begin(), bare.files.end());
    if (twice != bare.files.end()) throw InputError({}, "inputs", *twice, "is named twice");
    calibrate::FitFile file = calibrate::fit_of_bare_files(bare, arguments.threads);
    tell_notes(file.notes);
    return file;
  }
  if (arguments.inputs.size() > 1) {
    throw InputError({}, "calibrate", *toml, "must be the only file: a fit file names its curves");
  }
  if (!arguments.bare_option.empty()) {
    throw InputError({}, arguments.bare_option, "",
                     "is for curves without a fit file; this is what " + *toml + " says");
  }
  calibrate::FitFile file = calibrate::read_fit_file(*toml);
  tell_notes(file.notes);
  return file;
}

void write_json(const std::string& path, std::span<const calibrate::FitRecord> records,
                const calibrate::FitOptions& fit, io::Overwrite overwrite) {
  const calibrate::SpecimenDraws draws{fit.intervals.specimens, fit.seed, fit.confidence};
  io::write_text_file(path, calibrate::json_summary(records, 2, draws) + "\n", overwrite);
}

/// @param records  put into another order where laws are compared
void print_report(std::vector<calibrate::FitRecord>& records, const calibrate::FitOptions& fit) {
  calibrate::ReportOptions options;
  options.color = isatty(STDOUT_FILENO) != 0;
  options.confidence = fit.confidence;
  options.specimen_resamples = fit.intervals.specimens;
  options.seed = fit.seed;
  fmt::print("{}", calibrate::laws_report(records, options));
  if (calibrate::compares_laws(records)) fmt::print("\n");
  const auto shown = std::span(records).first(calibrate::advised_first(records));
  if (shown.size() == 1) fmt::print("{}\n", calibrate::fit_report(shown.front(), options));
  fmt::print("{}", calibrate::batch_report(shown, options));
}

/// Whether it is a fit file whose targets name scenes.
bool has_scenes(const CalibrateArguments& arguments) {
  return arguments.inputs.size() == 1 && is_fit_file(arguments.inputs.front()) &&
         arguments.bare_option.empty() && calibrate::names_scenes(arguments.inputs.front());
}

/// Writes what is asked for beside the result file and prints the report.
int report(const CalibrateArguments& arguments, calibrate::FitStoreContents& contents) {
  if (!arguments.json.empty()) {
    write_json(arguments.json, contents.records, contents.options,
               io::overwrite_if(arguments.force || arguments.resume));
  }
  if (!arguments.quiet) {
    print_report(contents.records, contents.options);
    std::fflush(stdout);  // one file may take both
  }
  // Where laws are compared, one of them suffices.
  const auto usable = [](const calibrate::FitRecord* record) {
    return calibrate::is_usable(record->result);
  };
  const bool all = std::ranges::all_of(
      calibrate::by_target(contents.records),
      [&](const auto& records) { return std::ranges::any_of(records, usable); });
  return all ? kDone : kNotAcceptable;
}

int calibrate_files(const CalibrateArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string output = output_of(arguments);
  calibrate::FitFile file = read_inputs(arguments);
  set_intervals(arguments, file.options.intervals);
  if (!arguments.laws.empty()) file.options.laws = calibrate::laws_of(arguments.laws, "--laws");
  if (arguments.no_modulus_prior) file.options.modulus_prior = false;
  const bool found = finds_output(arguments.resume, arguments.force, output);
  if (!arguments.dry_run) check_outputs(file, output, arguments.json, arguments.force, found);
  for (calibrate::TargetBlock& block : file.targets) {
    block.options.accept = block.options.accept || arguments.accept;
  }
  std::vector<calibrate::Target> targets = calibrate::import_all(file, arguments.threads);
  if (file.options.intervals.specimens > 0 && targets.size() < 2) {
    throw InputError({}, "bootstrap_specimens", std::to_string(file.options.intervals.specimens),
                     "needs several specimens, for the mean of their parameters");
  }
  if (arguments.dry_run) {
    print_plausible(file.targets);
    print_dry_run(targets, file.options, output);
    return kDone;
  }

  calibrate::FitStoreContents contents;
  contents.inputs = input_texts(file);
  contents.meta = io::begin_meta(arguments.command_line, arguments.threads);
  contents.meta.versions.emplace_back("nlopt", calibrate::nlopt_version());
  const InterruptGuard interrupt;
  calibrate::JournaledOptions how;
  how.journal = {io::journal_path(output), arguments.resume, arguments.force,
                 contents.meta.instruction_set};
  how.threads = arguments.threads;
  how.stop = &interrupt.flag();
  const std::size_t fits = targets.size() * std::max<std::size_t>(1, file.options.laws.size());
  ProgressBar bar("fitting", fits, arguments.quiet);
  how.progress = [&bar](const calibrate::BatchProgress& progress) {
    bar.update(progress.done, progress.failed + progress.rejected, progress.resumed);
  };
  calibrate::JournaledBatch batch(targets, file.options, how);
  if (found) {
    contents = calibrate::read_fit_store(output);
    take_complete_output(output, contents.run, batch);
    return report(arguments, contents);
  }
  // Another run may have had the journal until now, and have written the output.
  io::check_output_path(output, arguments.force);
  tell_of_journal(batch, arguments.quiet);
  std::vector<calibrate::FitResult> results = batch.run();
  bar.clear();
  if (!batch.complete()) {
    tell_interrupted(output);
    return kInterrupted;
  }

  for (std::size_t i = 0; i < results.size(); ++i) {
    contents.records.push_back({targets[batch.cases()[i].target], std::move(results[i])});
  }
  contents.options = file.options;
  contents.run = batch.run_id();
  contents.meta.resumptions = batch.resumptions();
  contents.meta.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  calibrate::write_fit_store(output, contents, io::overwrite_if(arguments.force));
  batch.finish();
  const int code = report(arguments, contents);
  if (!arguments.quiet) tell("wrote {}\n", output);
  return code;
}

constexpr const char* kBareGroup = "Curves without a fit file";

void add_bare_options(CLI::App& sub, calibrate::BareFiles& bare) {
  add_column_options(sub, bare, kBareGroup);
  const auto add = [&](const char* name, auto& value, const char* takes, const char* text) {
    return sub.add_option(name, value, text)->option_text(takes)->group(kBareGroup);
  };
  add("--test", bare.test, "KIND", "tension, bending or torsion");
  add("--measure", bare.measure, "KIND", "engineering or true");
  add("--table", bare.table, "FILE:KEY", "Read a row per specimen, found by the column KEY");
  add("--group", bare.group, "COLUMN", "Form groups by a column of the table")
      ->allow_extra_args(false);
  add("--fix", bare.fixed, "NAME=VALUE", "Hold a parameter: youngs_modulus=\"200 GPa\"")
      ->allow_extra_args(false);
}

constexpr const char* kIntervalGroup = "Other intervals than those of the covariance";

void add_interval_options(CLI::App& sub, CalibrateArguments& arguments) {
  sub.add_flag("--profile", arguments.profile, "Find likelihood intervals of all parameters")
      ->group(kIntervalGroup);
  const auto add = [&](const char* name, auto& value, int least, const char* text) {
    sub.add_option(name, value, text)
        ->check(CLI::Range(least, calibrate::kMaxResamples))
        ->option_text("N")
        ->group(kIntervalGroup);
  };
  add("--bootstrap", arguments.bootstrap, 0, "Resample the residuals N times, such as 400");
  add("--bootstrap-block", arguments.bootstrap_block, 1, "Draw N neighbouring residuals together");
  add("--bootstrap-specimens", arguments.bootstrap_specimens, 0,
      "Resample the specimens N times: targets that share the parameters of a fit through scenes; "
      "fits of a group of ten and more, for their mean");
}

/// The first option of a group that was given; empty if none was.
std::string first_given(const CLI::App& sub, const char* group) {
  for (const CLI::Option* option : sub.get_options()) {
    if (option->get_group() == group && option->count() > 0) return option->get_name();
  }
  return {};
}

}  // namespace

void add_calibrate(CLI::App& app, const std::string& command_line, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "calibrate", "Fit parameters to measured curves: a fit file, or bare curves");
  auto arguments = std::make_shared<CalibrateArguments>();
  sub->add_option("inputs", arguments->inputs, "A fit file, or CSV files of curves")
      ->required()
      ->option_text("FIT.toml|FILE.csv...");
  sub->add_option("-o,--output", arguments->output,
                  "Write the result file (HDF5) here; default: the input's name with .h5")
      ->option_text("FILE");
  add_json_option(*sub, arguments->json);
  sub->add_option("--laws", arguments->laws,
                  "Fit each of these laws and compare them: ideal, linear, voce, chaboche, "
                  "multilinear")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("LAW,...");
  add_threads_option(*sub, arguments->threads);
  add_dry_run_option(*sub, arguments->dry_run);
  sub->add_flag("--resume", arguments->resume, "Continue an interrupted run");
  add_force_option(*sub, arguments->force, "the output, and an interrupted run");
  add_quiet_option(*sub, arguments->quiet, "no report, no progress");
  sub->add_flag("--accept", arguments->accept,
                "Fit curves that are those of no material, too; --dry-run prints the bounds");
  sub->add_flag(
      "--no-modulus-prior", arguments->no_modulus_prior,
      "Fit E by the curve's law alone, not with the slope of its elastic part as a prior");
  add_interval_options(*sub, *arguments);
  add_bare_options(*sub, arguments->bare);
  sub->footer(
      "Examples:\n"
      "  plastica calibrate fit.toml -o fit.h5 --json fit.json\n"
      "  plastica calibrate curve.csv --laws ideal,linear,voce\n"
      "  plastica calibrate fit.toml --profile --bootstrap 400\n"
      "  plastica calibrate a.csv b.csv --strain Strain --stress Stress:MPa \\\n"
      "    --fix youngs_modulus=\"200 GPa\"");
  arguments->command_line = command_line;
  sub->callback([&action, arguments, sub] {
    arguments->bare_option = first_given(*sub, kBareGroup);
    action = [arguments] {
      return has_scenes(*arguments) ? calibrate_scenes(*arguments) : calibrate_files(*arguments);
    };
  });
}

}  // namespace plastica::cli
