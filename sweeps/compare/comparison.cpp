#include "sweeps/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "sweeps/compare/closed_forms.hpp"
#include "sweeps/compare/comparer.hpp"
#include "sweeps/compare/refined_reference.hpp"

namespace plastica::sweeps {
namespace {

/// Says where cases shear, and what they are compared with does not.
void note_shear(const CaseTable& cases, const ClosedForm& form, Comparison& comparison) {
  if (!form.in_bending) return;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases.setup(i).solver.translation != JointTranslation::Elastic) continue;
    comparison.notes.emplace_back(
        "the closed form does not shear: the error of cases with solver.translation = \"elastic\" "
        "is the shear's, too");
    return;
  }
}

/// f[t_j-1, t_j, t_j+1], half of the second derivative. @param j  an inner row
double second_difference(const std::vector<double>& time, const std::vector<double>& curve,
                         std::size_t j) {
  const double before = (curve[j] - curve[j - 1]) / (time[j] - time[j - 1]);
  const double after = (curve[j + 1] - curve[j]) / (time[j + 1] - time[j]);
  return (after - before) / (time[j + 1] - time[j - 1]);
}

/// What straight lines between the rows of a curve leave out at other times, rms over the rms of
/// the curve: the remainder of Newton's formula, f[t_j, t_j+1, x] (x - t_j) (x - t_j+1), with the
/// second difference of the rows about x. An estimate.
/// @param rows  times of the curve, rising (n >= 3)
/// @param at    other times
double left_out_between(const std::vector<double>& rows, const std::vector<double>& curve,
                        const std::vector<double>& at) {
  double left_out = 0.0;
  double size = 0.0;
  for (const double x : at) {
    const auto above = std::ranges::upper_bound(rows, x);
    const auto k = std::clamp<std::ptrdiff_t>(above - rows.begin(), 1,
                                              static_cast<std::ptrdiff_t>(rows.size()) - 1);
    const auto j = static_cast<std::size_t>(k);  // x lies between rows j - 1 and j
    double bend = 0.0;                           // the mean of those at both rows
    double inner_rows = 0.0;
    for (const std::size_t inner : {j - 1, j}) {
      if (inner < 1 || inner + 1 >= rows.size()) continue;
      bend += second_difference(rows, curve, inner);
      inner_rows += 1.0;
    }
    const double here = bend / inner_rows * (x - rows[j - 1]) * (rows[j] - x);
    const double share = (x - rows[j - 1]) / (rows[j] - rows[j - 1]);
    const double value = curve[j - 1] + share * (curve[j] - curve[j - 1]);
    left_out += here * here;
    size += value * value;
  }
  return size > 0.0 ? std::sqrt(left_out / size) : 0.0;
}

/// Says where the rows of a reference are too few for its curve.
void note_rows(const Against& against, Comparer& comparer) {
  constexpr double kLeast = 1e-3;
  const bool rises =
      std::ranges::adjacent_find(against.time, std::greater_equal<>()) == against.time.end();
  if (against.time.size() < 3 || !rises) return;
  double most = 0.0;
  for (const CaseResult& result : comparer.results()) {
    most = std::max(most, left_out_between(against.time, against.curve, result.time));
  }
  if (most < kLeast) return;
  comparer.out().notes.push_back(
      fmt::format("the reference is drawn straight between its {} rows, which leaves out about "
                  "{:.2g} % of it, an estimate: that is in the errors",
                  against.time.size(), 100.0 * most));
}

/// A stored reference: its whole curve, or what the sweep takes of it.
void with_file(const Sweep& sweep, std::size_t cases, Comparer& comparer) {
  const Against& against = sweep.against;
  for (std::size_t i = 0; i < cases; ++i) {
    if (sweep.quantity.is_curve()) {
      comparer.with_curve(i, against.time, against.curve);
    } else {
      comparer.with_number_of(i, against.time, against.curve);
    }
  }
  if (sweep.quantity.is_curve()) note_rows(against, comparer);
}

}  // namespace

Comparison compare(const Sweep& sweep, const CaseTable& cases,
                   const std::vector<RefinementGroup>& groups,
                   const std::vector<CaseResult>& results, std::span<const std::string> ids) {
  Comparer comparer(sweep, cases, results);
  switch (sweep.against.kind) {
    case AgainstKind::Nothing: break;
    case AgainstKind::Theory: {
      const ClosedForm& form = find_closed_form(sweep.against.name);
      for (std::size_t i = 0; i < results.size(); ++i) comparer.with_theory(i, form);
      note_shear(cases, form, comparer.out());
      break;
    }
    case AgainstKind::File: with_file(sweep, results.size(), comparer); break;
    case AgainstKind::Value:
      for (std::size_t i = 0; i < results.size(); ++i) {
        comparer.with_number(i, sweep.against.value);
      }
      break;
    case AgainstKind::Finest:
    case AgainstKind::Richardson: compare_refined({sweep, cases, groups, ids}, comparer); break;
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
