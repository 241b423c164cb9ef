#include "sweeps/advise/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "plastica/base/status.hpp"
#include "plastica/theory/convergence.hpp"
#include "sweeps/run/first_break.hpp"

namespace plastica::sweeps {
namespace {

void note_each(std::string_view name, std::span<const double> values, Outcome& outcome) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    outcome.numbers.push_back({fmt::format("{} {}", name, i + 1), values[i]});
  }
}

std::vector<double> largest_rotations(const ChainHistory& chain) {
  std::vector<double> largest(chain.joints);
  const std::size_t frames = chain.joints > 0 ? chain.angle.size() / (3 * chain.joints) : 0;
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t i = 0; i < chain.joints; ++i) {
      const double* angle = &chain.angle[3 * (f * chain.joints + i)];
      largest[i] = std::max(largest[i], std::hypot(angle[0], angle[1], angle[2]));
    }
  }
  return largest;
}

void note_numbers(const Response& response, Outcome& outcome) {
  if (const auto broken = first_break(response.chain)) {
    outcome.numbers.push_back({"time of the first break", broken->time});
    outcome.break_place = broken->place;
  }
  if (response.limit) outcome.numbers.push_back({"limit load", response.limit->below});
  if (response.critical) {
    // One that lies beyond the last equilibrium is the limit load itself, found or not by rounding.
    std::vector<double> passed = response.critical->factor;
    if (response.limit) {
      std::erase_if(passed, [&](double factor) { return factor >= response.limit->below; });
    }
    note_each("critical load", passed, outcome);
  }
  if (response.buckling) note_each("buckling factor", response.buckling->factor, outcome);
  if (response.vibration) note_each("frequency", response.vibration->frequency, outcome);
}

Deviation incomparable(std::string reason) {
  return {std::numeric_limits<double>::infinity(), {}, std::move(reason)};
}

/// A difference of histories has the sign of its part along the finer one, if that is most of it.
double with_sign(double deviation, double along, double squares) {
  constexpr double kMost = 0.7;
  if (std::abs(along) < kMost * deviation * squares) return std::nan("");
  return std::copysign(deviation, along);
}

/// Adds a quantity's deviation if it is the largest so far. What is not finite is the largest.
/// @param part  the deviation with its sign
void take(Deviation& so_far, double part, double deviation, std::string quantity) {
  ++so_far.quantities;
  so_far.parts.push_back({quantity, part});
  if (deviation <= so_far.largest) return;
  so_far.largest = std::isfinite(deviation) ? deviation : std::numeric_limits<double>::infinity();
  so_far.quantity = std::move(quantity);
}

/// Samples of two runs that are at one time: n-th of the coarser, n-th of the finer one.
using Matched = std::vector<std::pair<std::size_t, std::size_t>>;

Matched matched_samples(const Outcome& coarse, const Outcome& fine) {
  Matched matched;
  const double end = coarse.time.empty() ? 0.0 : coarse.time.back();
  std::size_t k = 0;
  for (std::size_t i = 0; i < coarse.time.size(); ++i) {
    while (k < fine.time.size() && fine.time[k] < coarse.time[i] - 1e-9 * end) ++k;
    if (k == fine.time.size()) break;
    if (fine.time[k] <= coarse.time[i] + 1e-9 * end) matched.emplace_back(i, k);
  }
  return matched;
}

void compare_probe(const WatchedProbe& probe, std::span<const double> coarse,
                   std::span<const double> fine, const Matched& matched, Deviation& so_far) {
  double largest = 0.0;
  double scale = 0.0;
  double difference = 0.0;
  double squares = 0.0;
  double along = 0.0;
  for (const auto& [i, k] : matched) {
    largest = std::max(largest, std::abs(coarse[i]));
    scale = std::max(scale, std::abs(fine[k]));
    difference += (coarse[i] - fine[k]) * (coarse[i] - fine[k]);
    squares += fine[k] * fine[k];
    along += (coarse[i] - fine[k]) * fine[k];
  }
  if (std::max(scale, largest) <= probe.least) {
    so_far.parts.insert(so_far.parts.end(), 3, {{}, std::nan("")});
    return;
  }
  const double history = std::sqrt(difference / squares);
  take(so_far, with_sign(history, along, squares), history, probe.name + ": history");
  const auto take_one = [&](double part, std::string_view of) {
    take(so_far, part, std::abs(part), fmt::format("{}: {}", probe.name, of));
  };
  const auto [last, last_fine] = matched.back();
  take_one((largest - scale) / scale, "largest");
  take_one((coarse[last] - fine[last_fine]) / scale, "last");
}

std::string break_text(const Outcome& outcome) {
  if (!outcome.break_place) return "does not break";
  return fmt::format("breaks at {:.4g} of the length", *outcome.break_place);
}

/// Why the two are not one outcome, but for its numbers; empty: they are.
std::string other_outcome(const Outcome& coarse, const Outcome& fine, std::string_view than) {
  if (!break_alike(coarse.break_place, coarse.segments, fine.break_place, fine.segments)) {
    return fmt::format("it {}, and {} it {}", break_text(coarse), than, break_text(fine));
  }
  if (coarse.status != fine.status) {
    return fmt::format("it is {}, and {} {}", name_of(coarse.status), than, name_of(fine.status));
  }
  for (std::size_t i = 0; i < std::max(coarse.numbers.size(), fine.numbers.size()); ++i) {
    const bool in_both = i < std::min(coarse.numbers.size(), fine.numbers.size()) &&
                         coarse.numbers[i].name == fine.numbers[i].name;
    if (in_both) continue;
    const Outcome& more = i < fine.numbers.size() ? fine : coarse;
    return more.numbers[i].name + " is there in one of two settings alone";
  }
  return {};
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
  outcome.work = outcome.segments * std::max(response.counters.iterations, 1);
  outcome.seconds = response.seconds;
  const auto samples = static_cast<std::ptrdiff_t>(response.samples);
  const auto& time = response.chain.time;
  outcome.time.assign(time.begin(), time.begin() + samples);
  for (const WatchedProbe& probe : watched) {
    const auto& values = response.probes[probe.probe];
    outcome.history.emplace_back(values.begin(), values.begin() + samples);
  }
  note_numbers(response, outcome);
  outcome.bent = largest_rotations(response.chain);
  return outcome;
}

bool end_alike(const Outcome& coarse, const Outcome& fine) {
  return other_outcome(coarse, fine, {}).empty();
}

Deviation deviation(const Outcome& coarse, const Outcome& fine,
                    const std::vector<WatchedProbe>& watched, std::string_view than) {
  for (const Outcome* one : {&coarse, &fine}) {
    if (!usable(one->status)) return incomparable(one->reason);
  }
  if (std::string other = other_outcome(coarse, fine, than); !other.empty()) {
    return incomparable(std::move(other));
  }
  const Matched matched = matched_samples(coarse, fine);
  if (matched.empty()) return incomparable("the two have no sample at the same time");
  Deviation found;
  for (std::size_t k = 0; k < watched.size(); ++k) {
    compare_probe(watched[k], coarse.history[k], fine.history[k], matched, found);
  }
  for (std::size_t i = 0; i < fine.numbers.size(); ++i) {
    const auto& [name, value] = fine.numbers[i];
    const double off = (coarse.numbers[i].value - value) / std::abs(value);
    if (coarse.numbers[i].value == 0.0 && value == 0.0) {
      found.parts.push_back({name, std::nan("")});
    } else {
      take(found, off, std::abs(off), name);
    }
  }
  return found;
}

SignedDeviation off_limit_of_two_orders(const std::array<double, 3>& sizes, const Deviation& coarse,
                                        const Deviation& fine) {
  SignedDeviation worst;
  const std::size_t quantities = coarse.parts.size() == fine.parts.size() ? fine.parts.size() : 0;
  for (std::size_t q = 0; q < quantities; ++q) {
    const double middle = fine.parts[q].value;  // over the finest run
    const double most = middle + coarse.parts[q].value;
    const double off = most - theory::limit_of_two_orders(sizes, std::array{0.0, middle, most});
    if (std::abs(off) > std::abs(worst.value)) worst = {coarse.parts[q].quantity, off};
  }
  return worst;
}

}  // namespace plastica::sweeps
