#include "calibrate/search/search_record.hpp"

#include "plastica/io/bytes.hpp"

namespace plastica::calibrate {
namespace {

constexpr const char* kSource = "a record of a search";

void put(io::ByteWriter& to, const RunCounters& runs) {
  to.put(runs.runs).put(runs.failed).put(runs.segment_iterations);
}

RunCounters counters_from(io::ByteReader& from) {
  RunCounters runs;
  runs.runs = from.get<int>();
  runs.failed = from.get<int>();
  runs.segment_iterations = from.get<std::int64_t>();
  return runs;
}

io::ByteReader open(std::span<const std::byte> bytes) {
  io::ByteReader reader(bytes, kSource);
  if (reader.get<std::uint32_t>() != kSearchRecordVersion) {
    throw io::StorageError(kSource, "is of another version");
  }
  return reader;
}

}  // namespace

std::vector<std::byte> bytes_of(const SearchRecord& record) {
  io::ByteWriter to;
  to.put(kSearchRecordVersion).put(static_cast<std::int32_t>(record.found.outcome));
  to.put(record.found.x).put(record.found.residual).put(record.found.cost);
  to.put(record.found.evaluations);
  to.put(record.start.found).put(record.start.reason).put(record.start.reversed);
  put(to, record.start.runs);
  put(to, record.runs);
  return to.take();
}

SearchRecord search_record_from(std::span<const std::byte> bytes) {
  io::ByteReader from = open(bytes);
  SearchRecord record;
  record.found.outcome = static_cast<LeastSquaresOutcome>(from.get<std::int32_t>());
  record.found.x = from.get<std::vector<double>>();
  record.found.residual = from.get<std::vector<double>>();
  record.found.cost = from.get<double>();
  record.found.evaluations = from.get<int>();
  record.start.found = from.get<bool>();
  record.start.reason = from.get<std::string>();
  record.start.reversed = from.get<bool>();
  record.start.runs = counters_from(from);
  record.runs = counters_from(from);
  from.expect_end();
  return record;
}

std::vector<std::byte> bytes_of(const ScreenRecord& record) {
  io::ByteWriter to;
  to.put(kSearchRecordVersion).put(record.costs);
  put(to, record.runs);
  return to.take();
}

ScreenRecord screen_record_from(std::span<const std::byte> bytes) {
  io::ByteReader from = open(bytes);
  ScreenRecord record;
  record.costs = from.get<std::vector<double>>();
  record.runs = counters_from(from);
  from.expect_end();
  return record;
}

std::vector<std::byte> bytes_of(const TaskRecord& record) {
  io::ByteWriter to;
  to.put(kSearchRecordVersion).put(std::uint64_t{record.rows.size()});
  for (const std::vector<double>& row : record.rows) to.put(row);
  to.put(record.text);
  put(to, record.runs);
  return to.take();
}

TaskRecord task_record_from(std::span<const std::byte> bytes) {
  io::ByteReader from = open(bytes);
  TaskRecord record;
  const auto rows = from.get<std::uint64_t>();
  for (std::uint64_t i = 0; i < rows; ++i) record.rows.push_back(from.get<std::vector<double>>());
  record.text = from.get<std::string>();
  record.runs = counters_from(from);
  from.expect_end();
  return record;
}

}  // namespace plastica::calibrate
