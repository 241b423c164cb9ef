#include "calibrate/store/scene_result_bytes.hpp"

#include <string>

#include "calibrate/store/coders.hpp"
#include "calibrate/store/interval_bytes.hpp"
#include "calibrate/store/parameter_bytes.hpp"

namespace plastica::calibrate {
namespace {

using store::A;

constexpr const char* kSource = "a record of a fit through scenes";

void code(auto& coder, A<SegmentsError> auto& e) {
  coder(e.at_half, e.at_own, e.at_twice, e.trend, e.observed_order, e.order, e.safety_factor,
        e.extrapolated, e.extrapolated_error, e.error);
}

void code(auto& coder, A<SceneSegments> auto& s) {
  const auto item = [](auto& to, auto& each) { code(to, each); };
  coder(s.segments, s.note);
  coder.each(s.parameters, item);
}

void code(auto& coder, A<ScenePartFit> auto& p) {
  coder(p.name, p.level, p.samples, p.cost, p.noise, p.misfit_share, p.runs_probability, p.fitted,
        p.fitted_error, p.break_strain, p.degrees_of_freedom);
}

void code(auto& coder, A<SceneStart> auto& s) {
  coder(s.from, s.to, s.cost, s.outcome, s.evaluations);
}

void code(auto& coder, A<SceneFitResult> auto& r) {
  const auto item = [](auto& to, auto& each) { code(to, each); };
  coder(r.status, r.reason);
  coder.each(r.parameters, [](auto& to, auto& each) { store::code_parameter(to, each); });
  coder(r.correlation);
  coder.each(r.parts, item);
  coder(r.degrees_of_freedom);
  coder.each(r.starts, item);
  coder.maybe(r.segments, item);
  coder(r.outcome, r.runs, r.failed_runs, r.segment_iterations, r.warnings);
  store::code_intervals(coder, r.intervals);
  coder(r.law, r.search_runs);
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
