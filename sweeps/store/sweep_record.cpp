#include "sweeps/store/sweep_record.hpp"

#include <algorithm>
#include <utility>

#include "plastica/model/check_value.hpp"
#include "sweeps/run/case_warnings.hpp"

namespace plastica::sweeps {

bool SweepRecord::has_errors() const {
  return std::any_of(comparison.error.begin(), comparison.error.end(),
                     [](const auto& error) { return error.has_value(); });
}

std::string words_of(const Against& against, const Quantity& quantity) {
  switch (against.kind) {
    case AgainstKind::Nothing: return "";
    case AgainstKind::Theory: return "theory:" + against.name;
    case AgainstKind::File: return "reference:" + against.name;
    case AgainstKind::Value:
      return "value:" + model_detail::number_text(against.value) +
             (quantity.unit == "1" ? "" : " " + quantity.unit);
    case AgainstKind::Finest: return "finest";
    case AgainstKind::Richardson: return "richardson";
  }
  return "";
}

SweepRecord make_record(const Sweep& sweep, const CaseTable& cases, std::vector<std::string> ids,
                        std::vector<CaseResult> results) {
  SweepRecord record;
  record.name = sweep.name;
  record.scene_name = sweep.setup.scene.name;
  record.axes = sweep.axes;
  record.quantity = sweep.quantity;
  record.against = words_of(sweep.against, sweep.quantity);
  record.error_scale = sweep.error_scale;
  record.refined = sweep.refined;
  record.timed_runs = sweep.timed_runs;
  record.ids = std::move(ids);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto at = cases.position(i);
    record.position.insert(record.position.end(), at.begin(), at.end());
  }
  record.groups = refinement_groups(sweep, cases);
  record.comparison = compare(sweep, cases, record.groups, results, record.ids);
  record.warnings = case_warnings(sweep, cases, results);
  record.results = std::move(results);
  record.inputs = sweep.inputs;
  return record;
}

}  // namespace plastica::sweeps
