#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/io/case_journal.hpp"
#include "plastica/io/merge_shards.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/report/format.hpp"

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

/// What the command that made the shards is told, to make a result of the journal.
std::vector<std::string> words_of(const io::ShardMark& mark, const MergeArguments& arguments) {
  std::vector<std::string> words = mark.words;
  words.insert(words.end(), {"--output=" + arguments.output, "--resume",
                             "--threads=" + std::to_string(arguments.threads)});
  if (arguments.force) words.emplace_back("--force");
  if (arguments.quiet) words.emplace_back("--quiet");
  return words;
}

/// The journal goes if no result was made of it: the shards have all that it has.
class MergedJournal {
 public:
  explicit MergedJournal(std::string path) : path_(std::move(path)) {}
  ~MergedJournal() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  MergedJournal(const MergedJournal&) = delete;
  MergedJournal& operator=(const MergedJournal&) = delete;

 private:
  std::string path_;
};

int merge(const MergeArguments& arguments, const RunWords& run) {
  for (const std::string& shard : arguments.shards) {
    refuse_input("--output", arguments.output, shard);
  }
  refuse_other_format(arguments.output);
  io::check_output_path(arguments.output, arguments.force);
  const std::string path = io::journal_path(arguments.output);
  const io::ShardMark mark = io::merge_shards(arguments.shards, path, arguments.force);
  const MergedJournal journal(path);
  if (!arguments.quiet) {
    tell("{} of {}\n", report::counted(mark.cases, mark.noun.substr(0, mark.noun.size() - 1)),
         report::counted(mark.shard.count, "shard"));
  }
  return run(words_of(mark, arguments));
}

}  // namespace

void add_merge(CLI::App& app, const RunWords& run, Action& action) {
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
  add_force_option(*sub, arguments->force, "the output, and an interrupted run");
  add_quiet_option(*sub, arguments->quiet, "no report, no progress");
  sub->footer(
      "Reads again what the shards were told to read: run it where they ran, or in a\n"
      "copy of the folder. Nothing is computed anew. The result is, bit by bit, that of\n"
      "one run without shards; only /meta says how it came about. The shards stay.\n"
      "Example:\n"
      "  plastica calibrate fit.toml -o fit.h5 --shard 1/2   # here\n"
      "  plastica calibrate fit.toml -o fit.h5 --shard 2/2   # on another machine\n"
      "  plastica merge fit.h5.shard-* -o fit.h5");
  sub->callback([&action, &run, arguments] {
    action = [&run, arguments] { return merge(*arguments, run); };
  });
}

}  // namespace plastica::cli
