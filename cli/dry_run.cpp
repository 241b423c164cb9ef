#include "cli/dry_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "calibrate/target/plausibility.hpp"
#include "calibrate/trial/remesh.hpp"
#include "cli/tell.hpp"
#include "plastica/base/check.hpp"

namespace plastica::cli {
namespace {

using calibrate::FitOptions;
using calibrate::Target;
using calibrate::TargetStatus;

/// Bytes that a target and its fit hold in memory: all but curves, as measured, and the trace of a
/// fit of usual length.
std::size_t memory_of(const FitOptions& options) {
  constexpr std::size_t kTarget = 11'000;
  const std::size_t usual = static_cast<std::size_t>(options.stopping.global_evaluations) + 100;
  const std::size_t evaluations = options.keep_trace ? usual : 0;
  return kTarget + sizeof(double) * evaluations * (options.parameters.size() + 1);
}

/// Of the largest of their files, as text and in cells, while it is read.
std::size_t largest_table(std::span<const Target> targets) {
  constexpr std::size_t kRow = 200;
  std::map<std::string_view, std::size_t> rows;
  std::size_t largest = 0;
  for (const Target& target : targets) {
    largest = std::max(largest, rows[target.file] += target.raw.samples());
  }
  return kRow * largest;
}

void print_parameters(const Target& target, const FitOptions& options) {
  const calibrate::ParameterSet set(target, options);
  say("parameters of {} (SI):\n", target.name);
  for (const calibrate::ResolvedParameter& p : set.all()) {
    std::string_view role = "fixed";
    if (p.role == calibrate::ParameterRole::Free) role = p.idle ? "free, not determined" : "free";
    if (p.role == calibrate::ParameterRole::Tied) role = "tied";
    say("  {:<36} {:<6} start {:<12.6g}", p.field->path, role, p.start);
    if (p.role == calibrate::ParameterRole::Free) {
      say(" bounds {:.6g} … {:.6g}{}", p.lower, p.upper, p.logarithmic ? ", log" : "");
    }
    say("\n");
  }
}

/// "16 segments", or "none with half (why not)".
std::string repetition(const calibrate::WeightedTarget& weighted, calibrate::Division division) {
  try {
    return fmt::format("{} segments", calibrate::remeshed(weighted, division).scene.beam.segments);
  } catch (const InputError& error) {
    const bool half = division == calibrate::Division::Half;
    return fmt::format("none with {} ({})", half ? "half" : "twice", error.what());
  }
}

}  // namespace

void print_plausible(std::span<const calibrate::TargetBlock> blocks) {
  std::set<std::string> said;
  for (const calibrate::TargetBlock& block : blocks) {
    if (block.options.test != calibrate::Test::Tension) continue;
    const std::string text = calibrate::plausible_text(block.options);
    if (said.insert(text).second) say("plausible: {}\n", text);
  }
}

void print_repetitions(std::span<const calibrate::SceneFitCase> fits) {
  std::string beams;
  for (const calibrate::SceneFitCase& fit : fits) {
    for (const calibrate::WeightedTarget& weighted : fit.targets) {
      if (weighted.setup.scene.is_coupon()) continue;
      beams += fmt::format("  {}: {} and {}\n", weighted.target.name,
                           repetition(weighted, calibrate::Division::Half),
                           repetition(weighted, calibrate::Division::Twice));
    }
  }
  if (beams.empty()) return;
  say("then again with half and with twice the segments, for their error: a search each from the "
      "fitted values,\nhalf and twice the work a run (fit.segments_error = false: neither)\n{}",
      beams);
}

void print_dry_run(std::span<const Target> targets, const FitOptions& options,
                   const std::string& output) {
  std::size_t ready = 0;
  constexpr std::size_t kProgram = 40'000'000;
  std::size_t bytes = kProgram + largest_table(targets);
  std::size_t curves = 0;
  for (const Target& target : targets) {
    ready += target.status == TargetStatus::Ready ? 1 : 0;
    bytes += memory_of(options) * std::max<std::size_t>(options.laws.size(), 1);
    // Fitted ones are made again when they are written.
    curves += calibrate::bytes_of_curves(target);
    say("{:<32} {:>6} samples  {}\n", target.name, target.corrected.samples(),
        target.status == TargetStatus::Ready ? "ready" : target.reason);
  }
  const auto first = std::find_if(targets.begin(), targets.end(), [](const Target& target) {
    return target.status == TargetStatus::Ready;
  });
  if (first != targets.end()) print_parameters(*calibrate::CorrectedTarget(*first), options);
  const bool on_disk = curves > calibrate::CurveSpool::kInMemory;
  say("{} target{}, {} to fit, algorithm {}, about {:.0f} MB of memory{}\n", targets.size(),
      targets.size() == 1 ? "" : "s", ready, options.algorithm,
      static_cast<double>(on_disk ? bytes : bytes + curves) / 1e6,
      on_disk ? fmt::format(" and, while it runs, {:.0f} MB on the disk",
                            static_cast<double>(curves) / 1e6)
              : "");
  say("level coupon: a strain history drives all joints alike: one stands for all\n");
  say("nothing was run; the result would be {}\n", output);
}

}  // namespace plastica::cli
