#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/weighted_squares.hpp"
#include "calibrate/search/fit_interrupted.hpp"
#include "plastica/coupon/material.hpp"
#include "plastica/run/parameters.hpp"

/// How a misfit comes to the sum of squares of its samples.
namespace plastica::calibrate {
namespace {

/// Whether E and the yield stress alone move it, each in proportion.
bool is_ideal_coupon(const Model& model) {
  const coupon::CouponShape& shape = model.coupon;
  const auto is_known = [](const Field* field) {
    return field->material == MaterialField::YoungsModulus ||
           field->material == MaterialField::YieldStress;
  };
  return !model.chain && shape.hardening == HardeningLaw::Ideal &&
         shape.deformation != Deformation::Torsion && shape.formulas == Formulas::Mechanics &&
         std::ranges::all_of(model.parameters, is_known);
}

}  // namespace

void Misfit::begin_search() {
  if (std::exchange(is_searched_, true) || !is_ideal_coupon(model_)) return;
  rising_ = RisingIdeal::of(model_.drive, target_.corrected.stress, weight_);
  run_values_.reset();
}

void Misfit::end_search() {
  is_searched_ = false;
  rising_.reset();
  run_values_.reset();
}

bool Misfit::run_model(bool with_slopes) {
  was_run_ = run_values_ != model_values_ || (with_slopes && !run_slopes_);
  if (was_run_) {
    if (is_raised(stop_)) throw FitInterrupted();
    run_values_ = model_values_;
    run_slopes_ = with_slopes;
    is_closed_ = take_closed_form(model_values_);
    samples_are_there_ = sample_slopes_are_there_ = false;
    if (!is_closed_) {
      follow(model_values_, with_slopes);
      if (usable(response_.status)) sum_stress_cost(with_slopes);
    }
  }
  return usable(response_.status) && std::isfinite(stress_cost_);
}

void Misfit::follow(ParameterValues values, bool with_slopes) {
  if (with_slopes) {
    run_sensitivity(model_, values, workspace_, response_, sensitivity_);
  } else {
    run(model_, values, workspace_, response_);
  }
  samples_are_there_ = true;
  sample_slopes_are_there_ = with_slopes;
}

void Misfit::need_samples(bool with_slopes) {
  if (!run_values_ || (samples_are_there_ && (sample_slopes_are_there_ || !with_slopes))) return;
  follow(*run_values_, with_slopes);
  // All else stays what it was, to the last bit.
  if (is_closed_) take_closed_form(*run_values_);
}

bool Misfit::take_closed_form(ParameterValues values) {
  MaterialValues<double> material;
  if (!rising_ || !take_parameters(model_, values, material)) return false;
  const auto coupon = coupon::coupon_material(model_.coupon, material);
  if (!(coupon.stiffness > 0.0) || !(coupon.yield > 0.0)) return false;
  const auto sum = rising_->sum(coupon.stiffness, coupon.yield);
  const RisingIdeal::Permanent permanent = rising_->permanent(coupon.stiffness, coupon.yield);
  if (!sum || !std::isfinite(sum->squares) || !std::isfinite(permanent.by_stiffness)) return false;
  response_.event.reset();
  response_.status = Status::Completed;
  response_.samples = model_.drive.size();
  response_.permanent_strain = permanent.strain;
  stress_cost_ = sum->squares;
  for (std::size_t i = 0; i < model_.parameters.size(); ++i) {
    const bool stiffens = model_.parameters[i]->material == MaterialField::YoungsModulus;
    const double by = (stiffens ? coupon.stiffness : coupon.yield) / values[i];
    stress_slope_[i] = by * (stiffens ? sum->by_stiffness : sum->by_yield);
    sensitivity_.permanent_strain[i] =
        by * (stiffens ? permanent.by_stiffness : permanent.by_yield);
    closed_normal_[i] = by * by * (stiffens ? sum->stiffness_normal : sum->yield_normal);
  }
  return true;
}

void Misfit::sum_stress_cost(bool with_slopes) {
  const std::span model(response_.probes[0].data(), samples_);
  if (!with_slopes) {
    stress_cost_ = weighted_squares(model, target_.corrected.stress, weight_);
    return;
  }
  stress_cost_ = weighted_squares(model, target_.corrected.stress, weight_, sensitivity_.stress,
                                  stress_slope_);
}

}  // namespace plastica::calibrate
