#include "sweeps/run/result_bytes.hpp"

#include "plastica/io/bytes.hpp"

namespace plastica::sweeps {
namespace {

/// Visits all of a result, so that reading cannot forget what writing has.
template <class Result, class Coder>
void traverse(Result& r, Coder& code) {
  code(r.status, r.reason, r.level, r.value, r.time, r.curve, r.segments, r.iterations, r.cutbacks,
       r.last_time, r.last_value, r.energy_balance_error, r.standard_error, r.break_joint,
       r.break_place, r.seconds);
}

}  // namespace

std::vector<std::byte> bytes_of(const CaseResult& result) {
  io::ByteWriter writer;
  const auto put = [&](const auto&... values) { (writer.put(values), ...); };
  traverse(result, put);
  return writer.take();
}

CaseResult result_from_bytes(std::span<const std::byte> bytes) {
  io::ByteReader reader(bytes, "record of a journal");
  CaseResult result;
  const auto get = [&](auto&... values) {
    ((values = reader.get<std::remove_reference_t<decltype(values)>>()), ...);
  };
  traverse(result, get);
  reader.expect_end();
  return result;
}

}  // namespace plastica::sweeps
