#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sweeps/compare/comparison.hpp"
#include "sweeps/store/sweep_record.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {

/// A sweep with results that are made up.
class Made {
 public:
  Made(const std::string& text, const std::vector<double>& values)
      : sweep(cantilever_sweep(text)), cases(sweep), groups(refinement_groups(sweep, cases)) {
    for (const double value : values) {
      CaseResult result;
      result.status = Status::Completed;
      if (std::isfinite(value)) result.value = value;
      results.push_back(std::move(result));
    }
  }
  Comparison compared() const { return compare(sweep, cases, groups, results); }
  /// @param ids  of the runs
  SweepRecord record(std::vector<std::string> ids = {}) const {
    if (ids.empty()) {
      for (std::size_t i = 0; i < results.size(); ++i) ids.push_back(std::to_string(i));
    }
    return make_record(sweep, cases, std::move(ids), results);
  }

  Sweep sweep;
  CaseTable cases;
  std::vector<RefinementGroup> groups;
  std::vector<CaseResult> results;
};

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

inline std::string against(const std::string& what) {
  return "[error]\nprobe = 'tip'\nagainst = '" + what + "'\n";
}

}  // namespace plastica::sweeps
