#include "calibrate/store/scene_result_bytes.hpp"

#include <string>

#include "calibrate/result/describe_fit.hpp"
#include "calibrate/store/coders.hpp"
#include "calibrate/store/described_bytes.hpp"
#include "calibrate/store/interval_bytes.hpp"

namespace plastica::calibrate {
namespace {

using store::A;

constexpr const char* kSource = "a record of a fit through scenes";

void code(auto& coder, A<SceneSegments> auto& s) {
  coder(s.segments, s.note);
  coder.each(s.parameters,
             [](auto& to, auto& each) { store::code_described(to, each, kDescribeSegments); });
}

void code(auto& coder, A<TargetFit> auto& p) {
  coder(p.name, p.fitted, p.fitted_error);
  store::code_described(coder, p, kDescribeTargetFit);
}

void code(auto& coder, A<SceneStart> auto& s) {
  coder(s.from, s.to);
  store::code_described(coder, s, kDescribeStart);
}

void code(auto& coder, A<SceneFitResult> auto& r) {
  const auto item = [](auto& to, auto& each) { code(to, each); };
  coder(r.status, r.reason);
  coder.each(r.parameters, [](auto& to, auto& each) { store::code_parameter(to, each); });
  coder(r.correlation);
  coder.each(r.targets, item);
  coder(r.degrees_of_freedom);
  coder.each(r.starts, item);
  coder.maybe(r.segments, item);
  coder(r.outcome, r.runs, r.failed_runs, r.segment_iterations, r.warnings);
  store::code_intervals(coder, r.intervals);
  coder(r.law, r.search_runs, r.held_out);
}

/// Not inlined, for the same reason as in record_bytes.cpp.
[[gnu::noinline]] void put_scene_version(io::ByteWriter& writer) {
  writer.put(kSceneResultVersion);
}

}  // namespace

std::vector<std::byte> bytes_of(const SceneFitResult& result) {
  io::ByteWriter writer;
  put_scene_version(writer);
  store::Putter putter(writer);
  code(putter, result);
  return writer.take();
}

SceneFitResult scene_result_from_bytes(std::span<const std::byte> bytes) {
  io::ByteReader reader(bytes, kSource);
  const auto version = reader.get<std::uint32_t>();
  if (version != kSceneResultVersion) {
    throw io::StorageError(kSource, "has version " + std::to_string(version) +
                                        ", this library reads version " +
                                        std::to_string(kSceneResultVersion));
  }
  SceneFitResult result;
  store::Getter getter(reader);
  code(getter, result);
  reader.expect_end();
  return result;
}

}  // namespace plastica::calibrate
