#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <type_traits>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/store/journaled_fits.hpp"
#include "cli/calibrate_arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/fit_reports.hpp"
#include "cli/run_files.hpp"
#include "cli/shard_option.hpp"
#include "plastica/io/text_file.hpp"

/// What `plastica calibrate` does with fits of either kind, once it has read its inputs.
namespace plastica::cli {

/// Writes what is asked for beside the result file and prints the report. @return the exit code
template <class Contents>
int report_fits(const CalibrateArguments& arguments, Contents& contents) {
  if (!arguments.json.empty()) {
    io::write_text_file(arguments.json, json_of(contents),
                        io::overwrite_if(arguments.force || arguments.resume));
  }
  if (!arguments.quiet) {
    print_fits(contents);
    std::fflush(stdout);  // one file may take both
  }
  // Where laws are compared, one of them suffices.
  const auto usable = [](const auto* record) { return calibrate::is_usable(record->result); };
  const bool all = std::ranges::all_of(
      calibrate::by_target(contents.records),
      [&](const auto& records) { return std::ranges::any_of(records, usable); });
  return all ? kDone : kNotAcceptable;
}

/// Fits what the file of a shard lacks. @param fit  as below
template <class Batch, class Fit>
int run_shard(const CalibrateArguments& arguments, const std::string& output, Batch& batch,
              const Fit& fit) {
  const io::Shard shard = arguments.shard->shard;
  const std::string path = io::shard_path(output, shard);
  if (batch.shard_ended()) {
    tell_shard_found(path);
    return kDone;
  }
  tell_of_journal(batch, arguments.quiet);
  fit();
  if (!batch.complete()) {
    tell_interrupted(output);
    return kInterrupted;
  }
  batch.end_shard();
  if (!arguments.quiet) tell_shard_ended(path, shard, batch.own(), batch.size(), "fits");
  return kDone;
}

/// Fits what neither a found output nor the journal has, stores all and reports.
/// @param found  whether the output is there, see `finds_output`
/// @param contents  has all but records, id and end of the run
/// @param begin  of the run
/// @param fit  runs the batch. @return the records of its results
/// @return the exit code
template <class Contents, class Batch, class Fit>
int run_fits(const CalibrateArguments& arguments, const std::string& output, bool found,
             Contents& contents, std::chrono::steady_clock::time_point begin, Batch& batch,
             const Fit& fit) {
  if (arguments.shard) return run_shard(arguments, output, batch, fit);
  if (found && !batch.leads()) return kDone;
  if (found) {
    contents = read_fits<Contents>(output, calibrate::FitSamples::Counted);
    take_complete_output(output, contents.run, batch);
    return report_fits(arguments, contents);
  }
  // Another run may have had the journal until now, and have written the output.
  io::check_output_path(output, arguments.force);
  tell_of_journal(batch, arguments.quiet);
  contents.records = fit();
  // So that this report and those made of the file later are the same.
  calibrate::put_in_order(contents.records);
  if (!batch.leads()) return kDone;
  if (!batch.complete()) {
    tell_interrupted(output);
    return kInterrupted;
  }
  contents.run = batch.run_id();
  contents.meta.resumptions = batch.resumptions();
  contents.meta.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if constexpr (std::is_same_v<Contents, calibrate::SceneFitContents>) {
    calibrate::write_scene_fit_store(output, contents, io::overwrite_if(arguments.force));
  } else {
    calibrate::write_fit_store(output, contents, io::overwrite_if(arguments.force));
  }
  batch.finish();
  const int code = report_fits(arguments, contents);
  if (!arguments.quiet) tell("wrote {}\n", output);
  return code;
}

/// The meta of a run of fits that begins now.
inline io::RunMeta begin_fit_meta(const CalibrateArguments& arguments) {
  io::RunMeta meta = io::begin_meta(arguments.command_line, arguments.threads);
  meta.versions.emplace_back("nlopt", calibrate::nlopt_version());
  return meta;
}

/// How the fits of a run are journaled.
inline calibrate::JournaledOptions journaling(const CalibrateArguments& arguments,
                                              const std::string& output, const io::RunMeta& meta,
                                              StopFlag stop) {
  calibrate::JournaledOptions how;
  how.journal = policy_of(output, arguments.shard, arguments.resume, arguments.force,
                          meta.instruction_set, arguments.merged, arguments.team);
  if (arguments.launched != nullptr) arguments.launched->watch(stop, how.journal.path, output);
  how.threads = arguments.threads;
  how.stop = stop;
  return how;
}

}  // namespace plastica::cli
