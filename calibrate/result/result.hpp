#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/problem/modulus_prior.hpp"
#include "calibrate/result/fit_outcome.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/status.hpp"

namespace plastica::calibrate {

/// One stage of the optimizer.
struct OptimizerStage {
  std::string algorithm;  ///< NLopt's name, "GN_CRS2_LM"
  std::string outcome;    ///< "xtol-reached", "roundoff-limited", …
  int evaluations = 0;
  double cost = 0.0;  ///< best cost of the stage [Pa^2]
};

/// Every cost evaluation in order, for the file; of large batches their number alone.
struct Trace {
  /// The free parameters that the target depends on, as indices into those of the fit, in rising
  /// order (n).
  std::vector<std::uint32_t> active;
  std::vector<double> values;  ///< (n_evaluations x n), SI, row by row
  std::vector<double> costs;   ///< (n_evaluations) [Pa^2]
  std::size_t left_out = 0;    ///< evaluations that are counted, but neither in values nor in costs
  std::size_t unread = 0;      ///< of a file's, that were counted alone (FitSamples)

  void leave_out() {
    left_out += costs.size();
    values = std::vector<double>();  // with their memory, which {} would keep
    costs = std::vector<double>();
  }
};

/// What the priors that parameters state did to a fit (weighed_priors.hpp).
struct StatedPriors {
  double variance = 0.0;  ///< what z^2 of each counts in the cost [Pa^2]
  double squared = 0.0;   ///< the sum of z^2 at the solution [1]
};

/// The result of the fit of one specimen's curve.
struct FitResult : FitOutcome {
  FitResult() { status = FitStatus::Rejected; }

  double cost = 0.0;             ///< f at the solution, with the break term of a free limit [Pa^2]
  double misfit_rms = 0.0;       ///< sqrt of f without the break term [Pa]
  double misfit_fraction = 0.0;  ///< misfit_rms / largest measured stress [1]
  std::string misfit_word;       ///< "close", "fair", "poor": lack_of_fit.hpp
  /// Probability of so few runs of one sign, if the residuals were noise (verdict.hpp); NaN for
  /// fewer than 20.
  double runs_test_p = std::numeric_limits<double>::quiet_NaN();
  double autocorrelation = 0.0;    ///< of neighbouring residuals (lack_of_fit.hpp) [1]
  double effective_samples = 0.0;  ///< by their weights (lack_of_fit.hpp) [1]
  std::size_t samples = 0;         ///< that entered the fit
  std::optional<double> noise;     ///< that was stated, of the stress [Pa]; empty: none was
  /// Of fits of the simpler laws that this one contains, whose values were tried as starts.
  std::size_t simpler_evaluations = 0;
  std::optional<double> break_strain_total;  ///< total strain at which the fitted model breaks [1]
  /// Of Young's modulus by the elastic slope, with which it was weighed.
  std::optional<ModulusPrior> modulus_prior;
  /// Where parameters state priors.
  std::optional<StatedPriors> stated_priors;
  /// Where laws are compared: what the fits of other specimens leave of this curve, as a fraction
  /// squared (unseen.hpp) [1].
  std::optional<double> unseen;
  std::uint64_t seed = 0;
  std::vector<OptimizerStage> stages;
  Trace trace;  ///< `correlation` is of its active parameters
  /// The model at the corrected samples; if the specimen broke also at its first broken sample, and
  /// where the model breaks between the two, with its stress before and 0 after.
  Curve fitted;

  std::size_t evaluations() const { return trace.costs.size() + trace.left_out + trace.unread; }
  /// Those that `correlation` is of: the free ones that the target depends on.
  std::vector<const FittedParameter*> correlated_parameters() const;
};

/// A target and what its fit gave: one row of a batch, what journal and file hold.
struct FitRecord {
  Target target;
  FitResult result;

  const std::string& name() const { return target.name; }
};

/// Whether a result file's curves and evaluations are read one by one, or counted alone, as reports
/// of large batches want them: then `Curve::samples` and `FitResult::evaluations` say how many.
enum class FitSamples { Read, Counted };

/// What a record is called, alike for all kinds of records.
inline const std::string& name_of(const FitRecord& record) { return record.target.name; }

}  // namespace plastica::calibrate
