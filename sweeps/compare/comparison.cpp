#include "sweeps/compare/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/theory/convergence.hpp"
#include "sweeps/compare/closed_forms.hpp"

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

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

class Comparer {
 public:
  Comparer(const Sweep& sweep, const CaseTable& cases, const std::vector<CaseResult>& results)
      : sweep_(sweep), cases_(cases), results_(results) {
    out_.reference.resize(results.size());
    out_.reference_curve.resize(results.size());
    out_.error.resize(results.size());
    out_.reason.resize(results.size());
  }

  void with_number(std::size_t i, double reference) {
    out_.reference[i] = reference;
    const double scale = sweep_.error_scale.value_or(std::abs(reference));
    if (!results_[i].value) return;
    if (!(scale > 0.0)) {
      out_.reason[i] = "the reference is 0: give error.scale";
      return;
    }
    out_.error[i] = (*results_[i].value - reference) / scale;
  }

  /// @param time, curve  that reach over the case's own times
  void with_curve(std::size_t i, const std::vector<double>& time,
                  const std::vector<double>& curve) {
    const CaseResult& result = results_[i];
    if (result.curve.empty()) return;
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

  void with_theory(std::size_t i, const ClosedForm& form) {
    const CaseResult& result = results_[i];
    if (!result.value && result.curve.empty()) return;
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

  void with_finest(const RefinementGroup& group) {
    std::size_t finest = group.cases.size();
    for (std::size_t k = group.cases.size(); k-- > 0 && finest == group.cases.size();) {
      const CaseResult& result = results_[group.cases[k]];
      if (result.value || !result.curve.empty()) finest = k;
    }
    if (finest == group.cases.size()) return;
    const CaseResult& reference = results_[group.cases[finest]];
    for (std::size_t k = 0; k < finest; ++k) {
      const std::size_t i = group.cases[k];
      if (reference.value) {
        with_number(i, *reference.value);
      } else {
        with_curve(i, reference.time, reference.curve);
      }
    }
    if (reference.value) out_.reference[group.cases[finest]] = reference.value;
    out_.reason[group.cases[finest]] = "is the finest, the reference of its group";
  }

  void with_richardson(const RefinementGroup& group) {
    std::vector<double> sizes;
    std::vector<double> values;
    for (const std::size_t k : group.distinct()) {
      const CaseResult& result = results_[group.cases[k]];
      if (!result.value) continue;
      sizes.push_back(group.size[k]);
      values.push_back(*result.value);
    }
    std::optional<double> reference;
    if (sizes.size() >= 3) {
      const auto grid = theory::grid_convergence(sizes, values);
      reference =
          grid.kind == theory::ConvergenceKind::Unchanged ? values.back() : grid.extrapolated;
    }
    for (const std::size_t i : group.cases) {
      if (reference) {
        with_number(i, *reference);
      } else if (results_[i].value) {
        out_.reason[i] = "nothing can be extrapolated: it takes three values that converge";
      }
    }
  }

  Comparison take() { return std::move(out_); }

 private:
  const Sweep& sweep_;
  const CaseTable& cases_;
  const std::vector<CaseResult>& results_;
  Comparison out_;
};

/// A stored reference: its whole curve, or what the sweep takes of it.
void with_file(const Sweep& sweep, std::size_t cases, Comparer& comparer) {
  const Against& against = sweep.against;
  const Measured measured = sweep.quantity.is_curve()
                                ? Measured{}
                                : take_of(sweep.quantity.take, against.time, against.curve);
  for (std::size_t i = 0; i < cases; ++i) {
    if (sweep.quantity.is_curve()) {
      comparer.with_curve(i, against.time, against.curve);
    } else if (measured.value) {
      comparer.with_number(i, *measured.value);
    }
  }
}

}  // namespace

Comparison compare(const Sweep& sweep, const CaseTable& cases,
                   const std::vector<RefinementGroup>& groups,
                   const std::vector<CaseResult>& results) {
  Comparer comparer(sweep, cases, results);
  switch (sweep.against.kind) {
    case AgainstKind::Nothing: break;
    case AgainstKind::Theory: {
      const ClosedForm& form = find_closed_form(sweep.against.name);
      for (std::size_t i = 0; i < results.size(); ++i) comparer.with_theory(i, form);
      break;
    }
    case AgainstKind::File: with_file(sweep, results.size(), comparer); break;
    case AgainstKind::Value:
      for (std::size_t i = 0; i < results.size(); ++i) {
        comparer.with_number(i, sweep.against.value);
      }
      break;
    case AgainstKind::Finest:
      for (const RefinementGroup& group : groups) comparer.with_finest(group);
      break;
    case AgainstKind::Richardson:
      for (const RefinementGroup& group : groups) comparer.with_richardson(group);
      break;
  }
  return comparer.take();
}

void check_reference(const Sweep& sweep, const CaseTable& cases) {
  if (sweep.against.kind != AgainstKind::Theory) return;
  const SourceLocation where{sweep.path, 0};
  const ClosedForm& form = find_closed_form(sweep.against.name, where);
  const std::vector<double> start{0.0};
  try {
    (void)form.values(cases.setup(0), sweep.quantity, start);
  } catch (const InputError& error) {
    throw InputError(where, "error.against", "theory:" + sweep.against.name,
                     error.field().empty() ? error.rule() : error.field() + " " + error.rule());
  }
}

}  // namespace plastica::sweeps
