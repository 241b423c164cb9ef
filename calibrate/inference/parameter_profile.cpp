#include "calibrate/inference/parameter_profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/inference/bootstrap.hpp"
#include "calibrate/inference/not_a_number.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {

ParameterProfile::ParameterProfile(ProfiledParameter parameter, const LeastSquaresProblem& squares,
                                   std::vector<double> x, double cost, double confidence)
    : parameter_(std::move(parameter)),
      confidence_(confidence),
      factor_(theory::student_t_quantile(0.5 + 0.5 * confidence, parameter_.degrees_of_freedom)) {
  best_.x = std::move(x);
  best_.cost = cost;
  best_.value = parameter_.is_break ? parameter_.limit : best_.x[parameter_.coordinate];
  if (std::isfinite(parameter_.squared_error) && parameter_.squared_error > 0.0) {
    // Of given weights the covariance is not the inverse of the squares' curvature: there the
    // threshold is stretched as the squared error is.
    ratio_ = parameter_.squared_error / parameter_.inverse;
    best_.step = factor_ * std::sqrt(parameter_.squared_error);
    best_.along = parameter_.along;
    return;
  }
  // At a bound, or not identified: without a scale of its own.
  constexpr double kFraction = 0.02;
  const std::size_t k = parameter_.coordinate;
  best_.step = kFraction *
               (parameter_.is_break ? std::abs(best_.value) : squares.upper[k] - squares.lower[k]);
}

bool ParameterProfile::depends() const {
  const auto moves = [](double g) { return g != 0.0; };
  return std::isfinite(best_.value) && std::ranges::any_of(parameter_.gradient, moves);
}

ProfileSide ParameterProfile::side(const LeastSquaresProblem& squares, bool up) const {
  ProfileOptions how;
  how.rise = factor_ * factor_ * ratio_;
  if (parameter_.is_break) return profile_function(squares, best_, up, how);
  return profile_coordinate(squares, best_, parameter_.coordinate, up, how);
}

double ParameterProfile::value_of(double at) const {
  return parameter_.is_break ? at : parameter_.value_of(parameter_.coordinate, at);
}

/// A break's end has its place between two samples in it, too.
void ParameterProfile::set_end(double end, bool up, ProfileEnd why,
                               LikelihoodProfile& profile) const {
  const ProfiledParameter& p = parameter_;
  double to = end;
  if (p.is_break) {
    const double reach = theory::half_interval(confidence_, std::abs(end - best_.value) / factor_,
                                               p.degrees_of_freedom, p.halves);
    const double open = best_.value + (up ? reach : -reach);
    to = std::clamp(open, p.lower, p.upper);
    if (to != open) why = ProfileEnd::Bound;
  } else {
    // The bound itself, where coordinates have rounded it.
    to = why == ProfileEnd::Bound ? (up ? p.upper : p.lower) : value_of(end);
  }
  (up ? profile.high : profile.low) = to;
  (up ? profile.high_end : profile.low_end) = why;
}

void ParameterProfile::add(const ProfilePoint& point, LikelihoodProfile& profile) const {
  profile.value.push_back(value_of(point.value));
  profile.rise.push_back((point.cost - best_.cost) / ratio_);
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    profile.searched.push_back(parameter_.value_of(i, point.x[i]));
  }
}

LikelihoodProfile ParameterProfile::profile(const ProfileSide& low, const ProfileSide& high) const {
  LikelihoodProfile profile;
  profile.threshold = factor_ * factor_;
  set_end(low.end, false, low.why, profile);
  set_end(high.end, true, high.why, profile);
  for (const ProfilePoint& point : low.points) add(point, profile);
  add({best_.value, best_.cost, best_.x}, profile);
  for (const ProfilePoint& point : high.points) add(point, profile);
  return profile;
}

LikelihoodProfile ParameterProfile::unmoved() const {
  LikelihoodProfile profile;
  profile.threshold = factor_ * factor_;
  profile.low = profile.high = kNan;
  if (!parameter_.is_break || !std::isfinite(best_.value)) return profile;
  for (const bool up : {false, true}) set_end(best_.value, up, ProfileEnd::Crossed, profile);
  return profile;
}

BootstrapResult bootstrap_of(const std::vector<std::vector<double>>& rows,
                             const std::vector<bool>& known, int block, double confidence) {
  BootstrapResult result;
  result.resamples = static_cast<int>(rows.size());
  result.block = block;
  std::vector<std::vector<double>> columns(known.size());
  for (const std::vector<double>& row : rows) {
    const auto is_number = [](double v) { return std::isfinite(v); };
    if (row.empty() || !std::ranges::all_of(row, is_number)) {
      ++result.failed;
      continue;
    }
    result.values.insert(result.values.end(), row.begin(), row.end());
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(row[i]);
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    result.intervals.push_back(known[i] ? bootstrap_interval(std::move(columns[i]), confidence)
                                        : BootstrapInterval{kNan, kNan, kNan});
  }
  return result;
}

}  // namespace plastica::calibrate
