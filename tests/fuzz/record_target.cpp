#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "calibrate/store/result_bytes.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/shard.hpp"
#include "sweeps/run/result_bytes.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/calibrate/store/synthetic_scene_fits.hpp"
#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// What the records of a journal hold, by the first byte: a fit, a fit through scenes, a case of a
/// sweep, a shard's mark. A capital is followed by patches of a record that the program makes: one
/// of an older version would be refused. What was read, written and read again has the same bytes.
namespace plastica::fuzz {
namespace {

template <typename Read>
auto read_record(const Read& read, std::span<const std::byte> bytes) {
  auto result = result_or_refused([&] { return read(bytes); });
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

template <typename Result>
std::string text_of_record(const Result& result) {
  const std::vector<std::byte> bytes = bytes_of(result);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const std::string& made_record(char kind) {
  static const std::string fit = text_of_record(calibrate::filled_record("a").result);
  static const std::string scene_fit = text_of_record(calibrate::filled_scene_record("a").result);
  static const std::string one_case =
      text_of_record(sweeps::CaseResult{.status = Status::Completed, .time = {0.0, 1.0}});
  static const std::string mark =
      text_of_record(io::ShardMark{{2, 7}, "0123", "baseline", {"sweep", "a.toml"}});
  switch (kind) {
    case 'F': return fit;
    case 'T': return scene_fit;
    case 'C': return one_case;
    default: return mark;
  }
}

void read_any_record(Bytes bytes) {
  if (bytes.empty()) return;
  std::string content(text_of(bytes.subspan(1)));
  auto kind = static_cast<char>(bytes[0]);
  if (kind >= 'A' && kind <= 'Z') {
    content = patched(made_record(kind), 0, ByteSource(bytes.subspan(1)));
    kind = static_cast<char>(kind - 'A' + 'a');
  }
  const std::span<const std::byte> record = std::as_bytes(std::span(content));
  switch (kind) {
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
