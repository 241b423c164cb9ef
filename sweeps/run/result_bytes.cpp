#include "sweeps/run/result_bytes.hpp"

#include <cstddef>

#include "plastica/io/bytes.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/storage_error.hpp"
#include "plastica/model/field.hpp"

namespace plastica::sweeps {
namespace {

/// Visits all of a result, so that reading cannot forget what writing has.
template <class Result, class Coder>
void traverse(Result& r, Coder& code) {
  code(r.status, r.reason, r.level, r.value, r.time, r.curve, r.segments, r.iterations, r.cutbacks,
       r.last_time, r.last_value, r.energy_balance_error, r.standard_error, r.break_joint,
       r.break_place, r.seconds, r.warnings);
}

}  // namespace

std::vector<std::byte> bytes_of(const CaseResult& result) {
  io::ByteWriter writer;
  const auto put = [&](const auto&... values) { (writer.put(values), ...); };
  traverse(result, put);
  return writer.take();
}

CaseResult result_from_bytes(std::span<const std::byte> bytes) {
  constexpr const char* kSource = "record of a journal";
  io::ByteReader reader(bytes, kSource);
  CaseResult result;
  const auto get = [&](auto&... values) {
    ((values = reader.get<std::remove_reference_t<decltype(values)>>()), ...);
  };
  traverse(result, get);
  reader.expect_end();
  // Reports look for the words of both.
  if (static_cast<std::size_t>(result.status) >= io::status_words().size() ||
      static_cast<std::size_t>(result.level) >=
          find_field_or_null("solver.level")->choices.size()) {
    throw io::StorageError(kSource, "has a number that stands for no word");
  }
  return result;
}

}  // namespace plastica::sweeps
