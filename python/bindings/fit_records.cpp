#include "python/bindings/fit_records.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace plastica::python {

py::dict profiles_of(const calibrate::FitOutcome& outcome, py::handle owner) {
  py::dict profiles;
  const auto free = outcome.free_parameters();
  for (std::size_t k = 0; k < outcome.intervals.profiles.size(); ++k) {
    const calibrate::LikelihoodProfile& profile = outcome.intervals.profiles[k];
    py::dict one;
    one["interval"] = py::make_tuple(profile.low, profile.high);
    one["ends"] = py::make_tuple(name_of(profile.low_end), name_of(profile.high_end));
    one["threshold"] = profile.threshold;
    one["value"] = view_of(profile.value, owner);
    one["rise"] = view_of(profile.rise, owner);
    profiles[py::str(free[k]->name())] = one;
  }
  return profiles;
}

py::object bootstrap_of(const calibrate::FitOutcome& outcome,
                        const calibrate::BootstrapResult& bootstrap, py::handle owner) {
  if (bootstrap.resamples == 0) return py::none();
  const auto free = outcome.free_parameters();
  py::dict said;
  said["resamples"] = bootstrap.resamples;
  said["failed"] = bootstrap.failed;
  said["block"] = bootstrap.block;
  said["values"] = matrix(bootstrap.values, free.size(), owner);
  py::dict errors;
  py::dict intervals;
  for (std::size_t k = 0; k < bootstrap.intervals.size(); ++k) {
    const auto& interval = bootstrap.intervals[k];
    errors[py::str(free[k]->name())] = interval.standard_error;
    intervals[py::str(free[k]->name())] = py::make_tuple(interval.low, interval.high);
  }
  said["error"] = errors;
  said["interval"] = intervals;
  return said;
}

void set_intervals(bool profile, int bootstrap, int block, int specimens,
                   calibrate::IntervalOptions& intervals) {
  intervals.profile = intervals.profile || profile;
  if (bootstrap != 0) intervals.bootstrap = bootstrap;
  if (block != 1) intervals.block = block;
  if (specimens != 0) intervals.specimens = specimens;
  calibrate::check_intervals(intervals);
}

}  // namespace plastica::python
