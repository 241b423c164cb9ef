#pragma once

#include <string>

#include "calibrate/fit/result.hpp"
#include "calibrate/result/describe.hpp"

/// What of a record stands where in a result file; not installed. Documented in data/README.md.
namespace plastica::calibrate::store {

constexpr auto kCharacteristicsColumns = [](auto& columns) {
  columns("youngs_modulus", "Pa", PLASTICA_MEMBER(youngs_modulus));
  columns("youngs_modulus_standard_error", "Pa", PLASTICA_MEMBER(youngs_modulus_stderr));
  columns("modulus_window_low", "Pa", PLASTICA_MEMBER(modulus_window_low));
  columns("modulus_window_high", "Pa", PLASTICA_MEMBER(modulus_window_high));
  columns("modulus_method", "", PLASTICA_MEMBER(modulus_method));
  columns("proof_offset", "1", PLASTICA_MEMBER(offset));
  columns("rp02", "Pa", PLASTICA_MEMBER(rp02));
  columns("reh", "Pa", PLASTICA_MEMBER(reh));
  columns("rel", "Pa", PLASTICA_MEMBER(rel));
  columns("rm", "Pa", PLASTICA_MEMBER(rm));
  columns("strain_at_rm", "1", PLASTICA_MEMBER(strain_at_rm));
  columns("break_strain", "1", PLASTICA_MEMBER(break_strain));
  columns("break_strain_plastic", "1", PLASTICA_MEMBER(break_strain_plastic));
  columns("largest_strain", "1", PLASTICA_MEMBER(largest_strain));
  columns.part("broke", PLASTICA_MEMBER(observed_break), [](auto& part) {
    part("last_whole_strain", "1", PLASTICA_MEMBER(last_whole_strain));
    part("last_whole_stress", "Pa", PLASTICA_MEMBER(last_whole_stress));
    part("first_broken_strain", "1", PLASTICA_MEMBER(first_broken_strain));
    part("break_rule", "", PLASTICA_MEMBER(rule));
  });
};

constexpr auto kFitColumns = [](auto& columns) {
  columns("name", "", PLASTICA_MEMBER(target.name));
  columns("law", "", PLASTICA_MEMBER(result.law));
  columns("status", "", PLASTICA_MEMBER(result.status));
  columns("reason", "", PLASTICA_MEMBER(result.reason));
  columns("file", "", PLASTICA_MEMBER(target.file));
  columns("test", "", PLASTICA_MEMBER(target.test));
  columns("measure", "", PLASTICA_MEMBER(target.measure));
  columns("loading", "", PLASTICA_MEMBER(target.loading));
  columns("target_status", "", PLASTICA_MEMBER(target.status));
  columns("target_reason", "", PLASTICA_MEMBER(target.reason));
  columns("samples", "1", PLASTICA_MEMBER(result.samples));
  columns("seed", "", PLASTICA_MEMBER(result.seed));
  columns("noise", "Pa", PLASTICA_MEMBER(result.noise));
  columns("simpler_evaluations", "1", PLASTICA_MEMBER(result.simpler_evaluations));
  const auto fitted = [](const FitRecord& r) { return r.result.status == FitStatus::Fitted; };
  columns.only(fitted, [](auto& only) {
    only("cost", "Pa^2", PLASTICA_MEMBER(result.cost));
    only("misfit_rms", "Pa", PLASTICA_MEMBER(result.misfit_rms));
    only("misfit_share", "1", PLASTICA_MEMBER(result.misfit_share));
    only("misfit_word", "", PLASTICA_MEMBER(result.misfit_word));
    only("runs_probability", "1", PLASTICA_MEMBER(result.runs_probability));
    only("autocorrelation", "1", PLASTICA_MEMBER(result.autocorrelation));
    only("effective_samples", "1", PLASTICA_MEMBER(result.effective_samples));
  });
  columns("break_strain_total", "1", PLASTICA_MEMBER(result.break_strain_total));
};

/// Walks through all that a file holds of its records.
/// @tparam Store  a StoreWriter or a StoreReader
template <typename Store>
void walk_records(Store& store) {
  store.table(
      "fits", kFitColumns, [](auto& record) -> auto& { return record; });
  store.table("characteristics", kCharacteristicsColumns, PLASTICA_MEMBER(target.characteristics));
  store.parameters();
  store.moved();
  store.correlation();
  store.intervals();

  store.curve("curves/raw", PLASTICA_MEMBER(target.raw));
  store.curve("curves/corrected", PLASTICA_MEMBER(target.corrected));
  store.curve("curves/fitted", PLASTICA_MEMBER(result.fitted));
  store.evaluations();

  store.list("groups", PLASTICA_MEMBER(target.group), [](auto& columns) {
    columns("key", "", PLASTICA_MEMBER(first));
    columns("value", "", PLASTICA_MEMBER(second));
  });
  store.list("properties", PLASTICA_MEMBER(target.properties), [](auto& columns) {
    columns("key", "", PLASTICA_MEMBER(first));
    columns("value", "", PLASTICA_MEMBER(second));
  });
  store.list("repairs", PLASTICA_MEMBER(target.repairs), [](auto& columns) {
    columns("kind", "", PLASTICA_MEMBER(kind));
    columns("count", "1", PLASTICA_MEMBER(count));
    columns("text", "", PLASTICA_MEMBER(text));
  });
  store.list("corrections", PLASTICA_MEMBER(target.corrections), [](auto& columns) {
    columns("kind", "", PLASTICA_MEMBER(kind));
    columns("applied", "", PLASTICA_MEMBER(applied));
    columns("amount", "", PLASTICA_MEMBER(amount));
    columns("amount_units", "", PLASTICA_MEMBER(unit));
    columns("text", "", PLASTICA_MEMBER(text));
  });
  store.list("stages", PLASTICA_MEMBER(result.stages), [](auto& columns) {
    columns("algorithm", "", PLASTICA_MEMBER(algorithm));
    columns("outcome", "", PLASTICA_MEMBER(outcome));
    columns("evaluations", "1", PLASTICA_MEMBER(evaluations));
    columns("cost", "Pa^2", PLASTICA_MEMBER(cost));
  });
  const auto text = [](auto& columns) {
    columns(
        "text", "", [](auto& row) -> auto& { return row; });
  };
  store.list("warnings/target", PLASTICA_MEMBER(target.warnings), text);
  store.list("warnings/fit", PLASTICA_MEMBER(result.warnings), text);
}

}  // namespace plastica::calibrate::store
