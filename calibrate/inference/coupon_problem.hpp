#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/inference/uncertainty.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/search/least_squares.hpp"

/// A fitted coupon as those see it who look for its intervals; not installed.
namespace plastica::calibrate {

/// The search's cost (misfit.hpp) as a sum of squares over the noise s, in the coordinates of the
/// parameter set; a free break limit is not one of them but follows. The box is that of the bounds,
/// where the search may end below (`ResolvedParameter::search_upper`).
///
/// Residuals are r_i sqrt(w_i W/sum w^2)/s with W = sum w, so that equal weights give r_i/s; the
/// last are what the break term and the priors add.
class CouponProblem {
 public:
  /// @param result  Fitted, with these options; all must outlive this
  CouponProblem(const Target& target, const FitOptions& options, const FitResult& result);
  CouponProblem(const CouponProblem&) = delete;
  CouponProblem& operator=(const CouponProblem&) = delete;

  /// From the solution on (n searched parameters, m = n_samples + 2).
  const LeastSquaresProblem& squares() const { return squares_; }
  /// The same and last the break limit that the model has at the middle of the break's interval.
  LeastSquaresProblem with_limit();
  const std::vector<double>& solution() const { return squares_.start; }  ///< (n)
  double cost() const { return cost_; }                                   ///< there

  double noise() const { return noise_; }  ///< s; not 0 where the model meets the curve [Pa]
  /// Of the samples that enter the fit, in their order: where among the residuals, and what of it
  /// is left [Pa]; and how many parameters took their part of it.
  const std::vector<std::size_t>& entered() const { return entered_; }
  std::vector<double> residual_of_entered() const;
  /// Of unequal noise: the variance of each of them [Pa^2] (uncertainty.hpp); else empty.
  const std::vector<double>& own_variance() const { return uncertainty_.own_variance; }
  std::size_t rank() const { return uncertainty_.rank; }
  /// Of a residual in Pa, to have it as the squares do.
  double scale(std::size_t sample) const { return scale_[sample]; }
  /// A prior's residual where its parameter is off the mean by one standard deviation.
  double prior_size() const { return break_scale_ * misfit_.prior_size(); }
  /// Of the priors, the last residuals, at the solution (n_priors).
  std::span<const double> prior_residuals() const { return prior_residuals_; }

  /// g^T C g and g^T A^-1 g, A of the squares, over what the curve determines; and C, A^-1 times g.
  struct Moments {
    double squared_error = 0.0;
    double inverse = 0.0;
    std::vector<double> along;  ///< A^-1 g over its moment (n)
  };
  /// @param gradient  of something by the coordinates (n)
  /// @return empty where the curve does not determine it
  std::optional<Moments> moments(std::span<const double> gradient) const;

  /// A free parameter of the fit.
  struct Free {
    const FittedParameter* fitted = nullptr;
    std::optional<std::size_t> coordinate;  ///< of one that is searched
    bool is_break = false;                  ///< the one that follows; else without coordinate: idle
    double degrees_of_freedom = 1.0;        ///< of the residuals' part of its error
  };
  const std::vector<Free>& free() const { return free_; }  ///< in the order of the result

  /// The break limit at the solution, where the break is at the middle, its slope by the
  /// coordinates (n) and half the interval that its sampling leaves.
  double limit() const { return details_.permanent / misfit_.break_factor(); }
  std::vector<double> limit_slope() const;
  double limit_half() const { return limit_half_; }
  /// The limit at coordinates, with the break at a place of its interval: 0 where the specimen was
  /// intact for sure, 1 where it was broken. NaN where the model cannot be run.
  double limit_at(std::span<const double> x, double place);

  double value(std::size_t coordinate, double x) const;  ///< SI

 private:
  std::span<const double> active_of(std::span<const double> x);
  bool residuals(std::span<const double> x, std::span<double> residual);

  ParameterSet set_;
  Misfit misfit_;
  std::vector<std::size_t> searched_;  ///< active index of each coordinate (n)
  std::vector<double> active_;         ///< SI (n_active)
  Misfit::Details details_;
  Uncertainty uncertainty_;
  Spread spread_;
  double noise_ = 0.0;
  double limit_half_ = 0.0;
  std::vector<double> prior_residuals_;
  double weight_unit_ = 1.0;   ///< squares over the weighted ones of the details [1/Pa^2]
  std::vector<double> scale_;  ///< (n_samples) [1/Pa]
  double break_scale_ = 0.0;
  std::vector<std::size_t> entered_;
  LeastSquaresProblem squares_;
  double cost_ = 0.0;
  std::vector<Free> free_;
};

}  // namespace plastica::calibrate
