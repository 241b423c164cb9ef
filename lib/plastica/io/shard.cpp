#include "plastica/io/shard.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <numeric>

#include "plastica/base/check.hpp"
#include "plastica/io/bytes.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::io {
namespace {

/// Digits alone.
std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

}  // namespace

Shard parse_shard(std::string_view option, const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view all = text;
  const auto index = whole_number(all.substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : whole_number(all.substr(slash + 1));
  if (!index || !count) {
    throw InputError({}, option, text,
                     "must be the number of a shard and how many there are, such as 2/7");
  }
  if (*count < 1 || *count > kMaxShards) {
    throw InputError({}, option, text,
                     "there must be 1 … " + std::to_string(kMaxShards) + " shards");
  }
  if (*index < 1 || *index > *count) {
    throw InputError({}, option, text,
                     "the number of a shard must be 1 … " + std::to_string(*count));
  }
  return {*index, *count};
}

std::string words_of(const Shard& shard) {
  return "shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count);
}

std::string shard_path(const std::string& output, const Shard& shard) {
  return output + ".shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
}

std::vector<std::size_t> dealt(std::span<const std::string> ids, std::size_t count) {
  std::vector<std::uint64_t> digest(ids.size());
  std::transform(ids.begin(), ids.end(), digest.begin(),
                 [](const std::string& id) { return Digest().text(id).value(); });
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return digest[a] != digest[b] ? digest[a] < digest[b] : ids[a] < ids[b];
  });
  std::vector<std::size_t> shard(ids.size());
  for (std::size_t k = 0; k < order.size(); ++k) shard[order[k]] = k % count + 1;
  return shard;
}

std::vector<std::byte> bytes_of(const ShardMark& mark) {
  ByteWriter writer;
  writer.put(std::uint64_t{mark.shard.index}).put(std::uint64_t{mark.shard.count});
  writer.put(mark.run).put(mark.instruction_set).put(mark.words);
  return writer.take();
}

ShardMark shard_mark_from_bytes(std::span<const std::byte> bytes, const std::string& path) {
  ByteReader reader(bytes, path);
  ShardMark mark;
  mark.shard.index = static_cast<std::size_t>(reader.get<std::uint64_t>());
  mark.shard.count = static_cast<std::size_t>(reader.get<std::uint64_t>());
  mark.run = reader.get<std::string>();
  mark.instruction_set = reader.get<std::string>();
  mark.words = reader.get<std::vector<std::string>>();
  reader.expect_end();
  if (mark.shard.count < 1 || mark.shard.count > kMaxShards || mark.shard.index < 1 ||
      mark.shard.index > mark.shard.count) {
    throw StorageError(path, "says that it is " + words_of(mark.shard));
  }
  return mark;
}

}  // namespace plastica::io
