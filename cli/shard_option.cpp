#include "cli/shard_option.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "plastica/report/format.hpp"

namespace plastica::cli {

void add_shard_option(CLI::App& sub, std::string& text) {
  sub.add_option("--shard", text,
                 "Compute part I of N, into OUT.h5.shard-I-of-N; plastica merge puts the parts "
                 "together")
      ->option_text("I/N");
}

std::vector<std::string> words_again(const CLI::App& sub) {
  constexpr std::array<std::string_view, 7> kOfOne{
      "--shard", "--output", "--threads", "--resume", "--rerun-failed", "--force", "--quiet"};
  std::vector<std::string> words{sub.get_name()};
  for (const CLI::Option* option : sub.get_options()) {
    if (option->count() == 0) continue;
    const std::string name = option->get_name();
    if (std::ranges::find(kOfOne, name) != kOfOne.end()) continue;
    for (const std::string& value : option->results()) {
      if (option->get_positional()) {
        words.push_back(value);
      } else if (option->get_expected_max() == 0) {  // a flag
        words.push_back(name);
      } else {
        words.push_back(name + "=" + value);
      }
    }
  }
  return words;
}

std::optional<io::ShardOfRun> shard_of(const std::string& text, const std::string& json,
                                       const std::vector<std::string>& words) {
  if (text.empty()) return {};
  refuse_option(!json.empty(), "--json",
                "is of a whole run: plastica export makes it of the "
                "merged result");
  return io::ShardOfRun{io::parse_shard("--shard", text), words};
}

io::JournalPolicy policy_of(const std::string& output, std::optional<io::ShardOfRun> shard,
                            bool resume, bool force, const std::string& instruction_set) {
  const std::string path = shard ? io::shard_path(output, shard->shard) : io::journal_path(output);
  return {path, resume, force, instruction_set, std::move(shard)};
}

void tell_shard_found(const std::string& path) {
  tell("{} is complete: nothing is left to do\n", path);
}

void tell_shard_ended(const std::string& path, const io::Shard& shard, std::size_t own,
                      std::size_t all, const std::string& noun) {
  tell("wrote {}: {}, {} of {} {}\n", path, words_of(shard), own, all, noun);
}

}  // namespace plastica::cli
