#include "sweeps/compare/comparison.hpp"

#include <algorithm>
#include <cmath>

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
