#pragma once

#include <string>
#include <utility>

#include "sweeps/run/sweep_run.hpp"
#include "sweeps/store/sweep_record.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {

/// The record of a sweep of the shipped cantilever that was run; `rest` begins with its axes.
inline SweepRecord record_of(const std::string& rest) {
  const Sweep sweep = cantilever_sweep(rest);
  SweepRun run(sweep, {});
  auto results = run.run();
  return make_record(sweep, run.cases(), run.ids(), std::move(results));
}

/// The tip of the cantilever against the elastica, two ways to join its end, three sizes.
inline SweepRecord two_groups() {
  return record_of(segments_axis("[4, 8, 16]") +
                   "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n" +
                   kTipError);
}

}  // namespace plastica::sweeps
