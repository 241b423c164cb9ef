#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plastica/io/result_file.hpp"
#include "sweeps/compare/comparison.hpp"
#include "sweeps/plan/sweep.hpp"
#include "sweeps/run/case_result.hpp"

namespace plastica::sweeps {

/// A sweep that was run, and what came out: what a result file holds, and all reports are made of.
struct SweepRecord {
  std::string name;
  std::string scene_name;
  std::vector<Axis> axes;
  Quantity quantity;
  std::string against{};  ///< as the sweep file has it: "theory:elastica"; empty: nothing
  std::optional<double> error_scale{};
  std::optional<std::size_t> refined{};  ///< number of the axis that refines
  int timed_runs = 0;
  std::vector<std::string> ids;       ///< (n_cases)
  std::vector<std::size_t> position;  ///< number of the value on each axis (n_cases x n_axes)
  std::vector<CaseResult> results;    ///< (n_cases)
  Comparison comparison;
  std::vector<std::string> warnings{};  ///< of the cases, see `case_warnings`
  std::vector<RefinementGroup> groups;
  std::vector<io::InputText> inputs;  ///< the sweep's file, then the scene's
  io::RunMeta meta;

  std::size_t cases() const { return ids.size(); }
  /// Value of a case on an axis.
  const FieldValue& at(std::size_t index, std::size_t axis) const {
    return axes[axis].values[position[index * axes.size() + axis]];
  }
  /// Whether any case has an error.
  bool has_errors() const;
};

/// The reference as a file has it: "theory:elastica".
std::string words_of(const Against& against, const Quantity& quantity);

/// Puts together what is known of a sweep and its results; without meta.
SweepRecord make_record(const Sweep& sweep, const CaseTable& cases, std::vector<std::string> ids,
                        std::vector<CaseResult> results);

}  // namespace plastica::sweeps
