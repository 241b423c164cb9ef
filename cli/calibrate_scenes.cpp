#include "cli/calibrate_scenes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/fit/scene_laws.hpp"
#include "calibrate/inference/moved_by_segments.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/scene_fit_json.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/search/fit_interrupted.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/store/journaled_scene_fits.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "cli/chosen_segments.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/search_progress.hpp"
#include "cli/tell.hpp"
#include "plastica/io/text_file.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::cli {
namespace {

using calibrate::SceneFitCase;
using calibrate::SceneFitFile;
using calibrate::SceneFitRecord;

void print_dry_run(const SceneFitFile& file, const std::string& output) {
  const std::size_t laws = std::max<std::size_t>(1, file.options.laws.size());
  const std::size_t fits = file.cases.size() * laws;
  say("{} {}{} of {} targets, written to {}\n", fits, fits == 1 ? "fit" : "fits",
      laws > 1 ? fmt::format(" by {} laws", laws) : "",
      std::accumulate(
          file.cases.begin(), file.cases.end(), std::size_t{0},
          [](std::size_t sum, const SceneFitCase& one) { return sum + one.targets.size(); }),
      output);
  for (const SceneFitCase& one : file.cases) {
    for (const calibrate::WeightedTarget& weighted : one.targets) {
      const Model model = prepare(weighted.setup.scene, weighted.setup.solver);
      const std::string segments =
          file.chooses_segments ? "segments to be found"
                                : fmt::format("{} segments", weighted.setup.scene.beam.segments);
      say("{}: {} samples, {}, {}\n", weighted.target.name, weighted.target.ordinate.size(),
          segments, model.level_reason);
    }
  }
  say("up to {} points of each search, {} {} a fit", file.options.evaluations, file.options.starts,
      file.options.starts == 1 ? "search" : "searches");
  const bool screens = file.options.starts > 1 && file.options.screen > 0;
  say("{}\n", screens ? fmt::format(" after {} screened points", file.options.screen) : "");
  if (file.chooses_segments) {
    say("segments: by trial fits, until they move no value by more than {:.3g} %\n",
        100.0 * file.options.segments_within);
  } else if (file.options.segments_error) {
    print_repetitions(file.cases);
  }
}

/// @param records  put into another order where laws are compared
void print_report(std::vector<SceneFitRecord>& records, double confidence) {
  calibrate::ReportOptions options;
  options.color = isatty(STDOUT_FILENO) != 0;
  options.confidence = confidence;
  fmt::print("{}", calibrate::laws_report(records, options));
  if (calibrate::compares_laws(records)) fmt::print("\n");
  const auto shown = std::span(records).first(calibrate::advised_first(records));
  fmt::print("{}", calibrate::scene_fits_report(shown, options));
}

/// Writes what is asked for beside the result file and prints the report.
/// @param within  what segments may do to a value, over it [1]; 0: anything
int report(const CalibrateArguments& arguments, calibrate::SceneFitContents& contents,
           double within) {
  if (!arguments.json.empty()) {
    io::write_text_file(arguments.json,
                        calibrate::scene_fits_json(contents.records, contents.confidence) + "\n",
                        io::overwrite_if(arguments.force || arguments.resume));
  }
  if (!arguments.quiet) {
    print_report(contents.records, contents.confidence);
    std::fflush(stdout);  // one file may take both
  }
  // Where laws are compared, one of them suffices.
  const auto usable = [](const SceneFitRecord* record) {
    return calibrate::is_usable(record->result);
  };
  const bool all = std::ranges::all_of(
      calibrate::by_target(contents.records),
      [&](const auto& records) { return std::ranges::any_of(records, usable); });
  const auto moved = [within](const SceneFitRecord& record) {
    return record.result.segments && calibrate::moved_by_segments(record.result).moved > within;
  };
  const bool kept = within == 0.0 || std::ranges::none_of(contents.records, moved);
  return all && kept ? kDone : kNotAcceptable;
}

}  // namespace

int calibrate_scenes(const CalibrateArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string output = output_of(arguments);
  SceneFitFile file = calibrate::read_scene_fit_file(arguments.inputs.front());
  tell_notes(file.notes);
  set_intervals(arguments, file.options.intervals);
  if (!arguments.laws.empty()) file.options.laws = calibrate::laws_of(arguments.laws, "--laws");
  if (arguments.no_modulus_prior) {
    throw InputError({}, "--no-modulus-prior", "",
                     "is for curves: fits through scenes have no such prior");
  }
  calibrate::check_fits(file);
  if (arguments.dry_run) {
    print_dry_run(file, output);
    return kDone;
  }
  const bool found = finds_output(arguments.resume, arguments.force, output);
  check_outputs(file.read_files, output, arguments.json, arguments.force, found);
  const InterruptGuard interrupt;
  try {
    if (const int code = take_chosen_segments(file, arguments, &interrupt.flag()); code != kDone) {
      return code;
    }
  } catch (const calibrate::FitInterrupted&) {
    tell("plastica: interrupted before the number of segments was found\n");
    return kInterrupted;
  }
  calibrate::SceneFitContents contents;
  contents.meta = io::begin_meta(arguments.command_line, arguments.threads);
  calibrate::JournaledOptions how;
  how.journal = {io::journal_path(output), arguments.resume, arguments.force,
                 contents.meta.instruction_set};
  how.threads = arguments.threads;
  how.stop = &interrupt.flag();
  ProgressBar bar("fitting", file.cases.size() * std::max<std::size_t>(1, file.options.laws.size()),
                  arguments.quiet);
  // A lone fit has a line of its own.
  const bool several = file.cases.size() > 1;
  how.progress = [&bar, several](const calibrate::BatchProgress& progress) {
    if (several) bar.update(progress.done, progress.failed, progress.resumed);
  };
  SearchProgress search(arguments.quiet);
  calibrate::JournaledSceneFits batch(
      file.cases, file.options, how,
      [&search](const calibrate::SceneFitProgress& progress) { search.update(progress); });
  if (found) {
    contents = calibrate::read_scene_fit_store(output);
    take_complete_output(output, contents.run, batch);
    return report(arguments, contents, file.options.segments_within);
  }
  // Another run may have had the journal until now, and have written the output.
  io::check_output_path(output, arguments.force);
  tell_of_journal(batch, arguments.quiet);
  if (!arguments.quiet && batch.stages() > 0) {
    tell("{} finished stages of fits resumed from the journal\n", batch.stages());
  }
  std::vector<calibrate::SceneFitResult> results = batch.run();
  bar.clear();
  search.clear();
  if (!batch.complete()) {
    tell_interrupted(output);
    return kInterrupted;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    contents.records.push_back(record_of(file.cases[batch.fits()[i].of], std::move(results[i])));
    contents.records.back().seconds = batch.seconds()[i];
  }
  contents.confidence = file.options.confidence;
  contents.inputs = std::move(file.inputs);
  contents.meta.resumptions = batch.resumptions();
  contents.meta.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  contents.run = batch.run_id();
  calibrate::write_scene_fit_store(output, contents, io::overwrite_if(arguments.force));
  batch.finish();
  const int code = report(arguments, contents, file.options.segments_within);
  if (!arguments.quiet) tell("wrote {}\n", output);
  return code;
}

}  // namespace plastica::cli
