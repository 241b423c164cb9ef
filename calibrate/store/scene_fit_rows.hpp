#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/result/describe.hpp"
#include "calibrate/scene/scene_fit_record.hpp"

/// What of a fit through scenes stands where in a result file; not installed. Documented in
/// data/README.md.
namespace plastica::calibrate::store {

/// Rows of the tables that have several, or none, for a fit; `fit` says whose a row is.
struct ScenePartRow {
  std::uint64_t fit = 0;
  SceneTarget target;
  double weight = 1.0;
  std::optional<ScenePartFit> made;  ///< empty: the fit has no parts
  bool has_curve = false;            ///< whether the fitted ordinates are there
};
struct SceneParameterRow {
  std::uint64_t fit = 0;
  FittedParameter parameter;
};
struct SceneSegmentsRow {
  std::uint64_t fit = 0;
  SegmentsError error;
};
struct SceneStartRow {
  std::uint64_t fit = 0;
  SceneStart start;
};
struct SceneWarningRow {
  std::uint64_t fit = 0;
  std::string text;
};

/// The rows of all fits, in the order of the fits.
struct SceneRows {
  std::vector<ScenePartRow> parts;
  std::vector<SceneParameterRow> parameters;
  std::vector<SceneSegmentsRow> segments;
  std::vector<SceneStartRow> starts;
  std::vector<SceneWarningRow> warnings;
};

constexpr auto kSceneFitColumns = [](auto& columns) {
  columns("name", "", PLASTICA_MEMBER(name));
  columns("law", "", PLASTICA_MEMBER(result.law));
  columns("status", "", PLASTICA_MEMBER(result.status));
  columns("reason", "", PLASTICA_MEMBER(result.reason));
  columns("degrees_of_freedom", "1", PLASTICA_MEMBER(result.degrees_of_freedom));
  columns("outcome", "", PLASTICA_MEMBER(result.outcome));
  columns("runs", "1", PLASTICA_MEMBER(result.runs));
  columns("search_runs", "1", PLASTICA_MEMBER(result.search_runs));
  columns("failed_runs", "1", PLASTICA_MEMBER(result.failed_runs));
  columns("segment_iterations", "1", PLASTICA_MEMBER(result.segment_iterations));
  columns.part("divided", PLASTICA_MEMBER(result.segments), [](auto& part) {
    part("segments", "1", PLASTICA_MEMBER(segments));
    part("segments_note", "", PLASTICA_MEMBER(note));
  });
};

/// Whose row of `kDescribeParameter` it is.
constexpr auto kSceneParameterColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("path", "", PLASTICA_MEMBER(parameter.path));
  columns("dimension", "", PLASTICA_MEMBER(parameter.dimension));
};

constexpr auto kScenePartColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("name", "", PLASTICA_MEMBER(target.name));
  columns("kind", "", PLASTICA_MEMBER(target.kind));
  columns("driven", "", PLASTICA_MEMBER(target.driven));
  columns("abscissa_probe", "", PLASTICA_MEMBER(target.abscissa_probe));
  columns("ordinate_probe", "", PLASTICA_MEMBER(target.ordinate_probe));
  columns("abscissa_dimension", "", PLASTICA_MEMBER(target.abscissa_is));
  columns("ordinate_dimension", "", PLASTICA_MEMBER(target.ordinate_is));
  columns("abscissa_factor", "1", PLASTICA_MEMBER(target.abscissa_factor));
  columns("ordinate_factor", "1", PLASTICA_MEMBER(target.ordinate_factor));
  columns("given_noise", "", PLASTICA_MEMBER(target.noise));
  columns.part("broke", PLASTICA_MEMBER(target.broke), [](auto& part) {
    part("break_at", "", PLASTICA_MEMBER(at));
    part("break_half_interval", "", PLASTICA_MEMBER(half_interval));
  });
  columns("weight", "1", PLASTICA_MEMBER(weight));
  columns("has_curve", "", PLASTICA_MEMBER(has_curve));
  columns.part("present", PLASTICA_MEMBER(made), [](auto& part) {
    part("level", "", PLASTICA_MEMBER(level));
    part("samples", "1", PLASTICA_MEMBER(samples));
    part("cost", "", PLASTICA_MEMBER(cost));
    part("noise", "", PLASTICA_MEMBER(noise));
    part("degrees_of_freedom", "1", PLASTICA_MEMBER(degrees_of_freedom));
    part("misfit_share", "1", PLASTICA_MEMBER(misfit_share));
    part("runs_probability", "1", PLASTICA_MEMBER(runs_probability));
    part("break_strain", "1", PLASTICA_MEMBER(break_strain));
  });
};

constexpr auto kSceneSegmentsColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("at_half", "", PLASTICA_MEMBER(error.at_half));
  columns("at_own", "", PLASTICA_MEMBER(error.at_own));
  columns("at_twice", "", PLASTICA_MEMBER(error.at_twice));
  columns("trend", "", PLASTICA_MEMBER(error.trend));
  columns("observed_order", "1", PLASTICA_MEMBER(error.observed_order));
  columns("order", "1", PLASTICA_MEMBER(error.order));
  columns("safety_factor", "1", PLASTICA_MEMBER(error.safety_factor));
  columns("extrapolated", "", PLASTICA_MEMBER(error.extrapolated));
  columns("extrapolated_error", "", PLASTICA_MEMBER(error.extrapolated_error));
  columns("error", "", PLASTICA_MEMBER(error.error));
};

constexpr auto kSceneStartColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("cost", "1", PLASTICA_MEMBER(start.cost));
  columns("outcome", "", PLASTICA_MEMBER(start.outcome));
  columns("evaluations", "1", PLASTICA_MEMBER(start.evaluations));
};

constexpr auto kSceneWarningColumns = [](auto& columns) {
  columns("fit", "", PLASTICA_MEMBER(fit));
  columns("text", "", PLASTICA_MEMBER(text));
};

}  // namespace plastica::calibrate::store
