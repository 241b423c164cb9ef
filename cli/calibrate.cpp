#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "calibrate/config/bare_files.hpp"
#include "calibrate/config/fit_file.hpp"
#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/fit/fit.hpp"
#include "calibrate/store/journaled_batch.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "cli/calibrate_arguments.hpp"
#include "cli/calibrate_scenes.hpp"
#include "cli/column_options.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_code.hpp"
#include "cli/input_kind.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/run_fits.hpp"
#include "cli/shard_option.hpp"
#include "cli/tell.hpp"
#include "plastica/base/instruction_set.hpp"
#include "plastica/io/result_file.hpp"

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

void expect_inputs(const CalibrateArguments& arguments) {
  for (const std::string& path : arguments.inputs) {
    std::error_code ignored;
    if (is_fit_file(path) && std::filesystem::is_fifo(path, ignored)) {
      throw InputError({path, 0}, "", "", "is a pipe: a fit file is read more than once");
    }
    expect_input(path, {InputKind::Fit, InputKind::Curves});
  }
}

/// Whether it is a fit file whose targets name scenes.
bool has_scenes(const CalibrateArguments& arguments) {
  return arguments.inputs.size() == 1 && is_fit_file(arguments.inputs.front()) &&
         arguments.bare_option.empty() && calibrate::names_scenes(arguments.inputs.front());
}

/// Gives back what a large list no longer needs.
template <typename Item>
void give_back(std::vector<Item>& items) {
  constexpr std::size_t kFew = 1000;
  if (items.capacity() > kFew && items.size() < items.capacity() / 8 * 7) items.shrink_to_fit();
}

/// Targets and their results, from the last to the first (the caller puts them in order): what has
/// been taken from both lists is given back meanwhile, as a large batch has no room for all of it
/// twice.
std::vector<calibrate::FitRecord> records_of(const std::vector<calibrate::FitCase>& cases,
                                             std::vector<calibrate::Target> targets,
                                             std::vector<calibrate::FitResult> results) {
  std::vector<calibrate::FitRecord> records;
  records.reserve(results.size());
  for (std::size_t i = results.size(); i-- > 0;) {
    const std::size_t of = cases[i].target;
    const bool is_first = i == 0 || cases[i - 1].target != of;
    records.push_back({is_first ? std::move(targets[of]) : targets[of], std::move(results[i])});
    results.pop_back();
    give_back(results);
    if (!is_first) continue;
    targets.pop_back();
    give_back(targets);
  }
  return records;
}

int calibrate_files(const CalibrateArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string output = output_of(arguments);
  calibrate::FitFile file = read_inputs(arguments);
  set_intervals(arguments, file.options.intervals);
  if (!arguments.laws.empty()) file.options.laws = calibrate::laws_of(arguments.laws, "--laws");
  if (arguments.no_modulus_prior) file.options.modulus_prior = false;
  take_isa(arguments.isa, file.options.setup.solver);
  calibrate::check_fit_options(file.options);
  const bool found = finds_output(arguments.resume, arguments.force, output, arguments.team);
  for (calibrate::TargetBlock& block : file.targets) {
    block.options.accept = block.options.accept || arguments.accept;
  }
  // Curves may go into the same folder. Whether an output is there already is said behind what is
  // wrong with the inputs.
  if (!arguments.dry_run) io::check_output_path(output, true);
  const std::string folder = calibrate::spool_folder(arguments.dry_run ? P_tmpdir "/" : output);
  const auto spool = std::make_shared<calibrate::CurveSpool>(folder);
  std::vector<calibrate::Target> targets = calibrate::import_all(file, arguments.threads, spool);
  file.options.keep_trace =
      calibrate::cases_of(targets.size(), file.options).size() <= calibrate::kTracedFits;
  if (file.options.intervals.specimens > 0 && targets.size() < 2) {
    throw InputError({}, "bootstrap_specimens", std::to_string(file.options.intervals.specimens),
                     "needs several specimens, for the mean of their parameters");
  }
  if (arguments.dry_run) {
    print_plausible(file.targets);
    print_dry_run(targets, file.options, output);
    say_shard(output, arguments.shard);
    return kDone;
  }
  check_outputs(file, output, arguments.json, arguments.force,
                found || arguments.shard.has_value());

  calibrate::FitStoreContents contents;
  contents.inputs = input_texts(file);
  contents.meta = begin_fit_meta(arguments);
  contents.meta.instruction_set = name_of(resolved(file.options.setup.solver.isa));
  const InterruptGuard interrupt;
  calibrate::JournaledOptions how = journaling(arguments, output, contents.meta, &interrupt.flag());
  ProgressBar bar("fitting", 0, arguments.quiet);
  how.progress = [&bar](const calibrate::BatchProgress& progress) {
    bar.update(progress.done, progress.failed + progress.rejected, progress.resumed);
  };
  how.counts_curves = true;
  calibrate::JournaledBatch batch(targets, file.options, how);
  bar.set_total(batch.own());
  contents.options = file.options;
  return run_fits(arguments, output, found, contents, begin, batch, [&] {
    std::vector<calibrate::FitResult> results = batch.run();
    bar.clear();
    return records_of(batch.cases(), std::move(targets), std::move(results));
  });
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

void add_calibrate(CLI::App& app, const Invocation& invocation, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "calibrate", "Fit parameters to measured curves: a fit file, or bare curves");
  auto arguments = std::make_shared<CalibrateArguments>();
  sub->add_option("inputs", arguments->inputs, "A fit file, or files of curves (CSV, .xlsx, HDF5)")
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
  add_isa_option(*sub, arguments->isa);
  add_dry_run_option(*sub, arguments->dry_run);
  sub->add_flag("--resume", arguments->resume, "Continue an interrupted run");
  add_force_option(*sub, arguments->force, "the output, and an interrupted run");
  add_shard_option(*sub);
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
      "    --fix youngs_modulus=\"200 GPa\"\n"
      "  mpirun -np 64 plastica calibrate fit.toml     # share a run (built with MPI)");
  arguments->command_line = invocation.command_line;
  arguments->merged = invocation.merged;
  arguments->launched = invocation.team;
  sub->callback([&action, arguments, sub] {
    arguments->bare_option = first_given(*sub, kBareGroup);
    action = [arguments, sub] {
      arguments->shard = shard_of(*sub);
      if (!arguments->shard) {
        arguments->team =
            join_team(arguments->launched, arguments->command_line, arguments->threads);
      }
      expect_inputs(*arguments);
      return has_scenes(*arguments) ? calibrate_scenes(*arguments) : calibrate_files(*arguments);
    };
  });
}

}  // namespace plastica::cli
