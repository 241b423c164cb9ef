#include "sweeps/run/case_result.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plastica/report/format.hpp"
#include "plastica/theory/spectrum.hpp"
#include "sweeps/run/first_break.hpp"

namespace plastica::sweeps {
namespace {

double time_mean(std::span<const double> time, std::span<const double> values) {
  if (values.size() == 1) return values[0];
  double integral = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    integral += 0.5 * (values[i] + values[i - 1]) * (time[i] - time[i - 1]);
  }
  return integral / (time.back() - time.front());
}

Measured frequency_of(std::span<const double> time, std::span<const double> values) {
  const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const auto peaks = theory::spectral_peaks(theory::amplitude_spectrum(values, step));
  if (peaks.empty()) return {std::nullopt, "no sine stands out of the probe's history"};
  return {peaks.front().frequency, {}};
}

/// Times of the samples; a coupon's are numbered.
std::vector<double> times_of(const Response& response) {
  if (response.chain.joints > 0) {
    const auto& time = response.chain.time;
    return {time.begin(), time.begin() + static_cast<std::ptrdiff_t>(response.samples)};
  }
  std::vector<double> time(response.samples);
  std::iota(time.begin(), time.end(), 0.0);
  return time;
}

Measured chain_quantity(const Response& response, const Quantity& quantity) {
  if (quantity.kind == QuantityKind::LimitLoad) {
    if (!response.limit) return {std::nullopt, "there is no limit load"};
    return {response.limit->below, {}};
  }
  const auto broken = first_break(response.chain);
  if (!broken) return {std::nullopt, "nothing breaks"};
  return {quantity.kind == QuantityKind::BreakTime ? broken->time : broken->factor, {}};
}

Measured coupon_quantity(const Response& response, const Quantity& quantity) {
  if (!response.event) return {std::nullopt, "nothing breaks"};
  if (quantity.kind == QuantityKind::BreakLoad) return {response.event->stress, {}};
  return {response.event->strain, {}};
}

Measured quantity_of(const Response& response, const Quantity& quantity) {
  const bool is_chain = response.chain.joints > 0;
  switch (quantity.kind) {
    case QuantityKind::EnergyBalanceError: return {response.energy_balance_error, {}};
    case QuantityKind::BreakLoad:
      return is_chain ? chain_quantity(response, quantity) : coupon_quantity(response, quantity);
    case QuantityKind::LimitLoad:
    case QuantityKind::BreakTime:
      if (!is_chain) return {std::nullopt, "a coupon has none"};
      return chain_quantity(response, quantity);
    case QuantityKind::BreakStrain:
      if (is_chain) return {std::nullopt, "a chain has none; its probes have strains"};
      return coupon_quantity(response, quantity);
    case QuantityKind::BreakPlace:  // is noted with the joint
    case QuantityKind::Probe:
    case QuantityKind::NaturalFrequency:
    case QuantityKind::LoadedFrequency:
    case QuantityKind::BucklingFactor:
    case QuantityKind::Fit: break;
  }
  return {};
}

void measure_probe(const Response& response, const Quantity& quantity, CaseResult& result) {
  const auto& all = response.probes[quantity.probe];
  const std::span<const double> values(all.data(), response.samples);
  if (values.empty()) return;
  result.last_value = values.back();
  if (!is_complete(response.status)) return;
  const std::vector<double> time = times_of(response);
  if (quantity.is_curve()) {
    result.time = time;
    result.curve.assign(values.begin(), values.end());
    return;
  }
  const Measured measured = take_of(quantity.take, time, values);
  result.value = measured.value;
  result.reason = measured.reason;
}

std::string imbalance_of(const Response& response) {
  const bool energy = !(response.energy_balance_error <= kBalanceTolerance);
  const double wrong = energy ? response.energy_balance_error : response.momentum_error;
  return std::string(energy ? "energy" : "momentum") + " off by " +
         report::significant(100.0 * wrong, 3) +
         " %: " + std::string(advice(response.status, true));
}

}  // namespace

Measured take_of(Take take, std::span<const double> time, std::span<const double> values) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  switch (take) {
    case Take::Min: return {*least, {}};
    case Take::Max: return {*largest, {}};
    case Take::Size: return {std::max(-*least, *largest), {}};
    case Take::Mean:
    case Take::Frequency:
      if (!std::ranges::is_sorted(time)) {
        return {std::nullopt, "the load falls along the path: there is nothing over it"};
      }
      if (take == Take::Frequency) return frequency_of(time, values);
      return {time_mean(time, values), {}};
    case Take::End:
    case Take::Curve: break;
  }
  return {values.back(), {}};
}

CaseResult result_of_run(const BatchRow& row, const Quantity& quantity) {
  const Response& response = row.response;
  CaseResult result;
  result.status = response.status;
  result.level = row.level;
  const bool is_chain = response.chain.joints > 0;
  result.segments = is_chain ? static_cast<std::int64_t>(response.chain.joints) - 1 : 1;
  result.iterations =
      is_chain ? response.counters.iterations : static_cast<std::int64_t>(response.samples);
  result.cutbacks = response.counters.cutbacks;
  result.energy_balance_error = response.energy_balance_error;
  result.seconds = response.seconds;
  if (response.samples > 0) {
    result.last_time = is_chain ? response.chain.time[response.samples - 1]
                                : static_cast<double>(response.samples);
  }
  if (is_chain) {
    if (const auto broken = first_break(response.chain)) {
      result.break_joint = broken->joint;
      result.break_place = broken->place;
    }
  }
  if (quantity.kind == QuantityKind::Probe) {
    measure_probe(response, quantity, result);
  } else if (quantity.kind == QuantityKind::BreakPlace) {
    if (is_complete(response.status)) result.value = result.break_place;
    if (!result.value) result.reason = is_chain ? "nothing breaks" : "a coupon has none";
  } else if (is_complete(response.status)) {
    const Measured measured = quantity_of(response, quantity);
    result.value = measured.value;
    result.reason = measured.reason;
  }
  if (response.status == Status::NotBalanced) {
    result.reason = imbalance_of(response);
  } else if (!usable(response.status)) {
    result.reason = advice(response.status, row.in_motion);
  }
  if (response.status == Status::Unstable && response.critical) {
    result.reason = "it bifurcates at factor " +
                    report::significant(response.critical->factor.front(), 5) + ": " +
                    result.reason;
  }
  return result;
}

}  // namespace plastica::sweeps
