#include "cli/calibrate_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>
#include <vector>

#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/inference/moved_by_segments.hpp"
#include "calibrate/search/fit_interrupted.hpp"
#include "calibrate/store/journaled_scene_fits.hpp"
#include "calibrate/trial/scene_model.hpp"
#include "cli/chosen_segments.hpp"
#include "cli/common_options.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "cli/run_files.hpp"
#include "cli/run_fits.hpp"
#include "cli/search_progress.hpp"
#include "cli/tell.hpp"
#include "plastica/base/instruction_set.hpp"
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
      const calibrate::SceneModel fitted(weighted.setup, weighted.target, {});
      say("{}: {} samples, {}, {}; slopes by {}\n", weighted.target.name,
          weighted.target.ordinate.size(), segments, model.level_reason, fitted.slopes_from());
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

/// Lets `--isa` take the place of what the scenes say.
void take_isa(const std::string& isa, SceneFitFile& file) {
  for (SceneFitCase& one : file.cases) {
    for (calibrate::WeightedTarget& weighted : one.targets) {
      cli::take_isa(isa, weighted.setup.solver);
    }
  }
}

/// Whether the segments move any value by more than was asked for.
bool moved_too_far(const std::vector<SceneFitRecord>& records, double within) {
  return within > 0.0 && std::ranges::any_of(records, [within](const SceneFitRecord& record) {
           return record.result.segments &&
                  calibrate::moved_by_segments(record.result).moved > within;
         });
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
  take_isa(arguments.isa, file);
  calibrate::check_fits(file);
  if (arguments.shard) {
    refuse_option(file.chooses_segments, "--shard",
                  "needs a number of segments: trial fits of all of the run would find it");
    calibrate::check_dealt(file.options);
  }
  if (arguments.dry_run) {
    print_dry_run(file, output);
    say_shard(output, arguments.shard);
    return kDone;
  }
  const bool found = finds_output(arguments.resume, arguments.force, output, arguments.team);
  check_outputs(file.read_files, output, arguments.json, arguments.force,
                found || arguments.shard.has_value());
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
  contents.meta = begin_fit_meta(arguments);
  contents.meta.instruction_set =
      name_of(resolved(file.cases.front().targets.front().setup.solver.isa));
  calibrate::JournaledOptions how = journaling(arguments, output, contents.meta, &interrupt.flag());
  ProgressBar bar("fitting", 0, arguments.quiet);
  // A lone fit has a line of its own.
  const bool several = file.cases.size() > 1;
  how.progress = [&bar, several](const calibrate::BatchProgress& progress) {
    if (several) bar.update(progress.done, progress.failed, progress.resumed);
  };
  SearchProgress search(arguments.quiet);
  calibrate::JournaledSceneFits batch(
      file.cases, file.options, how,
      [&search](const calibrate::SceneFitProgress& progress) { search.update(progress); });
  bar.set_total(batch.own());
  contents.confidence = file.options.confidence;
  contents.inputs = std::move(file.inputs);
  const int code = run_fits(arguments, output, found, contents, begin, batch, [&] {
    std::vector<calibrate::SceneFitResult> results = batch.run();
    bar.clear();
    search.clear();
    std::vector<SceneFitRecord> records;
    for (std::size_t i = 0; i < results.size(); ++i) {
      records.push_back(record_of(file.cases[batch.fits()[i].of], std::move(results[i])));
      records.back().seconds = batch.seconds()[i];
    }
    return records;
  });
  const bool moved = moved_too_far(contents.records, file.options.segments_within);
  return code == kDone && moved ? kNotAcceptable : code;
}

}  // namespace plastica::cli
