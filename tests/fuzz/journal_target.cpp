#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/bytes.hpp"
#include "plastica/io/journal.hpp"
#include "plastica/io/journal_layout.hpp"
#include "plastica/io/merge_shards.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Journals and shards. Bytes that begin as a journal are one as they are; of others, lines
/// "ID=PAYLOAD", a journal is made whose records have their digests, since no fuzzer finds these.
namespace plastica::fuzz {
namespace {

void put_raw(std::string& file, std::span<const std::byte> bytes) {
  file.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

std::string journal_of(std::string_view lines) {
  io::ByteWriter header;
  header.put(io::journal_layout::kVersion).put(std::uint64_t{7});
  std::string file(io::kJournalMagic);
  put_raw(file, header.bytes());
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    const std::string_view id = line.substr(0, line.find('='));
    const std::string_view rest = line.substr(std::min(line.size(), id.size() + 1));
    const std::span<const std::byte> payload = std::as_bytes(std::span(rest));
    io::ByteWriter head;
    head.put(std::uint64_t{id.size()}).put(std::uint64_t{payload.size()});
    head.put(io::journal_layout::checksum_of(id, payload));
    put_raw(file, head.bytes());
    file += id;
    put_raw(file, payload);
  }
  return file;
}

/// What was read is what is written: of a journal that has nothing torn, byte by byte.
void write_again(const io::JournalContent& content, const std::string& file) {
  const std::string path = scratch_path("again.journal");
  {
    io::Journal again = io::Journal::create(path, content.run_digest);
    for (const io::JournalRecord& record : content.records) again.append(record.id, record.payload);
  }
  const std::string written = content_of(path);
  require(content.damaged > 0 || file.starts_with(written), "a journal that is written otherwise");
}

void read_any(Bytes bytes) {
  const std::string_view text = text_of(bytes);
  const std::string file =
      text.starts_with(io::kJournalMagic) ? std::string(text) : journal_of(text);
  const std::string path = scratch_file("fuzzed.shard", file);
  const auto content = result_or_refused([&] { return io::read_any_journal(path); });
  if (content && content->state == io::JournalState::Usable) {
    require(content->complete_bytes + content->dropped_bytes == file.size(),
            "bytes that are neither records nor torn");
    write_again(*content, file);
  }
  read_or_refused([&] { return io::read_journal(path, 7); });
  io::is_shard(path);
  const std::vector<std::string> twice{path, path};
  read_or_refused([&] { return io::merge_shards(std::span(twice).first(1)); });
  read_or_refused([&] { return io::merge_shards(twice); });
}

const Registered kJournal{"journal", read_any};

}  // namespace
}  // namespace plastica::fuzz
