#include "calibrate/store/result_bytes.hpp"

#include <string>

#include "calibrate/store/coded_rows.hpp"
#include "calibrate/store/layout.hpp"
#include "plastica/base/renamed.hpp"

namespace plastica::calibrate {
namespace {

using store::A;
using store::CodedRows;

constexpr const char* kSource = "a record of a fit";

void code(auto& coder, A<FittedParameter> auto& p) {
  coder(p.path, p.dimension, p.role);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(p)>>) {
    p.path = new_path(p.path);
  }
  store::code_described(coder, p, kDescribeParameter);
}

void code(auto& coder, A<BootstrapResult> auto& b) {
  coder(b.resamples, b.failed, b.block, b.values);
  coder.each(b.intervals, [](auto& to, auto& i) { to(i.standard_error, i.low, i.high); });
}

/// What the layout of a file's tables leaves to others.
void code_outcome(auto& coder, auto& result) {
  coder.each(result.parameters, [](auto& to, auto& each) { code(to, each); });
  code(coder, result.intervals.residuals);
  code(coder, result.intervals.specimens);
}

void code(auto& coder, A<FitResult> auto& result) {
  code_outcome(coder, result);
  CodedRows fits(coder, std::vector{&result});
  store::traverse_fit(fits);
}

void code(auto& coder, A<SceneFitResult> auto& result) {
  code_outcome(coder, result);
  CodedRows fits(coder, std::vector{&result});
  store::traverse_scene_fit(fits);
  auto targets = fits.list("", PLASTICA_MEMBER(targets), kDescribeTargetFit);
  targets.numbers("", "", PLASTICA_MEMBER(name));
  targets.numbers("", "", PLASTICA_MEMBER(fitted));
  targets.numbers("", "", PLASTICA_MEMBER(fitted_error));
}

/// Not inlined: g++ 12 would warn of an overflow that is none (-Wstringop-overflow) where it knows
/// that the writer is still empty.
[[gnu::noinline]] void put_version(io::ByteWriter& writer) { writer.put(kResultVersion); }

template <typename Result>
std::vector<std::byte> to_bytes(const Result& result) {
  io::ByteWriter writer;
  put_version(writer);
  store::Putter putter(writer);
  code(putter, result);
  return writer.take();
}

}  // namespace

std::vector<std::byte> bytes_of(const FitResult& result) { return to_bytes(result); }
std::vector<std::byte> bytes_of(const SceneFitResult& result) { return to_bytes(result); }

template <typename Result>
Result result_from_bytes(std::span<const std::byte> bytes) {
  io::ByteReader reader(bytes, kSource);
  const auto version = reader.get<std::uint32_t>();
  if (version != kResultVersion) {
    throw io::StorageError(kSource, "has version " + std::to_string(version) +
                                        ", this library reads version " +
                                        std::to_string(kResultVersion));
  }
  Result result;
  store::Getter getter(reader);
  code(getter, result);
  reader.expect_end();
  return result;
}

template FitResult result_from_bytes(std::span<const std::byte> bytes);
template SceneFitResult result_from_bytes(std::span<const std::byte> bytes);

}  // namespace plastica::calibrate
