#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/input_kind.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/result_kind.hpp"
#include "cli/run_files.hpp"
#include "cli/run_team.hpp"
#include "cli/shard_option.hpp"
#include "cli/tell.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/report/format.hpp"
#include "plastica/run/batch.hpp"
#include "plastica/run/response_size.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/report/json.hpp"
#include "sweeps/report/text.hpp"
#include "sweeps/store/sweep_store.hpp"

namespace plastica::cli {
namespace {

namespace fs = std::filesystem;

struct SweepArguments {
  std::string file;
  std::string output;
  std::string json;
  int threads = 0;
  bool dry_run = false;
  bool resume = false;
  bool rerun_failed = false;
  bool force = false;
  bool quiet = false;
  std::string isa;
  std::optional<io::ShardOfRun> shard;       ///< empty: all of the sweep
  const io::MergedShards* merged = nullptr;  ///< in place of runs; null: there are none
  RunTeam* launched = nullptr;               ///< other processes, which may join; null: none
  Team* team = nullptr;                      ///< those that have joined; null: none
  std::string command_line;
};

std::string output_of(const SweepArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return fs::path(arguments.file).stem().string() + ".h5";
}

/// Refuses to write over what the sweep reads, whatever is forced.
void refuse_inputs(std::string_view option, const std::string& path, const sweeps::Sweep& sweep) {
  refuse_input(option, path, sweep.path);
  refuse_input(option, path, sweep.scene.path);
  if (sweep.against.kind == sweeps::AgainstKind::File) {
    refuse_input(option, path, sweep.against.name);
  }
}

/// An output that is there is gone on with, or replaced on purpose.
void check_outputs(const SweepArguments& arguments, const std::string& output,
                   const sweeps::Sweep& sweep) {
  const bool goes_on = arguments.resume || arguments.rerun_failed;
  refuse_inputs("--output", output, sweep);
  refuse_other_format(output);
  if (!arguments.json.empty()) {
    refuse_inputs("--json", arguments.json, sweep);
    refuse_own_files("--json", arguments.json, output);
    io::check_output_path(arguments.json, arguments.force || goes_on);
  }
  io::check_output_path(output, arguments.force || goes_on || arguments.shard.has_value());
  const std::string kept =
      arguments.shard ? io::shard_path(output, arguments.shard->shard) : io::journal_path(output);
  if (arguments.rerun_failed && !fs::exists(kept) && (arguments.shard || !fs::exists(output))) {
    throw InputError({}, "--rerun-failed", arguments.shard ? kept : output,
                     "is not there: nothing has been run yet");
  }
}

sweeps::EarlierResults results_before(const SweepArguments& arguments, const std::string& output) {
  const bool goes_on = arguments.resume || arguments.rerun_failed;
  if (!goes_on || !fs::exists(output)) return {};
  check_without_digest(output);
  return sweeps::earlier_results(output);
}

void print_dry_run(const sweeps::Sweep& sweep, const std::string& output) {
  const sweeps::CaseTable cases(sweep);
  say("{}: {} of {}\n", sweep.path, report::counted(cases.size(), "case"), sweep.scene.path);
  for (const sweeps::Axis& axis : sweep.axes) {
    const auto [low, high] = std::minmax_element(axis.values.begin(), axis.values.end());
    const auto& first = axis.sampled ? *low : axis.values.front();
    const auto& last = axis.sampled ? *high : axis.values.back();
    say("  {}: {}{}, {} … {}\n", axis.field->path, report::counted(axis.values.size(), "value"),
        axis.sampled ? " drawn" : "", sweeps::value_text(*axis.field, first),
        sweeps::value_text(*axis.field, last));
  }
  const Setup last_case = cases.setup(cases.size() - 1);
  const Model model = prepare(last_case.scene, last_case.solver);
  say("  last case: level {}; its run takes about {:.2f} MB\n", model.level_reason,
      static_cast<double>(response_size(model).bytes()) / 1e6);
  if (sweeps::is_simulated(sweep.quantity.kind)) {
    say("  it runs {}\n", sweep.timed_runs > 0 ? "one by one: they are timed" : riding_of(model));
  }
  say("  compared: {}{}{}\n", sweep.quantity.name,
      sweep.against.kind == sweeps::AgainstKind::Nothing ? "" : " against ",
      sweeps::words_of(sweep.against, sweep.quantity));
  say("nothing was run; the result would be {}\n", output);
}

void tell_of_journal(const sweeps::SweepRun& run, bool quiet) {
  if (run.journal()->dropped_bytes() > 0) {
    tell("plastica: dropped {} bytes of an unfinished record from the journal\n",
         run.journal()->dropped_bytes());
  }
  if (run.journal()->damaged() > 0 && run.resumed() < run.own()) tell_of_damage();
  if (const std::size_t shards = run.journal()->merged_shards(); shards > 0) {
    if (!quiet) tell("{} of {} shards\n", report::counted(run.resumed(), "case"), shards);
    return;
  }
  if (!quiet && run.resumed() > 0) {
    tell("{} resumed from an earlier run\n", report::counted(run.resumed(), "case"));
  }
}

int sweep_file(const SweepArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string output = output_of(arguments);
  expect_input(arguments.file, {InputKind::Sweep});
  sweeps::Sweep sweep = sweeps::read_sweep_file(arguments.file);
  tell_notes(sweep.notes);
  take_isa(arguments.isa, sweep.setup.solver);
  if (arguments.team != nullptr && sweep.timed_runs > 0) {
    throw InputError({sweep.path, 0}, "cost.timed_runs", std::to_string(sweep.timed_runs),
                     "times cases, and processes slow one another: run it without mpirun");
  }
  sweeps::check_reference(sweep, sweeps::CaseTable(sweep));
  if (arguments.dry_run) {
    print_dry_run(sweep, output);
    say_shard(output, arguments.shard);
    return kDone;
  }
  check_outputs(arguments, output, sweep);

  io::RunMeta meta = io::begin_meta(arguments.command_line, arguments.threads);
  meta.instruction_set = name_of(resolved(sweep.setup.solver.isa));
  const InterruptGuard interrupt;
  sweeps::SweepRunOptions how;
  const std::optional<io::ShardOfRun>& shard = arguments.shard;
  how.journal = policy_of(output, shard, arguments.resume || arguments.rerun_failed,
                          arguments.force, meta.instruction_set, arguments.merged, arguments.team);
  if (arguments.launched != nullptr)
    arguments.launched->watch(&interrupt.flag(), how.journal.path, "");
  if (!shard) how.earlier = results_before(arguments, output);
  how.rerun_failed = arguments.rerun_failed;
  how.threads = arguments.threads;
  how.stop = &interrupt.flag();
  sweeps::SweepRun run(sweep, std::move(how));
  if (shard && run.journal()->shard_ended() && !arguments.rerun_failed) {
    tell_shard_found(io::shard_path(output, shard->shard));
    return kDone;
  }
  // Another run may have had the journal until now, and have written the output.
  io::check_output_path(
      output, arguments.force || arguments.resume || arguments.rerun_failed || shard.has_value());
  tell_of_journal(run, arguments.quiet);
  ProgressBar bar("sweeping", run.own(), arguments.quiet);
  run.on_progress([&bar](const sweeps::SweepProgress& progress) {
    bar.update(progress.done, progress.failed, progress.resumed);
  });
  std::vector<sweeps::CaseResult> results = run.run();
  bar.clear();
  if (!run.leads()) return kDone;
  if (!run.complete()) {
    tell_interrupted("");
    return kInterrupted;
  }
  if (shard) {
    run.end_shard();
    if (!arguments.quiet) {
      tell_shard_ended(io::shard_path(output, shard->shard), shard->shard, run.own(),
                       run.cases().size(), "cases");
    }
    return kDone;
  }

  sweeps::SweepRecord record =
      sweeps::make_record(sweep, run.cases(), run.ids(), std::move(results));
  record.meta = std::move(meta);
  record.meta.resumptions = run.journal()->resumptions();
  record.meta.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const bool goes_on = arguments.resume || arguments.rerun_failed;
  sweeps::write_sweep_store(output, record, io::overwrite_if(arguments.force || goes_on));
  run.finish();
  if (!arguments.json.empty()) {
    io::write_text_file(arguments.json, sweeps::sweep_json(record),
                        io::overwrite_if(arguments.force || goes_on));
  }
  if (!arguments.quiet) {
    fmt::print("{}", sweeps::sweep_report(record));
    tell("wrote {}\n", output);
  }
  const bool of_fits = sweep.quantity.kind == sweeps::QuantityKind::Fit;
  const bool any = std::any_of(
      record.results.begin(), record.results.end(),
      [&](const auto& result) { return usable(result.status) && (!of_fits || result.value); });
  return any ? kDone : kNotAcceptable;
}

}  // namespace

void add_sweep(CLI::App& app, const Invocation& invocation, Action& action) {
  CLI::App* sub =
      app.add_subcommand("sweep", "Vary a scene over axes; compare its cases and what they cost");
  auto arguments = std::make_shared<SweepArguments>();
  sub->add_option("file", arguments->file, "Sweep file")->required()->option_text("SWEEP.toml");
  sub->add_option("-o,--output", arguments->output,
                  "Write the result file (HDF5) here; default: the sweep's name with .h5")
      ->option_text("FILE");
  add_json_option(*sub, arguments->json);
  add_threads_option(*sub, arguments->threads,
                     "as many as the machine has, or one where cases are timed");
  add_isa_option(*sub, arguments->isa);
  add_dry_run_option(*sub, arguments->dry_run);
  sub->add_flag("--resume", arguments->resume,
                "Run only what an interrupted run or the output lacks, or what has changed");
  sub->add_flag("--rerun-failed", arguments->rerun_failed,
                "As --resume, and run the failed cases again");
  add_force_option(*sub, arguments->force, "the output, and an interrupted run");
  add_quiet_option(*sub, arguments->quiet, "no report, no progress");
  add_shard_option(*sub);
  group_options(*sub, "Results", {"--output", "--json", "--force"});
  group_options(*sub, "After an interruption", {"--resume", "--rerun-failed"});
  sub->footer(
      "Example:\n"
      "  plastica sweep sweep.toml -o sweep.h5\n"
      "  mpirun -np 64 plastica sweep sweep.toml       # share a run (built with MPI)\n"
      "Exit code 1 if no case has a usable result, 130 after Ctrl-C: --resume goes on.");
  arguments->command_line = invocation.command_line;
  arguments->merged = invocation.merged;
  arguments->launched = invocation.team;
  sub->callback([&action, arguments, sub] {
    action = [arguments, sub] {
      arguments->shard = shard_of(*sub);
      if (!arguments->shard) {
        arguments->team =
            join_team(arguments->launched, arguments->command_line, arguments->threads);
      }
      return sweep_file(*arguments);
    };
  });
}

}  // namespace plastica::cli
