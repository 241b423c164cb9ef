#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plastica/io/case_journal.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library CLI11
class App;
}

namespace plastica::cli {

/// Adds `--shard`.
void add_shard_option(CLI::App& sub, std::string& text);

/// The words that tell a command again what it was told, but for what is told to one shard alone:
/// output, threads, what to go on from.
std::vector<std::string> words_again(const CLI::App& sub);

/// The shard that a run was told to compute; empty: it computes all.
/// @param text   of `--shard`; empty: not given
/// @param json   of `--json`, which a shard cannot write
/// @param words  see `words_again`
/// @throws InputError
std::optional<io::ShardOfRun> shard_of(const std::string& text, const std::string& json,
                                       const std::vector<std::string>& words);

/// Where a run keeps what is finished: in its journal, or in its shard's file.
io::JournalPolicy policy_of(const std::string& output, std::optional<io::ShardOfRun> shard,
                            bool resume, bool force, const std::string& instruction_set);

/// Says that a shard was found complete.
void tell_shard_found(const std::string& path);
/// Says what a shard's file has now. @param noun  "fits"
void tell_shard_ended(const std::string& path, const io::Shard& shard, std::size_t own,
                      std::size_t all, const std::string& noun);

}  // namespace plastica::cli
