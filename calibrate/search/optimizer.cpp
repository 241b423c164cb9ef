#include "calibrate/search/optimizer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>

#include "calibrate/search/gauss_newton.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

struct Algorithm {
  std::string_view name;
  nlopt::algorithm nlopt;
  bool global;
  bool gradient;
};

/// PRAXIS is not among them: it knows bounds as infinite costs and ends beside an active one.
constexpr std::array kAlgorithms{
    Algorithm{"crs", nlopt::GN_CRS2_LM, true, false},
    Algorithm{"direct-l", nlopt::GN_DIRECT_L, true, false},
    Algorithm{"direct-l-rand", nlopt::GN_DIRECT_L_RAND, true, false},
    Algorithm{"isres", nlopt::GN_ISRES, true, false},
    Algorithm{"esch", nlopt::GN_ESCH, true, false},
    Algorithm{"slsqp", nlopt::LD_SLSQP, false, true},
    Algorithm{"lbfgs", nlopt::LD_LBFGS, false, true},
    Algorithm{"var2", nlopt::LD_VAR2, false, true},
    Algorithm{"tnewton", nlopt::LD_TNEWTON_PRECOND_RESTART, false, true},
    Algorithm{"mma", nlopt::LD_MMA, false, true},
    Algorithm{"ccsaq", nlopt::LD_CCSAQ, false, true},
    Algorithm{"nelder-mead", nlopt::LN_NELDERMEAD, false, false},
    Algorithm{"sbplx", nlopt::LN_SBPLX, false, false},
    Algorithm{"bobyqa", nlopt::LN_BOBYQA, false, false},
    Algorithm{"cobyla", nlopt::LN_COBYLA, false, false},
};

const Algorithm& find(std::string_view name) {
  for (const Algorithm& algorithm : kAlgorithms) {
    if (algorithm.name == name) return algorithm;
  }
  std::string list = "must be one of";
  for (const std::string_view known : algorithm_names()) list += " " + std::string(known);
  throw InputError({}, "algorithm", name, list);
}

/// What the cost callback needs; keeps the best point, since NLopt may end on another one.
struct Run {
  const Problem& problem;
  int max_evaluations;
  Minimum best;
  std::exception_ptr error;
  bool spent = false;  ///< more evaluations were asked for than are allowed
};

double evaluate(unsigned n, const double* x, double* gradient, void* data) {
  Run& run = *static_cast<Run*>(data);
  // NLopt looks at a forced stop only now and then: some algorithms finish a round first, and some
  // overstep their number of evaluations so.
  run.spent = run.spent || run.best.evaluations >= run.max_evaluations;
  if (run.error || run.spent) throw nlopt::forced_stop();
  const std::span<const double> point(x, n);
  double cost = 0.0;
  try {
    cost = run.problem.cost(point, gradient ? std::span<double>(gradient, n) : std::span<double>());
  } catch (...) {
    // NLopt would turn it into "failure": it is carried around it instead.
    run.error = std::current_exception();
    throw nlopt::forced_stop();
  }
  ++run.best.evaluations;
  if (!std::isfinite(cost)) {
    if (gradient != nullptr) std::fill(gradient, gradient + n, 0.0);
    return std::numeric_limits<double>::max();
  }
  if (run.best.x.empty() || cost < run.best.cost) {
    run.best.x.assign(point.begin(), point.end());
    run.best.cost = cost;
  }
  return cost;
}

std::string_view outcome_name(nlopt::result result) {
  switch (result) {
    case nlopt::SUCCESS: return "success";
    case nlopt::STOPVAL_REACHED: return "stopval-reached";
    case nlopt::FTOL_REACHED: return "ftol-reached";
    case nlopt::XTOL_REACHED: return "xtol-reached";
    case nlopt::MAXEVAL_REACHED: return "maxeval-reached";
    case nlopt::MAXTIME_REACHED: return "maxtime-reached";
    default: return "failure";
  }
}

}  // namespace

std::span<const std::string_view> algorithm_names() {
  static constexpr auto kNames = [] {
    std::array<std::string_view, kAlgorithms.size() + 2> names{"auto", kGaussNewton};
    for (std::size_t i = 0; i < kAlgorithms.size(); ++i) names[i + 2] = kAlgorithms[i].name;
    return names;
  }();
  return kNames;
}

std::string nlopt_version() {
  return std::to_string(nlopt::version_major()) + "." + std::to_string(nlopt::version_minor()) +
         "." + std::to_string(nlopt::version_bugfix());
}

bool is_global(std::string_view algorithm) {
  return algorithm != kGaussNewton && find(algorithm).global;
}

bool needs_gradient(std::string_view algorithm) {
  return algorithm == kGaussNewton || find(algorithm).gradient;
}

Minimum minimize(const Problem& problem, const MinimizeOptions& options) {
  if (options.algorithm == kGaussNewton) return minimize_exact_squares(problem, options);
  const Algorithm& algorithm = find(options.algorithm);
  const auto n = static_cast<unsigned>(problem.start.size());
  Run run{problem, options.max_evaluations, {}, nullptr};

  nlopt::opt opt(algorithm.nlopt, n);
  opt.set_min_objective(evaluate, &run);
  opt.set_lower_bounds(problem.lower);
  opt.set_upper_bounds(problem.upper);
  opt.set_maxeval(options.max_evaluations);
  opt.set_xtol_abs(options.x_tolerance);
  opt.set_ftol_rel(options.cost_tolerance);
  // NLopt keeps its random state by thread; a seed before each run of an algorithm that draws
  // numbers makes the run repeatable.
  if (algorithm.global) nlopt::srand(static_cast<unsigned long>(options.seed));

  std::vector<double> x = problem.start;
  double cost = 0.0;
  bool failed = false;
  try {
    run.best.outcome = outcome_name(opt.optimize(x, cost));
  } catch (const nlopt::roundoff_limited&) {
    // No further progress in double precision: the best point is as good as it gets.
    run.best.outcome = "roundoff-limited";
  } catch (const nlopt::forced_stop&) {
    // By `evaluate`: see below.
  } catch (const std::runtime_error& error) {
    run.best.outcome = std::string("failure: ") + error.what();
    failed = true;
  }
  if (run.error) std::rethrow_exception(run.error);
  if (run.spent) {
    // Whatever NLopt made of the stop: some algorithms call it a failure.
    run.best.outcome = outcome_name(nlopt::MAXEVAL_REACHED);
    failed = false;
  }
  run.best.usable = !failed && !run.best.x.empty();
  return run.best;
}

}  // namespace plastica::calibrate
