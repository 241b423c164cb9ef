#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/config/bare_files.hpp"
#include "calibrate/inference/intervals.hpp"
#include "cli/run_team.hpp"
#include "cli/tell.hpp"
#include "plastica/io/case_journal.hpp"

namespace plastica::cli {

struct CalibrateArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::string json;
  std::vector<std::string> laws;  ///< to be compared; empty: as the fit file says
  int threads = 0;
  bool dry_run = false;
  bool resume = false;
  bool force = false;
  bool quiet = false;
  bool no_modulus_prior = false;
  bool accept = false;  ///< implausible curves, too
  calibrate::BareFiles bare;
  std::string bare_option;  ///< first of the options for curves without a fit file that was given
  bool profile = false;     ///< and these replace what a fit file says
  std::optional<int> bootstrap, bootstrap_block, bootstrap_specimens;
  std::string isa;                           ///< empty: as the files say
  std::optional<io::ShardOfRun> shard;       ///< empty: all of the run
  const io::MergedShards* merged = nullptr;  ///< in place of fits; null: there are none
  RunTeam* launched = nullptr;               ///< other processes, which may join; null: none
  Team* team = nullptr;                      ///< those that have joined; null: none
  std::string command_line;
};

/// The result file: the one that is asked for, or the input's name with .h5.
inline std::string output_of(const CalibrateArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  const std::filesystem::path first(arguments.inputs.front());
  return (arguments.inputs.size() == 1 ? first.stem().string() : "fit") + ".h5";
}

/// What the command line asks for, whatever the file says.
inline void set_intervals(const CalibrateArguments& arguments,
                          calibrate::IntervalOptions& intervals) {
  intervals.profile = intervals.profile || arguments.profile;
  intervals.bootstrap = arguments.bootstrap.value_or(intervals.bootstrap);
  intervals.block = arguments.bootstrap_block.value_or(intervals.block);
  intervals.specimens = arguments.bootstrap_specimens.value_or(intervals.specimens);
}

/// Says on stderr what a batch has found in its journal.
template <class Batch>
void tell_of_journal(const Batch& batch, bool quiet) {
  if (batch.dropped_bytes() > 0) {
    tell("plastica: dropped {} bytes of an unfinished record from the journal\n",
         batch.dropped_bytes());
  }
  if (batch.damaged() > 0 && batch.resumed() < batch.own()) tell_of_damage();
  if (!quiet && batch.merged_shards() > 0) {
    tell("{} fits of {} shards\n", batch.resumed(), batch.merged_shards());
    return;
  }
  if (!quiet && batch.resumed() > 0) {
    tell("{} fits resumed from the journal\n", batch.resumed());
  }
  if (!quiet && batch.stale() > 0) {
    const std::string& other = batch.other_instruction_set();
    tell("{} fits of the journal are {} and run again\n", batch.stale(),
         other.empty() ? "stale" : "of the instruction set " + other);
  }
  if constexpr (requires { batch.stages(); }) {
    if (!quiet && batch.stages() > 0) {
      tell("{} finished stages of fits resumed from the journal\n", batch.stages());
    }
  }
}

}  // namespace plastica::cli
