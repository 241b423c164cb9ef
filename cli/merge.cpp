#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/run_files.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/merge_shards.hpp"
#include "plastica/io/output_file.hpp"

namespace plastica::cli {
namespace {

namespace fs = std::filesystem;

struct MergeArguments {
  std::vector<std::string> shards;
  std::string output;
  int threads = 0;
  bool force = false;
  bool quiet = false;
};

/// What the command that made the shards is told, to take them for its result.
std::vector<std::string> words_of(const io::ShardMark& mark, const MergeArguments& arguments) {
  constexpr std::array<std::string_view, 2> kCommands{"calibrate", "sweep"};
  // What no shard says: its file was made by something else.
  static constexpr std::array<std::string_view, 12> kNotSaid{
      "--shard", "--output", "-o",       "--json",         "--dry-run", "--help",
      "-h",      "--force",  "--resume", "--rerun-failed", "--threads", "--quiet"};
  const auto says = [](const std::string& word) {
    return std::ranges::any_of(
        kNotSaid, [&](std::string_view other) { return word.substr(0, word.find('=')) == other; });
  };
  const auto inputs = std::ranges::find(mark.words, "--");
  if (mark.words.empty() || std::ranges::find(kCommands, mark.words.front()) == kCommands.end() ||
      std::any_of(mark.words.begin(), inputs, says)) {
    throw InputError({arguments.shards.front(), 0}, "", "",
                     "does not say which command computed it");
  }
  std::vector<std::string> words{mark.words.front(), "--output=" + arguments.output,
                                 "--threads=" + std::to_string(arguments.threads)};
  if (arguments.force) words.emplace_back("--force");
  if (arguments.quiet) words.emplace_back("--quiet");
  words.insert(words.end(), mark.words.begin() + 1, mark.words.end());
  return words;
}

/// Refuses to merge where the shards did not run. @throws InputError
void check_inputs(const io::ShardMark& mark) {
  const auto inputs = std::ranges::find(mark.words, "--");
  if (inputs == mark.words.end()) return;
  for (auto input = inputs + 1; input != mark.words.end(); ++input) {
    std::error_code ignored;
    if (fs::exists(*input, ignored)) continue;
    throw InputError(
        {}, "shards", *input,
        "is what they read, and is not here: run merge where they ran, or in a copy of "
        "that folder");
  }
}

int merge(const MergeArguments& arguments, const RunAgain& run) {
  for (const std::string& shard : arguments.shards) {
    refuse_input("--output", arguments.output, shard);
  }
  refuse_other_format(arguments.output);
  io::check_output_path(arguments.output, arguments.force);
  const io::MergedShards merged = io::merge_shards(arguments.shards);
  check_inputs(merged.mark);
  return run(words_of(merged.mark, arguments), merged);
}

}  // namespace

void add_merge(CLI::App& app, const RunAgain& run, Action& action) {
  CLI::App* sub =
      app.add_subcommand("merge", "Put the shards of a run together into its result file");
  auto arguments = std::make_shared<MergeArguments>();
  sub->add_option("shards", arguments->shards, "All shards of one run, in any order")
      ->required()
      ->option_text("OUT.h5.shard-1-of-N...");
  sub->add_option("-o,--output", arguments->output, "Write the result file (HDF5) here")
      ->required()
      ->option_text("FILE");
  add_threads_option(*sub, arguments->threads);
  add_force_option(*sub, arguments->force, "the output");
  add_quiet_option(*sub, arguments->quiet, "no report, no progress");
  sub->footer(
      "Reads again what the shards read: run it where they ran, or in a copy of that\n"
      "folder. Computes nothing. The result is, bit by bit, that of one run without\n"
      "shards; only /meta tells them apart. The shards stay.\n"
      "Example:\n"
      "  plastica calibrate fit.toml -o fit.h5 --shard 1/2   # here\n"
      "  plastica calibrate fit.toml -o fit.h5 --shard 2/2   # on another machine\n"
      "  plastica merge fit.h5.shard-* -o fit.h5");
  sub->callback([&action, &run, arguments] {
    action = [&run, arguments] { return merge(*arguments, run); };
  });
}

}  // namespace plastica::cli
