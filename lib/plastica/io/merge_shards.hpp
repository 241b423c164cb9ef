#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plastica/io/journal.hpp"
#include "plastica/io/shard.hpp"

namespace plastica::io {

/// All cases of a run, out of its shards.
struct MergedShards {
  ShardMark mark;                      ///< of shard 1
  std::uint64_t kind = 0;              ///< says what the records are, as a journal's digest
  std::vector<JournalRecord> records;  ///< of all shards
};

/// Whether a file is a shard, complete or not. Never throws.
bool is_shard(const std::string& path);

/// Reads all shards of a run. A run takes them in place of computing, if they are its own: see
/// `JournalPolicy::merged`.
/// @param paths  of their files, in any order
/// @throws InputError if a file is no shard, is damaged or not complete; if shards are of unlike
///         runs, lack, or are there twice. StorageError if one cannot be read
MergedShards merge_shards(std::span<const std::string> paths);

}  // namespace plastica::io
