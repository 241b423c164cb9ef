#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/inference/intervals.hpp"
#include "calibrate/problem/law.hpp"
#include "calibrate/problem/objective.hpp"
#include "calibrate/problem/parameter.hpp"
#include "plastica/base/stop_flag.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// When an optimizer stage ends: at the first of these.
struct StoppingRules {
  /// Largest number of cost evaluations of the global stage, which follows where the local one
  /// alone does not meet the curve closely; 0 switches it off.
  int global_evaluations = 60;
  /// Largest number of cost evaluations of the local stage.
  int local_evaluations = 500;
  /// The local stage ends when a step changes every scaled parameter by less than this [1].
  double parameter_tolerance = 1e-10;
  /// … or the cost by less than this fraction of itself.
  double cost_tolerance = 1e-14;
};

/// A step of the given weights: samples have this weight from a strain on, up to the next step.
///
/// It is the size of the corrected strain that counts, |strain|: compression, and both directions
/// of a cyclic curve, are weighted as tension is. Samples before the first step have weight 1.
struct WeightStep {
  double from = 0.0;    ///< |strain| of the first samples that it holds for [1], >= 0
  double weight = 1.0;  ///< >= 0; samples of weight 0 do not enter the fit
};

/// Everything that a fit is told besides the target.
struct FitOptions {
  Setup setup;  ///< material, section and rules of the beam; the target sets drive and probes
  /// Paths of the material's fields that the fit's file gives, whatever their values; "material":
  /// all.
  std::vector<std::string> stated;
  std::vector<Parameter> parameters;
  Objective objective = Objective::Path;
  std::optional<double> noise;  ///< standard deviation of the stress [Pa], LeastSquares
  /// Given weights by |strain|, LeastSquares; `from` rises strictly from step to step. They say how
  /// much a part of the curve matters, not how noisy it is: see uncertainty.hpp. A target whose
  /// samples all have weight 0 is rejected.
  std::vector<WeightStep> weights;
  /// Weight of the break term (see misfit.hpp), >= 0; 0 leaves break_strain unidentified.
  double break_weight = 1.0;
  /// Whether the slope of the elastic part is a prior of Young's modulus (modulus_prior.hpp).
  bool modulus_prior = true;
  std::string algorithm = "auto";  ///< see `algorithm_names()`
  StoppingRules stopping;
  /// Whether a result has every evaluation of its search, or their number alone. They are more than
  /// half of what a result takes.
  bool keep_trace = true;
  /// Laws to be compared, see fit_law.hpp; empty: the material's own alone.
  std::vector<Law> laws;
  std::uint64_t seed = 1;       ///< each target's own seed is made from this and the target's name
  double confidence = 0.95;     ///< of the intervals, within (0, 1)
  IntervalOptions intervals{};  ///< besides those of the covariance
  /// Once raised, no further evaluation is begun, and the fit ends by `FitInterrupted`. May be
  /// null.
  StopFlag stop = nullptr;
};

}  // namespace plastica::calibrate
