#include "sweeps/advise/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "plastica/base/status.hpp"

namespace plastica::sweeps {
namespace {

void note_break(const ChainHistory& chain, Outcome& outcome) {
  for (const ChainBreak& event : chain.events) {
    for (const BrokenJoint& joint : event.joints) {
      if (joint.cause == BreakCause::Cut) continue;
      outcome.break_time = event.time;
      outcome.break_place =
          static_cast<double>(joint.joint) / static_cast<double>(chain.joints - 1);
      return;
    }
  }
}

Deviation incomparable(std::string reason) {
  return {std::numeric_limits<double>::infinity(), {}, std::move(reason)};
}

double largest_size(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Adds a quantity's deviation if it is the largest so far. What is not finite is the largest.
void take(Deviation& so_far, double deviation, std::string quantity) {
  if (deviation <= so_far.largest) return;
  so_far.largest = std::isfinite(deviation) ? deviation : std::numeric_limits<double>::infinity();
  so_far.quantity = std::move(quantity);
}

/// The values of a history at the samples that the other run has, too.
/// @param every  which of its samples those are
std::vector<double> thinned(std::span<const double> values, std::size_t every) {
  std::vector<double> thin;
  for (std::size_t i = every - 1; i < values.size(); i += every) thin.push_back(values[i]);
  return thin;
}

/// Which samples of the finer run are those of the coarser: every first, second, … one; 0: the two
/// have other times.
std::size_t stride(const Outcome& coarse, const Outcome& fine) {
  if (coarse.time.empty() || fine.time.empty()) return 0;
  const double first = coarse.time.front();
  for (std::size_t every = 1; every <= fine.time.size(); ++every) {
    const double time = fine.time[every - 1];
    if (std::abs(time - first) <= 1e-9 * std::abs(first)) return every;
    if (time > first) break;
  }
  return 0;
}

void compare_probe(const WatchedProbe& probe, std::span<const double> coarse,
                   std::span<const double> fine_all, std::size_t every, Deviation& so_far) {
  const double scale = largest_size(fine_all);
  if (std::max(scale, largest_size(coarse)) <= probe.least) return;
  const std::vector<double> fine = thinned(fine_all, every);
  // A path that broke or reached its limit ends a sample earlier in one run than in the other.
  const std::size_t both = std::min(coarse.size(), fine.size());
  double difference = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < both; ++i) {
    difference += (coarse[i] - fine[i]) * (coarse[i] - fine[i]);
    squares += fine[i] * fine[i];
  }
  take(so_far, std::sqrt(difference / squares), probe.name + ": history");
  take(so_far, std::abs(largest_size(coarse) - scale) / scale, probe.name + ": largest");
  take(so_far, std::abs(coarse[both - 1] - fine[both - 1]) / scale, probe.name + ": last");
}

std::string break_text(const Outcome& outcome) {
  if (!outcome.break_time) return "does not break";
  return fmt::format("breaks at {:.4g} of the length", outcome.break_place);
}

}  // namespace

Outcome outcome_of(const BatchRow& row, const std::vector<WatchedProbe>& watched) {
  const Response& response = row.response;
  Outcome outcome;
  outcome.status = response.status;
  outcome.reason = row.reason;
  if (!usable(response.status)) {
    if (outcome.reason.empty()) outcome.reason = advice(response.status, row.in_motion);
    if (outcome.reason.empty()) outcome.reason = name_of(response.status);
  }
  if (response.chain.joints == 0) return outcome;
  outcome.segments = static_cast<std::int64_t>(response.chain.joints) - 1;
  outcome.work = outcome.segments * response.counters.iterations;
  outcome.seconds = response.seconds;
  const auto samples = static_cast<std::ptrdiff_t>(response.samples);
  const auto& time = response.chain.time;
  outcome.time.assign(time.begin(), time.begin() + samples);
  for (const WatchedProbe& probe : watched) {
    const auto& values = response.probes[probe.probe];
    outcome.history.emplace_back(values.begin(), values.begin() + samples);
  }
  note_break(response.chain, outcome);
  if (response.limit) outcome.limit_load = response.limit->below;
  return outcome;
}

Deviation deviation(const Outcome& coarse, const Outcome& fine,
                    const std::vector<WatchedProbe>& watched) {
  for (const Outcome* one : {&coarse, &fine}) {
    if (!usable(one->status)) return incomparable(one->reason);
  }
  const double apart = 1.5 / static_cast<double>(std::min(coarse.segments, fine.segments));
  const bool both_break = coarse.break_time && fine.break_time;
  if (coarse.break_time.has_value() != fine.break_time.has_value() ||
      (both_break && std::abs(coarse.break_place - fine.break_place) > apart)) {
    return incomparable(
        fmt::format("it {}, and finer it {}", break_text(coarse), break_text(fine)));
  }
  if (coarse.status != fine.status) {
    return incomparable(
        fmt::format("it is {}, and finer {}", name_of(coarse.status), name_of(fine.status)));
  }
  const std::size_t every = stride(coarse, fine);
  if (every == 0) return incomparable("the two have no sample at the same time");
  Deviation found;
  for (std::size_t k = 0; k < watched.size(); ++k) {
    compare_probe(watched[k], coarse.history[k], fine.history[k], every, found);
  }
  if (both_break) {
    take(found, std::abs(*coarse.break_time - *fine.break_time) / *fine.break_time,
         "time of the first break");
  }
  if (coarse.limit_load && fine.limit_load) {
    take(found, std::abs(*coarse.limit_load - *fine.limit_load) / std::abs(*fine.limit_load),
         "limit load");
  }
  return found;
}

}  // namespace plastica::sweeps
