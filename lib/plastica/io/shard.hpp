#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::io {

/// One of several parts into which the cases of a run are dealt, so that machines that share
/// nothing can compute them.
struct Shard {
  std::size_t index = 1;  ///< 1 … count
  std::size_t count = 1;

  bool operator==(const Shard&) const = default;
};

/// Most shards of a run.
inline constexpr std::size_t kMaxShards = 100'000;

/// Reads "2/7". @param option  is named in errors @throws InputError
Shard parse_shard(std::string_view option, const std::string& text);

/// "shard 2 of 7".
std::string words_of(const Shard& shard);

/// Where the shard of an output stands: beside it, "OUT.h5.shard-2-of-7".
std::string shard_path(const std::string& output, const Shard& shard);

/// Which shard has which case. The shards have all cases once, and as many as one another but for
/// one. Neighbours, which often take alike long, go to different shards: the cases are dealt in the
/// order of a digest of their ids.
/// @param ids  of all cases, each once (n)
/// @return numbers of shards, 1 … count (n)
std::vector<std::size_t> dealt(std::span<const std::string> ids, std::size_t count);

/// What a shard's file says of the run of which it is a part.
struct ShardMark {
  Shard shard;
  std::string run{};              ///< of all shards alike: a digest of all that the run computes
  std::string instruction_set{};  ///< that it was computed with
  /// The command that computed it, options before inputs, without what is told to one shard alone.
  std::vector<std::string> words{};
};

std::vector<std::byte> bytes_of(const ShardMark& mark);
/// @throws StorageError if the bytes are no such mark
ShardMark shard_mark_from_bytes(std::span<const std::byte> bytes, const std::string& path);

// Ids of the marks in a journal; no case has them.

/// What the file is a shard of.
inline constexpr std::string_view kShardMark = "shard";
/// That all of its cases were there. A case that is lost since is missed by its id.
inline constexpr std::string_view kShardEnd = "end of shard";

}  // namespace plastica::io
