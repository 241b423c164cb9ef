#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "calibrate/store/result_bytes.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/shard.hpp"
#include "sweeps/run/result_bytes.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// What the records of a journal hold, by the first byte: a fit, a fit through scenes, a case of a
/// sweep, a shard's mark. What was read, written and read again has the same bytes.
namespace plastica::fuzz {
namespace {

template <typename Read>
auto read_record(const Read& read, std::span<const std::byte> bytes) {
  const auto result = result_or_refused([&] { return read(bytes); });
  if (result) {
    const std::vector<std::byte> first = bytes_of(*result);
    require(first == bytes_of(read(first)), "a record that is another one when read again");
  }
  return result;
}

void read_case(std::span<const std::byte> bytes) {
  const auto result = read_record(&sweeps::result_from_bytes, bytes);
  if (!result) return;
  require(static_cast<std::size_t>(result->status) < io::status_words().size(),
          "a case that ended in no way that there is");
}

void read_any_record(Bytes bytes) {
  if (bytes.empty()) return;
  const std::span<const std::byte> record = std::as_bytes(bytes.subspan(1));
  switch (bytes[0]) {
    case 'f': read_record(&calibrate::result_from_bytes<calibrate::FitResult>, record); break;
    case 't': read_record(&calibrate::result_from_bytes<calibrate::SceneFitResult>, record); break;
    case 'c': read_case(record); break;
    case 's':
      read_record([](auto all) { return io::shard_mark_from_bytes(all, "fuzzed.shard"); }, record);
      break;
    default: break;
  }
}

const Registered kRecord{"record", read_any_record};

}  // namespace
}  // namespace plastica::fuzz
