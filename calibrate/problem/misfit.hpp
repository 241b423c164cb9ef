#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/problem/rising_ideal.hpp"
#include "calibrate/problem/weighed_priors.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::calibrate {

/// Makes a scene the test of a specimen: what is done to it, the strains of its corrected curve,
/// and its strain rate, where it has one.
/// @throws InputError if it has a rate and the material no rate law
void take_test(const Target& target, Scene& scene);

/// The cost of a fit: f = f_stress + f_break [Pa^2].
///
/// f_stress = sum w_i r_i^2 / sum w_i over the intact samples of the specimen, with r_i = model
/// stress - measured stress and
///   strain path:    w_i = (|de_i| + |de_{i+1}|)/2 at sample i, so that f_stress is the integral
///                   of the trapezia sum |de_i| (r_i^2 + r_{i-1}^2)/2 / sum |de_i|;
///   least squares:  w_i = weight_i/noise^2, weight_i the given weight at sample i (a step function
///                   of |strain|) and noise the given one, each 1 if not given; the noise cancels
///                   in f and counts in the uncertainty.
/// f_break = break_weight S^2 ((p - k break_strain)/P)^2, with p the permanent strain (in the
/// scene's break measure) that the model has when the specimen breaks, at the middle of the
/// break's sampling interval; S the largest measured |stress|, P the measured permanent strain at
/// break, k = sqrt(3) where a break strain of tension is fitted in torsion, else 1.
///
/// The stress misfit compares the unbroken law over the specimen's whole life; samples after its
/// break do not enter. So a model that would break earlier or later meets no jump: breaks of
/// model and specimen are compared by f_break alone. Whatever the other parameters are, it is zero
/// at break_strain = p/k. So a free one is not searched but set to that, within its bounds, at each
/// evaluation; the others are searched with the limit that is likely, p clamped to at least P/30,
/// in place of k break_strain: a break limit that is at a bound, fixed or tied does not add to
/// their gradient, but a model that does not yield at all, when the specimen broke with a plain
/// permanent strain, costs. One of less than a tenth of the total strain may be the modulus's
/// error, and says nothing of the yield stress: there p is clamped by no lower limit.
class Misfit {
 public:
  /// @throws InputError if the scene or a parameter does not suit the test
  Misfit(const Target& target, const FitOptions& options, const ParameterSet& parameters);

  /// Takes other starts and bounds of the same parameters.
  void set_parameters(const ParameterSet& parameters);

  /// Adds variance ((value - mean)/standard_deviation)^2 of each prior to the search's cost, where
  /// its parameter is searched; in place of earlier ones.
  void set_priors(const WeighedPriors& priors);

  /// How many samples enter the cost: those of weight above 0.
  std::size_t samples() const;

  // What runs the model throws FitInterrupted once the options' `stop` is raised.

  /// After a search: what follows is evaluated as in a misfit that has not been searched yet.
  void end_search();

  /// Cost at values of the active parameters [SI] (n_active); with their derivatives in
  /// `gradient` (n_active) if it is not empty. Infinite where the model cannot be run.
  double cost(std::span<const double> active, std::span<double> gradient);

  /// The cost with the likely limit in place of the break parameter's, whose value does not count,
  /// and with the priors; else as `cost`.
  double search_cost(std::span<const double> active, std::span<double> gradient);

  /// The cost of `search_cost` as a sum of squares |r|^2 of sqrt(w_i/sum w) (model - measured), the
  /// break's residual and the priors', J their slopes by the active parameters [SI].
  /// @param gradient  J^T r, half the gradient of the cost (n_active) [Pa^2/SI]
  /// @param normal  J^T J (n_active x n_active) [Pa^2/SI^2]
  double search_squares(std::span<const double> active, std::span<double> gradient,
                        std::span<double> normal);

  /// Model stress - measured stress of all intact samples [Pa] (n_samples); the break parameter's
  /// value does not count. @return false if the model cannot be run
  bool residuals(std::span<const double> active, std::span<double> residual);

  /// w_i over their sum (n_samples): the search's cost is sum w_i r_i^2 + `break_residual`^2 +
  /// the squares of `prior_residuals`.
  std::span<const double> weights() const { return weight_; }

  /// What the break term adds to the search's cost at the last evaluation, as a residual [Pa]: 0
  /// within the likely limits.
  double break_residual() const;
  /// How many priors there are.
  std::size_t priors() const { return priors_.size(); }
  /// What each of them adds at the last evaluation, as a residual [Pa] (n_priors).
  std::vector<double> prior_residuals() const;
  /// The same of any of them for a value that is off by one standard deviation.
  double prior_size() const { return std::sqrt(prior_variance_); }

  /// Whether the last evaluation ran the model: one at the point before it does not.
  bool was_run() const { return was_run_; }

  /// p above, of the last evaluation [1].
  double permanent_strain() const { return response_.permanent_strain; }

  /// S^2: costs over it are fractions of the largest stress [Pa^2].
  double cost_unit() const { return cost_unit_; }

  /// Second derivatives of the cost by the active parameters after Gauss and Newton,
  /// 2 sum w_i (dr_i/da)^2 / sum w_i (n_active) [Pa^2 / SI^2].
  std::vector<double> curvature(std::span<const double> active);

  /// The parts of a cost at a solution.
  struct Parts {
    double stress_cost = 0.0;      ///< f_stress [Pa^2]
    double break_cost = 0.0;       ///< f_break [Pa^2]
    std::vector<double> residual;  ///< (n_samples) [Pa]
    std::vector<double> weight;    ///< w_i, unscaled (n_samples)
  };
  Parts parts(std::span<const double> active);

  /// These, and what an uncertainty needs.
  struct Details : Parts {
    /// d model stress / d active, of each parameter all samples in a row (n_active x n_samples).
    std::vector<double> jacobian;
    /// d residual / d shift of the strain [Pa] (n_samples); empty where its zero has no error.
    /// Filled by `add_strain_errors`, as what follows.
    std::vector<double> by_shift;
    /// Of cyclic curves whose strain has noise: errors of the strain where it turns.
    struct Turns {
      std::vector<std::size_t> at;  ///< samples, rising
      /// d residual / d strain at the last turn before it [Pa] (n_samples; empty: no such errors).
      std::vector<double> slopes;
      double error = 0.0;  ///< standard error of the strain of each [1]
    } turns;
    double permanent = 0.0;                  ///< p above [1]
    std::vector<double> permanent_gradient;  ///< dp / d active (n_active)
    struct ActivePrior {
      std::size_t column = 0;  ///< active index
      double standard_deviation = 0.0;
      bool stated = true;  ///< as in `WeighedPriors`
    };
    std::vector<ActivePrior> priors;
    double prior_variance = 0.0;  ///< what z^2 of each counts in the cost [Pa^2]
  };
  Details details(std::span<const double> active);
  /// f_stress alone [Pa^2].
  double stress_cost(std::span<const double> active);

  /// k above times a tie's factor: limit of the test over the value of the break parameter.
  double break_factor() const { return break_factor_; }

 private:
  bool set_values(std::span<const double> active);
  /// Runs the model at the values set, unless it has been run there. @return whether it is usable
  bool run_model(bool with_slopes);
  /// Runs the model sample by sample.
  void follow(ParameterValues values, bool with_slopes);
  /// Follows it at the values of the last run, unless that has been done.
  void need_samples(bool with_slopes);
  /// Many evaluations follow: sums that make them cheap are worth their time.
  void begin_search();
  /// Takes all but the samples from `rising_`, if that applies at the values.
  bool take_closed_form(ParameterValues values);
  /// Sums f_stress, and with slopes its derivatives by the model's parameters.
  void sum_stress_cost(bool with_slopes);
  /// d all model parameters / d active (n_model x n_active).
  std::vector<double> model_by_active(std::size_t active);
  /// Slopes of the stress at the last evaluation by an active parameter (n_samples).
  /// @param map  `model_by_active`
  void stress_slopes(std::span<const double> map, std::size_t parameter,
                     std::span<double> slopes) const;
  /// Of a prior, where its parameter has a value [Pa].
  struct SetPrior {
    std::size_t index = 0;  ///< of its parameter in the set
    Prior prior;
    bool stated = true;
  };
  double prior_residual(const SetPrior& one) const;
  double prior_cost() const;
  /// f_stress; the gradient is that of `cost` if `with_break`, else of `search_cost`.
  double evaluate(std::span<const double> active, std::span<double> gradient, bool with_break);
  double limit() const;
  double likely_limit() const;
  /// f_break for a limit, after an evaluation; adds its derivatives to `by_all` unless empty.
  double break_cost(double limit, std::span<double> by_all, bool limit_moves) const;

  const Target& target_;
  ParameterSet parameters_;
  StopFlag stop_;
  std::size_t samples_ = 0;
  std::vector<double> weight_;  ///< over their sum (n_samples)
  std::vector<double> raw_weight_;
  double cost_unit_ = 1.0;
  double break_scale_ = 0.0;   ///< break_weight S^2 / P^2; 0 without a break term
  double likely_least_ = 0.0;  ///< of `likely_limit`
  double likely_most_ = 0.0;
  double break_factor_ = 1.0;
  std::size_t break_index_ = 0;  ///< of the break parameter in the set
  std::vector<SetPrior> priors_;
  double prior_variance_ = 0.0;
  std::vector<std::size_t> model_index_;  ///< set index of each model parameter
  Model model_;
  Workspace workspace_;
  Response response_;
  Sensitivity sensitivity_;
  std::vector<double> all_values_;
  std::vector<double> model_values_;
  std::vector<double> by_all_;
  std::vector<double> model_normal_;  ///< of the last `search_squares` (n_model x n_model)

  /// What the last run gave; kept for an evaluation at the same point.
  std::optional<std::vector<double>> run_values_;  ///< of the model
  bool run_slopes_ = false;
  bool was_run_ = false;
  bool is_searched_ = false;
  std::optional<RisingIdeal> rising_;  ///< of an ideal-plastic coupon whose strain only rises
  bool is_closed_ = false;             ///< whether the last run is of it
  bool samples_are_there_ = false;     ///< of the last run, in the response
  bool sample_slopes_are_there_ = false;
  std::vector<double> closed_normal_;  ///< of J^T J, whose other terms are 0 (n_model)
  double stress_cost_ = 0.0;
  std::vector<double> stress_slope_;  ///< d f_stress / d model parameter (n_model)
};

}  // namespace plastica::calibrate
