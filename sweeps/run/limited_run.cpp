#include "sweeps/run/limited_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "plastica/base/thread_seconds.hpp"
#include "plastica/report/format.hpp"
#include "plastica/run/path_stops.hpp"
#include "plastica/run/response_size.hpp"

namespace plastica::sweeps {
namespace {

/// The iterations of a run that is under way, as far as its response says.
double iterations_of(const Response& response) {
  const std::int64_t at_sample =
      response.samples > 0 ? response.chain.iterations[response.samples - 1] : 0;
  return static_cast<double>(std::max<std::int64_t>(response.counters.iterations, at_sample));
}

}  // namespace

double planned_steps(const Setup& setup) {
  if (setup.solver.analysis != Analysis::Dynamics) return setup.solver.steps;
  return fixed_steps(path_stops(setup.scene, setup.solver), setup.solver.time_step).count;
}

LimitedRun run_limited(const Setup& setup, const RunLimit& limit, StopFlag stop) {
  LimitedRun run;
  Response& response = run.row.response;
  check_memory(setup.scene, setup.solver);
  const Model model = prepare(setup.scene, setup.solver);
  response = make_response(model);
  run.row.level = model.level;
  run.row.in_motion = is_motion(model);
  Workspace workspace = make_workspace(model);
  workspace.stop = stop;
  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  double steps = 0.0;
  double known = 0.0;  // iterations that the response has told of
  double since = 0.0;  // steps that were taken since
  workspace.on_progress = [&](double /*time*/) {
    ++steps;
    ++since;
    if (const double now = iterations_of(response); now > known) {
      known = now;
      since = 0.0;
    }
    if (!(steps < limit.steps)) {
      run.row.reason = "takes more than " + report::brief(limit.steps) + " steps";
    } else if (!(known + since < limit.iterations)) {
      run.row.reason = "takes more than " + report::brief(limit.iterations) + " iterations";
    } else if (std::isfinite(limit.seconds) && !(seconds() < limit.seconds)) {
      run.row.reason = "takes more than " + report::brief(limit.seconds) + " s";
    }
    return run.row.reason.empty();
  };
  const double begin = thread_seconds();
  plastica::run(model, {}, workspace, response);
  response.seconds = thread_seconds() - begin;
  run.stopped = response.status == Status::Interrupted && !is_raised(stop);
  if (!run.stopped) run.row.reason.clear();  // the last step ended it, too
  return run;
}

}  // namespace plastica::sweeps
