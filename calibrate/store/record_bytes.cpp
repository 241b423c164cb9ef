#include "calibrate/store/record_bytes.hpp"

#include <string>

#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/store/coders.hpp"
#include "calibrate/store/described_bytes.hpp"
#include "calibrate/store/interval_bytes.hpp"

namespace plastica::calibrate {
namespace {

using io::ByteReader;
using io::ByteWriter;
using store::A;
using store::Getter;
using store::Putter;

constexpr auto kPair = [](auto& coder, auto& pair) { coder(pair.first, pair.second); };

void code(auto& coder, A<Curve> auto& curve) { coder(curve.strain, curve.stress); }

void code_deciding_parts(auto& coder, A<Target> auto& t) {
  coder(t.name, t.test, t.measure, t.loading, t.status, t.reason);
  code(coder, t.corrected);
  store::code_described(coder, t.characteristics, kDescribeCharacteristics);
  coder.each(t.properties, kPair);  // a strain rate is among them
}

void code(auto& coder, A<Target> auto& t) {
  code_deciding_parts(coder, t);
  coder(t.file);
  coder.each(t.group, kPair);
  code(coder, t.raw);
  coder.each(t.repairs, [](auto& to, auto& r) { store::code_described(to, r, kDescribeRepair); });
  coder.each(t.corrections,
             [](auto& to, auto& c) { store::code_described(to, c, kDescribeCorrection); });
  coder(t.warnings);
}

void code(auto& coder, A<FitResult> auto& r) {
  coder(r.status, r.reason, r.law);
  coder.each(r.parameters, [](auto& to, auto& parameter) { store::code_parameter(to, parameter); });
  coder(r.correlation, r.cost, r.misfit_rms, r.misfit_fraction, r.misfit_word, r.samples,
        r.break_strain_total, r.seed, r.runs_test_p, r.autocorrelation, r.effective_samples,
        r.noise, r.simpler_evaluations, r.held_out, r.unseen);
  coder.maybe(r.modulus_prior, [](auto& to, auto& prior) {
    store::code_described(to, prior, kDescribeModulusPrior);
  });
  coder.each(r.stages, [](auto& to, auto& s) { store::code_described(to, s, kDescribeStage); });
  coder(r.trace.active, r.trace.values, r.trace.costs);
  store::code_intervals(coder, r.intervals);
  code(coder, r.fitted);
  coder(r.warnings);
}

void code(auto& coder, A<FitRecord> auto& record) {
  code(coder, record.target);
  code(coder, record.result);
}

/// Not inlined: g++ 12 would warn of an overflow that is none (-Wstringop-overflow) where it knows
/// that the writer is still empty.
[[gnu::noinline]] void put_version(ByteWriter& writer) { writer.put(kRecordVersion); }

template <typename T>
std::vector<std::byte> to_bytes(const T& value) {
  ByteWriter writer;
  put_version(writer);
  Putter putter(writer);
  code(putter, value);
  return writer.take();
}

template <typename T>
T from_bytes(std::span<const std::byte> bytes) {
  ByteReader reader(bytes, "a record of a fit");
  const auto version = reader.get<std::uint32_t>();
  if (version != kRecordVersion) {
    throw io::StorageError("a record of a fit", "has version " + std::to_string(version) +
                                                    ", this library reads version " +
                                                    std::to_string(kRecordVersion));
  }
  T value;
  Getter getter(reader);
  code(getter, value);
  reader.expect_end();
  return value;
}

}  // namespace

std::vector<std::byte> bytes_of(const FitResult& result) { return to_bytes(result); }
FitResult result_from_bytes(std::span<const std::byte> bytes) {
  return from_bytes<FitResult>(bytes);
}

std::vector<std::byte> bytes_of(const FitRecord& record) { return to_bytes(record); }
FitRecord record_from_bytes(std::span<const std::byte> bytes) {
  return from_bytes<FitRecord>(bytes);
}

void put_deciding_parts(ByteWriter& writer, const Target& target) {
  Putter putter(writer);
  code_deciding_parts(putter, target);
}

}  // namespace plastica::calibrate
