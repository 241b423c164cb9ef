#include "sweeps/compare/refined_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plastica/theory/convergence.hpp"
#include "sweeps/compare/error_notes.hpp"
#include "sweeps/compare/extrapolation.hpp"
#include "sweeps/compare/finest_lines.hpp"
#include "sweeps/compare/reference_sets.hpp"
#include "sweeps/compare/unrefined.hpp"
#include "sweeps/plan/refining.hpp"

namespace plastica::sweeps {
namespace {

class RefinedComparison {
 public:
  RefinedComparison(const RefinedSweep& of, Comparer& comparer)
      : of_(of),
        comparer_(comparer),
        results_(comparer.results()),
        sets_(reference_sets(of.sweep, of.cases, results_, of.ids)) {}

  void run() {
    const bool finest = of_.sweep.against.kind == AgainstKind::Finest;
    std::vector<bool> done(sets_.sets.size());
    for (std::size_t s = 0; s < sets_.sets.size(); ++s) {
      done[s] = finest ? with_finest(sets_.sets[s]) : with_extrapolated(sets_.sets[s]);
    }
    for (const RefinementGroup& group : of_.groups) {
      if (done[sets_.set_of[group.cases.front()]]) continue;
      if (finest) {
        group_with_finest(group);
      } else {
        group_with_richardson(group);
      }
    }
    repeat_same_runs();
    add_error_notes(of_.sweep, of_.cases, sets_, comparer_.out());
  }

 private:
  /// @return whether the set has a reference
  bool with_finest(const ReferenceSet& set) {
    if (!set.finest)
      return !std::any_of(set.cases.begin(), set.cases.end(),
                          [&](std::size_t i) { return has_outcome(results_[i]); });
    const std::size_t finest = *set.finest;
    if (refuse_unconverged(set)) return true;
    for (const std::size_t i : set.cases) {
      if (i == finest || refuse_other_end(i, finest)) continue;
      comparer_.with_case(i, finest);
      note_where_coarser(set, i, finest);
    }
    Comparison& out = comparer_.out();
    if (results_[finest].value) out.reference[finest] = results_[finest].value;
    out.reason[finest] = kIsReference;
    const auto off = error_of_finest(of_.sweep, sets_, set, results_, out);
    for (const std::size_t i : set.cases) out.reference_error[i] = off;
    note_held(set);
    return true;
  }

  bool with_extrapolated(const ReferenceSet& set) {
    if (set.finest && refuse_unconverged(set)) return true;
    const Extrapolated found = extrapolate(of_.sweep, sets_, set, results_);
    if (!found.possible) return false;
    Comparison& out = comparer_.out();
    for (const std::size_t i : set.cases) {
      if (!found.value) {
        if (results_[i].value) out.reason[i] = found.reason;
        continue;
      }
      if (set.finest && refuse_other_end(i, *set.finest)) continue;
      comparer_.with_number(i, *found.value);
      if (set.finest) note_where_coarser(set, i, *set.finest);
      const double scale = of_.sweep.error_scale.value_or(std::abs(*found.value));
      if (found.uncertainty && scale > 0.0) out.reference_error[i] = *found.uncertainty / scale;
    }
    note_held(set);
    return true;
  }

  /// Where what happens changes among the finest cases, or what matters is as coarse in them, no
  /// case has an error.
  bool refuse_unconverged(const ReferenceSet& set) {
    std::string change = change_of_outcome(of_.sweep, sets_, set, results_);
    if (change.empty()) change = what_stays_coarse(of_.sweep, of_.cases, sets_, set, results_);
    if (change.empty()) return false;
    for (const std::size_t i : set.cases) {
      if (has_outcome(results_[i])) {
        comparer_.out().reason[i] = std::string(kNotConverged) + change;
      }
    }
    return true;
  }

  /// A case that ends otherwise is not a little off: it has no error, however close its value is.
  bool refuse_other_end(std::size_t i, std::size_t finest) {
    if (!has_outcome(results_[i]) || end_alike(results_[i], results_[finest])) return false;
    comparer_.out().reason[i] =
        std::string(kEndsOtherwise) + other_end(results_[i], results_[finest]);
    return true;
  }

  void note_where_coarser(const ReferenceSet& set, std::size_t i, std::size_t finest) {
    std::string& text = comparer_.out().coarser_in[i];
    const auto add = [&](std::size_t axis) {
      if (!text.empty()) text += ", ";
      text += of_.sweep.axes[axis].field->path;
    };
    for (const std::size_t a : set.numbers) {
      if (moves_with(of_.sweep, a, *of_.sweep.refined)) continue;
      if (!same_size(sets_.size_at(i, a), sets_.size_at(finest, a))) add(a);
    }
    for (const std::size_t a : set.words) {
      if (!words_converge(*of_.sweep.axes[a].field) && !sets_.finest_word_at(i, a)) add(a);
    }
  }

  void note_held(const ReferenceSet& set) {
    const std::string lacks = paths_of(of_.sweep, set.held);
    for (const std::size_t i : set.cases) comparer_.out().lacks[i] = lacks;
  }

  /// What a group of the refined axis alone lacks.
  void note_alone(const RefinementGroup& group) {
    const ReferenceSet& set = sets_.sets[sets_.set_of[group.cases.front()]];
    std::vector<std::size_t> others = set.held;
    for (const auto& axes : {set.numbers, set.words}) {
      for (const std::size_t a : axes) {
        if (a != *of_.sweep.refined) others.push_back(a);
      }
    }
    const std::string lacks = paths_of(of_.sweep, others);
    for (const std::size_t i : group.cases) comparer_.out().lacks[i] = lacks;
  }

  void group_with_finest(const RefinementGroup& group) {
    const auto finest = std::find_if(group.cases.rbegin(), group.cases.rend(),
                                     [&](std::size_t i) { return has_outcome(results_[i]); });
    if (finest == group.cases.rend()) return;
    for (const std::size_t i : group.cases) {
      if (i == *finest) break;
      comparer_.with_case(i, *finest);
    }
    Comparison& out = comparer_.out();
    if (results_[*finest].value) out.reference[*finest] = results_[*finest].value;
    out.reason[*finest] = kIsReference;
    note_alone(group);
  }

  void group_with_richardson(const RefinementGroup& group) {
    std::vector<double> sizes;
    std::vector<double> values;
    for (const std::size_t k : group.distinct()) {
      const CaseResult& result = results_[group.cases[k]];
      if (!result.value || !has_outcome(result)) continue;
      sizes.push_back(group.size[k]);
      values.push_back(*result.value);
    }
    const auto reference = extrapolated_along(sizes, values);
    for (const std::size_t i : group.cases) {
      if (reference) {
        comparer_.with_number(i, *reference);
      } else if (results_[i].value) {
        comparer_.out().reason[i] = kNothingExtrapolated;
      }
    }
    note_alone(group);
  }

  /// Cases of one run have one error.
  void repeat_same_runs() {
    Comparison& out = comparer_.out();
    for (std::size_t i = 0; i < sets_.same_as.size(); ++i) {
      const std::size_t first = sets_.same_as[i];
      if (first == i) continue;
      out.reference[i] = out.reference[first];
      out.error[i] = out.error[first];
      out.reference_curve[i] = out.reference_curve[first];
      out.reason[i] = out.reason[first] == kIsReference ? kIsRunOfReference : out.reason[first];
      out.lacks[i] = out.lacks[first];
      out.coarser_in[i] = out.coarser_in[first];
      out.reference_error[i] = out.reference_error[first];
    }
  }

  const RefinedSweep& of_;
  Comparer& comparer_;
  const std::vector<CaseResult>& results_;
  ReferenceSets sets_;
};

}  // namespace

void compare_refined(const RefinedSweep& of, Comparer& comparer) {
  RefinedComparison(of, comparer).run();
}

}  // namespace plastica::sweeps
