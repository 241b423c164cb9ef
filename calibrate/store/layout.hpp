#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

/// What of a fit stands where in a result file, and in a journal; not installed. Documented in
/// docs/hdf5.md. Parameters and bootstraps have tables of their own (parameter_tables.hpp,
/// interval_store.hpp).
///
/// @tparam Rows  WrittenRows, ReadRows (tables.hpp) or CodedRows (coded_rows.hpp)
namespace plastica::calibrate::store {

/// Of every fit.
/// @param held_out  since which version of its files
template <typename Rows>
void traverse_outcome(Rows& fits, int held_out) {
  fits.columns("fits", kDescribeOutcome);
  fits.numbers("correlation", "1", PLASTICA_MEMBER(correlation));
  fits.since(held_out,
             [](auto& later) { later.numbers("held_out", "1", PLASTICA_MEMBER(held_out)); });
  auto profiles = fits.list("profiles", PLASTICA_MEMBER(intervals.profiles), [](auto& columns) {
    columns("low", "", PLASTICA_MEMBER(low));
    columns("high", "", PLASTICA_MEMBER(high));
    columns("low_end", "", PLASTICA_MEMBER(low_end));
    columns("high_end", "", PLASTICA_MEMBER(high_end));
    columns("threshold", "1", PLASTICA_MEMBER(threshold));
  });
  profiles.numbers("profiles/value", "", PLASTICA_MEMBER(value));
  profiles.numbers("profiles/rise", "", PLASTICA_MEMBER(rise));
  profiles.numbers("profiles/searched", "", PLASTICA_MEMBER(searched));
}

inline constexpr auto kCurveColumns = [](auto& columns) {
  columns("strain", "1", PLASTICA_MEMBER(strain));
  columns("stress", "Pa", PLASTICA_MEMBER(stress));
};

inline constexpr auto kPairColumns = [](auto& columns) {
  columns("key", "", PLASTICA_MEMBER(first));
  columns("value", "", PLASTICA_MEMBER(second));
};

/// Of a FitResult.
template <typename Rows>
void traverse_fit(Rows& fits) {
  traverse_outcome(fits, 7);
  fits.columns("fits", kDescribeFit);
  fits.columns("fits", [](auto& d) {  // for other readers
    d.derived("free_parameters", "1", [](const auto& fit) { return fit.trace.active.size(); });
  });
  fits.numbers("free", "", PLASTICA_MEMBER(trace.active));
  fits.part(PLASTICA_MEMBER(fitted)).samples("curves/fitted", kCurveColumns);
  fits.samples("evaluations", [](auto& columns) {
    columns("cost", "Pa^2", PLASTICA_MEMBER(trace.costs));
    columns.table("values", PLASTICA_MEMBER(trace.values),
                  [](const auto& fit) { return fit.trace.active.size(); });
  });
  fits.list("stages", PLASTICA_MEMBER(stages), kDescribeStage);
  fits.list("warnings/fit", PLASTICA_MEMBER(warnings), kDescribeText);
}

/// Of a Target.
template <typename Rows>
void traverse_target(Rows& targets) {
  targets.columns("fits", [](auto& d) { d("name", "", PLASTICA_MEMBER(name), "of the target"); });
  targets.columns("fits", kDescribeSpecimen);
  targets.part(PLASTICA_MEMBER(characteristics))
      .columns("characteristics", kDescribeCharacteristics);
  targets.part(PLASTICA_MEMBER(raw)).samples("curves/raw", kCurveColumns);
  targets.part(PLASTICA_MEMBER(corrected)).samples("curves/corrected", kCurveColumns);
  targets.list("groups", PLASTICA_MEMBER(group), kPairColumns);
  targets.list("properties", PLASTICA_MEMBER(properties), kPairColumns);
  targets.list("repairs", PLASTICA_MEMBER(repairs), kDescribeRepair);
  targets.list("corrections", PLASTICA_MEMBER(corrections), kDescribeCorrection);
  targets.list("warnings/target", PLASTICA_MEMBER(warnings), kDescribeText);
}

/// Of a SceneFitResult, but for its targets.
template <typename Rows>
void traverse_scene_fit(Rows& fits) {
  traverse_outcome(fits, 8);
  fits.columns("fits", kDescribeSceneFit);
  fits.maybe(PLASTICA_MEMBER(segments))
      .list("segments", PLASTICA_MEMBER(parameters), kDescribeSegments);
  auto starts = fits.list("starts", PLASTICA_MEMBER(starts), kDescribeStart);
  starts.numbers("starts/from", "", PLASTICA_MEMBER(from));
  starts.numbers("starts/to", "", PLASTICA_MEMBER(to));
  fits.list("warnings", PLASTICA_MEMBER(warnings), kDescribeText);
}

/// A target of a fit through scenes, and what the fit made of it.
struct StoredTarget {
  SceneTarget target;
  double weight = 1.0;
  bool has_curve = false;         ///< whether the fitted ordinates are there
  std::optional<TargetFit> made;  ///< empty: nothing
};

/// A SceneFitRecord, its targets in one list.
struct StoredSceneFit {
  std::string name;
  std::vector<StoredTarget> targets;
  SceneFitResult result;
  double seconds = 0.0;
};

/// Of a FitRecord.
template <typename Rows>
void traverse_records(Rows& records) {
  auto targets = records.part(PLASTICA_MEMBER(target));
  traverse_target(targets);
  auto fits = records.part(PLASTICA_MEMBER(result));
  traverse_fit(fits);
}

/// Of a StoredSceneFit.
template <typename Rows>
void traverse_scene_records(Rows& records) {
  records.columns("fits", [](auto& d) { d("name", "", PLASTICA_MEMBER(name), "of the fit"); });
  auto fits = records.part(PLASTICA_MEMBER(result));
  traverse_scene_fit(fits);
  auto targets = records.list("targets", PLASTICA_MEMBER(targets), [](auto& d) {
    d("weight", "1", PLASTICA_MEMBER(weight));
    d("has_curve", "", PLASTICA_MEMBER(has_curve));
    d.optional("present", PLASTICA_MEMBER(made), kDescribeTargetFit);
    d.derived("abscissa_units", "",
              [](const auto& row) { return std::string(si_unit(row.target.abscissa_is)); });
    d.derived("ordinate_units", "",
              [](const auto& row) { return std::string(si_unit(row.target.ordinate_is)); });
  });
  targets.part(PLASTICA_MEMBER(target)).columns("targets", kDescribeSceneTarget);
  targets.samples("curves", [](auto& columns) {
    columns("abscissa", "", PLASTICA_MEMBER(target.abscissa));
    columns("ordinate", "", PLASTICA_MEMBER(target.ordinate));
    columns.maybe("fitted", "", [](auto& row) {
      return row.made && row.has_curve ? &row.made->fitted : nullptr;
    });
    columns.maybe("fitted_error", "", [](auto& row) {
      return row.made && row.has_curve ? &row.made->fitted_error : nullptr;
    });
  });
  targets.since(6, [](auto& later) {
    later.list("repairs", PLASTICA_MEMBER(target.repairs), kDescribeRepair, "target");
  });
}

}  // namespace plastica::calibrate::store
