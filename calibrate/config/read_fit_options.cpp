#include "calibrate/config/read_fit_options.hpp"

#include <array>
#include <limits>

#include "calibrate/config/read_parameters.hpp"
#include "calibrate/fit/optimizer.hpp"
#include "plastica/io/scene_file.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;

void read_stopping(const TomlTable& fit, StoppingRules& stopping) {
  constexpr std::int64_t kMost = 1'000'000'000;
  const auto stop = fit.find_table("stop");
  if (!stop) return;
  if (const auto value = stop->find("global_evaluations")) {
    stopping.global_evaluations = static_cast<int>(value->integer(0, kMost));
  }
  if (const auto value = stop->find("local_evaluations")) {
    stopping.local_evaluations = static_cast<int>(value->integer(1, kMost));
  }
  if (const auto value = stop->find("parameter_tolerance")) {
    stopping.parameter_tolerance = value->number_within(0.0, 1.0, true);
  }
  if (const auto value = stop->find("cost_tolerance")) {
    stopping.cost_tolerance = value->number_within(0.0, 1.0, true);
  }
}

void read_objective(const TomlTable& fit, FitOptions& options) {
  static constexpr std::array<std::string_view, 2> kObjectives{"strain-path", "least-squares"};
  if (const auto value = fit.find("objective")) {
    options.objective = static_cast<Objective>(value->word(kObjectives));
  }
  if (const auto value = fit.find("noise")) {
    options.noise = value->quantity(Dimension::Stress);
    if (*options.noise <= 0.0) throw value->error("must be above 0 Pa");
    if (options.objective != Objective::LeastSquares) {
      throw value->error("goes with objective = \"least-squares\" alone");
    }
  }
  if (const auto value = fit.find("break_weight")) {
    options.break_weight = value->number_within(0.0, std::numeric_limits<double>::infinity(), true);
  }
}

}  // namespace

FitOptions read_fit_options(const TomlTable& root) {
  FitOptions options;
  io::read_setup(root, options.setup);
  const auto fit = root.find_table("fit");
  if (!fit) {
    options.parameters = default_parameters();
    return options;
  }
  read_objective(*fit, options);
  if (const auto value = fit->find("algorithm")) {
    options.algorithm = algorithm_names()[value->word(algorithm_names())];
  }
  if (const auto value = fit->find("seed")) {
    options.seed =
        static_cast<std::uint64_t>(value->integer(0, std::numeric_limits<std::int64_t>::max()));
  }
  if (const auto value = fit->find("confidence")) {
    options.confidence = value->quantity(Dimension::None);
    if (options.confidence <= 0.0 || options.confidence >= 1.0) {
      throw value->error("must be above 0 % and below 100 %");
    }
  }
  read_stopping(*fit, options.stopping);
  options.parameters = read_parameters(*fit);
  return options;
}

}  // namespace plastica::calibrate
