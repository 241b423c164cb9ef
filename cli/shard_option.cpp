#include "cli/shard_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "cli/launched.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"

namespace plastica::cli {

void add_shard_option(CLI::App& sub) {
  sub.add_option(
         "--shard",
         "Compute shard I of N, into OUT.h5.shard-I-of-N, which plastica merge puts together; "
         "auto: that of this process under mpirun or srun")
      ->option_text("I/N|auto");
}

namespace {

/// The shard of this process, "2/7".
std::string shard_of_process() {
  const std::optional<Launched> process = launched();
  if (process) return fmt::format("{}/{}", process->rank + 1, process->count);
  throw InputError(
      {}, "--shard", "auto",
      "needs several processes of mpirun or srun, which tell each its number; a task of "
      "an array says its own: --shard $SLURM_ARRAY_TASK_ID/N");
}

/// The words that tell a command again what it was told, but for what is told to one shard alone:
/// output, threads, what to go on from.
std::vector<std::string> words_again(const CLI::App& sub) {
  constexpr std::array<std::string_view, 7> kOfOne{
      "--shard", "--output", "--threads", "--resume", "--rerun-failed", "--force", "--quiet"};
  std::vector<std::string> words{sub.get_name()};
  std::vector<std::string> inputs{"--"};
  for (const CLI::Option* option : sub.get_options()) {
    if (option->count() == 0) continue;
    const std::string name = option->get_name();
    if (std::ranges::find(kOfOne, name) != kOfOne.end()) continue;
    for (const std::string& value : option->results()) {
      if (option->get_positional()) {
        inputs.push_back(value);
      } else if (!value.empty()) {
        words.push_back(fmt::format("{}={}", name, value));  // of a flag "true" or "false"
      }
    }
  }
  words.insert(words.end(), inputs.begin(), inputs.end());
  return words;
}

}  // namespace

std::optional<io::ShardOfRun> shard_of(const CLI::App& sub) {
  const CLI::Option* option = sub.get_option("--shard");
  if (option->count() == 0) return {};
  refuse_option(sub.get_option("--json")->count() > 0, "--json",
                "is of all of a run: plastica export makes it of the merged result");
  std::string text = option->as<std::string>();
  if (text == "auto") text = shard_of_process();
  return io::ShardOfRun{io::parse_shard("--shard", text), words_again(sub)};
}

io::JournalPolicy policy_of(const std::string& output, std::optional<io::ShardOfRun> shard,
                            bool resume, bool force, const std::string& instruction_set,
                            const io::MergedShards* merged, Team* team) {
  const std::string path = shard ? io::shard_path(output, shard->shard) : io::journal_path(output);
  return {path, resume, force, instruction_set, std::move(shard), merged, team};
}

void say_shard(const std::string& output, const std::optional<io::ShardOfRun>& shard) {
  if (!shard) return;
  say("{} would be one in {} of these, written to {}\n", words_of(shard->shard), shard->shard.count,
      io::shard_path(output, shard->shard));
}

void tell_shard_found(const std::string& path) {
  tell("{} is complete: nothing is left to do\n", path);
}

void tell_shard_ended(const std::string& path, const io::Shard& shard, std::size_t own,
                      std::size_t all, const std::string& noun) {
  tell("wrote {}: {}, {} of {} {}\n", path, words_of(shard), own, all, noun);
}

}  // namespace plastica::cli
