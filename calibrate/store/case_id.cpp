#include "calibrate/store/case_id.hpp"

#include <variant>

#include "calibrate/result/describe_target.hpp"
#include "calibrate/store/coded_rows.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/base/instruction_set.hpp"
#include "plastica/base/renamed.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {
namespace {

using io::ByteWriter;

void put_setup(ByteWriter& writer, const Setup& setup) {
  for (const Field& field : fields()) {
    const FieldValue value = field.get(setup);
    writer.put(old_path(field.path)).put(std::uint64_t{value.index()});
    if (const auto* number = std::get_if<double>(&value)) writer.put(*number);
    if (const auto* word = std::get_if<std::string>(&value)) writer.put(*word);
  }
}

void put_parameter(ByteWriter& writer, const Parameter& p) {
  writer.put(old_path(p.field->path)).put(p.role).put(p.value).put(p.lower).put(p.upper);
  writer.put(p.scale).put(p.tied_to != nullptr ? old_path(p.tied_to->path) : std::string());
  writer.put(p.factor).put(p.prior.has_value());
  if (p.prior) writer.put(p.prior->mean).put(p.prior->standard_deviation);
}

/// Those parts of a target that can decide its fit: where it comes from, its raw curve, what was
/// repaired and to which group it belongs can change without changing the fit.
void put_target(ByteWriter& writer, const Target& t) {
  store::Putter put(writer);
  put(t.name, t.test, t.measure, t.loading, t.status, t.reason);
  put(digest_of(t.corrected));
  store::code_described(put, t.characteristics, kDescribeCharacteristics);
  put.each(t.properties, [](auto& to, auto& pair) { to(pair.first, pair.second); });  // strain rate
}

}  // namespace

std::uint64_t digest_of(const FitOptions& options) {
  ByteWriter writer;
  writer.put(version()).put(name_of(resolved(options.setup.solver.isa)));
  put_setup(writer, options.setup);
  writer.put(std::uint64_t{options.parameters.size()});
  for (const Parameter& parameter : options.parameters) put_parameter(writer, parameter);
  writer.put(options.objective).put(options.noise).put(options.break_weight);
  writer.put(options.modulus_prior);
  writer.put(std::uint64_t{options.weights.size()});
  for (const WeightStep& step : options.weights) writer.put(step.from).put(step.weight);
  writer.put(options.algorithm);
  writer.put(options.stopping.global_evaluations).put(options.stopping.local_evaluations);
  writer.put(options.stopping.parameter_tolerance).put(options.stopping.cost_tolerance);
  writer.put(std::uint64_t{options.laws.size()});
  for (const Law law : options.laws) writer.put(law);
  writer.put(options.seed).put(options.confidence);
  writer.put(options.intervals.profile).put(options.intervals.bootstrap);
  writer.put(options.intervals.block);
  return io::Digest().block(writer.bytes()).value();
}

std::string case_id(const Target& target, std::uint64_t options_digest) {
  ByteWriter writer;
  put_target(writer, target);
  const auto digest = io::Digest().integer(options_digest).block(writer.bytes()).value();
  return target.name + ' ' + io::hexadecimal(digest);
}

}  // namespace plastica::calibrate
