#include "sweeps/compare/comparer.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace plastica::sweeps {
namespace {

/// A curve at a time, straight between its samples. @param x  within the curve's times
double at(const std::vector<double>& time, const std::vector<double>& curve, double x) {
  const auto above = std::lower_bound(time.begin(), time.end(), x);
  const auto k = static_cast<std::size_t>(above - time.begin());
  if (k == 0) return curve.front();
  if (k == time.size()) return curve.back();
  const double span = time[k] - time[k - 1];
  const double fraction = span > 0.0 ? (x - time[k - 1]) / span : 1.0;
  return curve[k - 1] + fraction * (curve[k] - curve[k - 1]);
}

/// Why a curve is not to be compared over its time; empty: it rises. A path that arcs lead comes
/// back to loads that it had.
std::string why_not_over(const std::vector<double>& time) {
  if (std::ranges::is_sorted(time)) return {};
  return "the load falls along the path, so that it has several values at one load";
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

Comparer::Comparer(const Sweep& sweep, const CaseTable& cases,
                   const std::vector<CaseResult>& results)
    : sweep_(sweep), cases_(cases), results_(results) {
  out_.reference.resize(results.size());
  out_.reference_curve.resize(results.size());
  out_.error.resize(results.size());
  out_.reason.resize(results.size());
  out_.lacks.resize(results.size());
  out_.coarser_in.resize(results.size());
  out_.reference_error.resize(results.size());
}

void Comparer::with_number(std::size_t i, double reference) {
  out_.reference[i] = reference;
  const double scale = sweep_.error_scale.value_or(std::abs(reference));
  if (!results_[i].value) return;
  // What a closed form leaves of 0 is rounding.
  constexpr double kRounding = 1e-12;
  if (!(scale > kRounding * std::abs(*results_[i].value))) {
    out_.reason[i] = "the reference is 0: give error.scale";
    return;
  }
  out_.error[i] = (*results_[i].value - reference) / scale;
}

void Comparer::with_curve(std::size_t i, const std::vector<double>& time,
                          const std::vector<double>& curve) {
  const CaseResult& result = results_[i];
  if (result.curve.empty()) return;
  for (const auto* times : {&time, &result.time}) {
    out_.reason[i] = why_not_over(*times);
    if (!out_.reason[i].empty()) return;
  }
  // A last time may differ by its rounding.
  const double room = 1e-9 * std::abs(result.time.back());
  if (time.front() > result.time.front() + room || time.back() < result.time.back() - room) {
    out_.reason[i] = "the reference does not reach over the case's times";
    return;
  }
  std::vector<double> off(result.time.size());
  std::vector<double> reference(result.time.size());
  for (std::size_t k = 0; k < off.size(); ++k) {
    reference[k] = at(time, curve, result.time[k]);
    off[k] = result.curve[k] - reference[k];
  }
  const double scale = sweep_.error_scale.value_or(rms(reference));
  if (scale > 0.0) {
    out_.error[i] = rms(off) / scale;
  } else {
    out_.reason[i] = "the reference is 0: give error.scale";
  }
  out_.reference_curve[i] = std::move(reference);
}

void Comparer::with_number_of(std::size_t i, const std::vector<double>& time,
                              const std::vector<double>& curve) {
  const CaseResult& result = results_[i];
  if (!result.value) return;
  Measured measured = take_of(sweep_.quantity.take, time, curve);
  if (result.level != Level::Coupon) {
    out_.reason[i] = why_not_over(time);
    if (!out_.reason[i].empty()) return;
    // Up to the case's last state, no further.
    const double end = result.last_time;
    const double room = 1e-9 * std::abs(end);
    const bool from_start = sweep_.quantity.take != Take::End;
    if ((from_start && time.front() > room) || time.back() < end - room ||
        time.front() > end + room) {
      out_.reason[i] = "the reference does not reach over the case's times";
      return;
    }
    const auto beyond = std::upper_bound(time.begin(), time.end(), end + room);
    const auto count = static_cast<std::size_t>(beyond - time.begin());
    std::vector<double> until(time.begin(), beyond);
    std::vector<double> values(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(count));
    if (until.back() < end - room && sweep_.quantity.take != Take::Frequency) {
      until.push_back(end);
      values.push_back(at(time, curve, end));
    }
    measured = take_of(sweep_.quantity.take, until, values);
  }
  if (measured.value) {
    with_number(i, *measured.value);
  } else {
    out_.reason[i] = measured.reason;
  }
}

void Comparer::with_case(std::size_t i, std::size_t reference) {
  const CaseResult& of = results_[reference];
  if (of.value) {
    with_number(i, *of.value);
  } else {
    with_curve(i, of.time, of.curve);
  }
}

void Comparer::with_theory(std::size_t i, const ClosedForm& form) {
  const CaseResult& result = results_[i];
  if (!result.value && result.curve.empty()) return;
  if (form.at_end && result.status != Status::Completed && result.status != Status::Unstable) {
    out_.reason[i] = "its run ended early, and the closed form is of the end";
    return;
  }
  try {
    const auto values = form.values(cases_.setup(i), sweep_.quantity, result.time);
    if (sweep_.quantity.is_curve()) {
      with_curve(i, result.time, values);
    } else {
      with_number(i, values.front());
    }
  } catch (const InputError& error) {
    out_.reason[i] = error.what();
  }
}

}  // namespace plastica::sweeps
