#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plastica/io/case_journal.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library CLI11
class App;
}

namespace plastica {
class Team;
}

namespace plastica::cli {

/// Adds `--shard`, which `shard_of` reads.
void add_shard_option(CLI::App& sub);

/// The shard that a run was told to compute; empty: it computes all.
/// @param sub   the command as it was told
/// @throws InputError
std::optional<io::ShardOfRun> shard_of(const CLI::App& sub);

/// Where a run keeps what is finished: in its journal, or in its shard's file. Where shards are
/// merged it computes nothing.
io::JournalPolicy policy_of(const std::string& output, std::optional<io::ShardOfRun> shard,
                            bool resume, bool force, const std::string& instruction_set,
                            const io::MergedShards* merged, Team* team);

/// Says of a dry run what a shard would do of it; nothing where it is the whole run.
void say_shard(const std::string& output, const std::optional<io::ShardOfRun>& shard);
/// Says that a shard was found complete.
void tell_shard_found(const std::string& path);
/// Says what a shard's file has now. @param noun  "fits"
void tell_shard_ended(const std::string& path, const io::Shard& shard, std::size_t own,
                      std::size_t all, const std::string& noun);

}  // namespace plastica::cli
