#pragma once

#include <span>
#include <string>

#include "plastica/io/shard.hpp"

namespace plastica::io {

/// Whether a file begins as a journal or a shard does. Never throws.
bool begins_as_journal(const std::string& path);

/// Puts the shards of a run together into a journal, with which the run then goes on to its result
/// as if it had computed all itself: only a run of the same inputs, options, version and
/// instruction set takes it, see `CaseJournal::begin`. The shards stay as they are.
/// @param shards  paths of their files, in any order
/// @param path    of the journal. One that was merged before is replaced, since the shards have all
///                that it has
/// @param force   replaces any other journal, too
/// @return what all shards say of their run (with the index of the first)
/// @throws InputError if a file is no shard, is not complete or is of another run, if shards lack
/// or
///         stand twice, or if there is a journal; StorageError if one cannot be read or written, or
///         another run has it
ShardMark merge_shards(std::span<const std::string> shards, const std::string& path, bool force);

}  // namespace plastica::io
