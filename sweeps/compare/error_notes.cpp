#include "sweeps/compare/error_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sweeps/plan/refining.hpp"

namespace plastica::sweeps {
namespace {

bool is_refined_by_any(const Sweep& sweep, std::initializer_list<std::string_view> paths) {
  return std::any_of(sweep.axes.begin(), sweep.axes.end(), [&](const Axis& axis) {
    return axis.values.size() > 1 &&
           std::find(paths.begin(), paths.end(), axis.field->path) != paths.end();
  });
}

/// Whether an axis has a word among its values.
bool takes(const Sweep& sweep, std::string_view word) {
  return std::any_of(sweep.axes.begin(), sweep.axes.end(), [&](const Axis& axis) {
    return std::find(axis.values.begin(), axis.values.end(), FieldValue(std::string(word))) !=
           axis.values.end();
  });
}

/// Fields that matter to the scene and that no axis refines.
std::vector<std::string_view> not_refined(const Sweep& sweep, const Setup& setup) {
  std::vector<std::string_view> fields;
  const Scene& scene = setup.scene;
  const QuantityKind kind = sweep.quantity.kind;
  if (!scene.is_coupon() && !is_refined_by_any(sweep, {"beam.segments", "beam.segment_depth"})) {
    fields.emplace_back("beam.segments");
  }
  const bool in_motion = setup.solver.analysis == Analysis::Dynamics && !scene.is_coupon() &&
                         kind != QuantityKind::NaturalFrequency;
  // Where steps follow an error, the largest of them refines nothing.
  const bool adaptive = setup.solver.step_error > 0.0;
  const std::string_view step = adaptive ? "solver.step_error" : "solver.time_step";
  if (in_motion && !is_refined_by_any(sweep, {step, "solver.step_error"})) {
    fields.push_back(step);
  }
  const bool fibres = scene.yield_model == YieldModel::Fibre || takes(sweep, "fibre");
  if (!scene.is_coupon() && fibres && kind != QuantityKind::NaturalFrequency &&
      !is_refined_by_any(sweep, {"solver.fibres"})) {
    fields.emplace_back("solver.fibres");
  }
  return fields;
}

/// Axes of words, none of which is known to be the finest, and of values that are kept apart.
std::vector<std::size_t> split_axes(const Sweep& sweep) {
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const Axis& axis = sweep.axes[a];
    if (axis.values.size() < 2) continue;
    const auto finest = std::count_if(axis.values.begin(), axis.values.end(), [&](const auto& v) {
      return is_finest_word(*axis.field, v);
    });
    const AxisRole role = role_of(*axis.field);
    const bool splits =
        axis.apart || role == AxisRole::Method || (role == AxisRole::Word && finest != 1);
    if (splits) axes.push_back(a);
  }
  return axes;
}

}  // namespace

std::string error_alone(std::string_view refined, const std::string& lacks) {
  return fmt::format("error of {} alone; that of {} is not in it", refined, lacks);
}

std::string paths_of(const Sweep& sweep, const std::vector<std::size_t>& axes) {
  std::string all;
  for (const std::size_t a : axes) {
    all += (all.empty() ? "" : ", ") + std::string(sweep.axes[a].field->path);
  }
  return all;
}

void add_error_notes(const Sweep& sweep, const CaseTable& cases, const ReferenceSets& sets,
                     Comparison& comparison) {
  std::set<std::string> refined;
  for (const ReferenceSet& set : sets.sets) {
    std::vector<std::size_t> axes = set.numbers;
    axes.insert(axes.end(), set.words.begin(), set.words.end());
    if (set.finest && axes.size() > 1) refined.insert(paths_of(sweep, axes));
  }
  const bool finest = sweep.against.kind == AgainstKind::Finest;
  for (const std::string& axes : refined) {
    comparison.notes.push_back(finest ? "the reference is the finest in all of " + axes
                                      : "extrapolated in all of " + axes);
  }
  const std::string split = paths_of(sweep, split_axes(sweep));
  if (!split.empty()) {
    comparison.notes.push_back(
        fmt::format("values of {} are compared each with a reference of its own", split));
  }
  std::set<std::string> lacking;
  for (const std::string& lacks : comparison.lacks) {
    if (!lacks.empty()) lacking.insert(lacks);
  }
  for (const std::string& lacks : lacking) {
    comparison.notes.push_back(error_alone(sweep.axes[*sweep.refined].field->path, lacks) +
                               ": no case is finer than the others in all");
  }
  double off = 0.0;
  for (const auto& error : comparison.reference_error) off = std::max(off, error.value_or(0.0));
  if (off > 0.0) {
    comparison.notes.push_back(
        fmt::format("the reference itself is off by about {:.2g} %, an estimate", 100.0 * off));
  }
  const Setup setup = cases.setup(0);
  for (const std::string_view path : not_refined(sweep, setup)) {
    const Field& field = *find_field_or_null(path);
    comparison.notes.push_back(fmt::format("the error of {} is not in it: it is not refined ({})",
                                           path, value_text(field, field.get(setup))));
  }
}

}  // namespace plastica::sweeps
