#pragma once

#include <string>

#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/result/result.hpp"

/// What of a record stands where in a result file; not installed. Documented in docs/hdf5.md.
namespace plastica::calibrate::store {

/// Visits all that a file holds of its records.
/// @tparam Store  a StoreWriter or a StoreReader
template <typename Store>
void traverse_records(Store& store) {
  store.table(
      "fits", kDescribeFit, [](auto& record) -> auto& { return record; });
  store.table("characteristics", kDescribeCharacteristics, PLASTICA_MEMBER(target.characteristics));
  store.parameters();
  store.free_parameters();
  store.correlation();
  store.numbers_since(7, "held_out", PLASTICA_MEMBER(result.held_out));
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
  store.list("repairs", PLASTICA_MEMBER(target.repairs), kDescribeRepair);
  store.list("corrections", PLASTICA_MEMBER(target.corrections), kDescribeCorrection);
  store.list("stages", PLASTICA_MEMBER(result.stages), kDescribeStage);
  store.list("warnings/target", PLASTICA_MEMBER(target.warnings), kDescribeText);
  store.list("warnings/fit", PLASTICA_MEMBER(result.warnings), kDescribeText);
}

}  // namespace plastica::calibrate::store
