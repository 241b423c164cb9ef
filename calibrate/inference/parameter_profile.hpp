#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "calibrate/inference/intervals.hpp"
#include "calibrate/inference/profile.hpp"
#include "calibrate/search/least_squares.hpp"

/// The likelihood profile of one free parameter of a fit, whatever its targets; not installed.
namespace plastica::calibrate {

/// What a fit knows of a free parameter whose likelihood is followed.
struct ProfiledParameter {
  double lower = 0.0, upper = 0.0;  ///< bounds [SI]
  bool is_break = false;            ///< a limit, which is not searched but follows the others
  std::size_t coordinate = 0;       ///< of one that is searched
  double limit = 0.0;               ///< of a break: its value at the solution [1]; NaN: none
  std::vector<double> halves;       ///< of a break: half the intervals that samplings leave [1]
  std::vector<double> gradient;     ///< of coordinate or limit, by the coordinates (n)
  /// g^T C g with the covariance C, and g^T A^-1 g, A of the squares; NaN where the curves do not
  /// determine it.
  double squared_error = 0.0, inverse = 0.0;
  std::vector<double> along;        ///< A^-1 g over the latter (n)
  double degrees_of_freedom = 0.0;  ///< of the noise in it
  /// SI of a coordinate, by its index.
  std::function<double(std::size_t index, double at)> value_of;
};

/// Both sides of a profile, then what they say.
class ParameterProfile {
 public:
  /// @param squares  with the solution x and its cost
  ParameterProfile(ProfiledParameter parameter, const LeastSquaresProblem& squares,
                   std::vector<double> x, double cost, double confidence);

  /// Whether there is anything to follow: a limit may not depend on what is searched.
  bool depends() const;
  bool is_break() const { return parameter_.is_break; }

  /// @param squares  of a break with one residual more, the limit
  ProfileSide side(const LeastSquaresProblem& squares, bool up) const;
  LikelihoodProfile profile(const ProfileSide& low, const ProfileSide& high) const;
  /// Of a break that nothing searched moves: its sampling alone. NaN of one that no target shows.
  LikelihoodProfile unmoved() const;

 private:
  double value_of(double at) const;
  void set_end(double end, bool up, ProfileEnd why, LikelihoodProfile& profile) const;
  void add(const ProfilePoint& point, LikelihoodProfile& profile) const;

  ProfiledParameter parameter_;
  double confidence_;
  double factor_;       ///< Student's, of the confidence
  double ratio_ = 1.0;  ///< squared error over that of the squares' curvature
  ProfileStart best_;
};

/// What resamples of a fit say.
/// @param rows  values of the free parameters [SI] of each resample; empty, or with one that is no
///        number, of one that failed
/// @param known  which of these the curves determine (n_free): of others all is NaN
BootstrapResult bootstrap_of(const std::vector<std::vector<double>>& rows,
                             const std::vector<bool>& known, int block, double confidence);

}  // namespace plastica::calibrate
